// SPDX-License-Identifier: MIT
//
// Moment shadow maps (MSM): each texel stores the first four powers of depth on [-1, 1]. Texels can be averaged.
//
//     glm::vec4 texel = umbrage::encode_msm(depth);
//     float visibility = umbrage::decode_msm(blurred, receiver, umbrage::msm_bias_32);
//
// Four 16-bit channels store optimized moments (Peters and Klein's 16-bit transform), which use all of each channel:
//
//     glm::vec4 held = umbrage::to_optimized_moments(texel);
//     float visibility = umbrage::decode_msm(umbrage::from_optimized_moments(held), receiver, umbrage::msm_bias_16);
//
// Visibility is an upper bound, from the distribution with these moments that shadows the receiver the least. It has
// three depths: the receiver's and two others. The shadow is the share of the others that is nearer to the light.
// Also called: MSM, 4MSM, Hamburger MSM (encode_msm, decode_msm); optimized moments, 16-bit moment quantization
// (to_optimized_moments, from_optimized_moments).
#pragma once

#include <cmath>

#include <glm/vec2.hpp>
#include <glm/vec4.hpp>

#include <umbrage/filter/prefiltered/chebyshev.hpp>

namespace umbrage {

/// Biases of moments: (share x, target y) moves moments by a share x towards (0, y, 0, y). After rounding, the moments
/// are then still those of some depths. Shadows get lighter by up to x. Near their casters they get lighter by up to
/// sqrt(x).
inline const glm::vec2 msm_bias_32{3e-6f, 0.375f};  ///< for 32-bit floats
inline const glm::vec2 msm_bias_16{6e-5f, 0.628f};  ///< for optimized moments in four 16-bit channels

/// Texel of a moment shadow map: the first four powers of depth on [-1, 1].
/// @param depth     in [0, 1]; clamped. NaN: (1, 1, 1, 1), as the far plane and a cleared texel
/// @param cleared   cleared depth: 1, or 0 where depth is reversed
/// @formula         (z, z^2, z^3, z^4), z = 2 to_forward_depth - 1
/// @exactness       B, n = 15
/// @cite            Peters, Klein: Moment shadow mapping, I3D 2015; on [-1, 1]: Peters et al.: Improved moment shadow
///                  maps for translucent occluders, soft shadows and single scattering, JCGT 2017
template <real T>
[[nodiscard]] UMBRAGE_INLINE constexpr glm::vec<4, T> encode_msm(T depth, T cleared = T(1)) {
    const T z = to_forward_depth(saturate(depth, cleared), cleared) * T(2) - T(1);
    const T square = z * z;
    return {z, square, square * z, square * square};
}

/// Moments for four 16-bit channels: each uses all of [0, 1]. The mean of transformed moments is the transformed mean.
/// @formula         (1.5 b1 - 2 b3 + 1/2, 4 b2 - 4 b4, sqrt(3)/2 b1 - 2 sqrt(3)/9 b3 + 1/2, (b2 + b4) / 2)
/// @exactness       B, n = 4
/// @cite            Peters et al., JCGT 2017
template <real T>
[[nodiscard]] UMBRAGE_INLINE constexpr glm::vec<4, T> to_optimized_moments(glm::vec<4, T> b) {
    return {(b.x * T(0.75) - b.z) * T(2) + T(0.5), (b.y - b.w) * T(4), (b.x * T(2.25) - b.z) * T(0.384900182f) + T(0.5),
            (b.y + b.w) * T(0.5)};
}

/// Moments from four 16-bit channels: the inverse of to_optimized_moments.
/// @formula         x = o.x - 1/2, z = o.z - 1/2:
///                  (sqrt(3) z - x / 3, o.w + o.y / 8, 3/4 sqrt(3) z - 3/4 x, o.w - o.y / 8)
/// @exactness       B, n = 5;  off by at most 2^-22 of the original moments, from rounding in both directions
template <real T>
[[nodiscard]] UMBRAGE_INLINE constexpr glm::vec<4, T> from_optimized_moments(glm::vec<4, T> o) {
    const T x = o.x - T(0.5), z = o.z - T(0.5), eighth = o.y * T(0.125);
    return {z * T(1.73205078f) - x * T(0.333333343f), o.w + eighth, z * T(1.29903817f) - x * T(0.75), o.w - eighth};
}

namespace detail {

/// First half of moment_atoms, up to the root of `square`, and second half from there on.
template <real T>
struct atom_equation {
    T D, E, h, a, B, c, square;

    UMBRAGE_INLINE atom_equation(glm::vec<4, T> b, T x) : D(b.y - b.x * b.x) {
        const T L = b.z - b.x * b.y, l = L / D;
        E = (b.w - b.y * b.y) - L * l, h = b.x * T(2) - l;
        a = D * at(x), B = x * E + h * a, c = D * (E - a);
        const T under = B * B - T(4) * a * c;
        square = pick(under > T(0), under, T(0));
    }
    UMBRAGE_INLINE atom_equation() = default;

