// umbrage 0.1.0, MIT License: disc_tap

// umbrage_disc_tap: the texel that a point of a disc falls on
//   position  floor(256 coord) of the receiver;   p  point, in 1/16 of the radius;   turn  of umbrage_disc_turn
//   radius    in 1/16 texel, a whole number from 0 to 4095
fn umbrage_disc_tap(position: vec2f, p: vec2f, turn: vec2f, radius: f32) -> vec2f {
    let turned: vec2f = vec2f(turn.x * p.x - turn.y * p.y, turn.y * p.x + turn.x * p.y);
    return floor((position + floor(turned * radius * (1.0 / 64.0))) * (1.0 / 256.0));
}
