// umbrage 0.1.0, MIT License: pcf_2x2_dx_sdk
// Paste along: compare_dx_sdk.wgsl, inside_texel_space.wgsl, beyond_far.wgsl, is_compared.wgsl, texel.wgsl, fetch_clamped.wgsl, decode.wgsl, fetch_depth.wgsl

// umbrage_pcf_2x2_dx_sdk: the DirectX SDK sample's 2x2 filter; visibility, 1.0 is lit
//   map, size  shadow map and its size in texels;   coord  receiver in texels, first centre at (0.5, 0.5)
//   receiver   depth, not biased;   epsilon  in depth, added to the stored side
fn umbrage_pcf_2x2_dx_sdk(map: texture_2d<f32>, size: vec2f, coord: vec2f, receiver: f32, epsilon: f32) -> f32 {
    let compared: bool = umbrage_is_compared(coord, receiver);
    let x: vec2f = select(vec2f(0.0, 0.0), coord - 0.5, compared);  // no branch: fetches overlap
    let texel: vec2f = floor(x);
    let weight: vec2f = x - texel;
    let a: f32 = umbrage_compare_dx_sdk(receiver, umbrage_fetch_depth(map, size, texel), epsilon);
    let right: f32 = umbrage_fetch_depth(map, size, texel + vec2f(1.0, 0.0));
    let above: f32 = umbrage_fetch_depth(map, size, texel + vec2f(0.0, 1.0));
    let beyond: f32 = umbrage_fetch_depth(map, size, texel + vec2f(1.0, 1.0));
    let b: f32 = umbrage_compare_dx_sdk(receiver, right, epsilon);
    let c: f32 = umbrage_compare_dx_sdk(receiver, above, epsilon);
    let d: f32 = umbrage_compare_dx_sdk(receiver, beyond, epsilon);
    let low: f32 = a + weight.x * (b - a);
    let high: f32 = c + weight.x * (d - c);
    let visibility: f32 = low + weight.y * (high - low);
    return select(1.0, visibility, compared);
}
