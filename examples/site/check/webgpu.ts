// SPDX-License-Identifier: MIT
//
// Runs a call in WebGPU: a triangle over a target that has a pixel for each input.
import {
    explained,
    filters_floats,
    own_bindings,
    own_group,
    Refused,
    texture_of,
    wgsl_program,
    type Call,
} from './program';
import type { Reading } from './read';
import type { Batch, Gpu, Prepared } from './run';

const width = 256,
    bytes_a_row = width * 16;

const triangle = `@vertex fn main(@builtin(vertex_index) i: u32) -> @builtin(position) vec4f {
    return vec4f(f32(i & 1u) * 4.0 - 1.0, f32(i >> 1) * 4.0 - 1.0, 0.0, 1.0);
}`;

/** Depth textures of floats are drawn: WebGPU writes no data into them. */
const copy_depth = `@group(0) @binding(0) var depths: texture_2d<f32>;
@fragment fn main(@builtin(position) pixel: vec4f) -> @builtin(frag_depth) f32 {
    return textureLoad(depths, vec2i(pixel.xy), 0).x;
}`;

export async function open_webgpu(): Promise<Gpu> {
    if (!navigator.gpu)
        throw new Refused('This browser offers no WebGPU, which WGSL needs. Chrome, Edge and Safari 26 have it.');
    const adapter = await navigator.gpu.requestAdapter();
    if (!adapter) throw new Refused('This browser has WebGPU, but no GPU that it lets WebGPU use.');
    const smooth = adapter.features.has('float32-filterable'),
        { info } = adapter;
    const device = await adapter.requestDevice({ requiredFeatures: smooth ? ['float32-filterable'] : [] });
    return {
        name: 'WebGPU',
        device: info.description || [info.vendor, info.architecture].filter(Boolean).join(' ') || 'unknown GPU',
        async prepare(call, reading) {
            if (filters_floats(call) && !smooth) throw new Refused('WebGPU does not filter textures of floats here.');
            return prepare(device, call, reading, smooth);
        },
    };
}

async function checked<T>(device: GPUDevice, make: () => T | Promise<T>): Promise<T> {
    device.pushErrorScope('validation');
    const made = await make(),
        error = await device.popErrorScope();
    if (error) throw new Refused(`WebGPU refuses the shader: ${error.message}`);
    return made;
}

/** Compiles, and throws the compiler's messages by the reader's lines. */
async function compile(device: GPUDevice, call: Call, reading: Reading): Promise<GPUShaderModule> {
    const program = wgsl_program(call, reading);
    device.pushErrorScope('validation'); // the messages say it better
    const module = device.createShaderModule({ code: program.shader }),
        { messages } = await module.getCompilationInfo();
    await device.popErrorScope();
    const errors = messages
        .filter(each => each.type === 'error')
        .map(each => ({ line: each.lineNum, words: each.message }));
    if (errors.length) throw explained(call, program, errors);
    return module;
}

/** Layout entry of a texture or sampler of that name. `smooth`: textures of floats can be filtered. */
function layout_entry(binding: number, name: string, smooth: boolean): GPUBindGroupLayoutEntry {
    const visibility = GPUShaderStage.FRAGMENT;
    if (name === 'shadow_map_sampler') return { binding, visibility, sampler: { type: 'comparison' } };
    if (name === 'linear_map_sampler')
        return { binding, visibility, sampler: { type: smooth ? 'filtering' : 'non-filtering' } };
    if (name === 'map_sampler') return { binding, visibility, sampler: { type: 'non-filtering' } };
    if (name === 'shadow_map') return { binding, visibility, texture: { sampleType: 'depth' } };
    return { binding, visibility, texture: { sampleType: smooth ? 'float' : 'unfilterable-float' } };
}

