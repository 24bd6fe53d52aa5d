// SPDX-License-Identifier: MIT
//
// Draws a state: the maps, the receivers that the camera sees, their visibility, and the picture of it.
import type { Shadow } from 'umbrage';
import type { Values, ValuesOf } from 'umbrage/values';

import { make_camera, type Camera } from './camera';
import { delete_target, make_program, make_target, make_texture, read_back, use_texture, type GL, type Target } from './gpu';
import { asked_of, clip_of, light_position, values_of, type Asked, type Seen } from './light';
import { box_of, groups_of, type Box, type Scene } from './mesh';
import { depth_pass, everywhere, lookup_pass, map_pass, picture_pass, receivers_pass, shadow_of, turns } from './passes';
import type { State } from './state';

/** What the GPU had and what it made of it, for C++ to do again. */
export interface Frame {
    asked: Asked;
    block: Float32Array;
    points: Float32Array<ArrayBuffer>;
    normals: Float32Array<ArrayBuffer>;
    map: Float32Array<ArrayBuffer> | Uint8Array<ArrayBuffer>;
    map_size: [number, number];
    visibility: Float32Array<ArrayBuffer>;  // four floats a pixel, the first counts
    width: number;
    height: number;
}

/** A mesh in places that stand together. */
interface Drawable { array: WebGLVertexArrayObject; indices: number; places: number; box: Box }

/** True where no point of a box lies in the picture of a matrix. Depth does not count: a depth pass may clamp it. */
function is_outside({ low, high }: Box, m: Float32Array): boolean {
    const planes = [-1, 1].flatMap(side => [0, 1].map(axis => [0, 1, 2, 3].map(c => side * m[4 * c + axis]! - m[4 * c + 3]!)));
    return planes.some(([x, y, z, beyond]) =>  // the corner that is least beyond is beyond it
        [x!, y!, z!].reduce((sum, n, axis) => sum + n * (n < 0 ? high : low)[axis]!, beyond!) > 0);
}

/** Programs and map of a light, made anew when its kind, filter, encoding or size changes. */
interface Look { key: string; asked: Asked; sun: Shadow; depths: WebGLProgram; lookup: WebGLProgram; as_picture: WebGLProgram; map: Target }

export class Picture {
    private readonly receivers: WebGLProgram;
    private readonly compose: WebGLProgram;
    private readonly block: WebGLBuffer;
    private drawables: Drawable[] = [];
    private scene?: Scene;  // whose parts these are
    private look?: Look;
    private seen?: Target;
    private few?: Target;
    private found?: Target;
    private by_cpp?: WebGLTexture;
    private places?: WebGLTexture;
    private drawn?: { state: State; scene: Scene; values: Values };

    constructor(private readonly gl: GL, private readonly values: ValuesOf) {
        if (!gl.getExtension('EXT_color_buffer_float')) throw new Error('This browser cannot draw into textures of floats.');
        this.receivers = make_program(gl, receivers_pass.vertex, receivers_pass.fragment);
        this.compose = make_program(gl, everywhere, picture_pass);
        this.block = gl.createBuffer()!;
    }

    /** True while the browser has taken the graphics away. */
    get is_lost() { return this.gl.isContextLost(); }

    /** Uploads a scene's parts. */
    private set_scene(scene: Scene) {
        const { gl } = this;
        this.scene = scene;
        for (const { array } of this.drawables) gl.deleteVertexArray(array);
        gl.bindVertexArray(null);
        const upload = (values: unknown, kind: number = gl.ARRAY_BUFFER) => {
            const buffer = gl.createBuffer()!;
            gl.bindBuffer(kind, buffer);
            gl.bufferData(kind, values as BufferSource, gl.STATIC_DRAW);
            return buffer;
        };
        const attribute = (slot: number, buffer: WebGLBuffer, size: number, type: number, stride: number, at = 0) => {
            gl.bindBuffer(gl.ARRAY_BUFFER, buffer);
            gl.enableVertexAttribArray(slot);
            gl.vertexAttribPointer(slot, size, type, type !== gl.FLOAT, stride, at);
        };
        this.drawables = scene.parts.flatMap(part => {
            const positions = upload(part.positions), normals = upload(part.normals), colors = upload(part.colors);
            const indices = upload(part.indices, gl.ELEMENT_ARRAY_BUFFER);
            return groups_of(part.places).map(places => {
                const array = gl.createVertexArray()!, at = upload(places);
                gl.bindVertexArray(array);
                attribute(0, positions, 3, gl.FLOAT, 12);
                attribute(1, normals, 3, gl.BYTE, 4);
                attribute(2, colors, 3, gl.UNSIGNED_BYTE, 4);
                for (let column = 0; column < 4; ++column) {
                    attribute(3 + column, at, 4, gl.FLOAT, 64, 16 * column);
                    gl.vertexAttribDivisor(3 + column, 1);
                }
                gl.bindBuffer(gl.ELEMENT_ARRAY_BUFFER, indices);
                gl.bindVertexArray(null);
                return { array, indices: part.indices.length, places: places.length / 16, box: box_of([{ ...part, places }]) };
            });
        });
    }

