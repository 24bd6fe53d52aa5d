// umbrage 0.1.0, MIT License: four_tap_hardware
// Paste along: beyond_far.wgsl, compare.wgsl, texel.wgsl, fetch_clamped.wgsl, decode.wgsl, fetch_depth.wgsl, depth_at.wgsl

// umbrage_four_tap_hardware: mean of the shadow test at four taps of the sampler's; visibility, 1.0 is lit
//   map, size  shadow map and its size in texels;   a, b, c, d  taps, (0.0, 0.0) to (1.0, 1.0) over the map, all lit
//   where the mean of |x| + |y| is 2^15 texels or more;   receiver  depth, biased
fn umbrage_four_tap_hardware(map: texture_2d<f32>, size: vec2f, a: vec2f, b: vec2f, c: vec2f, d: vec2f,
                             receiver: f32) -> f32 {
    let sum: vec2f = (abs(a) + abs(b) + abs(c) + abs(d)) * size;
    let compared: bool = select((sum.x + sum.y < 131072.0), false, umbrage_beyond_far(receiver));
    let count: f32 = umbrage_compare(receiver, umbrage_depth_at(map, size, a)) +
        umbrage_compare(receiver, umbrage_depth_at(map, size, b)) +
        umbrage_compare(receiver, umbrage_depth_at(map, size, c)) +
        umbrage_compare(receiver, umbrage_depth_at(map, size, d));
    return select(1.0, count * 0.25, compared);
}
