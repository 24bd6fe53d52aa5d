// umbrage @version@, MIT License. Types that all languages share.

/** What a snippet's text is in; those of one language do not go with those of another. */
export type Language = 'glsl' | 'hlsl' | 'msl' | 'wgsl';

/** How exactly a text and the C++ functions of its names agree: a to the bit, b to the bit in written order and
 *  elsewhere within n 2^-23 S (n is `operations`, S the formula with magnitudes), c within that bound or `within`. */
export type Exactness = 'a' | 'b' | 'c';

declare const is_of: unique symbol;

/** What a filter takes behind a receiver's coordinate and depth. */
export interface FilterArgument {
    readonly name: string;
    /** As GLSL calls it. */
    readonly type: 'int' | 'float' | 'vec2' | 'vec3' | 'vec4';
    /** The default. Of a rotation it is that of one pixel: umbrage_disc_rotation(pixel) gives each its own. */
    readonly value: number | readonly number[];
}

/** A filter: its function takes map, size, coordinate and receiver, then its arguments. */
export interface Filter {
    /** A comparison sampler serves where comparisons are all; else depths as they are, or moments in their place. */
    readonly reads: 'comparisons' | 'depths' | 'moments';
    /** From a receiver to the farthest center of a texel that is read, along an axis, in texels; of the default arguments. */
    readonly reach: number;
    readonly arguments: readonly FilterArgument[];
    /** Of a filter that takes several coordinates in place of one: where they lie from the receiver's, in texels. */
    readonly offsets?: readonly (readonly number[])[];
}

/** One function, as text, and what is known of it. */
export interface SnippetOf<L extends Language> {
    readonly [is_of]: L;
    readonly name: string;
    readonly summary: string;
    /** The worst tier of what it holds and needs, unbound. */
    readonly exactness: Exactness;
    readonly operations: number;
    readonly within: number;
    /** `within` holds in written order alone. */
    readonly as_written: boolean;
    /** The oldest GLSL that has it; every dialect where it is 100. */
    readonly lowest: '100' | '300 es';
    readonly needs: readonly SnippetOf<L>[];
    readonly filter?: Filter;
    /** The function for a 2D texture of depths, without what it needs. */
    readonly text: string;
}

/** What a map's texels lie in. */
export type Texture =
    'texture_2d' | 'atlas' | 'array' | 'cube' | 'cube_faces' | 'integer' | 'depth' | 'depth_array' | 'shadow' | 'shadow_array';

/** A map for shaders: where its texels are, and how they compare. Texts in it are in the shader's own language. */
export interface BindingOf<L extends Language> {
    texture?: Texture;
    direction?: 'forward' | 'reversed';
    /** Outside the map texels count as the far plane, lit, or as the nearest ones inside. Left out: bordered, but
     *  clamped for tiles, regions and faces of cubes. */
    outside?: 'bordered' | 'clamped';
    /** 2x2 texels at once; the sampler must clamp to the edge, but for regions. */
    gather?: boolean;
    /** Of `value`, four floats, as "umbrage_decode_rg11(value.xy, 1.0)"; else value.x. Where nothing is gathered
     *  also of `texel`, two floats, the number that was asked for. */
    depth?: string;
    /** How many components of `value` it reads. */
    channels?: number;
    /** Of `receiver` and `stored`, as "exp(40.0 * (stored - receiver))"; 1.0 is lit. Left out: by direction. With one's own
     *  no receiver is beyond the far plane. */
    compare?: string;
    /** Moves each depth along the receiver's plane: functions take the plane's slope and the receiver's coordinate, two
     *  floats each, behind the map. Not where a sampler gathers comparisons. */
    receiver_plane?: boolean;
    /** The map's first texel in the texture: two floats. */
    origin?: string;
    /** For regions of textures that are read by coordinates: two floats. */
    texture_size?: string;
    /** In place of the texture's: what stands for the map in declarations, in calls, and a texel `at`. */
    parameters?: string;
    arguments?: string;
    texel?: string;
    /** What these texts call. */
    needs?: readonly SnippetOf<L>[];
}

