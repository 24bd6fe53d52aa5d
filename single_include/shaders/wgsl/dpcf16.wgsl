// umbrage 0.1.0, MIT License: dpcf16
// Paste along: inside_texel_space.wgsl, beyond_far.wgsl, is_compared.wgsl, cleared_depth.wgsl, distance_code.wgsl, penumbra.wgsl, disc_tap.wgsl, texel.wgsl, fetch_clamped.wgsl, decode.wgsl, fetch_depth.wgsl, compare.wgsl, blocker.wgsl, blockers16.wgsl, mend_quotient.wgsl, floor_divide.wgsl, hardened16.wgsl

// umbrage_dpcf16: contact hardening by 16 points; visibility, 1.0 is lit
//   map, size  shadow map and its size in texels;   coord  receiver in texels, first centre at (0.5, 0.5)
//   receiver   depth, biased;   softness  of make_softness;   turn  umbrage_disc_turn of the pixel
fn umbrage_dpcf16(map: texture_2d<f32>, size: vec2f, coord: vec2f, receiver: f32, softness: vec3f, turn: vec2f) -> f32 {
    let compared: bool = umbrage_is_compared(coord, receiver);
    let at: vec2f = select(vec2f(0.0, 0.0), floor(coord * 256.0), compared);
    let z: f32 = umbrage_distance_code(receiver);
    let widest: f32 = umbrage_penumbra(z, softness);
    let found: vec2f = umbrage_blockers16(map, size, at, receiver, widest, turn);
    let mean: f32 = umbrage_floor_divide(found.y, max(found.x, 1.0));
    let radius: f32 = umbrage_penumbra(z - mean, softness);
    let ratio: f32 = umbrage_floor_divide(radius * 256.0, max(widest, 1.0));
    let dark: f32 = umbrage_hardened16(found.x, ratio);
    return select(1.0, 1.0 - dark, compared);
}
