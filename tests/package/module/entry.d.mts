// umbrage @version@, MIT License. Types of the texts in one language.
import type { BindingOf, BoundOf, DebugOf, EncodingName, EncodingOf, Exactness, Filter, FilterArgument, LightOf, ShadowOf,
    ShadowOptionsOf, SnippetOf, Texture, WithReversed } from './module/types.mjs';

export type { Exactness, Filter, FilterArgument, Texture };
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
@texts@
/** All of them by name, for tools that walk them. */
export const snippets: Readonly<Record<string, Snippet>>;
export const encodings: Readonly<Record<EncodingName, Encoding>>;

@names@
