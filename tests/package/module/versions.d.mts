export type Version =
    '100' | '110' | '120' | '130' | '150' | '300 es' | '310 es' | '320 es' | '330' | '430' | '450' | '460';
export const versions: readonly Version[];
/** True when the snippet, or the snippet bound to its map, compiles in a dialect of GLSL.
 *  @throws Error   another version */
export function supports(item: Snippet | Bound, version: Version): boolean;
/** The beginning of a GLSL shader: #version, preamble, the snippets and all they need. A preamble brings `precise` to
 *  310 es by `#extension GL_EXT_gpu_shader5 : require` and `#define UMBRAGE_PRECISE precise`. */
export function source(version: Version, items: readonly (Snippet | Bound)[], preamble?: string): string;
/** A GLSL text of the snippets and all they need, to paste into any shader; or into one of the version, for engines whose
 *  preprocessors do not know __VERSION__. */
export function text(items: readonly (Snippet | Bound)[], version?: Version): string;