    /** Draws everything but the picture itself. */
    draw(state: State, scene: Scene, width: number, height: number) {
        if (scene !== this.scene) this.set_scene(scene);
        const { gl } = this, camera = make_camera(scene, state, width / height), look = this.look_for(state);
        this.fit(width, height);
        const some = state.light === 'adaptive_pages' ? this.some_receivers(camera) : undefined;
        const values = values_of(this.values, look.sun, state, scene, camera, some);
        this.drawn = { state, scene, values };
        this.draw_maps(look, state, values);

        const seen = this.seen!;
        this.draw_receivers(seen, camera);
        gl.disable(gl.DEPTH_TEST);
        gl.viewport(0, 0, width, height);
        gl.bindFramebuffer(gl.FRAMEBUFFER, this.found!.frame);
        gl.useProgram(look.lookup);
        gl.bindBufferBase(gl.UNIFORM_BUFFER, 0, this.block);
        gl.bufferData(gl.UNIFORM_BUFFER, values.block, gl.DYNAMIC_DRAW);
        gl.uniformBlockBinding(look.lookup, gl.getUniformBlockIndex(look.lookup, 'umbrage_sun_block'), 0);
        use_texture(gl, look.lookup, 'umbrage_sun_map', look.map.colors[0]!, 0);
        use_texture(gl, look.lookup, 'at', seen.colors[0]!, 1);
        use_texture(gl, look.lookup, 'face', seen.colors[1]!, 2);
        gl.uniform1f(gl.getUniformLocation(look.lookup, 'normals'), state.bias === 'none' ? 0 : 1);
        gl.drawArrays(gl.TRIANGLES, 0, 3);
    }

    /** Draws the picture on the canvas. `divider` is where C++'s half begins, 0 to 1; 1 while C++ has no answer. */
    show(divider: number) {
        const { gl, drawn, look, seen, found } = this;
        if (!drawn || !look || !seen || !found) return;
        const { state, scene } = drawn;
        gl.disable(gl.DEPTH_TEST);
        gl.bindFramebuffer(gl.FRAMEBUFFER, null);
        gl.viewport(0, 0, seen.width, seen.height);
        const p = state.view === 'map' ? look.as_picture : this.compose, set = (name: string) => gl.getUniformLocation(p, name);
        gl.useProgram(p);
        if (state.view === 'map') {
            use_texture(gl, p, 'map', look.map.colors[0]!, 0);
            gl.uniform2f(set('range'), 0, 1);
            gl.uniform2fv(set('map_size'), look.sun.target.map_size);
            gl.uniform1i(set('map_count'), this.map_count);
            gl.uniform2f(set('picture_size'), seen.width, seen.height);
        } else {
            [['at', seen.colors[0]], ['shading_normal', seen.colors[2]], ['albedo', seen.colors[3]], ['gpu', found.colors[0]],
                ['cpu', this.by_cpp], ['places', this.places]].forEach(([name, texture], unit) =>
                use_texture(gl, p, name as string, texture as WebGLTexture, unit));
            gl.uniform3fv(set('light'), light_position(state, scene));
            gl.uniform1f(set('is_sun'), state.light === 'spot_light' || state.light === 'point_light' ? 0 : 1);
            gl.uniform1f(set('divider'), divider);
            gl.uniform1f(set('map_size'), look.asked.map_size);
            gl.uniform1f(set('gutter'), look.asked.gutter);
            gl.uniform1i(set('view'), divider >= 1 || state.view === 'both' ? 0 : state.view === 'difference' ? 1 : 2);
        }
        gl.drawArrays(gl.TRIANGLES, 0, 3);
    }

    /** Number of maps that the last draw() drew. */
    get map_count() { return this.drawn?.values.matrices.length ?? 0; }

    /** What the GPU had of the last draw(). */
    frame(): Frame {
        const { gl } = this, { values, state } = this.drawn!, { asked, map } = this.look!, seen = this.seen!;
        const normals = read_back(gl, seen, 1, 'floats');
        if (state.bias === 'none') normals.fill(0);
        return {
            asked, block: values.block, width: seen.width, height: seen.height, map_size: [map.width, map.height],
            points: read_back(gl, seen, 0, 'floats'), normals,
            map: asked.encoding === 'depth32f' ? read_back(gl, map, 0, 'floats') : read_back(gl, map, 0, 'bytes'),
            visibility: read_back(gl, this.found!, 0, 'floats'),
        };
    }

