// SPDX-License-Identifier: MIT
//
// Metal's textures and samplers as C++. Textures have one level. Filters weight in floats, unlike most hardware.
#pragma once

#include <cmath>
#include <type_traits>

#include "memory.hpp"
#include "functions.hpp"

namespace metal {

enum class access { read, sample };
enum class component { x, y, z, w };
enum class coord { normalized, pixel };
enum class filter { nearest, linear };
enum class mag_filter { nearest, linear };
enum class min_filter { nearest, linear };
enum class mip_filter { none, nearest, linear };
enum class address { clamp_to_edge, clamp_to_zero, clamp_to_border, repeat, mirrored_repeat };
enum class s_address { clamp_to_edge, clamp_to_zero, clamp_to_border, repeat, mirrored_repeat };
enum class t_address { clamp_to_edge, clamp_to_zero, clamp_to_border, repeat, mirrored_repeat };
enum class border_color { transparent_black, opaque_black, opaque_white };
enum class compare_func { never, less, less_equal, greater, greater_equal, equal, not_equal, always };

struct level {
    explicit level(float) {}
};

struct sampler {
    bool linear = false, pixels = false;
    address s = address::clamp_to_edge, t = address::clamp_to_edge;
    border_color border = border_color::transparent_black;
    compare_func compare = compare_func::never;

    template <class... Words>
    requires(std::is_enum_v<Words>&&...) constexpr sampler(Words... words) { (set(words), ...); }
    explicit sampler(const parity::metal_text::memory& m)
        : linear(m.linear),
          compare(m.compare == 1   ? compare_func::less_equal
                  : m.compare == 2 ? compare_func::greater_equal
                                   : compare_func::never) {}

    float operator()(float receiver, float stored) const {
        switch (compare) {
            case compare_func::less: return receiver < stored;
            case compare_func::less_equal: return receiver <= stored;
            case compare_func::greater: return receiver > stored;
            case compare_func::greater_equal: return receiver >= stored;
            case compare_func::equal: return receiver == stored;
            case compare_func::not_equal: return receiver != stored;
            case compare_func::always: return 1;
            case compare_func::never: break;
        }
        return 0;
    }

private:
    constexpr void set(coord c) { pixels = c == coord::pixel; }
    constexpr void set(filter f) { linear = f == filter::linear; }
    constexpr void set(mag_filter f) { linear = f == mag_filter::linear; }
    constexpr void set(min_filter) {}  // the texture is drawn larger here, never smaller
    constexpr void set(mip_filter) {}
    constexpr void set(address a) { s = t = a; }
    constexpr void set(s_address a) { s = static_cast<address>(a); }
    constexpr void set(t_address a) { t = static_cast<address>(a); }
    constexpr void set(border_color c) { border = c; }
    constexpr void set(compare_func f) { compare = f; }
};

/// Layers of texels without gaps.
template <class Texel>
struct texture {
    const Texel* texels;
    uint width, height;

    explicit texture(const parity::metal_text::memory& m)
        : texels(static_cast<const Texel*>(m.texels)), width(m.width), height(m.height) {}

    uint get_width(uint = 0) const { return width; }
    uint get_height(uint = 0) const { return height; }
    uint get_num_mip_levels() const { return 1; }

    /// Outside, where Metal promises nothing, what no texel is.
    Texel read(uint2 at, uint layer = 0) const {
        return at.x < width && at.y < height ? texels[(layer * height + at.y) * width + at.x] : Texel(-7);
    }

protected:
    float2 texels_at(const sampler& s, float2 p) const { return s.pixels ? p : p * float2(width, height); }

    /// A texel's place along one side, by a mode of address; negative: on the border.
    static int placed(int at, int size, address how) {
        if (how == address::clamp_to_edge) return clamp(at, 0, size - 1);
        const int period = how == address::mirrored_repeat ? 2 * size : size, in = ((at % period) + period) % period;
        if (how == address::mirrored_repeat) return in < size ? in : period - 1 - in;
        return how == address::repeat || (at >= 0 && at < size) ? in : -1;
    }
    Texel texel(const sampler& s, int2 at, uint layer) const {
        const int2 place(placed(at.x, int(width), s.s), placed(at.y, int(height), s.t));
        if (place.x >= 0 && place.y >= 0) return read(uint2(place), layer);
        const bool zero = s.s == address::clamp_to_zero || s.t == address::clamp_to_zero;
        if (zero || s.border == border_color::transparent_black) return Texel(0);
        Texel color(s.border == border_color::opaque_white ? 1 : 0);
        if constexpr (!std::is_arithmetic_v<Texel>) color[3] = 1;
        return color;
    }

