// umbrage 0.1.0, texel_inside: texel of the map, itself if the map has it. Exactness: tier A.
// SPDX-License-Identifier: MIT
// Copyright (c) 2026 the umbrage authors. License text: LICENSE in the umbrage repository.
// Map: `map: texture_2d<f32>`, texels of the kind that the function's comment names, read unfiltered.
// Other maps: bind() of the library or of its npm package prints this text, by texture.

// umbrage_texel_inside: texel of the map, itself if the map has it; otherwise any, whose value does not count
fn umbrage_texel_inside(size: vec2f, texel: vec2f) -> vec2f {
    return min(abs(texel), size - 1.0);
}
