// SPDX-License-Identifier: MIT
#include "soft.hpp"

#include <algorithm>
#include <memory>
#include <stdexcept>
#include <utility>

#include <glm/common.hpp>

#include <umbrage/filter/blocker/pcss.hpp>
#include <umbrage/images/blur.hpp>
#include <umbrage/images/moment_table.hpp>
#include <umbrage/images/prefilter.hpp>
#include <umbrage/images/variance_table.hpp>

namespace example {
namespace {

namespace prefilters = umbrage::prefilters;

constexpr std::string_view of_variance = umbrage::glsl::summed_variance.name,
                           of_moments = umbrage::glsl::summed_moments.name;
bool is_table(std::string_view name) { return name == of_variance || name == of_moments; }

/// Bytes of a texel, and what its target makes of it: floats hold what they are given, but turned moments are made for
/// four channels of 16 bits.
template <class Prefilter>
constexpr int bytes_of(const Prefilter&) {
    return sizeof(typename Prefilter::texel);
}
constexpr int bytes_of(const prefilters::msm_unorm16&) { return 8; }
template <class Prefilter>
void store(const Prefilter&, umbrage::image<typename Prefilter::texel>&) {}
void store(const prefilters::msm_unorm16&, umbrage::image<glm::vec4>& texels) {
    for (glm::vec4& t : texels.texels()) t = glm::floor(glm::clamp(t, 0.0f, 1.0f) * 65535.0f + 0.5f) / 65535.0f;
}

umbrage::blur_kernel kernel_of(int radius) {
    return radius > 0 ? umbrage::make_gaussian_kernel(2 * radius + 1, 0.5f * static_cast<float>(radius))
                      : umbrage::blur_kernel{{1.0f}};
}

template <class Prefilter>
look_up of_blurred(const Prefilter& filter, umbrage::image_view<const float> map, int radius, progress& progress) {
    using image = umbrage::image<typename Prefilter::texel>;
    image moments(map.size);
    const auto blurred = std::make_shared<image>(map.size);
    umbrage::encode_moments(map, moments.view(), filter, progress.bands());
    store(filter, moments);
    umbrage::blur(moments, *blurred, kernel_of(radius), progress.bands());
    store(filter, *blurred);
    return [=, &progress](const umbrage::sloped_receivers& receivers, umbrage::image_view<float> visibility) {
        umbrage::visibility(std::as_const(*blurred).view(), filter, receivers.at, visibility, progress.bands());
    };
}

/// @param table, of   a summed-area table, and what it was made for
template <class Kind>
look_up of_table(umbrage::image<glm::u16vec4> table, const Kind& of, progress& progress) {
    const auto kept = std::make_shared<const umbrage::image<glm::u16vec4>>(std::move(table));
    return [=, &progress](const umbrage::sloped_receivers& r, umbrage::image_view<float> visibility) {
        umbrage::image<glm::vec3> receivers(visibility.size);
        for (glm::ivec2 p{0}; p.y < visibility.size.y; ++p.y)
            for (p.x = 0; p.x < visibility.size.x; ++p.x) receivers[p] = {r.at.x[p], r.at.y[p], r.at.depth[p]};
        umbrage::visibility(kept->view(), of, std::as_const(receivers).view(), of.radius, visibility, progress.bands());
    };
}

}  // namespace

const std::vector<std::string>& prefilter_names() {
    static const std::vector<std::string> names = [] {
        std::vector<std::string> all;
        prefilters::all::for_each([&](const auto& filter) { all.emplace_back(filter.name); });
        all.insert(all.end(), {std::string(of_variance), std::string(of_moments)});
        return all;
    }();
    return names;
}

int prefilter_bytes(std::string_view name) {
    int bytes = static_cast<int>(sizeof(glm::u16vec4)) * (name == of_moments ? 2 : 1);
    prefilters::all::with(name, [&](const auto& filter) { bytes = bytes_of(filter); });
    return bytes;
}

bool filters_ahead(std::string_view filter) {
    return std::ranges::find(prefilter_names(), filter) != prefilter_names().end();
}

std::optional<float> soft_reach(std::string_view name, float max_radius) {
    if (hardens(name)) return umbrage::filters::pcss{.softness{.max_radius = 16 * max_radius}}.reach();
    if (filters_ahead(name)) return is_table(name) ? 0.5f : 0.0f;
    return std::nullopt;
}

look_up prefiltered(std::string_view name, umbrage::image_view<const float> map, int radius, progress& progress) {
    if (name == of_variance) {
        const umbrage::variance_table of{.bits = variance_bits, .radius = radius};
        return of_table(umbrage::make_variance_table(map, of, progress.bands()), of, progress);
    }
    if (name == of_moments) {
        const umbrage::moment_table of{.radius = radius};
        return of_table(umbrage::make_moment_table(map, of, progress.bands()), of, progress);
    }
    look_up out;
    prefilters::all::with(name, [&](const auto& filter) { out = of_blurred(filter, map, radius, progress); });
    if (!out) throw std::invalid_argument("no prefiltered map is called " + std::string(name));
    return out;
}

}  // namespace example
