// SPDX-License-Identifier: MIT
#include <cstdint>

#include <glm/vec2.hpp>
#include <glm/vec3.hpp>
#include <glm/vec4.hpp>

#include <umbrage/depth/rg.hpp>
#include <umbrage/images/blur.hpp>
#include <umbrage/images/depth_span.hpp>
#include <umbrage/images/encode.hpp>
#include <umbrage/images/filter_bounds.hpp>
#include <umbrage/images/min_max.hpp>
#include <umbrage/images/moment_table.hpp>
#include <umbrage/images/prefilter.hpp>
#include <umbrage/images/summed_area.hpp>
#include <umbrage/images/variance_table.hpp>

#include "functions.hpp"

namespace {

using namespace umbrage;

const image<float> depths = random_depths({190, 37});

image<glm::vec3> receivers() {
    numbers random;
    image<glm::vec3> all({70, 20});
    for (glm::vec3& r : all.texels()) r = {random(-2, 192), random(-2, 39), random(0, 1)};
    return all;
}

blob codes(const hook& parallel) {
    image<glm::u8vec2> texels(depths.size());
    encode(depths.view(), texels.view(), rg<11>{}, parallel);
    image<float> back(depths.size());
    decode(std::as_const(texels).view(), back.view(), rg<11>{}, parallel);
    return blob_of(back);
}

blob prefiltered(const hook& parallel) {
    constexpr prefilters::vsm filter{};
    image<glm::vec2> moments(depths.size()), blurred(depths.size());
    encode_moments(depths, moments, filter, parallel);
    blur(moments.view(), blurred.view(), make_gaussian_kernel(5, 1.0f), parallel);
    const auto seen = receivers();
    image<float> out(seen.size());
    visibility(blurred, filter, seen, out, parallel);
    blob all = blob_of(out);
    for (const auto& level : make_mip_chain(blurred, 3, parallel)) {
        const blob more = blob_of(level);
        all.insert(all.end(), more.begin(), more.end());
    }
    return all;
}

template <class Value>
blob sums(const hook& parallel) {
    image<Value> values(depths.size()), table(depths.size());
    for (std::size_t i = 0; i < values.texels().size(); ++i)
        values.texels()[i] = static_cast<Value>(100 * depths.texels()[i]);
    summed_area(values.view(), table.view(), parallel);
    return blob_of(table);
}

template <class Table>
blob box(const image<glm::u16vec4>& table, const Table& of, const hook& parallel) {
    const auto seen = receivers();
    image<float> out(seen.size());
    visibility(table, of, seen, 3, out, parallel);
    return blob_of(out);
}

blob span(const hook& parallel) {
    const depth_span seen = measure_depths(depths, 1.0f, parallel);
    return blob_of(std::span<const float>(&seen.least, 2));
}

blob pyramid(const hook& parallel) {
    blob all;
    for (const auto& level : make_min_max_pyramid(depths, 3, parallel))
        for (const auto* image : {&level.least, &level.greatest}) {
            const blob more = blob_of(*image);
            all.insert(all.end(), more.begin(), more.end());
        }
    return all;
}

}  // namespace

std::vector<function> tables() {
    return {
        {"encode, decode", codes},
        {"encode_moments, blur, make_mip_chain, visibility", prefiltered},
        {"summed_area of integers", sums<std::uint32_t>},
        {"summed_area of floats", sums<float>},
        {"make_moment_table, visibility",
         [](const hook& h) {
             const moment_table of{.radius = 4};
             return box(make_moment_table(depths, of, h), of, h);
         }},
        {"make_variance_table, visibility",
         [](const hook& h) {
             const variance_table of{.radius = 4};
             return box(make_variance_table(depths, of, h), of, h);
         }},
        {"measure_depths", span},
        {"make_filter_bounds",
         [](const hook& h) { return blob_of(make_filter_bounds(depths, 3.5f, depth_direction::forward, h).bounds); }},
        {"make_min_max_pyramid", pyramid}};
}
