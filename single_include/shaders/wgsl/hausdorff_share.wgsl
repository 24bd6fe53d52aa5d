// umbrage 0.1.0, MIT License: hausdorff_share

// umbrage_hausdorff_share: least share of depths on -1.0 to 1.0 before the receiver's, of four moments
//   b  moments, biased;   z  the receiver's depth on -1.0 to 1.0
fn umbrage_hausdorff_share(b: vec4f, z: f32) -> f32 {
    let d: f32 = (b.z - b.x) - z * (b.y - 1.0);
    let n: f32 = (b.w - b.y) - z * (b.z - b.x);
    let f: f32 = n / d;
    let s: f32 = z + f;
    let p: f32 = z * f;
    let above: f32 = (b.z - (1.0 + s) * b.y) + ((s + p) * b.x - p);
    let below: f32 = -2.0 * ((1.0 + z) * (1.0 + f));
    let between: f32 = (f * f - 1.0) * (f - z);
    let end: f32 = above / below;
    let other: f32 = d / between;
    return end + select(0.0, other, f < z);
}
