// umbrage @version@, MIT License. Types of the texts in one language.
import type { BindingOf, BoundOf, EncodingName, EncodingOf, Exactness, Filter, FilterArgument, SnippetOf, Texture, WithReversed } from './module/types.mjs';

export type { Exactness, Filter, FilterArgument, Texture };
export type Snippet = SnippetOf<'@language@'>;
export type Binding = BindingOf<'@language@'>;
export type Bound = BoundOf<'@language@'>;
export type Encoding = WithReversed<EncodingOf<'@language@'>>;

/** The snippet as functions for one map: umbrage_<what>_<name>, or without a suffix when the name is empty. */
export function bind(what: Snippet, name: string, map?: Binding): Bound;
/** The worst tier of a text: of the snippets, of all they need, and of the hooks of the maps they are bound to. What a
 *  binding says in the shader's own language has no tier. */
export function exactness(items: readonly (Snippet | Bound)[]): Exactness;
@texts@
/** All of them by name, for tools that walk them. */
export const snippets: Readonly<Record<string, Snippet>>;
export const encodings: Readonly<Record<EncodingName, Encoding>>;

@names@
