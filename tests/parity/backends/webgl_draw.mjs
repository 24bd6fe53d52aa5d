// SPDX-License-Identifier: MIT
//
// Draws jobs in WebGL 1 and 2: parity's in webgl.js, and those of a page.
//
// A job: a number of parts, each with its length before it and padded to four bytes. The first is JSON; the vertex
// shader, the fragment shader and the textures' texels follow.
import { parts_of } from './parts.mjs';

/** Function that draws a job and gives its pixels. `make_canvas` makes a canvas for each version of WebGL. */
export function webgl(make_canvas) {
    const contexts = {};
    let textures = [], serial = 0;

    function open(version) {
        const gl = make_canvas().getContext(version === 1 ? 'webgl' : 'webgl2', { antialias: false });
        if (!gl) throw new Error('no WebGL ' + version);
        const wanted = version === 1 ? ['OES_texture_float', 'WEBGL_color_buffer_float'] : [];
        for (const name of wanted) if (!gl.getExtension(name)) throw new Error('no ' + name);
        gl.disable(gl.DITHER);
        gl.pixelStorei(gl.UNPACK_ALIGNMENT, 1);
        gl.bindBuffer(gl.ARRAY_BUFFER, gl.createBuffer());
        gl.bufferData(gl.ARRAY_BUFFER, new Float32Array([-1, -1, 3, -1, -1, 3]), gl.STATIC_DRAW);
        gl.enableVertexAttribArray(0);
        gl.vertexAttribPointer(0, 2, gl.FLOAT, false, 0, 0);
        return { gl, version, units: [], targets: {}, serial: 0, shader: '', program: null };
    }

    function parameters(gl, target, linear) {
        const set = (name, value) => gl.texParameteri(target, gl['TEXTURE_' + name], value);
        for (const name of ['MIN_FILTER', 'MAG_FILTER']) set(name, linear ? gl.LINEAR : gl.NEAREST);
        for (const name of ['WRAP_S', 'WRAP_T']) set(name, gl.CLAMP_TO_EDGE);
        return set;
    }

    // shape, format and compare are numbers of texture_image in texture.hpp.
    function texture(c, t) {
        const gl = c.gl, id = gl.createTexture(), [width, height] = t.size;
        const target = [gl.TEXTURE_2D, gl.TEXTURE_2D_ARRAY, gl.TEXTURE_CUBE_MAP][t.shape];
        gl.bindTexture(target, id);
        const set = parameters(gl, target, t.linear);
        if (t.compare) {
            set('COMPARE_MODE', gl.COMPARE_REF_TO_TEXTURE);
            set('COMPARE_FUNC', [0, gl.LEQUAL, gl.GEQUAL][t.compare]);
        }
        const bytes = [gl.RGBA, gl.UNSIGNED_BYTE], floats = [gl.RGBA, gl.FLOAT];
        const [internal, format, type] = c.version === 1 ? [gl.RGBA, ...t.format === 4 ? bytes : floats] : [
            [gl.RGBA32F, ...floats], [gl.RGBA32UI, gl.RGBA_INTEGER, gl.UNSIGNED_INT],
            [gl.DEPTH_COMPONENT32F, gl.DEPTH_COMPONENT, gl.FLOAT],
            [gl.DEPTH_COMPONENT16, gl.DEPTH_COMPONENT, gl.UNSIGNED_SHORT], [gl.RGBA8, ...bytes]][t.format];
        const arrays = { [gl.FLOAT]: Float32Array, [gl.UNSIGNED_INT]: Uint32Array, [gl.UNSIGNED_SHORT]: Uint16Array,
            [gl.UNSIGNED_BYTE]: Uint8Array };
        const pixels = new arrays[type](t.bytes);
        if (target === gl.TEXTURE_2D_ARRAY) {
            gl.texImage3D(target, 0, internal, width, height, t.layers, 0, format, type, pixels);
            return id;
        }
        const first = target === gl.TEXTURE_2D ? target : gl.TEXTURE_CUBE_MAP_POSITIVE_X;
        const layer = pixels.length / t.layers;
        for (let l = 0; l < t.layers; ++l)
            gl.texImage2D(first + l, 0, internal, width, height, 0, format, type,
                pixels.subarray(l * layer, (l + 1) * layer));
        return id;
    }

    /** Formats and array of a target: bytes, or floats, which WebGL 2 has as the integers of their bits. */
    function target_of({ gl, version }, bytes) {
        if (bytes) return [version === 1 ? gl.RGBA : gl.RGBA8, gl.RGBA, gl.UNSIGNED_BYTE, Uint8Array];
        if (version === 1) return [gl.RGBA, gl.RGBA, gl.FLOAT, Float32Array];
        return [gl.RGBA32UI, gl.RGBA_INTEGER, gl.UNSIGNED_INT, Uint32Array];
    }

    function color(gl, size, [internal, format, type]) {
        const id = gl.createTexture();
        gl.bindTexture(gl.TEXTURE_2D, id);
        parameters(gl, gl.TEXTURE_2D, false);
        gl.texImage2D(gl.TEXTURE_2D, 0, internal, size[0], size[1], 0, format, type, null);
        return id;
    }

    const failure = (gl, text) => new Error(gl.isContextLost() ? 'the context was lost' : text);

    function link(gl, vertex, fragment) {
        const program = gl.createProgram();
        for (const [kind, text] of [[gl.VERTEX_SHADER, vertex], [gl.FRAGMENT_SHADER, fragment]]) {
            const stage = gl.createShader(kind);
            gl.shaderSource(stage, text);
            gl.compileShader(stage);
            if (!gl.getShaderParameter(stage, gl.COMPILE_STATUS)) throw failure(gl, gl.getShaderInfoLog(stage) + text);
            gl.attachShader(program, stage);
        }
        gl.bindAttribLocation(program, 0, 'corner');
        gl.linkProgram(program);
        if (!gl.getProgramParameter(program, gl.LINK_STATUS)) throw failure(gl, gl.getProgramInfoLog(program) + fragment);
        return program;
    }

    return function run(block) {
        const parts = parts_of(block), text = part => new TextDecoder().decode(part);
        const job = JSON.parse(text(parts[0]));
        const c = contexts[job.version] ||= open(job.version), gl = c.gl;
        if (job.hello) {
            const names = gl.getExtension('WEBGL_debug_renderer_info');
            return new TextEncoder().encode(gl.getParameter(names ? names.UNMASKED_RENDERER_WEBGL : gl.RENDERER));
        }
        if (job.textures) {
            textures = job.textures.map((t, i) => ({ ...t, bytes: parts[3 + i].slice().buffer }));
            ++serial;
        }
        if (c.serial !== serial)
            for (const t of textures) {
                gl.activeTexture(gl.TEXTURE0 + t.unit);
                gl.deleteTexture(c.units[t.unit]);  // its shape may be another
                c.units[t.unit] = texture(c, t);
            }
        c.serial = serial;
        const fragment = text(parts[2]);
        if (c.shader !== fragment) {
            gl.deleteProgram(c.program);
            c.program = link(gl, text(parts[1]), fragment);
            c.shader = fragment;
        }
        gl.useProgram(c.program);
        for (const t of textures) gl.uniform1i(gl.getUniformLocation(c.program, t.name), t.unit);
        gl.uniform2f(gl.getUniformLocation(c.program, 'map_size'), ...job.map_size);

        const formats = target_of(c, job.bytes), [, format, type, array] = formats, [width, height] = job.size;
        const target = c.targets[type] ||= { frame: gl.createFramebuffer() };
        gl.bindFramebuffer(gl.FRAMEBUFFER, target.frame);
        if (target.height !== height) {
            gl.activeTexture(gl.TEXTURE0 + job.spare_unit);
            gl.deleteTexture(target.color);
            target.color = color(gl, job.size, formats);
            gl.framebufferTexture2D(gl.FRAMEBUFFER, gl.COLOR_ATTACHMENT0, gl.TEXTURE_2D, target.color, 0);
            const status = gl.checkFramebufferStatus(gl.FRAMEBUFFER);
            if (status !== gl.FRAMEBUFFER_COMPLETE) throw failure(gl, 'incomplete target');
            gl.bindTexture(gl.TEXTURE_2D, null);
            target.height = height;
        }
        gl.viewport(0, 0, width, height);
        gl.drawArrays(gl.TRIANGLES, 0, 3);
        const pixels = new array(width * job.rows * 4);
        gl.readPixels(0, 0, width, job.rows, format, type, pixels);
        const error = gl.getError();
        if (error) throw failure(gl, 'WebGL error ' + error);
        return new Uint8Array(pixels.buffer);
    };
}
