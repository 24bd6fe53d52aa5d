// umbrage 0.1.0, probe_inputs: debug color, unless position or normal is wrong. Exactness: tier A.
// SPDX-License-Identifier: MIT
// Copyright (c) 2026 the umbrage authors. License text: LICENSE in the umbrage repository.

// umbrage_probe_inputs: color, unless the receiver is wrong
//   magenta  position or normal is not a number
//   yellow   a normal of zero
fn umbrage_probe_inputs(color: vec3f, world: vec3f, normal: vec3f) -> vec3f {
    let limit: f32 = 18446744073709551616.0;
    // limits differ on purpose: Mesa makes max(x, y) < limit of equal ones, which loses a NaN
    var usable: bool = abs(world.x) < limit && abs(world.y) * 2.0 < limit * 2.0 && abs(world.z) * 4.0 < limit * 4.0;
    usable = usable && abs(normal.x) * 8.0 < limit * 8.0;
    usable = usable && abs(normal.y) * 16.0 < limit * 16.0 && abs(normal.z) * 32.0 < limit * 32.0;
    let zero: bool = normal.x == 0.0 && normal.y == 0.0 && normal.z == 0.0;
    let given: vec3f = select(color, vec3f(1.0, 1.0, 0.0), zero);
    return select(vec3f(1.0, 0.0, 1.0), given, usable);
}