    [[nodiscard]] UMBRAGE_INLINE T at(T t) const { return (t + h) * t - D; }
    [[nodiscard]] UMBRAGE_INLINE glm::vec<4, T> atoms(T root) const {
        const T w = pick(B < T(0), root - B, -(B + root)) * T(0.5), s = w / a, t = c / w;
        return {s, t, share(s), share(t)};
    }
    [[nodiscard]] UMBRAGE_INLINE T share(T t) const {
        const T height = at(t), least = D * E;
        return least / (least + (t * t * E + height * height * D));
    }
};

/// True when moment_atoms found depths.
template <real T>
[[nodiscard]] UMBRAGE_INLINE inline bool are_shares(const glm::vec<4, T>& atoms) {
    const T sum = atoms.z + atoms.w;
    return bool(int(!is_nan(sum)) & int(std::abs(sum) <= T(4294967296)));
}

/// Visibility from moment_atoms, as decode_msm returns it.
/// @param d   the receiver's depth, growing with distance
template <real T>
[[nodiscard]] UMBRAGE_INLINE inline T lit_by_atoms(const glm::vec<4, T>& atoms, T x, T d) {
    const T lit = T(1) - (pick(atoms.x < x, atoms.z, T(0)) + pick(atoms.y < x, atoms.w, T(0)));
    const T within = pick(lit > T(0), pick(lit < T(1), lit, T(1)), T(0));
    const T known = pick(are_shares(atoms), within, pick(x <= T(0), T(1), T(0)));
    return pick(bool(int(is_nan(d)) | int(is_nan(x))), T(0), known);
}

/// Depth on [-1, 1]. NaN counts as near.
template <real T>
[[nodiscard]] UMBRAGE_INLINE inline T moment_depth(T d) {
    return pick(d > T(0), pick(d < T(1), d, T(1)), T(0)) * T(2) - T(1);
}

}  // namespace detail

/// The two depths that form the distribution with the given moments, together with the receiver's depth.
///
/// @param b         moments, biased
/// @param x         the receiver's depth on [-1, 1] minus b.x
/// @return          (depth, depth, share, share); depths are minus b.x. NaN for moments of fewer than three depths
/// @formula         D = b2 - b1^2, L = b3 - b1 b2, E = b4 - b2^2 - L l, l = L / D, h = 2 b1 - l, q(t) = (t + h) t - D;
///                  t the roots of a t^2 + B t + c, a = D q(x), B = x E + h a, c = D (E - a); the share at t is
///                  D E / (D E + t^2 E + q(t)^2 D)
/// @exactness       C, within 1/64 as written: five divisions and a root
template <real T>
[[nodiscard]] glm::vec<4, T> moment_atoms(glm::vec<4, T> b, T x) {
    const detail::atom_equation<T> equation(b, x);
    return equation.atoms(std::sqrt(equation.square));
}

/// Moments with the bias applied, as moment_atoms takes them.
/// @param b         moments of depths, or their mean
/// @param bias      msm_bias_32, msm_bias_16
/// @formula         b + ((0, bias.y, 0, bias.y) - b) bias.x
/// @exactness       B, n = 3
template <real T>
[[nodiscard]] UMBRAGE_INLINE constexpr glm::vec<4, T> bias_moments(glm::vec<4, T> b, glm::vec<2, T> bias) {
    return {b.x - b.x * bias.x, b.y + (bias.y - b.y) * bias.x, b.z - b.z * bias.x, b.w + (bias.y - b.w) * bias.x};
}

/// Visibility from a mean of four moments.
/// @param b         mean of texels
/// @param receiver  receiver depth in [0, 1], with the bias already applied; clamped
/// @param bias      msm_bias_32, msm_bias_16
/// @param cleared   cleared depth: 1, or 0 where depth is reversed
/// @return          visibility in [0, 1]: at least the lit fraction, minus bias.x and the error below
/// @edge            NaN receiver: 0. Moments of fewer than three depths, or NaN: 1 where the receiver is no farther
///                  than their mean, else 0. Numbers that are not moments: 0 to 1, decided by rounding near poles
/// @formula         1 - sum of the shares of moment_atoms before the receiver
/// @exactness       C, within 1/64 as written. Rounding in binary32 has, to first order, the effect of moments that are
///                  off by (0, 1, 3, 7) 2^-24. That is at most 9 2^-24 / (bias.x e), e the smallest eigenvalue of the
///                  matrix of (0, y, 0, y): 0.199 for 0.375 and 0.159 for 0.628. So 0.057 with msm_bias_16, 0.027 with
///                  a share of 1e-4 towards 0.375. With msm_bias_32 it is 0.9, which says little
/// @cite            Peters, Klein: Moment shadow mapping, I3D 2015
template <real T>
[[nodiscard]] T decode_msm(glm::vec<4, T> b, T receiver, glm::vec<2, T> bias, T cleared = T(1)) {
    const T d = to_forward_depth(receiver, cleared);
    const glm::vec<4, T> m = bias_moments(b, bias);
    const T x = detail::moment_depth(d) - m.x;
    return detail::lit_by_atoms(moment_atoms(m, x), x, d);
}

namespace glsl {

inline constexpr snippet encode_msm{
    .name = "encode_msm",
    .summary = "depth to a texel of a moment shadow map (MSM)",
    .exactness = tier::b,
    .operations = 15,
    .needs = list<&saturate, &to_forward_depth>,
    .source = R"GLSL(
// umbrage_encode_msm: first four powers of depth on -1.0 to 1.0, the texel of a moment shadow map. NaN counts as far
UMBRAGE_HIGHP vec4 umbrage_encode_msm(UMBRAGE_HIGHP float depth) {
    UMBRAGE_PRECISE UMBRAGE_HIGHP float z = umbrage_to_forward_depth(umbrage_saturate(depth)) * 2.0 - 1.0;
    UMBRAGE_HIGHP float square = z * z;
    return vec4(z, square, square * z, square * square);
}
)GLSL",
};

inline constexpr snippet to_optimized_moments{
    .name = "to_optimized_moments",
    .summary = "four moments (MSM) to four 16-bit channels",
    .exactness = tier::b,
    .operations = 4,
    .source = R"GLSL(
// umbrage_to_optimized_moments: four moments for four 16-bit channels, each over all of 0.0 to 1.0
UMBRAGE_HIGHP vec4 umbrage_to_optimized_moments(UMBRAGE_HIGHP vec4 b) {
    UMBRAGE_PRECISE UMBRAGE_HIGHP float x = (b.x * 0.75 - b.z) * 2.0 + 0.5;
    UMBRAGE_PRECISE UMBRAGE_HIGHP float y = (b.y - b.w) * 4.0;
    UMBRAGE_PRECISE UMBRAGE_HIGHP float z = (b.x * 2.25 - b.z) * 0.384900182 + 0.5;
    UMBRAGE_PRECISE UMBRAGE_HIGHP float w = (b.y + b.w) * 0.5;
    return vec4(x, y, z, w);
}
)GLSL",
};

