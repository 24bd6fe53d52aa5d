// umbrage 0.1.0, decode_msm: mean of MSM texels to visibility. Exactness: tier C.
// GLSL below 400 and 320 es lets compilers fuse or reorder sums.
// decode_msm, tier C: within 1/64 of C++ as written. Reordered: no bound, but a visibility is in [0, 1].
// SPDX-License-Identifier: MIT
// Copyright (c) 2026 the umbrage authors. License text: LICENSE in the umbrage repository.
// Other maps: bind() of the library or of its npm package prints this text, by direction.

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

#ifndef UMBRAGE_HAS_BIAS_MOMENTS
#define UMBRAGE_HAS_BIAS_MOMENTS
// umbrage_bias_moments: moments moved by a share bias.x towards (0.0, bias.y, 0.0, bias.y)
UMBRAGE_HIGHP vec4 umbrage_bias_moments(UMBRAGE_HIGHP vec4 b, UMBRAGE_HIGHP vec2 bias) {
    UMBRAGE_PRECISE UMBRAGE_HIGHP float x = b.x - b.x * bias.x;
    UMBRAGE_PRECISE UMBRAGE_HIGHP float y = b.y + (bias.y - b.y) * bias.x;
    UMBRAGE_PRECISE UMBRAGE_HIGHP float z = b.z - b.z * bias.x;
    UMBRAGE_PRECISE UMBRAGE_HIGHP float w = b.w + (bias.y - b.w) * bias.x;
    return vec4(x, y, z, w);
}
#endif

#ifndef UMBRAGE_HAS_MOMENT_ATOMS
#define UMBRAGE_HAS_MOMENT_ATOMS
// umbrage_moment_atoms: the two depths that have the same moments with the receiver's, minus b.x, and their shares
//   b   moments, biased
//   x   the receiver's depth on -1.0 to 1.0 minus b.x
UMBRAGE_HIGHP vec4 umbrage_moment_atoms(UMBRAGE_HIGHP vec4 b, UMBRAGE_HIGHP float x) {
    UMBRAGE_PRECISE UMBRAGE_HIGHP float d = b.y - b.x * b.x;
    UMBRAGE_PRECISE UMBRAGE_HIGHP float third = b.z - b.x * b.y;
    UMBRAGE_HIGHP float l = third / d;
    UMBRAGE_PRECISE UMBRAGE_HIGHP float e = (b.w - b.y * b.y) - third * l;
    UMBRAGE_PRECISE UMBRAGE_HIGHP float h = b.x * 2.0 - l;
    UMBRAGE_PRECISE UMBRAGE_HIGHP float a = d * ((x + h) * x - d);
    UMBRAGE_PRECISE UMBRAGE_HIGHP float m = x * e + h * a;
    UMBRAGE_PRECISE UMBRAGE_HIGHP float c = d * (e - a);
    UMBRAGE_PRECISE UMBRAGE_HIGHP float square = m * m - 4.0 * a * c;
    UMBRAGE_HIGHP float root = sqrt(square > 0.0 ? square : 0.0);
    UMBRAGE_PRECISE UMBRAGE_HIGHP float w = (m < 0.0 ? root - m : -(m + root)) * 0.5;
    UMBRAGE_HIGHP vec2 t = vec2(w / a, c / w);
    UMBRAGE_PRECISE UMBRAGE_HIGHP vec2 q = (t + h) * t - d;
    UMBRAGE_HIGHP float least = d * e;
    UMBRAGE_PRECISE UMBRAGE_HIGHP vec2 sum = least + (t * t * e + q * q * d);
    return vec4(t.x, t.y, least / sum.x, least / sum.y);
}
#endif

#ifndef UMBRAGE_HAS_CLEARED_DEPTH
#define UMBRAGE_HAS_CLEARED_DEPTH
// umbrage_cleared_depth: depth of the far plane
UMBRAGE_HIGHP float umbrage_cleared_depth() {
    return 1.0;
}
#endif

#ifndef UMBRAGE_HAS_TO_FORWARD_DEPTH
#define UMBRAGE_HAS_TO_FORWARD_DEPTH
// umbrage_to_forward_depth: depth that grows with distance, 1.0 - depth where the map's depth is reversed
UMBRAGE_HIGHP float umbrage_to_forward_depth(UMBRAGE_HIGHP float depth) {
    return umbrage_cleared_depth() < 0.5 ? 1.0 - depth : depth;
}
#endif

#ifndef UMBRAGE_HAS_DECODE_MSM
#define UMBRAGE_HAS_DECODE_MSM
// umbrage_decode_msm: visibility of a receiver, at least its lit fraction minus bias.x. 1.0 = lit
//   b: mean of texels. receiver: depth in [0, 1], bias applied
//   bias: (3e-6, 0.375) for 32-bit floats, (6e-5, 0.628) for 16-bit channels
UMBRAGE_HIGHP float umbrage_decode_msm(UMBRAGE_HIGHP vec4 b, UMBRAGE_HIGHP float receiver, UMBRAGE_HIGHP vec2 bias) {
    UMBRAGE_HIGHP float d = umbrage_to_forward_depth(receiver);
    UMBRAGE_HIGHP vec4 m = umbrage_bias_moments(b, bias);
    UMBRAGE_PRECISE UMBRAGE_HIGHP float x = ((d > 0.0 ? (d < 1.0 ? d : 1.0) : 0.0) * 2.0 - 1.0) - m.x;
    UMBRAGE_HIGHP vec4 atoms = umbrage_moment_atoms(m, x);
    UMBRAGE_HIGHP float first = atoms.x < x ? atoms.z : 0.0;
    UMBRAGE_HIGHP float second = atoms.y < x ? atoms.w : 0.0;
    UMBRAGE_PRECISE UMBRAGE_HIGHP float lit = 1.0 - (first + second);
    bool known = abs(atoms.z + atoms.w) <= 4294967296.0;  // false for NaN
    lit = known ? (lit > 0.0 ? (lit < 1.0 ? lit : 1.0) : 0.0) : (x <= 0.0 ? 1.0 : 0.0);
    return d > 0.0 ? lit : (d <= 0.0 ? lit : 0.0);
}
#endif