/** A map of texels in an encoding, and how they come about: without blending, of one sample, in a target that is not sRGB. */
export interface EncodingOf<L extends Language> extends Readonly<BindingOf<L>> {
    readonly name: string;
    /** The target's format, as OpenGL calls it: RG8, R16, RGB10_A2, ... */
    readonly format: string;
    /** Format of a depth texture that holds the encoding: DEPTH_COMPONENT32F, ... Empty: none does. */
    readonly depth_format: string;
    /** What the target is cleared to: where nothing is drawn all is lit. Channels that the texel lacks are 0. */
    readonly cleared: readonly [number, number, number, number];
    /** What the depth pass writes: umbrage_write(depth) is a color for the target. Where depth is reversed, or several passes
     *  share a text, bind it: bind(rg16.write, 'sun', { direction: 'reversed' }) is umbrage_write_sun(depth). */
    readonly write: SnippetOf<L>;
}

/** An encoding of depths that are 0 at the far plane. */
export type WithReversed<E> = E & { readonly reversed: E };

export interface BoundOf<L extends Language> {
    readonly what: SnippetOf<L>;
    readonly suffix: string;
}

/** A light, and how its maps are looked up: spot_light, cascades, point_light, ... */
export interface LightOf<L extends Language> {
    readonly [is_of]: L;
    readonly name: string;
}

export interface ShadowOptionsOf<L extends Language> {
    kind: LightOf<L>;
    /** One that has `filter`; not those of several coordinates or an epsilon. */
    filter: SnippetOf<L>;
    /** Left out: depth32f, a float depth texture or floats. depth24 and depth16 are depth textures of fewer bits. A filter of moments has its own. */
    encoding?: EncodingOf<L> & { readonly reversed: EncodingOf<L> };
    /** Of one map, in texels. */
    map_size: number | readonly [number, number];
    /** Of depth, as the light's clip space has it. */
    direction?: 'forward' | 'reversed';
    /** What the maps lie in. One: texture_2d, depth or shadow. Several: atlas, array, depth_array or shadow_array. */
    map?: Texture;
    /** Reads 2x2 texels at once, by a sampler that clamps to the edge: for pcf_2x2 and kernels, from GLSL 430 and 310 es on. */
    gather?: boolean;
    /** Form of the filter for a comparison sampler that filters linearly, as window_hardware3 of tent3: fewer fetches, tier C. */
    linear?: SnippetOf<L>;
    /** No normal: umbrage_<name>(world) takes the triangle's own from derivatives, in a fragment shader, outside all branches. */
    derivatives?: boolean;
    /** What block, map and sampler are bound to, 0 or above; set is WGSL's group or HLSL's space. Each shadow of a text has
     *  others, but for GLSL before 430 and 310 es, and Metal, whose texts have none. WGSL counts all three alike. */
    block?: number;
    texture?: number;
    sampler?: number;
    set?: number;
    /** The export `debug`: adds umbrage_probe_<name>(world, normal), colors that say why a point has no shadow, and
     *  umbrage_calibrate_<name>(number), which says how a map of known depths is read. */
    debug?: DebugOf<L>;
}

/** What debug functions are made of; programs that do not debug leave it to the bundler. */
export interface DebugOf<L extends Language> {
    readonly [is_of]: L;
}

/** A light's shadow: an item of a text, which declares block and map and defines umbrage_<name>(world, normal). Filters that
 *  turn from pixel to pixel take the position in pixels, too. */
export interface ShadowOf<L extends Language> extends BoundOf<L> {
    /** What the depth pass calls: umbrage_write_<name>(depth) is a color for the target. Exponents of ESM and EVSM come from
     *  the block: umbrage_write_<name>(depth, filter_terms). */
    readonly depth_pass: BoundOf<L>;
    /** What the depth pass calls for its vertices: umbrage_vertex_<name>(to_clip, world, anchor), with a view of
     *  umbrage/values. Directional lights move casters nearer than the near plane onto it. Paraboloids take the map's number,
     *  too. The clip space is one of umbrage/values. */
    vertex_pass(clip: { readonly direction: 'forward' | 'reversed'; readonly range: 'zero_to_one' | 'minus_one_to_one' }): BoundOf<L>;
    /** What the target is cleared to; of moments, for the filter's default arguments. `values` gives it for others. */
    readonly cleared: readonly number[];
    /** Of the texture: its size and layers, and how many maps lie beside each other and in rows in each layer. */
    readonly target: {
        /** OpenGL's name: the encoding's `format`, or its `depth_format` where `map` is depth, shadow, or an array of them. */
        readonly format: string;
        readonly size: readonly [number, number];
        readonly layers: number;
        readonly grid: readonly [number, number];
        readonly map_size: readonly [number, number];
    };
    /** Of the uniform block, whose values umbrage/values gives. */
    readonly bytes: number;
}

export type EncodingName = @encodings@;
export type SnippetName = @snippets@;
