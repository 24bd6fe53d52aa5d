// SPDX-License-Identifier: MIT
//
// Draws for remote.cpp in a headless browser:  node webgl.js CHROMIUM NODE_MODULES
//
// On standard input come jobs, on standard output go results, each a length in four bytes and that many bytes. This
// program passes them on to the page without a look; what is in them is between block.cpp and webgl_draw.mjs.
'use strict';
const fs = require('fs');
const http = require('http');
const path = require('path');
const { collect, send } = require('./frames.js');
const [browser_path, modules] = process.argv.slice(2);
const { chromium } = require(path.join(modules, 'playwright-core'));

// Runs in the page. A result: 0 and pixels, or 1 and words.
async function work() {
    const { webgl } = await import('/webgl_draw.mjs');
    const run = webgl(() => document.createElement('canvas'));
    for (;;) {
        const reply = await fetch('/job');
        if (!reply.ok) return;
        const block = new Uint8Array(await reply.arrayBuffer());
        let status = 0, result;
        try {
            result = run(block);
        } catch (error) {
            status = 1;
            result = new TextEncoder().encode(error.message);
        }
        await fetch('/result', { method: 'POST', body: new Blob([new Uint8Array([status]), result]) });
    }
}

const jobs = [], readers = [];
let ended = false;
function hand_out() {
    while (readers.length && (jobs.length || ended)) {
        const job = jobs.shift(), reply = readers.shift();
        reply.writeHead(job ? 200 : 410);
        reply.end(job);
    }
}

const server = http.createServer((request, reply) => {
    if (request.url === '/job') {
        readers.push(reply);
        hand_out();
    } else if (request.url === '/result') {
        const chunks = [];
        request.on('data', chunk => chunks.push(chunk));
        request.on('end', () => {
            send(Buffer.concat(chunks), () => reply.end());
        });
    } else if (request.url.endsWith('.mjs')) {
        reply.setHeader('Content-Type', 'text/javascript');
        reply.end(fs.readFileSync(path.join(__dirname, path.basename(request.url))));
    } else {
        reply.setHeader('Content-Type', 'text/html');
        reply.end('<!doctype html>');
    }
});

server.listen(0, '127.0.0.1', async () => {
    let browser;
    try {
        browser = await chromium.launch({
            executablePath: browser_path,
            args: ['--no-sandbox', '--use-gl=angle', '--use-angle=swiftshader', '--enable-unsafe-swiftshader',
                '--disable-gpu-watchdog', '--disable-quic', '--no-first-run', '--disable-background-networking',
                '--disable-component-update', '--disable-sync'],
        });
        const page = await browser.newPage();
        await page.goto('http://127.0.0.1:' + server.address().port + '/');
        const drawing = page.evaluate(work);
        collect(process.stdin, job => { jobs.push(job); hand_out(); }).then(() => { ended = true; hand_out(); });
        await drawing;
    } catch (error) {
        console.error('webgl.js: ' + error.message);
        process.exitCode = 1;
    }
    if (browser) await browser.close();
    server.closeAllConnections();
    server.close();
    process.stdin.destroy();
});