    /// A value of the texel at a point, or where the sampler filters of the four around it.
    template <class Value>
    auto filtered(const sampler& s, float2 p, uint layer, int2 offset, const Value& value) const {
        const float2 place = texels_at(s, p);
        if (!s.linear) return value(texel(s, int2(floor(place)) + offset, layer));
        const float2 from = place - 0.5f, first = floor(from), weight = from - first;
        const auto at = [&](int x, int y) { return value(texel(s, int2(first) + offset + int2(x, y), layer)); };
        return (at(0, 0) * (1 - weight.x) + at(1, 0) * weight.x) * (1 - weight.y) +
               (at(0, 1) * (1 - weight.x) + at(1, 1) * weight.x) * weight.y;
    }
    /// Of the four texels around a point, in the order that gathers have.
    template <class Value>
    float4 four(const sampler& s, float2 p, uint layer, int2 offset, const Value& value) const {
        const int2 first = int2(floor(texels_at(s, p) - 0.5f)) + offset;
        const auto at = [&](int x, int y) { return value(texel(s, first + int2(x, y), layer)); };
        return {at(0, 1), at(1, 1), at(1, 0), at(0, 0)};
    }
    float4 four_of(const sampler& s, float2 p, uint layer, int2 offset, component c) const {
        return four(s, p, layer, offset, [c](const Texel& t) { return t[int(c)]; });
    }
    static constexpr auto itself = [](const Texel& t) { return t; };
};

template <class T, access = access::sample>
struct texture2d : texture<vec<T, 4>> {
    using color = vec<T, 4>;
    using texture<color>::texture;
    color sample(sampler s, float2 p, int2 offset = int2(0)) const {
        return this->filtered(s, p, 0, offset, this->itself);
    }
    color sample(sampler s, float2 p, level, int2 offset = int2(0)) const { return sample(s, p, offset); }
    float4 gather(sampler s, float2 p, int2 offset = int2(0), component c = component::x) const {
        return this->four_of(s, p, 0, offset, c);
    }
};
template <class T, access = access::sample>
struct texture2d_array : texture<vec<T, 4>> {
    using color = vec<T, 4>;
    using texture<color>::texture;
    color sample(sampler s, float2 p, uint layer, int2 offset = int2(0)) const {
        return this->filtered(s, p, layer, offset, this->itself);
    }
    color sample(sampler s, float2 p, uint layer, level, int2 offset = int2(0)) const {
        return sample(s, p, layer, offset);
    }
    float4 gather(sampler s, float2 p, uint layer, int2 offset = int2(0), component c = component::x) const {
        return this->four_of(s, p, layer, offset, c);
    }
};
template <class T>
using texturecube = texture<vec<T, 4>>;

template <class T, access = access::sample>
struct depth2d_array : texture<T> {
    using texture<T>::texture;
    T sample(sampler s, float2 p, uint layer, int2 offset = int2(0)) const {
        return this->filtered(s, p, layer, offset, this->itself);
    }
    T sample(sampler s, float2 p, uint layer, level, int2 offset = int2(0)) const {
        return sample(s, p, layer, offset);
    }
    float4 gather(sampler s, float2 p, uint layer, int2 offset = int2(0)) const {
        return this->four(s, p, layer, offset, this->itself);
    }
    float4 gather_compare(sampler s, float2 p, uint layer, float receiver, int2 offset = int2(0)) const {
        return this->four(s, p, layer, offset, [=](float stored) { return s(receiver, stored); });
    }
    float sample_compare(sampler s, float2 p, uint layer, float receiver, int2 offset = int2(0)) const {
        return this->filtered(s, p, layer, offset, [=](float stored) { return s(receiver, stored); });
    }
    float sample_compare(sampler s, float2 p, uint layer, float receiver, level, int2 offset = int2(0)) const {
        return sample_compare(s, p, layer, receiver, offset);
    }
};
template <class T, access A = access::sample>
struct depth2d : private depth2d_array<T, A> {
    using layers = depth2d_array<T, A>;
    using layers::layers, layers::get_width, layers::get_height, layers::get_num_mip_levels;
    T read(uint2 at, uint = 0) const { return layers::read(at); }
    T sample(sampler s, float2 p, int2 offset = int2(0)) const { return layers::sample(s, p, 0, offset); }
    T sample(sampler s, float2 p, level, int2 offset = int2(0)) const { return sample(s, p, offset); }
    float4 gather(sampler s, float2 p, int2 offset = int2(0)) const { return layers::gather(s, p, 0, offset); }
    float4 gather_compare(sampler s, float2 p, float receiver, int2 offset = int2(0)) const {
        return layers::gather_compare(s, p, 0, receiver, offset);
    }
    float sample_compare(sampler s, float2 p, float receiver, int2 offset = int2(0)) const {
        return layers::sample_compare(s, p, 0, receiver, offset);
    }
    float sample_compare(sampler s, float2 p, float receiver, level, int2 offset = int2(0)) const {
        return sample_compare(s, p, receiver, offset);
    }
};

}  // namespace metal