async function prepare(device: GPUDevice, call: Call, reading: Reading, smooth: boolean): Promise<Prepared> {
    const module = await compile(device, call, reading),
        used: { group: number; binding: number; what: string }[] = [];
    for (const [binding, [what]] of own_bindings.entries())
        if (!reading.globals.some(each => each.name === what)) used.push({ group: own_group, binding, what });
    for (const each of call.textures) {
        const { group, binding } = reading.globals.find(({ name }) => name === each.name)!;
        used.push({ group, binding, what: texture_of(each) });
    }
    const groups = Array.from({ length: own_group + 1 }, (_, group) => used.filter(each => each.group === group));
    const layouts = groups.map(all =>
        device.createBindGroupLayout({ entries: all.map(({ binding, what }) => layout_entry(binding, what, smooth)) }),
    );
    const pipeline = await checked(device, () =>
        device.createRenderPipeline({
            layout: device.createPipelineLayout({ bindGroupLayouts: layouts }),
            vertex: { module: device.createShaderModule({ code: triangle }) },
            fragment: { module, entryPoint: 'umbrage_check', targets: [{ format: 'rgba32float' }] },
        }),
    );
    const sampler = (filter: GPUFilterMode, compare?: GPUCompareFunction) =>
        device.createSampler({ magFilter: filter, minFilter: filter, ...(compare && { compare }) });
    const samplers = {
        map_sampler: sampler('nearest'),
        linear_map_sampler: sampler(smooth ? 'linear' : 'nearest'),
        shadow_map_sampler: sampler('linear', 'less-equal'),
    };
    return {
        run: batch =>
            checked(device, async () => {
                const rows = Math.ceil(batch.inputs.length / 4 / width),
                    padded = new Float32Array(width * rows * 4);
                padded.set(batch.inputs);
                const inputs = float_texture(device, 'rgba32float', [width, rows], padded),
                    [map, depths] = map_textures(device, batch);
                const resources: Record<string, GPUBindingResource> = {
                    umbrage_inputs: inputs.createView(),
                    umbrage_map: map.createView(),
                    map: map.createView(),
                    linear_map: map.createView(),
                    shadow_map: depths.createView(),
                    ...samplers,
                };
                const target = device.createTexture({
                    format: 'rgba32float',
                    size: [width, rows],
                    usage: GPUTextureUsage.RENDER_ATTACHMENT | GPUTextureUsage.COPY_SRC,
                });
                const read = device.createBuffer({
                    size: bytes_a_row * rows,
                    usage: GPUBufferUsage.COPY_DST | GPUBufferUsage.MAP_READ,
                });
                const commands = device.createCommandEncoder();
                const pass = commands.beginRenderPass({
                    colorAttachments: [{ view: target.createView(), loadOp: 'clear', storeOp: 'store' }],
                });
                pass.setPipeline(pipeline);
                groups.forEach((all, group) =>
                    pass.setBindGroup(
                        group,
                        device.createBindGroup({
                            layout: layouts[group]!,
                            entries: all.map(({ binding, what }) => ({ binding, resource: resources[what]! })),
                        }),
                    ),
                );
                pass.draw(3);
                pass.end();
                commands.copyTextureToBuffer({ texture: target }, { buffer: read, bytesPerRow: bytes_a_row }, [
                    width,
                    rows,
                ]);
                device.queue.submit([commands.finish()]);
                await read.mapAsync(GPUMapMode.READ);
                const result = new Float32Array(read.getMappedRange().slice(0, batch.inputs.byteLength));
                for (const each of [inputs, map, depths, target, read]) each.destroy();
                return result;
            }),
    };
}

function float_texture(
    device: GPUDevice,
    format: 'rgba32float' | 'r32float',
    size: [number, number],
    values: Float32Array<ArrayBuffer>,
): GPUTexture {
    const texture = device.createTexture({
        format,
        size,
        usage: GPUTextureUsage.COPY_DST | GPUTextureUsage.TEXTURE_BINDING,
    });
    device.queue.writeTexture({ texture }, values, { bytesPerRow: size[0] * (format === 'r32float' ? 4 : 16) }, size);
    return texture;
}

/** The depths as floats and as a depth texture; of codecs, which have no map, one texel. */
function map_textures(device: GPUDevice, { size, map }: Batch): [GPUTexture, GPUTexture] {
    const floats = map.length
        ? float_texture(device, 'r32float', size, map)
        : float_texture(device, 'r32float', [1, 1], new Float32Array(1));
    const depths = device.createTexture({
        format: 'depth32float',
        size: map.length ? size : [1, 1],
        usage: GPUTextureUsage.RENDER_ATTACHMENT | GPUTextureUsage.TEXTURE_BINDING,
    });
    const pipeline = device.createRenderPipeline({
        layout: 'auto',
        vertex: { module: device.createShaderModule({ code: triangle }) },
        fragment: { module: device.createShaderModule({ code: copy_depth }), targets: [] },
        depthStencil: { format: 'depth32float', depthWriteEnabled: true, depthCompare: 'always' },
    });
    const commands = device.createCommandEncoder(),
        pass = commands.beginRenderPass({
            colorAttachments: [],
            depthStencilAttachment: {
                view: depths.createView(),
                depthLoadOp: 'clear',
                depthClearValue: 0,
                depthStoreOp: 'store',
            },
        });
    pass.setPipeline(pipeline);
    pass.setBindGroup(
        0,
        device.createBindGroup({
            layout: pipeline.getBindGroupLayout(0),
            entries: [{ binding: 0, resource: floats.createView() }],
        }),
    );
    pass.draw(3);
    pass.end();
    device.queue.submit([commands.finish()]);
    return [floats, depths];
}
