// umbrage 0.1.0, msm_unorm16: visibility from a blurred MSM of optimized moments. Exactness: tier C.
// WGSL lets compilers fuse or reorder sums.
// msm_unorm16, tier C: within 1/64 of C++ as written. Reordered: no bound, but a visibility is in [0, 1].
// SPDX-License-Identifier: MIT
// Copyright (c) 2026 the umbrage authors. License text: LICENSE in the umbrage repository.
// Map: `map: texture_2d<f32>`, texels of the kind that the function's comment names, read unfiltered.
// Render target of msm_unorm16: RGBA16 UNORM, not sRGB, no blending, one sample. Clear to
//   umbrage_to_optimized_moments of umbrage_encode_msm of the far plane's depth.
// Other maps: bind() of the library or of its npm package prints this text, by texture, outside, direction.

// umbrage_inside_texel_space: true for coordinates in texels that a filter can take; others are lit, also NaN
fn umbrage_inside_texel_space(coord: vec2f) -> bool {
    // the float below 32768: of one limit for both Mesa makes max(x, y) < limit, which loses a NaN
    return abs(coord.x) < 32768.0 && abs(coord.y) <= 32767.998046875;
}

// umbrage_bias_moments: moments moved by a share bias.x towards (0.0, bias.y, 0.0, bias.y)
fn umbrage_bias_moments(b: vec4f, bias: vec2f) -> vec4f {
    let x: f32 = b.x - b.x * bias.x;
    let y: f32 = b.y + (bias.y - b.y) * bias.x;
    let z: f32 = b.z - b.z * bias.x;
    let w: f32 = b.w + (bias.y - b.w) * bias.x;
    return vec4f(x, y, z, w);
}

// umbrage_moment_atoms: the two depths that have the same moments with the receiver's, minus b.x, and their shares
//   b   moments, biased
//   x   the receiver's depth on -1.0 to 1.0 minus b.x
fn umbrage_moment_atoms(b: vec4f, x: f32) -> vec4f {
    let d: f32 = b.y - b.x * b.x;
    let third: f32 = b.z - b.x * b.y;
    let l: f32 = third / d;
    let e: f32 = (b.w - b.y * b.y) - third * l;
    let h: f32 = b.x * 2.0 - l;
    let a: f32 = d * ((x + h) * x - d);
    let m: f32 = x * e + h * a;
    let c: f32 = d * (e - a);
    let square: f32 = m * m - 4.0 * a * c;
    let root: f32 = sqrt(select(0.0, square, square > 0.0));
    let w: f32 = select(-(m + root), root - m, m < 0.0) * 0.5;
    let t: vec2f = vec2f(w / a, c / w);
    let q: vec2f = (t + h) * t - d;
    let least: f32 = d * e;
    let sum: vec2f = least + (t * t * e + q * q * d);
    return vec4f(t.x, t.y, least / sum.x, least / sum.y);
}

// umbrage_from_optimized_moments: four moments from the result of umbrage_to_optimized_moments
fn umbrage_from_optimized_moments(o: vec4f) -> vec4f {
    let x: f32 = o.x - 0.5;
    let z: f32 = o.z - 0.5;
    let eighth: f32 = o.y * 0.125;
    let b1: f32 = z * 1.73205078 - x * 0.333333343;
    let b2: f32 = o.w + eighth;
    let b3: f32 = z * 1.29903817 - x * 0.75;
    let b4: f32 = o.w - eighth;
    return vec4f(b1, b2, b3, b4);
}

// umbrage_beyond_far_plane: true if a receiver is beyond the far plane
fn umbrage_beyond_far_plane(receiver: f32) -> bool {
    return receiver > 1.0;
}

// umbrage_in_filter_domain: true if a filter compares; lit outside texel space and beyond the far plane
fn umbrage_in_filter_domain(coord: vec2f, receiver: f32) -> bool {
    // a choice, not a && !b: FXC turns !(receiver > 1.0) into receiver <= 1.0, which loses a NaN
    return select(umbrage_inside_texel_space(coord), false, umbrage_beyond_far_plane(receiver));
}

// umbrage_map_covers: true if a receiver lies in a prefiltered map or a table; elsewhere it is lit
fn umbrage_map_covers(size: vec2f, coord: vec2f) -> bool {
    return coord.x >= 0.0 && coord.y >= 0.0 && coord.x < size.x && coord.y < size.y;
}

