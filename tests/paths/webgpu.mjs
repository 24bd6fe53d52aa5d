// SPDX-License-Identifier: MIT
//
// A page of WebGPU that draws paths, from what the package prints.
import * as wgsl from '/package/wgsl.mjs';
import { webgpu_clip_space } from '/package/values.mjs';
import { light_from, light_values, shadow_options } from './light.mjs';
import { camera, picture, vertices } from './scene.mjs';

const formats = { R32F: 'r32float', RG8: 'rg8unorm', RGB8: 'rgba8unorm', RGBA8: 'rgba8unorm', RGB10_A2: 'rgb10a2unorm',
    DEPTH_COMPONENT32F: 'depth32float', DEPTH_COMPONENT24: 'depth24plus', DEPTH_COMPONENT16: 'depth16unorm' };
const usage = { target: 0x10, texture: 0x4, copied: 0x1 };

/** One device, over as many frames as a path has. */
export class page {
    static async made() {
        const made = new page(), adapter = await navigator.gpu?.requestAdapter();
        if (!adapter) throw new Error('no adapter of WebGPU');
        made.device = await adapter.requestDevice();
        made.device.onuncapturederror = event => { made.error ??= event.error.message; };
        return made;
    }
    buffer(floats, flags) {
        const made = this.device.createBuffer({ size: floats.byteLength, usage: flags | GPUBufferUsage.COPY_DST });
        this.device.queue.writeBuffer(made, 0, floats);
        return made;
    }
    texture(format, [width, height], layers, flags) {
        return this.device.createTexture({ size: [width, height, layers], format, usage: flags });
    }
    group(pipeline, number, ...resources) {
        return this.device.createBindGroup({ layout: pipeline.getBindGroupLayout(number),
            entries: resources.map((resource, binding) => ({ binding, resource })) });
    }
    pipeline(module, [vertex, fragment], format, depth_format, direction) {
        return this.device.createRenderPipeline({
            layout: 'auto',
            vertex: { module, entryPoint: vertex, buffers: [{ arrayStride: 24, attributes: [
                { shaderLocation: 0, offset: 0, format: 'float32x3' }, { shaderLocation: 1, offset: 12, format: 'float32x3' }] }] },
            ...fragment && { fragment: { module, entryPoint: fragment, targets: format ? [{ format }] : [] } },
            depthStencil: { format: depth_format, depthCompare: direction === 'reversed' ? 'greater' : 'less', depthWriteEnabled: true },
        });
    }

