// SPDX-License-Identifier: MIT
//
// A filter and a setup of a user's own in WebGL 1 and 2: every receiver is as C++ says, bit for bit.
//     node own_in_webgl.mjs FILE CHROMIUM NODE_MODULES
import { existsSync, readFileSync } from 'node:fs';
import { createRequire } from 'node:module';
import { join, resolve } from 'node:path';

const [file, browser_path, modules] = process.argv.slice(2);
if (!existsSync(join(modules, 'playwright-core'))) {
    console.log(`SKIPPED: no playwright-core in ${modules}`);
    process.exit(77);
}
const { chromium } = createRequire(join(resolve(modules), 'x.js'))('playwright-core');

/** Draws one shadow, in the page, with each of some blocks; how many receivers differ. */
function differing({ version, text, blocks, map, size, points, normals, target: [width, height], seen }) {
    const canvas = document.createElement('canvas'), gl = canvas.getContext(version === 1 ? 'webgl' : 'webgl2');
    for (const name of version === 1 ? ['OES_texture_float', 'WEBGL_color_buffer_float'] : ['EXT_color_buffer_float'])
        if (!gl.getExtension(name)) throw new Error(`no ${name}`);
    const is_old = version === 1, read = is_old ? 'texture2D' : 'texture';
    const fragment = `${text}${is_old ? '' : 'out vec4 color;\n'}uniform sampler2D points, normals;
void main() {
    vec2 at = gl_FragCoord.xy / vec2(${width}.0, ${height}.0);
    ${is_old ? 'gl_FragColor' : 'color'} = vec4(umbrage_own(${read}(points, at).xyz, ${read}(normals, at).xyz), 0.0, 0.0, 1.0);
}
`;
    const vertex = `${is_old ? 'attribute' : '#version 300 es\nin'} vec2 corner;\nvoid main() { gl_Position = vec4(corner, 0.0, 1.0); }`;
    const program = gl.createProgram();
    for (const [kind, source] of [[gl.VERTEX_SHADER, vertex], [gl.FRAGMENT_SHADER, fragment]]) {
        const stage = gl.createShader(kind);
        gl.shaderSource(stage, source);
        gl.compileShader(stage);
        if (!gl.getShaderParameter(stage, gl.COMPILE_STATUS)) throw new Error(gl.getShaderInfoLog(stage));
        gl.attachShader(program, stage);
    }
    gl.bindAttribLocation(program, 0, 'corner');
    gl.linkProgram(program);
    if (!gl.getProgramParameter(program, gl.LINK_STATUS)) throw new Error(gl.getProgramInfoLog(program));
    gl.useProgram(program);

    const rgba = values => Float32Array.from({ length: 4 * values.length }, (_, i) => i % 4 ? 0 : values[i / 4]);
    const texture = (unit, name, [w, h], texels) => {
        gl.activeTexture(gl.TEXTURE0 + unit);
        gl.bindTexture(gl.TEXTURE_2D, gl.createTexture());
        for (const filter of [gl.TEXTURE_MIN_FILTER, gl.TEXTURE_MAG_FILTER]) gl.texParameteri(gl.TEXTURE_2D, filter, gl.NEAREST);
        for (const wrap of [gl.TEXTURE_WRAP_S, gl.TEXTURE_WRAP_T]) gl.texParameteri(gl.TEXTURE_2D, wrap, gl.CLAMP_TO_EDGE);
        gl.texImage2D(gl.TEXTURE_2D, 0, is_old ? gl.RGBA : gl.RGBA32F, w, h, 0, gl.RGBA, gl.FLOAT, texels);
        if (name) gl.uniform1i(gl.getUniformLocation(program, name), unit);
    };
    texture(0, 'umbrage_own_map', size, rgba(map));
    texture(1, 'points', [width, height], new Float32Array(points));
    texture(2, 'normals', [width, height], new Float32Array(normals));
    texture(3, '', [width, height], null);
    gl.bindFramebuffer(gl.FRAMEBUFFER, gl.createFramebuffer());
    gl.framebufferTexture2D(gl.FRAMEBUFFER, gl.COLOR_ATTACHMENT0, gl.TEXTURE_2D, gl.getParameter(gl.TEXTURE_BINDING_2D), 0);
    gl.bindBuffer(gl.ARRAY_BUFFER, gl.createBuffer());
    gl.bufferData(gl.ARRAY_BUFFER, new Float32Array([-1, -1, 3, -1, -1, 3]), gl.STATIC_DRAW);
    gl.enableVertexAttribArray(0);
    gl.vertexAttribPointer(0, 2, gl.FLOAT, false, 0, 0);
    gl.viewport(0, 0, width, height);
    return blocks.map(block => {
        if (is_old) gl.uniform4fv(gl.getUniformLocation(program, 'umbrage_own_block'), new Float32Array(block));
        else {
            const buffer = gl.createBuffer();
            gl.bindBufferBase(gl.UNIFORM_BUFFER, 0, buffer);
            gl.bufferData(gl.UNIFORM_BUFFER, new Float32Array(block), gl.STATIC_DRAW);
            gl.uniformBlockBinding(program, gl.getUniformBlockIndex(program, 'umbrage_own_block'), 0);
        }
        gl.drawArrays(gl.TRIANGLES, 0, 3);
        const pixels = new Float32Array(4 * width * height), error = gl.getError();
        gl.readPixels(0, 0, width, height, gl.RGBA, gl.FLOAT, pixels);
        if (error) throw new Error(`error ${error} of WebGL`);
        return seen.filter((value, i) => Math.fround(value) !== pixels[4 * i]).length;
    });
}

const { size: target, points, normals, shadows } = JSON.parse(readFileSync(file, 'utf8'));
const browser = await chromium.launch({ executablePath: browser_path, args: ['--no-sandbox', '--use-gl=angle', '--use-angle=swiftshader',
    '--enable-unsafe-swiftshader', '--disable-gpu-watchdog', '--no-first-run', '--disable-background-networking'] });
let good = true;
try {
    const page = await browser.newPage();
    for (const { what, texts, block, ...shadow } of shadows) {
        const blocks = [block, block.map((n, i) => i === 0 ? n + 0.01 : n)], partly = shadow.seen.filter(v => v > 0 && v < 1).length;
        for (const version of [1, 2]) {
            const [wrong, faulty] = await page.evaluate(differing,
                { ...shadow, blocks, version, text: texts[version - 1], points, normals, target });
            console.log(`${what} of a user's own, WebGL ${version}: ${wrong} of ${shadow.seen.length} receivers differ, ${partly} partly `
                + `lit; ${faulty} with a fault`);
            good = good && wrong === 0 && partly > 200 && faulty > 0;
        }
    }
} finally {
    await browser.close();
}
process.exitCode = good ? 0 : 1;
