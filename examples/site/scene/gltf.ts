// SPDX-License-Identifier: MIT
//
// Reads glTF 2.0, binary or with embedded data, without textures: its meshes where its nodes place them.
import { WebIO, type JSONDocument, type Node } from '@gltf-transform/core';
import { mat3, mat4, vec3 } from 'gl-matrix';

import { most_triangles, Refused, type Read } from './load';

export async function read_gltf(name: string, file: ArrayBuffer): Promise<Read> {
    const binary = name.toLowerCase().endsWith('.glb'), io = new WebIO();
    let document;
    try {
        const json = binary ? (await io.binaryToJSON(new Uint8Array(file))).json : JSON.parse(new TextDecoder().decode(file));
        refuse_compressed(name, json);
        document = binary ? await io.readBinary(new Uint8Array(file)) : await io.readJSON({ json, resources: embedded(name, json) });
    } catch (error) {
        if (error instanceof Refused) throw error;
        throw new Refused(`${name} is not a glTF file that can be read: ${error instanceof Error ? error.message : error}`);
    }
    const out = { positions: [] as Float32Array[], normals: [] as Float32Array[], colors: [] as Float32Array[], indices: [] as Uint32Array[] };
    let vertices = 0, triangles = 0;
    for (const node of document.getRoot().listNodes())
        for (const part of node.getMesh()?.listPrimitives() ?? []) {
            if (part.getMode() !== 4) continue;  // points and lines cast no shadow
            const position = part.getAttribute('POSITION');
            if (!position) continue;
            const count = position.getCount(), list = part.getIndices()?.getArray() ?? Uint32Array.from({ length: count }, (_, i) => i);
            if ((triangles += list.length / 3) > most_triangles) throw new Refused(`${name} has more than 5 million triangles.`);
            const color = part.getMaterial()?.getBaseColorFactor() ?? [0.6, 0.6, 0.6, 1];
            const placed = place(node, count, i => position.getElement(i, []), part.getAttribute('NORMAL'));
            out.positions.push(placed.positions);
            out.normals.push(placed.normals);
            out.colors.push(Float32Array.from({ length: 3 * count }, (_, i) => color[i % 3]!));
            const base = vertices;
            out.indices.push(Uint32Array.from(list, (index: number) => base + index));
            vertices += count;
        }
    const joined = <T extends Float32Array | Uint32Array>(parts: T[], type: new (size: number) => T): T => {
        const all = new type(parts.reduce((sum, part) => sum + part.length, 0));
        let at = 0;
        for (const part of parts) all.set(part, at), at += part.length;
        return all;
    };
    const normals = joined(out.normals, Float32Array);
    return { positions: joined(out.positions, Float32Array), colors: joined(out.colors, Float32Array), indices: joined(out.indices, Uint32Array),
        ...normals.some(n => n !== 0) && { normals } };
}

function place(node: Node, count: number, element: (i: number) => number[], normal: { getElement(i: number, to: number[]): number[] } | null) {
    const matrix = node.getWorldMatrix() as unknown as mat4, turn = mat3.normalFromMat4(mat3.create(), matrix) ?? mat3.create();
    const positions = new Float32Array(3 * count), normals = new Float32Array(3 * count), v = vec3.create();
    for (let i = 0; i < count; ++i) {
        positions.set(vec3.transformMat4(v, element(i) as unknown as vec3, matrix), 3 * i);
        if (normal) normals.set(vec3.transformMat3(v, normal.getElement(i, []) as unknown as vec3, turn), 3 * i);
    }
    return { positions, normals };
}

type Json = JSONDocument['json'];

function refuse_compressed(name: string, json: Json) {
    const known: Record<string, string> = { KHR_draco_mesh_compression: 'Draco', EXT_meshopt_compression: 'meshoptimizer' };
    for (const extension of json.extensionsRequired ?? [])
        if (extension in known) throw new Refused(`${name} is compressed by ${known[extension]}, which this page does not read. Export it uncompressed.`);
        else if (/mesh|quantization/.test(extension)) throw new Refused(`${name} needs ${extension}, which this page does not read.`);
}

/** Data of buffers that a JSON file holds itself. Textures are left out. */
function embedded(name: string, json: Json): JSONDocument['resources'] {
    json.images = [], json.textures = [];
    for (const material of json.materials ?? [])
        for (const place of [material, material.pbrMetallicRoughness ?? {}])
            for (const key of Object.keys(place)) if (/Texture$/.test(key)) delete (place as Record<string, unknown>)[key];
    for (const { uri } of json.buffers ?? [])
        if (uri !== undefined && !uri.startsWith('data:'))
            throw new Refused(`${name} keeps its vertices in ${uri}. Drop a .glb file, which holds everything.`);
    return {};
}
