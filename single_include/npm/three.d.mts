// SPDX-License-Identifier: MIT
//
// Types of umbrage/three. three.js itself comes with no types; @types/three fits.
import type { Snippet } from '../umbrage.mjs';

/** What the addon uses of three.js: pass the whole module. */
export interface Three {
    readonly REVISION: string;
    readonly ShaderChunk: object;
    readonly BasicShadowMap: number;
    readonly WebGLRenderer: Function;
    readonly Material: { readonly prototype: object };
}

export interface Scene { traverse(use: (object: any) => void): void }

export interface Options {
    /** A filter that reads depths: hard, castano_dyadic5, disc16, pcss16, ... A light's shadow.radius is a disc's radius in
     *  texels, and scales the softness of pcss and dpcf. */
    readonly filter: Snippet;
    /** In place of the filter's defaults, see filter.filter.arguments; but for rotation, of which each pixel has its own. */
    readonly arguments?: Readonly<Record<string, number | readonly number[]>>;
    /** Colors that say what is wrong with a receiver, as umbrage_probe_color has them; gray: no light reached it. */
    readonly probe?: boolean;
    /** A scene that was drawn before: its materials are compiled again. */
    readonly scene?: Scene;
}

/** Puts a filter in place of three.js' own, for all lights but point lights, and for all materials. Sets the renderer's
 *  shadowMap.type. A second call changes the filter.
 *  @throws Error   another copy of three.js than the renderer's, one older than r182, one whose shader text is not known,
 *                  options that do not fit */
export function install(THREE: Three, renderer: object, options: Options): void;

/** Restores three.js' own text, byte for byte, and its type of shadow map.
 *  @throws Error   options that do not fit */
export function uninstall(THREE: Three, options?: { readonly scene?: Scene }): void;
