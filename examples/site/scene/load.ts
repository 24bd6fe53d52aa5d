// SPDX-License-Identifier: MIT
//
// Makes a scene of a file that a visitor dropped. Whatever cannot be drawn is refused in a sentence.
import { read_obj } from './obj';
import { box_of, identity, type Mesh, type Part } from './mesh';

export const most_triangles = 5e6;

/** A reason to refuse a file, in words for the visitor. */
export class Refused extends Error {}

/** Vertices of triangles as a reader found them; normals and colors are optional, three floats a vertex. */
export interface Read {
    positions: Float32Array;
    normals?: Float32Array;
    colors?: Float32Array;
    indices: Uint32Array;
}

export async function load(name: string, file: ArrayBuffer): Promise<Part[]> {
    if (file.byteLength === 0) throw new Refused(`${name} is empty.`);
    const kind = name.toLowerCase().match(/\.[a-z0-9]+$/)?.[0];
    let read: Read;
    if (kind === '.obj') read = read_obj(name, new TextDecoder().decode(file));
    else if (kind === '.glb' || kind === '.gltf') read = await (await import('./gltf')).read_gltf(name, file);
    else throw new Refused(`${name} is neither OBJ nor glTF: drop a file that ends in .obj, .gltf or .glb.`);
    return [standing(name, read)];
}

function standing(name: string, { positions, normals, colors, indices }: Read): Part {
    if (indices.length === 0) throw new Refused(`${name} has no triangles.`);
    if (indices.length > 3 * most_triangles)
        throw new Refused(`${name} has ${indices.length / 3} triangles. At most 5 million are drawn.`);
    const vertices = positions.length / 3;
    for (const index of indices)
        if (!(index < vertices)) throw new Refused(`${name} has a triangle with vertex ${index}, but ${vertices} vertices.`);
    for (const number of positions)
        if (!Number.isFinite(number)) throw new Refused(`${name} has a position that is not a finite number.`);

    const mesh = { positions, normals: new Int8Array(4 * vertices), colors: new Uint8Array(4 * vertices).fill(200), indices };
    const { low, high } = box_of([{ ...mesh, places: identity }]);
    const extent = Math.max(high[0] - low[0], high[1] - low[1], high[2] - low[2]);
    if (!(extent > 0 && Number.isFinite(extent))) throw new Refused(`${name} has no extent: all its vertices are in one place.`);
    const scale = 2 / extent, middle = [(low[0] + high[0]) / 2, low[1], (low[2] + high[2]) / 2];
    for (let i = 0; i < positions.length; ++i) positions[i] = (positions[i]! - middle[i % 3]!) * scale;
    const smooth = normals ?? normals_of(positions, indices);
    for (let v = 0; v < vertices; ++v) {
        const length = Math.hypot(smooth[3 * v]!, smooth[3 * v + 1]!, smooth[3 * v + 2]!) || 1;
        for (let c = 0; c < 3; ++c) {
            mesh.normals[4 * v + c] = Math.round(127 * smooth[3 * v + c]! / length);
            if (colors) mesh.colors[4 * v + c] = Math.round(255 * Math.sqrt(Math.min(Math.max(colors[3 * v + c]!, 0), 1)));
        }
    }
    return with_floor(mesh);
}

/** Normals of vertices, from the triangles around each, larger ones weigh more. */
function normals_of(positions: Float32Array, indices: Uint32Array): Float32Array {
    const normals = new Float32Array(positions.length);
    for (let t = 0; t < indices.length; t += 3) {
        const [a, b, c] = [3 * indices[t]!, 3 * indices[t + 1]!, 3 * indices[t + 2]!];
        const edge = (to: number, axis: number) => positions[to + axis]! - positions[a + axis]!;
        for (let axis = 0; axis < 3; ++axis) {
            const y = (axis + 1) % 3, z = (axis + 2) % 3, across = edge(b, y) * edge(c, z) - edge(b, z) * edge(c, y);
            for (const vertex of [a, b, c]) normals[vertex + axis]! += across;
        }
    }
    return normals;
}

function with_floor(mesh: Mesh): Part {
    const vertices = mesh.positions.length / 3, half = 4;
    const join = <T extends Float32Array | Int8Array | Uint8Array | Uint32Array>(all: T, more: number[]): T => {
        const joined = new (all.constructor as new (size: number) => T)(all.length + more.length);
        joined.set(all);
        joined.set(more, all.length);
        return joined;
    };
    const four = (values: number[]) => [values, values, values, values].flat();
    return {
        positions: join(mesh.positions, [-half, 0, half, half, 0, half, half, 0, -half, -half, 0, -half]),
        normals: join(mesh.normals, four([0, 127, 0, 0])),
        colors: join(mesh.colors, four([190, 184, 176, 255])),
        indices: join(mesh.indices, [0, 1, 2, 0, 2, 3].map(corner => vertices + corner)),
        places: identity,
    };
}
