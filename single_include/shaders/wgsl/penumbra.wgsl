// umbrage 0.1.0, MIT License: penumbra

// umbrage_penumbra: radius in 1/16 texel, a whole number
//   apart     umbrage_distance_code of the receiver less that of the blocker
//   softness  (1/16 texel a code, least, widest), of make_softness
fn umbrage_penumbra(apart: f32, softness: vec3f) -> f32 {
    return min(max(floor(apart * softness.x), softness.y), softness.z);
}
