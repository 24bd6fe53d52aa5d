// SPDX-License-Identifier: MIT
//
// Files of folders as one site, for tests in a browser.
import { createReadStream, existsSync, statSync } from 'node:fs';
import { createServer } from 'node:http';
import { extname, join } from 'node:path';

const types = { '.html': 'text/html', '.mjs': 'text/javascript', '.js': 'text/javascript', '.css': 'text/css', '.json': 'application/json' };

/** @param roots   folders by the beginning of their addresses, the longer ones first: { '/package/': folder, '/': folder }
 *  @param html    page at the address /, if any
 *  @return        the server, and its address without a / at its end */
export async function serve(roots, html) {
    const server = createServer((request, answer) => {
        const url = decodeURI(request.url.split('?')[0]), start = Object.keys(roots).find(root => url.startsWith(root));
        if (url === '/favicon.ico') return answer.writeHead(204).end();
        if (url === '/' && html !== undefined) return answer.writeHead(200, { 'content-type': 'text/html' }).end(html);
        const file = start === undefined ? '' : join(roots[start], url.slice(start.length));
        if (!existsSync(file) || !statSync(file).isFile()) return answer.writeHead(404).end();
        answer.writeHead(200, { 'content-type': types[extname(file)] ?? 'text/plain' });
        createReadStream(file).pipe(answer);
    }).listen(0, '127.0.0.1');
    await new Promise(ready => server.on('listening', ready));
    return { server, address: `http://127.0.0.1:${server.address().port}` };
}