    /** Takes C++'s visibility and places of the last draw(). */
    set_answer(visibility: Float32Array, places: Float32Array) {
        const { gl } = this, { width, height } = this.seen!;
        gl.activeTexture(gl.TEXTURE0);
        gl.bindTexture(gl.TEXTURE_2D, this.by_cpp!);
        gl.texSubImage2D(gl.TEXTURE_2D, 0, 0, 0, width, height, gl.RED, gl.FLOAT, visibility);
        gl.bindTexture(gl.TEXTURE_2D, this.places!);
        gl.texSubImage2D(gl.TEXTURE_2D, 0, 0, 0, width, height, gl.RGBA, gl.FLOAT, places);
    }

    private look_for(state: State): Look {
        const { gl } = this, asked = asked_of(state), key = JSON.stringify(asked);
        if (this.look?.key === key) return this.look;
        const sun = shadow_of(asked), [width, height] = sun.target.size;
        if (this.look) {
            for (const program of [this.look.depths, this.look.lookup, this.look.as_picture]) gl.deleteProgram(program);
            delete_target(gl, this.look.map);
            this.look = undefined;
        }
        const pass = depth_pass(sun, clip_of(state));
        return this.look = { key, asked, sun,
            depths: make_program(gl, pass.vertex, pass.fragment),
            lookup: make_program(gl, everywhere, lookup_pass(sun, turns(asked.filter))),
            as_picture: make_program(gl, everywhere, map_pass(sun, asked)),
            map: make_target(gl, [asked.encoding === 'depth32f' ? 'RGBA32F' : 'RGBA8'], width, height, true) };
    }

    private fit(width: number, height: number) {
        const { gl } = this;
        if (this.seen?.width === width && this.seen.height === height) return;
        for (const target of [this.seen, this.few, this.found]) delete_target(gl, target);
        for (const texture of [this.by_cpp, this.places]) gl.deleteTexture(texture ?? null);
        const receivers = ['RGBA32F', 'RGBA32F', 'RGBA8', 'RGBA8'] as const;
        this.seen = make_target(gl, receivers, width, height, true);
        this.few = make_target(gl, receivers, Math.ceil(width / 16), Math.ceil(height / 16), true);
        this.found = make_target(gl, ['RGBA32F'], width, height, false);
        this.by_cpp = make_texture(gl, 'R32F', width, height);
        this.places = make_texture(gl, 'RGBA32F', width, height);
    }

    private draw_receivers(target: Target, camera: Camera) {
        const { gl } = this;
        gl.bindFramebuffer(gl.FRAMEBUFFER, target.frame);
        gl.viewport(0, 0, target.width, target.height);
        gl.enable(gl.DEPTH_TEST);
        gl.depthFunc(gl.LESS);
        for (let i = 0; i < target.colors.length; ++i) gl.clearBufferfv(gl.COLOR, i, [0, 0, 0, 0]);
        gl.clearBufferfv(gl.DEPTH, 0, [1]);
        gl.useProgram(this.receivers);
        gl.uniform3fv(gl.getUniformLocation(this.receivers, 'eye'), camera.position);
        this.draw_scene(this.receivers, camera.to_clip as Float32Array);
    }

    /** Positions and normals that the camera sees, one pixel of each 16 x 16. */
    private some_receivers(camera: Camera): Seen {
        const { gl } = this, { width, height } = this.seen!, few = this.few!;
        this.draw_receivers(few, camera);
        return { picture: [width, height], points: read_back(gl, few, 0, 'floats'), normals: read_back(gl, few, 1, 'floats') };
    }

    private draw_maps({ sun, depths, map }: Look, state: State, { matrices, views }: Values) {
        const { gl } = this, reversed = state.depth === 'reversed', [columns] = sun.target.grid, [width, height] = sun.target.map_size;
        gl.bindFramebuffer(gl.FRAMEBUFFER, map.frame);
        gl.viewport(0, 0, map.width, map.height);
        gl.clearBufferfv(gl.COLOR, 0, sun.cleared as number[]);
        gl.clearBufferfv(gl.DEPTH, 0, [reversed ? 0 : 1]);
        gl.enable(gl.DEPTH_TEST);
        gl.depthFunc(reversed ? gl.GREATER : gl.LESS);
        gl.useProgram(depths);
        views.forEach(({ to_clip, anchor }, i) => {
            gl.viewport(i % columns * width, Math.floor(i / columns) * height, width, height);
            gl.uniform4fv(gl.getUniformLocation(depths, 'anchor'), anchor);
            this.draw_scene(depths, to_clip, matrices[i]!);
        });
    }

    /** @param within   world to clip space, for what lies outside */
    private draw_scene(program: WebGLProgram, to_clip: Float32Array, within = to_clip) {
        const { gl } = this;
        gl.uniformMatrix4fv(gl.getUniformLocation(program, 'to_clip'), false, to_clip);
        for (const { array, indices, places, box } of this.drawables) {
            if (is_outside(box, within)) continue;
            gl.bindVertexArray(array);
            gl.drawElementsInstanced(gl.TRIANGLES, indices, gl.UNSIGNED_INT, 0, places);
        }
        gl.bindVertexArray(null);
    }
}
