// umbrage 0.1.0, probe_inputs: debug color, unless position or normal is wrong. Exactness: tier A.
// SPDX-License-Identifier: MIT
// Copyright (c) 2026 the umbrage authors. License text: LICENSE in the umbrage repository.

#ifndef UMBRAGE_HIGHP
#ifdef GL_ES
#define UMBRAGE_HIGHP highp
#else
#define UMBRAGE_HIGHP
#endif
#endif
#ifndef UMBRAGE_PRECISE
#if (defined(GL_ES) && __VERSION__ >= 320) || (!defined(GL_ES) && __VERSION__ >= 400)
#define UMBRAGE_PRECISE precise
#else
#define UMBRAGE_PRECISE
#endif
#endif

#ifndef UMBRAGE_HAS_PROBE_INPUTS
#define UMBRAGE_HAS_PROBE_INPUTS
// umbrage_probe_inputs: color, unless the receiver is wrong
//   magenta  position or normal is not a number
//   yellow   a normal of zero
UMBRAGE_HIGHP vec3 umbrage_probe_inputs(UMBRAGE_HIGHP vec3 color, UMBRAGE_HIGHP vec3 world,
                                        UMBRAGE_HIGHP vec3 normal) {
    UMBRAGE_HIGHP float limit = 18446744073709551616.0;
    // limits differ on purpose: Mesa makes max(x, y) < limit of equal ones, which loses a NaN
    bool usable = abs(world.x) < limit && abs(world.y) * 2.0 < limit * 2.0 && abs(world.z) * 4.0 < limit * 4.0;
    usable = usable && abs(normal.x) * 8.0 < limit * 8.0;
    usable = usable && abs(normal.y) * 16.0 < limit * 16.0 && abs(normal.z) * 32.0 < limit * 32.0;
    bool zero = normal.x == 0.0 && normal.y == 0.0 && normal.z == 0.0;
    UMBRAGE_HIGHP vec3 given = zero ? vec3(1.0, 1.0, 0.0) : color;
    return usable ? given : vec3(1.0, 0.0, 1.0);
}
#endif
