// umbrage 0.1.0, MIT License: write_threejs_rgba
// Paste along: cleared_depth.wgsl, saturate.wgsl

// umbrage_write_threejs_rgba: depth to the RGBA format of three.js r167 and later, values to write as they are
fn umbrage_write_threejs_rgba(depth: f32) -> vec4f {
    let v: f32 = umbrage_saturate(depth);
    let x: f32 = v * 16777216.0;
    let whole: f32 = floor(x);
    let high: f32 = floor(whole * (1.0 / 65536.0));
    let rest: f32 = whole - high * 65536.0;
    let middle: f32 = floor(rest * (1.0 / 256.0));
    let low: f32 = rest - middle * 256.0;
    let c: vec4f = vec4f(high * 0.00392156886, middle * 0.00392156886, low * 0.00392156886, x - whole);
    return select(vec4f(1.0, 1.0, 1.0, 1.0), c, v < 1.0);
}
