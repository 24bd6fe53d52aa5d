// umbrage @version@, MIT License. Types of the texts in one language.
import type { BindingOf, BoundOf, DebugOf, EncodingName, EncodingOf, Exactness, Filter, FilterArgument, LightOf, ShadowOf,
    ShadowOptionsOf, SnippetName, SnippetOf, Texture, WithReversed } from './module/types.mjs';

export type { EncodingName, Exactness, Filter, FilterArgument, SnippetName, Texture };
export type Snippet = SnippetOf<'@language@'>;
export type Binding = BindingOf<'@language@'>;
export type Bound = BoundOf<'@language@'>;
export type Encoding = WithReversed<EncodingOf<'@language@'>>;
export type Light = LightOf<'@language@'>;
export type ShadowOptions = ShadowOptionsOf<'@language@'>;
export type Shadow = ShadowOf<'@language@'>;

/** The snippet as functions for one map: umbrage_<what>_<name>, or without a suffix when the name is empty. */
export function bind(what: Snippet, name: string, map?: Binding): Bound;
/** The worst tier of a text: of the snippets, of all they need, and of the hooks of the maps they are bound to. What a
 *  binding says in the shader's own language has no tier. */
export function exactness(items: readonly (Snippet | Bound)[]): Exactness;
/** For an option of shadow(). */
export const debug: DebugOf<'@language@'>;
/** A light's shadow as functions of a shader, its maps' target and its depth pass. */
export function shadow(name: string, options: ShadowOptions): Shadow;
//@ glsl
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
//@ hlsl msl wgsl
/** The snippets, bound or not, and all they need, each once: text to paste into any shader. */
export function text(items: readonly (Snippet | Bound)[]): string;
//@ wgsl
/** A function of a text. */
export interface WgslFunction {
    readonly name: string;
    /** From `fn` to its closing bracket. */
    readonly text: string;
    /** Names of those that it calls. */
    readonly needs: readonly string[];
}
/** The functions of a text of the items, in order, each behind those that it calls: for hosts that take one at a time. No item
 *  is a shadow, which declares a block and a map, too. */
export function functions(items: readonly (Snippet | Bound)[]): WgslFunction[];
//@
/** All of them by name, for tools that walk them. */
export const snippets: Readonly<Record<SnippetName, Snippet>>;
export const encodings: Readonly<Record<EncodingName, Encoding>>;

@names@
