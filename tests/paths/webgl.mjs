// SPDX-License-Identifier: MIT
//
// A page of WebGL 1 or 2 that draws paths, from what the package prints.
import * as glsl from '/package/umbrage.mjs';
import { opengl_clip_space } from '/package/values.mjs';
import { camera, picture, vertices } from './scene.mjs';
import { light_from, light_values, shadow_options } from './light.mjs';

/** What a format is stored in where the API does not draw into it. */
const stored = { RGB8: 'RGBA8' };

/** One canvas, over as many frames as a path has. */
export class page {
    static async made(version) { return new page(version); }
    constructor(version) {
        const canvas = Object.assign(document.createElement('canvas'), { width: picture[0], height: picture[1] });
        this.old = version === 1;
        const gl = this.gl = canvas.getContext(this.old ? 'webgl' : 'webgl2', { antialias: false, preserveDrawingBuffer: true });
        for (const name of this.old ? [] : ['EXT_color_buffer_float']) if (!gl.getExtension(name)) throw new Error(`no ${name}`);
        gl.disable(gl.DITHER);
        gl.enable(gl.DEPTH_TEST);
    }

    program(vertex_items, fragment_items, vertex_main, fragment_main) {
        const { gl, old } = this, made = gl.createProgram(), version = old ? '100' : '300 es';
        const precision = 'precision highp float;\n' + (old ? '' : 'precision highp sampler2D;\nprecision highp sampler2DArray;\n'
            + 'precision highp sampler2DShadow;\nprecision highp sampler2DArrayShadow;\n');
        const [as_in, as_out, from] = old ? ['attribute', 'varying', 'varying'] : ['in', 'out', 'in'];
        const texts = [
            glsl.source(version, vertex_items, precision) + `${as_in} vec3 position, vertex_normal;\nuniform mat4 to_clip;\nuniform vec4 anchor;
uniform float number;\n${as_out} vec3 world, normal;\n${as_out} vec2 clip_depth;
void main() { gl_Position = ${vertex_main}; world = position, normal = vertex_normal, clip_depth = gl_Position.zw; }`,
            glsl.source(version, fragment_items, precision) + `${from} vec3 world, normal;\n${from} vec2 clip_depth;\nuniform float number;
${old ? '#define color gl_FragColor' : 'out vec4 color;'}\nvoid main() { ${fragment_main} }`];
        texts.forEach((text, i) => {
            const stage = gl.createShader(i ? gl.FRAGMENT_SHADER : gl.VERTEX_SHADER);
            gl.shaderSource(stage, text);
            gl.compileShader(stage);
            if (!gl.getShaderParameter(stage, gl.COMPILE_STATUS)) throw new Error(gl.getShaderInfoLog(stage));
            gl.attachShader(made, stage);
        });
        ['position', 'vertex_normal'].forEach((name, i) => gl.bindAttribLocation(made, i, name));
        gl.linkProgram(made);
        if (!gl.getProgramParameter(made, gl.LINK_STATUS)) throw new Error(gl.getProgramInfoLog(made));
        return made;
    }

    /** Textures that a shadow's maps lie in: what is looked up, and what a layer is drawn into. */
    make_maps({ target, settings }, { map }) {
        const { gl } = this, layered = map.includes('array'), kind = layered ? gl.TEXTURE_2D_ARRAY : gl.TEXTURE_2D;
        const is_depth = map.startsWith('depth') || map.startsWith('shadow'), made = gl.createTexture(), [width, height] = target.size;
        gl.activeTexture(gl.TEXTURE0);
        gl.bindTexture(kind, made);
        for (const filter of [gl.TEXTURE_MIN_FILTER, gl.TEXTURE_MAG_FILTER]) gl.texParameteri(kind, filter, gl.NEAREST);
        for (const wrap of [gl.TEXTURE_WRAP_S, gl.TEXTURE_WRAP_T]) gl.texParameteri(kind, wrap, gl.CLAMP_TO_EDGE);
        const store = format => (layered ? gl.texStorage3D(kind, 1, format, width, height, target.layers)
            : gl.texStorage2D(kind, 1, format, width, height));
        if (this.old) gl.texImage2D(kind, 0, gl.RGBA, width, height, 0, gl.RGBA, gl.UNSIGNED_BYTE, null);
        else store(gl[stored[target.format] ?? target.format]);
        if (map.startsWith('shadow')) {
            gl.texParameteri(kind, gl.TEXTURE_COMPARE_MODE, gl.COMPARE_REF_TO_TEXTURE);
            gl.texParameteri(kind, gl.TEXTURE_COMPARE_FUNC, settings.direction === 'reversed' ? gl.GEQUAL : gl.LEQUAL);
        }
        const frame = gl.createFramebuffer();
        gl.bindFramebuffer(gl.FRAMEBUFFER, frame);
        if (!is_depth) {
            const depths = gl.createRenderbuffer();
            gl.bindRenderbuffer(gl.RENDERBUFFER, depths);
            gl.renderbufferStorage(gl.RENDERBUFFER, this.old ? gl.DEPTH_COMPONENT16 : gl.DEPTH_COMPONENT32F, width, height);
            gl.framebufferRenderbuffer(gl.FRAMEBUFFER, gl.DEPTH_ATTACHMENT, gl.RENDERBUFFER, depths);
        }
        return { kind, made, frame, attach: layer => {
            const to = is_depth ? gl.DEPTH_ATTACHMENT : gl.COLOR_ATTACHMENT0;
            if (layered) gl.framebufferTextureLayer(gl.FRAMEBUFFER, to, made, 0, layer);
            else gl.framebufferTexture2D(gl.FRAMEBUFFER, to, kind, made, 0);
        } };
    }