// umbrage_texel: value of a texel inside the map
//   map    texture with the texels; a sampler that reads them must filter by nearest
//   size   size of the map, in texels
//   texel  integers, (0, 0) is the first
fn umbrage_texel(map: texture_2d<f32>, size: vec2f, texel: vec2f) -> vec4f {
    return textureLoad(map, vec2i(texel), 0);
}

// umbrage_fetch_clamped: texel of a map, or the nearest one inside for coordinates outside
fn umbrage_fetch_clamped(map: texture_2d<f32>, size: vec2f, texel: vec2f) -> vec4f {
    return umbrage_texel(map, size, clamp(texel, vec2f(0.0, 0.0), size - 1.0));
}

// umbrage_fetch_bilinear: bilinear mean of the four texels around a point, weights in steps of 1/256
//   coord   in texels. (0.5, 0.5) is the center of the first texel
fn umbrage_fetch_bilinear(map: texture_2d<f32>, size: vec2f, coord: vec2f) -> vec4f {
    let x: vec2f = floor(coord * 256.0) - 128.0;
    let texel: vec2f = floor(x * (1.0 / 256.0));
    // weights are in [0, 256) already. The clamp keeps compilers from regrouping sums across it
    let hi: vec2f = clamp(x * (1.0 / 256.0) - texel, vec2f(0.0, 0.0), vec2f(1.0, 1.0)) * 256.0;
    let lo: vec2f = 256.0 - hi;  // 1.0 - hi would become an interpolation, which rounds differently
    let a: vec4f = umbrage_fetch_clamped(map, size, texel);
    let b: vec4f = umbrage_fetch_clamped(map, size, texel + vec2f(1.0, 0.0));
    let c: vec4f = umbrage_fetch_clamped(map, size, texel + vec2f(0.0, 1.0));
    let d: vec4f = umbrage_fetch_clamped(map, size, texel + vec2f(1.0, 1.0));
    let low: vec4f = a * lo.x + b * hi.x;
    let high: vec4f = c * lo.x + d * hi.x;
    let sum: vec4f = low * lo.y + high * hi.y;
    return sum * (1.0 / 65536.0);
}

// umbrage_cleared_depth: depth of the far plane
fn umbrage_cleared_depth() -> f32 {
    return 1.0;
}

// umbrage_to_forward_depth: depth that grows with distance, 1.0 - depth where the map's depth is reversed
fn umbrage_to_forward_depth(depth: f32) -> f32 {
    return select(depth, 1.0 - depth, umbrage_cleared_depth() < 0.5);
}

// umbrage_decode_msm: visibility of a receiver, at least its lit fraction minus bias.x. 1.0 = lit
//   b: mean of texels. receiver: depth in [0, 1], bias applied
//   bias: (3e-6, 0.375) for 32-bit floats, (6e-5, 0.628) for 16-bit channels
fn umbrage_decode_msm(b: vec4f, receiver: f32, bias: vec2f) -> f32 {
    let d: f32 = umbrage_to_forward_depth(receiver);
    let m: vec4f = umbrage_bias_moments(b, bias);
    let x: f32 = (select(0.0, select(1.0, d, d < 1.0), d > 0.0) * 2.0 - 1.0) - m.x;
    let atoms: vec4f = umbrage_moment_atoms(m, x);
    let first: f32 = select(0.0, atoms.z, atoms.x < x);
    let second: f32 = select(0.0, atoms.w, atoms.y < x);
    var lit: f32 = 1.0 - (first + second);
    let known: bool = abs(atoms.z + atoms.w) <= 4294967296.0;  // false for NaN
    lit = select(select(0.0, 1.0, x <= 0.0), select(0.0, select(1.0, lit, lit < 1.0), lit > 0.0), known);
    return select(select(0.0, lit, d <= 0.0), lit, d > 0.0);
}

// umbrage_msm_unorm16: visibility from a blurred map of optimized moments, 1.0 = lit
//   map, size, coord: prefiltered map, its size, and the receiver in texels. (0.5, 0.5) is the center of the first
//   texel receiver: depth in [0, 1], bias applied. bias: as for decode_msm
fn umbrage_msm_unorm16(map: texture_2d<f32>, size: vec2f, coord: vec2f, receiver: f32, bias: vec2f) -> f32 {
    let compared: bool = select(false, umbrage_in_filter_domain(coord, receiver), umbrage_map_covers(size, coord));
    let m: vec4f = umbrage_fetch_bilinear(map, size, select(vec2f(0.0, 0.0), coord, compared));
    let lit: f32 = umbrage_decode_msm(umbrage_from_optimized_moments(m), receiver, bias);
    return select(1.0, lit, compared);
}
