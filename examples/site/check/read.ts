// SPDX-License-Identifier: MIT
//
// Reads what a shader declares outside of functions: its functions with their arguments, its uniforms, its outputs.
// It is no compiler. It finds names and types, so that the page can offer them; the browser's compiler judges the text.

export const languages = { glsl300: 'GLSL 300 es', glsl100: 'GLSL 100', wgsl: 'WGSL' } as const;
export type Language = keyof typeof languages;

/** Something that needs a value before the function can be called. */
export interface Needed {
    name: string;
    type: string;
}
export interface Signature {
    name: string;
    /** Empty: it returns nothing. */
    returns: string;
    arguments: Needed[];
    /** Line of the text, from 1. */
    line: number;
}
/** A variable of a shader's stage or group: a uniform, an input, an output. */
export interface Global extends Needed {
    kind: 'uniform' | 'input' | 'output';
    /** WGSL's numbers. */
    group: number;
    binding: number;
}
export interface Reading {
    functions: Signature[];
    globals: Global[];
    /** An #include, which no browser follows. */
    include: { line: number; file: string } | null;
}

const spaces = (text: string) => text.replace(/[^\n]/g, ' ');
const line_of = (text: string, at: number) => text.slice(0, at).split('\n').length;

/** The text with spaces for comments, at the same places. */
export const without_comments = (text: string) => text.replace(/\/\/[^\n]*|\/\*[^]*?(?:\*\/|$)/g, spaces);

/** The text with spaces between braces, so that only declarations are left. */
function without_bodies(text: string): string {
    let depth = 0,
        outer = '';
    for (const c of text) {
        if (c === '}') depth = Math.max(depth - 1, 0);
        outer += depth === 0 || c === '\n' ? c : ' ';
        if (c === '{') ++depth;
    }
    return outer;
}

/** Splits at commas, but not at those of array<f32, 4> or vec2(0.0, 1.0). */
function split(list: string): string[] {
    const parts = [''];
    let depth = 0;
    for (const c of list) {
        depth += '<(['.includes(c) ? 1 : '>)]'.includes(c) ? -1 : 0;
        if (c === ',' && depth === 0) parts.push('');
        else parts[parts.length - 1] += c;
    }
    return parts.map(part => part.trim()).filter(part => part !== '' && part !== 'void');
}

/** The language of a text, by words that the others do not have. */
export function language_of(text: string): Language {
    const code = without_comments(text);
    if (/\bfn\s+\w+\s*\(/.test(code)) return 'wgsl';
    const version = /^\s*#\s*version\s+(\d+)/m.exec(code);
    if (version) return Number(version[1]) === 100 ? 'glsl100' : 'glsl300';
    return /\b(texture2D\w*|textureCube|gl_FragColor|varying|attribute)\b/.test(code) ? 'glsl100' : 'glsl300';
}

/** "const highp vec2 uv" as a type and a name, which are its last words; an array's size belongs to its type. */
function glsl_argument(words: string): Needed {
    const [, type = words, name = '', array = ''] = /(\w+)\s+(\w+)\s*(\[.*\])?$/.exec(words) ?? [];
    return { name, type: type + array };
}

function read_glsl(code: string, outer: string): Pick<Reading, 'functions' | 'globals'> {
    const functions: Signature[] = [],
        globals: Global[] = [];
    for (const match of outer.matchAll(/\b(\w+)\s+(\w+)\s*\(([^(){};]*)\)\s*\{/g)) {
        const [, returns = '', name = '', list = ''] = match;
        functions.push({
            name,
            returns: returns === 'void' ? '' : returns,
            arguments: split(list).map(glsl_argument),
            line: line_of(code, match.index),
        });
    }
    const kinds = { uniform: 'uniform', in: 'input', varying: 'input', out: 'output' } as const;
    for (const [, kind, rest = ''] of outer.matchAll(
        /(?:^|[;}\n)])\s*(?:flat\s+|smooth\s+)?(uniform|in|varying|out)\s+([^;{}()]*);/g,
    )) {
        const [first = '', ...more] = split(rest),
            { type, name } = glsl_argument(first);
        for (const each of [name, ...more])
            globals.push({ kind: kinds[kind as keyof typeof kinds], type, name: each, group: 0, binding: 0 });
    }
    return { functions, globals };
}

function read_wgsl(code: string, outer: string): Pick<Reading, 'functions' | 'globals'> {
    const functions: Signature[] = [],
        globals: Global[] = [];
    const argument = (words: string): Needed => {
        const [name = '', ...type] = words.split(':');
        return { name: name.trim(), type: type.join(':').replace(/\s+/g, '') };
    };
    for (const match of outer.matchAll(/\bfn\s+(\w+)\s*\(([^)]*)\)\s*(?:->\s*([\w<>,\s]+?))?\s*\{/g)) {
        const [, name = '', list = '', returns = ''] = match;
        functions.push({
            name,
            returns: returns.replace(/\s+/g, ''),
            arguments: split(list).map(argument),
            line: line_of(code, match.index),
        });
    }
    for (const [attributes, name = '', type = ''] of outer.matchAll(
        /(?:@\w+\s*\([^)]*\)\s*)+var(?:\s*<[^>]*>)?\s+(\w+)\s*:\s*([^;=]*);/g,
    )) {
        const number = (word: string) => Number(new RegExp(`@${word}\\s*\\(\\s*(\\d+)`).exec(attributes)?.[1] ?? 0);
        globals.push({
            kind: 'uniform',
            name,
            type: type.replace(/\s+/g, ''),
            group: number('group'),
            binding: number('binding'),
        });
    }
    return { functions, globals };
}

export function read(text: string, language: Language): Reading {
    let code = without_comments(text);
    const include = /^[ \t]*#\s*include\s*([<"]?[^\n]*)/m.exec(code);
    if (language !== 'wgsl') code = code.replace(/^[ \t]*#(?:\\\n|[^\n])*/gm, spaces); // directives
    const outer = without_bodies(code),
        { functions, globals } = language === 'wgsl' ? read_wgsl(code, outer) : read_glsl(code, outer);
    return {
        functions: functions.filter(
            ({ name }, i) =>
                name !== 'main' && functions.findIndex(other => signature(other) === signature(functions[i]!)) === i,
        ),
        globals,
        include: include && { line: line_of(code, include.index), file: include[1]!.trim() },
    };
}

/** A function's name with its arguments' types, which tell overloads apart: "shadow(sampler2D, vec2, float)". */
export const signature = (of: Signature) => `${of.name}(${of.arguments.map(each => each.type).join(', ')})`;
