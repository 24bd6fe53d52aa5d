// SPDX-License-Identifier: MIT
#include "ray_light.hpp"

#include <algorithm>

#include <umbrage/light/cascades/cascades.hpp>

namespace parity {
namespace {

/// The proof's number of the n-th scene with a light of a kind, in a clip space whose depth runs forward.
std::uint64_t scene_number(ray_kind kind, std::uint64_t n) {
    std::vector<std::uint64_t> kinds;
    for (std::uint64_t k = 0; k < proof::light_kinds.size(); ++k) {
        const proof::light_kind& one = proof::light_kinds[k];
        const bool is_plain = one.receivers < proof::light_kind::fitted_to::cascade;
        if (kind == ray_kind::spot ? one.is_spot : !one.is_spot && is_plain) kinds.push_back(k);
    }
    const std::uint64_t clip = n / kinds.size();
    return kinds[n % kinds.size()] + proof::light_kinds.size() * ((clip & 1) | (clip >> 1) << 2);
}

}  // namespace

ray_light::ray_light(ray_kind kind, std::uint64_t n) : ray_scene(scene_number(kind, n)) {
    using namespace umbrage;
    if (kind == ray_kind::cascade) make_cascade(n);
    image<float> depths({map_size, map_size}, cleared_depth(clip_));
    rasterize_depth(depths, {positions_, triangles_}, light_.projection * light_.view, clip_, cull_mode::none, serial{},
                    kind_.at_near);
    map_ = texels(depths.size());
    std::transform(depths.texels().begin(), depths.texels().end(), map_.texels().begin(),
                   [](float depth) { return vec4(depth); });
}

/// One of three, stable or tight in turn, for its part of the camera's range.
void ray_light::make_cascade(std::uint64_t n) {
    using namespace umbrage;
    kind_ = proof::light_kinds[2];  // casters apart
    const auto splits = practical_splits<3>(camera_.z_near, camera_.z_far, 0.5f);
    const cascade_fit<float> fit{.camera = camera_,
                                 .direction = direction_,
                                 .scene = box_,
                                 .map_size = {map_size, map_size},
                                 .margin = widest_reach,
                                 .clip = clip_};
    cascade_ = (n % 2 ? make_stable_cascades<3>(fit, splits) : make_tight_cascades<3>(fit, splits))[n / 2 % 3];
    camera_.z_near = cascade_.begin, camera_.z_far = cascade_.end;
    light_ = cascade_.light;
    matrix_ = texture_matrix(light_, {map_size, map_size});
    planes_ = plane_matrix(matrix_);
}

std::optional<ray_light::receiver> ray_light::try_to_draw(random& r) const {
    receiver p{.triangle = static_cast<std::size_t>(r.below(static_cast<int>(triangles_.size())))};
    p.share = {r.unit(), r.unit()};
    if (p.share.x + p.share.y > 1.0f) p.share = 1.0f - p.share;
    const auto [a, b, c] = corners(p.triangle);
    p.world = vec3(a + double(p.share.x) * (b - a) + double(p.share.y) * (c - a));
    const vec3 at = coordinate(p.world);
    const auto within = [](float v) { return v >= widest_reach && v <= map_size - widest_reach; };
    const bool is_held = within(at.x) && within(at.y) && at.z >= 0.0f && at.z <= 1.0f;
    return is_held && is_received(p.world) ? std::optional(p) : std::nullopt;
}

ray_light::receiver ray_light::draw(random& r) const {
    while (true)
        if (const auto found = try_to_draw(r)) return *found;
}

bool ray_light::has_receivers() const {
    random r(0);
    int found = 0;
    for (int i = 0; i < 1024; ++i) found += try_to_draw(r).has_value();
    return found >= 32;
}

void ray_light::move_to_border(receiver& p, int steps) const {
    const auto [a, b, c] = corners(p.triangle);
    const auto world = [&, a = a, b = b, c = c](double u) { return a + u * (b - a) + double(p.share.y) * (c - a); };
    const auto column = [&](double u) {
        const glm::dvec4 h = glm::dmat4(matrix_) * glm::dvec4(world(u), 1.0);
        return h.x / h.w * steps;
    };
    double u = double(p.share.x);
    const double border = std::round(column(u)), step = 1e-6;
    for (int i = 0; i < 4; ++i) {
        const double change = (column(u + step) - column(u - step)) / (2.0 * step);
        if (std::abs(change) > 1.0) u += (border - column(u)) / change;
    }
    if (!(u >= 0.0 && u + double(p.share.y) <= 1.0)) return;
    p.share.x = static_cast<float>(u);
    p.world = vec3(world(u));
}

std::array<vec3, 3> ray_light::corners_of(const receiver& p) const {
    const auto [a, b, c] = corners(p.triangle);
    return {vec3(a), vec3(b), vec3(c)};
}

void ray_light::fill(const receiver& p, float reach, sample& s) const {
    const vec2 change = slope(p.triangle);
    const float error = rounding(p.world);
    s.x[0] = vec4(p.world, allowed_reach(reach));
    if (is_cascade()) {
        const glm::mat4& rotation = light_.view;
        s.x[1] = vec4(vec3(rotation[0]), change.x);
        s.x[2] = vec4(vec3(rotation[1]), change.y);
        s.x[3] = vec4(vec3(rotation[2]), error);
        s.x[4] = cascade_.scale;
        s.x[5] = cascade_.offset;
        return;
    }
    for (int column = 0; column < 4; ++column) s.x[std::size_t(1 + column)] = matrix_[column];
    s.x[5] = {change.x, change.y, error, 0.0f};
}

void ray_light::move_to_depth(sample& s, vec4 result) const {
    float& error = is_cascade() ? s.x[3].w : s.x[5].z;
    const float stored = map_[glm::ivec2(glm::floor(vec2(result.y, result.z)))].x;
    error = std::max(error + (result.w - stored), 0.0f);
}

bool ray_light::is_told(const receiver& p, float reach) const {
    const float bias = umbrage::acne_free_bias(slope(p.triangle), allowed_reach(reach), rounding(p.world));
    return !is_near_edge(coordinate(p.world), reach + 1.0f) && told_by_rays(p.world, p.triangle, bias, reach);
}

std::vector<ray_light> ray_lights(ray_kind kind, std::size_t count) {
    std::vector<ray_light> all;
    for (std::uint64_t n = 0; all.size() < count; ++n) {
        ray_light one(kind, n);
        if (one.has_receivers()) all.push_back(std::move(one));
    }
    return all;
}

}  // namespace parity