    /** One frame of a path: visibility of each pixel from above, 255 is lit. */
    async frame(path, values, seen) {
        const { device } = this, { map, direction, setup } = path, clip = { ...webgpu_clip_space, direction };
        const sun = wgsl.shadow('sun', { ...shadow_options(wgsl, path), set: 1 }), light = light_values(path, sun, clip, seen);
        const { block, views, edge_angle } = values(sun, light);
        const { grid: [columns], map_size: [tile_width, tile_height], layers, size, format } = sun.target;
        const is_depth = map.startsWith('depth') || map.startsWith('shadow'), compares = map.startsWith('shadow');
        const bends = setup === 'dual_paraboloid_light', four = setup === 'tetrahedron_light';
        const depth_format = is_depth ? formats[format] : 'depth32float';
        const color_format = is_depth ? undefined : formats[format];
        const far = direction === 'reversed' ? 0 : 1, [red, green, blue, alpha] = sun.cleared;

        // The depth pass
        const items = [sun.vertex_pass(clip), ...is_depth ? [] : [sun.depth_pass], ...four ? [wgsl.snippets.tetrahedron_face_of] : []];
        const dropped = `if (umbrage_tetrahedron_face_of(floor(at.xy), ${tile_width}.0) != pass_of.number) { discard; }`;
        const body = (four ? dropped : '') + (is_depth ? '' : ' return umbrage_write_sun(at.z);');
        const depth_module = device.createShaderModule({ code: `${wgsl.text(items)}
struct pass_uniforms { to_clip: mat4x4f, anchor: vec4f, number: f32 }
@group(0) @binding(0) var<uniform> pass_of: pass_uniforms;
@vertex fn place(@location(0) world: vec3f) -> @builtin(position) vec4f {
    return umbrage_vertex_sun(pass_of.to_clip, world, pass_of.anchor${bends ? ', pass_of.number' : ''});
}
@fragment fn write(@builtin(position) at: vec4f)${is_depth ? '' : ' -> @location(0) vec4f'} { ${body} }` });
        const depth_pass = this.pipeline(depth_module, ['place', body && 'write'], color_format, depth_format, direction);
        const flags = usage.target | usage.texture, casters = vertices(light_from(path), edge_angle), commands = device.createCommandEncoder();
        const depths = this.texture(depth_format, size, is_depth ? layers : 1, flags);
        const colors = is_depth ? undefined : this.texture(color_format, size, layers, flags);
        const layer_of = (texture, baseArrayLayer) => texture.createView({ dimension: '2d', baseArrayLayer, arrayLayerCount: 1 });
        const caster_buffer = this.buffer(casters, GPUBufferUsage.VERTEX);
        views.forEach(({ to_clip, anchor }, i) => {
            const layer = layers > 1 ? i : 0, tile = layers > 1 || four ? 0 : i, op = i === 0 || layers > 1 ? 'clear' : 'load';
            const pass = commands.beginRenderPass({
                colorAttachments: colors
                    ? [{ view: layer_of(colors, layer), loadOp: op, storeOp: 'store', clearValue: [red, green, blue, alpha] }] : [],
                depthStencilAttachment: { view: layer_of(depths, is_depth ? layer : 0), depthClearValue: far,
                    depthLoadOp: op, depthStoreOp: 'store' },
            });
            pass.setPipeline(depth_pass);
            pass.setViewport(tile % columns * tile_width, Math.floor(tile / columns) * tile_height, tile_width, tile_height, 0, 1);
            const uniforms = this.buffer(new Float32Array([...to_clip, ...anchor, i, 0, 0, 0]), GPUBufferUsage.UNIFORM);
            pass.setBindGroup(0, this.group(depth_pass, 0, { buffer: uniforms }));
            pass.setVertexBuffer(0, caster_buffer);
            pass.draw(casters.length / 6);
            pass.end();
        });

        // The picture
        const turns = path.filter.match(/^(disc|pcss|dpcf)/) ? ', at.place.xy' : '';
        const view_module = device.createShaderModule({ code: `${wgsl.text([sun])}
@group(0) @binding(0) var<uniform> to_clip: mat4x4f;
struct corner { @builtin(position) place: vec4f, @location(0) world: vec3f, @location(1) normal: vec3f }
@vertex fn place(@location(0) world: vec3f, @location(1) normal: vec3f) -> corner { return corner(to_clip * vec4f(world, 1.0), world, normal); }
@fragment fn color(at: corner) -> @location(0) vec4f { return vec4f(vec3f(umbrage_sun(at.world, at.normal${turns})), 1.0); }` });
        const view = this.pipeline(view_module, ['place', 'color'], 'rgba8unorm', 'depth32float', 'forward');
        const drawn = this.texture('rgba8unorm', picture, 1, usage.target | usage.copied), floor = vertices();
        const pass = commands.beginRenderPass({
            colorAttachments: [{ view: drawn.createView(), loadOp: 'clear', storeOp: 'store', clearValue: [0, 0, 1, 1] }],
            depthStencilAttachment: { view: this.texture('depth32float', picture, 1, usage.target).createView(),
                depthClearValue: 1, depthLoadOp: 'clear', depthStoreOp: 'store' },
        });
        pass.setPipeline(view);
        const matrix = this.buffer(new Float32Array(camera({ ...clip, direction: 'forward' }).to_clip), GPUBufferUsage.UNIFORM);
        pass.setBindGroup(0, this.group(view, 0, { buffer: matrix }));
        const layered = map.includes('array'), maps = (colors ?? depths).createView({ dimension: layered ? '2d-array' : '2d' });
        const sampler = compares && device.createSampler({ compare: direction === 'reversed' ? 'greater-equal' : 'less-equal' });
        pass.setBindGroup(1, this.group(view, 1, { buffer: this.buffer(block, GPUBufferUsage.UNIFORM) }, maps, ...sampler ? [sampler] : []));
        pass.setVertexBuffer(0, this.buffer(floor, GPUBufferUsage.VERTEX));
        pass.draw(floor.length / 6);
        pass.end();
        const [width, height] = picture, row = Math.ceil(4 * width / 256) * 256;
        const read = device.createBuffer({ size: row * height, usage: GPUBufferUsage.COPY_DST | GPUBufferUsage.MAP_READ });
        commands.copyTextureToBuffer({ texture: drawn }, { buffer: read, bytesPerRow: row }, picture);
        device.queue.submit([commands.finish()]);
        await read.mapAsync(GPUMapMode.READ);
        if (this.error) throw new Error(this.error);
        const pixels = new Uint8Array(read.getMappedRange());
        return Array.from({ length: width * height }, (_, i) => pixels[Math.floor(i / width) * row + 4 * (i % width)]);
    }
}