inline constexpr snippet from_optimized_moments{
    .name = "from_optimized_moments",
    .summary = "four 16-bit channels to four moments (MSM)",
    .exactness = tier::b,
    .operations = 5,
    .source = R"GLSL(
// umbrage_from_optimized_moments: four moments from the result of umbrage_to_optimized_moments
UMBRAGE_HIGHP vec4 umbrage_from_optimized_moments(UMBRAGE_HIGHP vec4 o) {
    UMBRAGE_PRECISE UMBRAGE_HIGHP float x = o.x - 0.5;
    UMBRAGE_PRECISE UMBRAGE_HIGHP float z = o.z - 0.5;
    UMBRAGE_HIGHP float eighth = o.y * 0.125;
    UMBRAGE_PRECISE UMBRAGE_HIGHP float b1 = z * 1.73205078 - x * 0.333333343;
    UMBRAGE_PRECISE UMBRAGE_HIGHP float b2 = o.w + eighth;
    UMBRAGE_PRECISE UMBRAGE_HIGHP float b3 = z * 1.29903817 - x * 0.75;
    UMBRAGE_PRECISE UMBRAGE_HIGHP float b4 = o.w - eighth;
    return vec4(b1, b2, b3, b4);
}
)GLSL",
};

inline constexpr snippet moment_atoms{
    .name = "moment_atoms",
    .summary = "two depths that have the moments with the receiver's",
    .exactness = tier::c,
    .within = 1.0f / 64.0f,
    .as_written = true,
    .source = R"GLSL(
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
)GLSL",
};

inline constexpr snippet bias_moments{
    .name = "bias_moments",
    .summary = "four moments (MSM) with a bias against rounding",
    .exactness = tier::b,
    .operations = 3,
    .source = R"GLSL(
// umbrage_bias_moments: moments moved by a share bias.x towards (0.0, bias.y, 0.0, bias.y)
UMBRAGE_HIGHP vec4 umbrage_bias_moments(UMBRAGE_HIGHP vec4 b, UMBRAGE_HIGHP vec2 bias) {
    UMBRAGE_PRECISE UMBRAGE_HIGHP float x = b.x - b.x * bias.x;
    UMBRAGE_PRECISE UMBRAGE_HIGHP float y = b.y + (bias.y - b.y) * bias.x;
    UMBRAGE_PRECISE UMBRAGE_HIGHP float z = b.z - b.z * bias.x;
    UMBRAGE_PRECISE UMBRAGE_HIGHP float w = b.w + (bias.y - b.w) * bias.x;
    return vec4(x, y, z, w);
}
)GLSL",
};

inline constexpr snippet decode_msm{
    .name = "decode_msm",
    .summary = "mean of MSM texels to visibility",
    .exactness = tier::c,
    .within = 1.0f / 64.0f,
    .as_written = true,
    .needs = list<&bias_moments, &to_forward_depth, &moment_atoms>,
    .source = R"GLSL(
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
)GLSL",
};

inline constexpr const snippet* msm_snippets[]{&encode_msm,   &to_optimized_moments, &from_optimized_moments,
                                               &moment_atoms, &bias_moments,         &decode_msm};

}  // namespace glsl
}  // namespace umbrage
