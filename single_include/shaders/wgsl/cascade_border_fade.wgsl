// umbrage 0.1.0, MIT License: cascade_border_fade
// Paste along: cascade_weight.wgsl

// umbrage_cascade_border_fade: weight of the next cascade, 1.0 from reach texels off the border of a map on
//   coordinate, size  in texels;   per_texel  weight a texel, 1.0 / width of the band along the border
fn umbrage_cascade_border_fade(coordinate: vec2f, size: vec2f, reach: f32, per_texel: f32) -> f32 {
    let half_size: vec2f = size * 0.5;
    let beyond: vec2f = abs(coordinate - half_size) - (half_size - reach);
    let v: vec2f = beyond * per_texel + 1.0;
    let x: f32 = umbrage_cascade_weight(v.x);
    let y: f32 = umbrage_cascade_weight(v.y);
    return select(y, x, x > y);
}
