// SPDX-License-Identifier: MIT
//
// Triangles to draw, and the scene files that write_scenes.cpp writes.

export interface Mesh {
    readonly positions: Float32Array;  // three a vertex
    readonly normals: Int8Array;       // four a vertex, the fourth 0
    readonly colors: Uint8Array;       // four a vertex: square roots of linear ones
    readonly indices: Uint32Array;     // three a triangle
}

/** The part of a mesh in many places, each a 4 x 4 matrix, column by column. */
export interface Part extends Mesh {
    readonly places: Float32Array;
}

export interface Box { low: [number, number, number]; high: [number, number, number] }

/** A scene: its parts, their box, and the point that cameras look at. */
export interface Scene {
    readonly parts: readonly Part[];
    readonly box: Box;
    readonly target: readonly [number, number, number];
    /** From the camera to the target, in world units, at distance 1 of the state. */
    readonly camera_distance: number;
    /** Vertical angle of the camera's view. */
    readonly view_degrees: number;
}

export const identity = new Float32Array([1, 0, 0, 0, 0, 1, 0, 0, 0, 0, 1, 0, 0, 0, 0, 1]);

/** Box around all places of all parts. */
export function box_of(parts: readonly Part[]): Box {
    const low: Box['low'] = [Infinity, Infinity, Infinity], high: Box['high'] = [-Infinity, -Infinity, -Infinity];
    for (const { positions, places } of parts)
        for (let p = 0; p < places.length; p += 16)
            for (let v = 0; v < positions.length; v += 3)
                for (let axis = 0; axis < 3; ++axis) {
                    const at = places[p + axis]! * positions[v]! + places[p + 4 + axis]! * positions[v + 1]!
                        + places[p + 8 + axis]! * positions[v + 2]! + places[p + 12 + axis]!;
                    if (at < low[axis]!) low[axis] = at;
                    if (at > high[axis]!) high[axis] = at;
                }
    return { low, high };
}

/** Places in groups that stand together: halved along their longer side until few are left. */
export function groups_of(places: Float32Array): Float32Array[] {
    const count = places.length / 16, most = 64;
    if (count <= most) return [places];
    const at = (place: number, axis: number) => places[16 * place + 12 + axis]!;
    const extent = (axis: number) => {
        let low = Infinity, high = -Infinity;
        for (let i = 0; i < count; ++i) low = Math.min(low, at(i, axis)), high = Math.max(high, at(i, axis));
        return high - low;
    };
    const axis = extent(0) > extent(2) ? 0 : 2, order = Array.from({ length: count }, (_, i) => i).sort((a, b) => at(a, axis) - at(b, axis));
    return [order.slice(0, count / 2), order.slice(count / 2)].flatMap(half => {
        const own = new Float32Array(16 * half.length);
        half.forEach((place, i) => own.set(places.subarray(16 * place, 16 * place + 16), 16 * i));
        return groups_of(own);
    });
}

/** Reads a scene file. */
export function read_scene(file: ArrayBuffer): { parts: Part[]; target: [number, number, number] } {
    const view = new DataView(file), parts: Part[] = [], target = [0, 4, 8].map(byte => view.getFloat32(byte, true)) as [number, number, number];
    let at = 12;
    const number = () => view.getUint32((at += 4) - 4, true);
    const take = <T>(type: new (buffer: ArrayBuffer, at: number, count: number) => T, count: number, bytes: number) => {
        const values = new type(file, at, count);
        at += count * bytes;
        return values;
    };
    for (let left = number(); left > 0; --left) {
        const vertices = number(), triangles = number(), places = number();
        parts.push({
            positions: take(Float32Array, 3 * vertices, 4),
            normals: take(Int8Array, 4 * vertices, 1),
            colors: take(Uint8Array, 4 * vertices, 1),
            indices: take(Uint32Array, 3 * triangles, 4),
            places: take(Float32Array, 16 * places, 4),
        });
    }
    return { parts, target };
}