    give_vertices(floats) {
        const { gl } = this;
        gl.bindBuffer(gl.ARRAY_BUFFER, gl.createBuffer());
        gl.bufferData(gl.ARRAY_BUFFER, floats, gl.STATIC_DRAW);
        for (const i of [0, 1]) gl.enableVertexAttribArray(i), gl.vertexAttribPointer(i, 3, gl.FLOAT, false, 24, 12 * i);
        return floats.length / 6;
    }
    clear(direction, color) {
        const { gl } = this, reversed = direction === 'reversed';
        gl.depthFunc(reversed ? gl.GREATER : gl.LESS);
        gl.clearDepth(reversed ? 0 : 1);
        gl.clearColor(...color);
        gl.clear(gl.COLOR_BUFFER_BIT | gl.DEPTH_BUFFER_BIT);
    }

    /** One frame of a path: visibility of each pixel from above, 255 is lit.
     *  @param fault   of faults.mjs */
    frame(path, values, seen, fault) {
        const { gl, old } = this, clip = { ...opengl_clip_space, direction: path.direction };
        const sun = glsl.shadow('sun', shadow_options(glsl, path)), light = light_values(path, sun, clip, seen);
        const given = { cleared: sun.cleared, compare: undefined, ...values(sun, light) };
        const { block, views, edge_angle, cleared, compare } = fault ? fault.make(given, { values, sun, light, path, glsl,
            options: other => shadow_options(glsl, other),
            before: light_values({ ...path, shift: [0.5, 0.3, -0.4] }, sun, clip, seen) }) : given;
        const { grid: [columns], map_size: [tile_width, tile_height], layers } = sun.target;

        // The depth pass
        const is_depth = path.map.startsWith('depth') || path.map.startsWith('shadow'), bends = path.setup === 'dual_paraboloid_light';
        const four = path.setup === 'tetrahedron_light';
        const depth = old ? 'clip_depth.x / clip_depth.y * 0.5 + 0.5' : 'gl_FragCoord.z';
        const items = [...is_depth ? [] : [sun.depth_pass], ...four ? [glsl.snippets.tetrahedron_face_of] : []];
        const depth_pass = this.program([sun.vertex_pass(clip)], items,
            `umbrage_vertex_sun(to_clip, position, anchor${bends ? ', number' : ''})`,
            (four ? `if (umbrage_tetrahedron_face_of(floor(gl_FragCoord.xy), ${tile_width}.0) != number) discard;\n` : '')
            + (is_depth ? '' : `color = umbrage_write_sun(${depth});`));
        const maps = this.make_maps(sun, path), casters = this.give_vertices(vertices(light_from(path), edge_angle));
        gl.useProgram(depth_pass);
        const at = name => gl.getUniformLocation(depth_pass, name);
        views.forEach(({ to_clip, anchor }, i) => {
            if (i === 0 || layers > 1) maps.attach(i), gl.viewport(0, 0, ...sun.target.size), this.clear(path.direction, cleared);
            const tile = layers > 1 || four ? 0 : i;
            gl.viewport(tile % columns * tile_width, Math.floor(tile / columns) * tile_height, tile_width, tile_height);
            gl.uniformMatrix4fv(at('to_clip'), false, to_clip);
            gl.uniform4fv(at('anchor'), anchor);
            gl.uniform1f(at('number'), i);
            gl.drawArrays(gl.TRIANGLES, 0, casters);
        });

        // The picture
        const turns = path.filter.match(/^(disc|pcss|dpcf)/) ? ', gl_FragCoord.xy' : '';
        const view = this.program([], [sun], 'to_clip * vec4(position, 1.0)',
            `color = vec4(vec3(umbrage_sun(world, normal${turns})), 1.0);`);
        const count = this.give_vertices(vertices());
        gl.useProgram(view);
        gl.uniformMatrix4fv(gl.getUniformLocation(view, 'to_clip'), false, new Float32Array(camera(opengl_clip_space).to_clip));
        if (old) gl.uniform4fv(gl.getUniformLocation(view, 'umbrage_sun_block'), block);
        else {
            gl.bindBufferBase(gl.UNIFORM_BUFFER, 0, gl.createBuffer());
            gl.bufferData(gl.UNIFORM_BUFFER, block, gl.DYNAMIC_DRAW);
            gl.uniformBlockBinding(view, gl.getUniformBlockIndex(view, 'umbrage_sun_block'), 0);
        }
        gl.uniform1i(gl.getUniformLocation(view, 'umbrage_sun_map'), 0);
        gl.bindTexture(maps.kind, maps.made);
        if (compare) gl.texParameteri(maps.kind, gl.TEXTURE_COMPARE_FUNC, gl[compare]);
        gl.bindFramebuffer(gl.FRAMEBUFFER, null);
        gl.viewport(0, 0, ...picture);
        this.clear('forward', [0, 0, 1, 1]);
        gl.drawArrays(gl.TRIANGLES, 0, count);
        const [width, height] = picture, pixels = new Uint8Array(4 * width * height), error = gl.getError();
        gl.readPixels(0, 0, width, height, gl.RGBA, gl.UNSIGNED_BYTE, pixels);
        if (error) throw new Error(`error ${error} of WebGL`);
        return Array.from({ length: width * height }, (_, i) => pixels[4 * ((height - 1 - Math.floor(i / width)) * width + i % width)]);
    }
}
