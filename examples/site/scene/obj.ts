// SPDX-License-Identifier: MIT
//
// Reads Wavefront OBJ: positions with optional colors, normals, and faces of any number of corners.
import { Refused, type Read } from './load';

export function read_obj(name: string, text: string): Read {
    const positions: number[] = [], normals: number[] = [], colors: number[] = [];
    const out = { positions: [] as number[], normals: [] as number[], colors: [] as number[], indices: [] as number[] };
    const corners = new Map<string, number>();
    let line_number = 0, has_normals = true, has_colors = false;
    const refuse = (what: string) => new Refused(`${name}, line ${line_number}: ${what}`);

    function numbers(words: string[]): number[] {
        return words.map(word => {
            const number = Number(word);
            if (!Number.isFinite(number)) throw refuse(`"${word}" is not a finite number.`);
            return number;
        });
    }
    /** An index of OBJ, from 1 or from the end, as one from 0. */
    function index(word: string, count: number): number {
        const number = Number(word), from_0 = number < 0 ? count + number : number - 1;
        if (!Number.isInteger(number) || from_0 < 0 || from_0 >= count) throw refuse(`there is no vertex "${word}".`);
        return from_0;
    }
    function corner(word: string): number {
        const known = corners.get(word);
        if (known !== undefined) return known;
        const [v, , n] = word.split('/'), at = 3 * index(v!, positions.length / 3), made = corners.size;
        out.positions.push(...positions.slice(at, at + 3));
        out.colors.push(...colors.slice(at, at + 3));
        if (n) {
            const of = 3 * index(n, normals.length / 3);
            out.normals.push(...normals.slice(of, of + 3));
        } else has_normals = false;
        corners.set(word, made);
        return made;
    }

    for (const line of text.split('\n')) {
        ++line_number;
        const [what, ...words] = line.trim().split(/\s+/);
        if (what === 'v') {
            const values = numbers(words);
            if (values.length < 3) throw refuse('a vertex has three coordinates.');
            positions.push(...values.slice(0, 3));
            has_colors ||= values.length >= 6;
            colors.push(...values.length >= 6 ? values.slice(3, 6) : [0.6, 0.6, 0.6]);
        } else if (what === 'vn') {
            const values = numbers(words);
            if (values.length !== 3) throw refuse('a normal has three coordinates.');
            normals.push(...values);
        } else if (what === 'f') {
            if (words.length < 3) throw refuse('a face has three corners or more.');
            const around = words.map(corner);
            for (let i = 2; i < around.length; ++i) out.indices.push(around[0]!, around[i - 1]!, around[i]!);
        }
    }
    if (line_number > 0 && out.indices.length === 0) throw new Refused(`${name} has no faces: is it an OBJ file?`);
    return { positions: new Float32Array(out.positions), indices: new Uint32Array(out.indices),
        ...has_normals && { normals: new Float32Array(out.normals) }, ...has_colors && { colors: new Float32Array(out.colors) } };
}
