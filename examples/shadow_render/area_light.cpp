// SPDX-License-Identifier: MIT
#include "area_light.hpp"

#include <cmath>
#include <cstddef>
#include <numbers>

#include <glm/geometric.hpp>

#include <ray_tracer.hpp>
#include <surface.hpp>

namespace shadow_render {
namespace {

/// Points of a disc as a sunflower has its seeds, turned by another angle in each sample.
glm::vec2 point_of_disc(int i, float turn) {
    const float angle = 2.39996323f * static_cast<float>(i) + turn;
    return std::sqrt((static_cast<float>(i) + 0.5f) / static_cast<float>(rays_a_sample)) *
           glm::vec2(std::cos(angle), std::sin(angle));
}

float turn_of(glm::ivec2 sample) {
    std::uint32_t hash = static_cast<std::uint32_t>(sample.x) * 0x9e3779b1u ^ static_cast<std::uint32_t>(sample.y);
    hash = (hash ^ (hash >> 15)) * 0x85ebca6bu;
    hash = (hash ^ (hash >> 13)) * 0xc2b2ae35u;
    return static_cast<float>(hash >> 8) * (2 * std::numbers::pi_v<float> / 0x1p24f);
}

}  // namespace

squared squared_error(const by_rays& expected, const umbrage::image<float>& visibility, int samples) {
    squared out;
    for (glm::ivec2 p{0}; p.y < visibility.size().y / samples; ++p.y)
        for (p.x = 0; p.x < visibility.size().x / samples; ++p.x) {
            float off = 0, counted = 0;
            for (int y = 0; y < samples; ++y)
                for (int x = 0; x < samples; ++x) {
                    const glm::ivec2 at = p * samples + glm::ivec2(x, y);
                    counted += expected.counted[at];
                    off += expected.counted[at] * (visibility[at] - expected.visibility[at]);
                }
            out.sum += std::pow(off / static_cast<float>(samples * samples), 2.0f);
            out.pixels += counted > 0;
        }
    return out;
}

double rms_error(const by_rays& expected, const umbrage::image<float>& visibility, int samples) {
    const auto [sum, pixels] = squared_error(expected, visibility, samples);
    return pixels > 0 ? 100 * std::sqrt(sum / pixels) : 0;
}

leaked leaked_light(const by_rays& expected, const umbrage::image<float>& visibility) {
    leaked out;
    for (std::size_t i = 0; i < visibility.texels().size(); ++i)
        if (expected.counted.texels()[i] && expected.visibility.texels()[i] <= 0)
            out.sum += visibility.texels()[i], ++out.samples;
    return out;
}

double leak(const by_rays& expected, const umbrage::image<float>& visibility) {
    const auto [sum, samples] = leaked_light(expected, visibility);
    return samples > 0 ? 100 * sum / samples : 0;
}

by_rays traced(const options& o, const view& v, example::progress& progress) {
    const example::ray_tracer rays(v.scene.geometry);
    const glm::vec3 axis = v.lamp.direction;
    const glm::vec3 side =
        glm::normalize(glm::cross(axis, glm::abs(axis.y) < 0.9f ? glm::vec3(0, 1, 0) : glm::vec3(1, 0, 0)));
    const glm::vec3 above = glm::cross(side, axis);
    by_rays out{umbrage::image<float>(v.seen.size(), 1.0f), umbrage::image<std::uint8_t>(v.seen.size())};

    const auto lit = [&](glm::vec3 from, glm::vec2 at) {
        const glm::vec3 aside = 0.5f * o.light_size * (at.x * side + at.y * above);
        const glm::vec3 to_light = v.lamp.spot() ? v.lamp.position + aside - from : aside - o.distance * axis;
        const float distance = glm::length(to_light);
        return !rays.blocked(from, to_light / distance, v.lamp.spot() ? distance : 1e3f);
    };
    const auto visibility = [&](glm::ivec2 sample, glm::vec3 from) {
        constexpr int first = 4;  // one in four: the rest where those differ
        const float turn = turn_of(sample);
        int sum = 0;
        for (int i = 0; i < rays_a_sample; i += first) sum += lit(from, point_of_disc(i, turn));
        if (sum == 0 || sum == rays_a_sample / first) return static_cast<float>(sum * first) / float(rays_a_sample);
        for (int i = 0; i < rays_a_sample; ++i) sum += i % first != 0 && lit(from, point_of_disc(i, turn));
        return static_cast<float>(sum) / float(rays_a_sample);
    };
    progress.bands()(v.seen.size().y, [&](int begin, int end) {
        for (int y = begin; y < end; ++y)
            example::for_each_run(v.seen, y, [&](int first, int last, std::uint32_t triangle) {
                const example::seen_triangle on = v.triangle(triangle);
                for (int x = first; x < last; ++x) {
                    const glm::ivec2 sample(x, y);
                    const glm::vec3 at = on.position(on.weights(sample)), face = on.face_normal(at);
                    const bool faces = glm::dot(face, v.lamp.to_light(at)) > 0.0f;
                    out.counted[sample] = faces && v.lamp.cone(at) > 0.0f;
                    out.visibility[sample] = faces ? visibility(sample, at + 1e-3f * face) : 0.0f;
                }
            });
    });
    return out;
}

}  // namespace shadow_render
