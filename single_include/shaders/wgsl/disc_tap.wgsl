// umbrage 0.1.0, MIT License: disc_tap

// umbrage_disc_tap: the texel that a point of a disc falls on
//   position  floor(256 coord) of the receiver;   p  point, in 1/16 of the radius;   turn  of umbrage_disc_turn
//   radius    in 1/16 texel, a whole number from 0 to 4095
fn umbrage_disc_tap(position: vec2f, p: vec2f, turn: vec2f, radius: f32) -> vec2f {
    let at: vec2f = position * (1.0 / 256.0);
    let texel: vec2f = floor(at);
    let within: vec2f = at - texel;
    let scaled: vec2f = turn * (radius * (1.0 / 16384.0));
    let x: f32 = scaled.x * p.x + within.x - scaled.y * p.y;
    let y: f32 = scaled.y * p.x + within.y + scaled.x * p.y;
    return texel + floor(vec2f(x, y));
}
