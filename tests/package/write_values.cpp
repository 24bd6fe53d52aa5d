// SPDX-License-Identifier: MIT
//
// Expected results of umbrage/values, from umbrage::shadow, one case in JSON per line:  write_values FILE
#include <fstream>
#include <iomanip>
#include <iostream>
#include <random>
#include <sstream>
#include <string>
#include <vector>

#include "common/sun_pages.hpp"
#include "languages.hpp"
#include "shadows.hpp"

namespace package {
namespace {

using namespace umbrage;

std::string json(double number) {
    std::ostringstream out;
    out << std::setprecision(17) << number;
    return out.str();
}
std::string json(glm::dvec3 v) { return '[' + json(v.x) + ',' + json(v.y) + ',' + json(v.z) + ']'; }
std::string json(const glm::dmat4& m) {
    std::string out;
    for (int i = 0; i < 16; ++i) out += (i > 0 ? "," : "[") + json(m[i / 4][i % 4]);
    return out + ']';
}
std::string json(glm::vec4 v) { return json(v.x) + ',' + json(v.y) + ',' + json(v.z) + ',' + json(v.w); }
std::string json(const bounding_box<double>& box) {
    return "{\"low\":" + json(box.low) + ",\"high\":" + json(box.high) + '}';
}

/// Floats as their bits.
std::string bits(const void* from, std::size_t count) {
    std::string out = "[";
    const auto* bytes = static_cast<const unsigned char*>(from);
    for (std::size_t i = 0; i < count; ++i) {
        std::uint32_t word;
        std::memcpy(&word, bytes + 4 * i, 4);
        out += (i > 0 ? "," : "") + std::to_string(word);
    }
    return out + ']';
}

class writer {
public:
    explicit writer(std::ostream& out) : out_(out) {}

    void of_clip_space(std::string_view name, const clip_space& clip) {
        clip_name_ = name;
        clip_ = clip;
        for_each_light(clip, [&](std::string_view kind, const auto& light) {
            for_each_shadow_filter(light, [&]<class Filter>(const Filter& filter) {
                if constexpr (detail::contact_hardening<Filter>)
                    given_ = ",\"filter\":{\"light_size\":0.25,\"max_radius\":6}";
                of_kind(kind, filter, depth32f{});
                given_ = "";
            });
        });
        for_each_encoding([&](auto encoding) {
            encoding = {.direction = clip_.direction};
            of_kind("spot_light", filters::tent<3>, encoding);
            of_kind("cascades", filters::tent<3>, encoding);
        });
        given_ = ",\"filter\":{\"radius\":3.25}";
        of_kind("point_light", filters::disc{.points = 8, .radius_texels = 3.25f}, depth32f{});
        given_ = ",\"filter\":{\"radius\":4}";
        of_kind("spot_light", filters::box{.radius = 4}, depth32f{});
        given_ = ",\"filter\":{\"light_size\":0.125,\"min_radius\":0.5,\"max_radius\":4}";
        for (const auto& kind : {"directional_light", "cascades", "cascades_8", "adaptive_pages", "point_light"})
            of_kind(kind, filters::dpcf{.points = 32, .softness = make_penumbra_params(0.125f, 0.5f, 4.0f)},
                    depth32f{});
        given_ = ",\"filter\":{\"exponents\":[20,5]}";
        prefilters::evsm4 evsm;
        evsm.parameters.exponents = {20, 5};
        of_kind("cascades_8", evsm, depth32f{});
        given_ = "";
    }

private:
    double number(double low, double high) { return std::uniform_real_distribution(low, high)(random_); }
    glm::dvec3 vector(double size) { return {number(-size, size), number(-size, size), number(-size, size)}; }

    /// A light of the kind, at random.
    void of_kind(std::string_view kind, const auto& filter, const auto& encoding) {
        const glm::dvec3 position = vector(20), ahead = vector(1) - glm::dvec3(0, 2, 0);
        const double z_near = number(0.1, 1), z_far = number(20, 50);
        const bounding_box<double> box{vector(10) - 20.0, vector(10) + 20.0}, casters{box.low - 5.0, box.high + 9.0};
        const int border = 16, size = shadow_size;
        const std::string planes = ",\"z_near\":" + json(z_near) + ",\"z_far\":" + json(z_far);
        const std::string at = ",\"position\":" + json(position), along = ",\"direction\":" + json(ahead);
        if (kind == "spot_light")
            add(kind,
                make_spot_light<double>({.position = position,
                                         .direction = ahead,
                                         .outer_angle_radians = 0.5,
                                         .z_near = z_near,
                                         .z_far = z_far,
                                         .clip = clip_}),
                filter, encoding, at + along + planes + ",\"outer_angle_radians\":0.5");
        if (kind == "directional_light") {
            const bool snap = number(0, 1) > 0.5, cast = number(0, 1) > 0.5;
            directional_fit<double> fit{
                .direction = ahead, .receivers = box, .snap_texels = glm::ivec2(snap ? size : 0), .clip = clip_};
            if (cast) fit.casters = casters;
            add(kind, fit_directional_light<double>(fit), filter, encoding,
                along + ",\"receivers\":" + json(box) + (snap ? ",\"snap\":true" : "") +
                    (cast ? ",\"casters\":" + json(casters) : ""));
        }
        if (kind == "cascades" || kind == "cascades_8" || kind == "warped_cascades")
            of_cascades(kind, filter, encoding, ahead, box, along);
        if (kind == "adaptive_pages") of_pages(filter, encoding, ahead, box, along);
        if (kind == "point_light")
            add(kind, point_light<double>{position, z_near, z_far, size, border, clip_}, filter, encoding,
                at + planes + ",\"border\":16");
        if (kind == "tetrahedron_light")
            add(kind, tetrahedron_light<double>{position, z_near, z_far, size, border, clip_}, filter, encoding,
                at + planes + ",\"border\":16");
        if constexpr (!detail::contact_hardening<std::decay_t<decltype(filter)>>)
            if (kind == "dual_paraboloid_light")
                add(kind, dual_paraboloid_light<double>{position, z_far, size, border, clip_}, filter, encoding,
                    at + ",\"range\":" + json(z_far) + ",\"border\":16");
    }

    light_space<double> camera() {
        return make_spot_light<double>({.position = vector(10),
                                        .direction = vector(1) + glm::dvec3(0, 0, -3),
                                        .outer_angle_radians = 0.4,
                                        .aspect = 1.5,
                                        .z_near = 0.5,
                                        .z_far = 60,
                                        .clip = clip_});
    }
    static std::string json_of(const light_space<double>& eye) {
        return ",\"camera\":{\"view\":" + json(eye.view) + ",\"projection\":" + json(eye.projection) +
               ",\"z_near\":0.5,\"z_far\":60}";
    }

    /// Pages of three points in four; the fourth is none.
    void of_pages(const auto& filter, const auto& encoding, glm::dvec3 ahead, const bounding_box<double>& scene,
                  const std::string& along) {
        const light_space<double> eye = camera(),
                                  root = example::page_root_around(scene.low, scene.high, ahead, {0, 1, 0}, clip_);
        const page_size size{.texels = 128, .gutter = 64};
        example::page_wishes wishes(root, ahead, size.texels, texture_matrix(eye, {640, 360}));
        std::string points, normals;
        for (int i = 0; i < 40; ++i) {
            const glm::vec4 point(vector(10), i % 4), normal(glm::normalize(vector(1)), 0);
            points += (i > 0 ? "," : "") + json(point), normals += (i > 0 ? "," : "") + json(normal);
            if (i % 4 > 0) wishes.add(glm::vec3(point), glm::vec3(normal));
        }
        page_cache cache({.slots = {8, 8}, .deepest_level = 4, .target = 0.5});
        static_cast<void>(cache.update(wishes.all()));
        add("adaptive_pages", adaptive_maps(root, cache, size), filter, encoding,
            along + ",\"scene\":" + json(scene) + json_of(eye) +
                ",\"picture\":[640,360],\"gutter\":64,\"target\":0.5,\"points\":[" + points + "],\"normals\":[" +
                normals + ']');
    }
    void of_cascades(std::string_view kind, const auto& filter, const auto& encoding, glm::dvec3 ahead,
                     const bounding_box<double>& scene, const std::string& along) {
        const light_space<double> eye = camera();
        const auto view = make_frustum<double>(
            {.view = eye.view, .projection = eye.projection, .z_near = 0.5, .z_far = 60, .clip = clip_});
        const cascade_fit<double> fit{.camera = view,
                                      .direction = ahead,
                                      .scene = scene,
                                      .map_size = glm::ivec2(shadow_size),
                                      .margin = detail::reach_of(filter),
                                      .overlap = 0.125,
                                      .clip = clip_};
        const bool own = number(0, 1) > 0.5;
        const std::string told = along + ",\"scene\":" + json(scene) + ",\"overlap\":0.125" + json_of(eye);
        if (kind == "cascades") {
            const auto splits = own ? std::array{0.5, 4.0, 13.0, 60.0} : practical_splits<3>(0.5, 60.0, 0.9);
            add(kind, cascaded_maps(make_stable_cascades<3>(fit, splits), 8.0f), filter, encoding,
                told + ",\"blend_texels\":8" + (own ? ",\"splits\":[0.5,4,13,60]" : ",\"cascades\":3"),
                own ? "" : "exp");
        } else if (kind == "warped_cascades") {
            const auto warp = [](const warp_fit<double>& part) { return fit_light_space_perspective(part); };
            add(kind, warped_maps(make_warped_cascades<2>(fit, practical_splits<2>(0.5, 60.0, 0.9), warp), view, 0.125),
                filter, encoding, told + ",\"cascades\":2", "exp");
        } else
            add(kind, cascaded_maps(make_stable_cascades<8>(fit, practical_splits<8>(0.5, 60.0, 0.9))), filter,
                encoding, told, "exp");
    }

    /// @param calls   which function of the C library
    void add(std::string_view kind, const auto& light, const auto& filter, const auto& encoding,
             const std::string& told, std::string_view calls = "") {
        using filter_type = std::decay_t<decltype(filter)>;
        const glm::dvec3 origin = number(0, 1) > 0.5 ? vector(50) : glm::dvec3(0);
        if constexpr (prefilter<filter_type>)
            print(kind, shadow(light, glm::ivec2(shadow_size), filter), "", origin, told, calls);
        else print(kind, shadow(light, glm::ivec2(shadow_size), filter, encoding), encoding.name, origin, told, calls);
    }
    void print(std::string_view kind, const auto& of, std::string_view encoding, glm::dvec3 origin,
               const std::string& told, std::string_view calls) {
        const auto block = of.relative_to(origin).uniforms();
        std::vector<glm::mat4> matrices;
        double edge_angle = 0;
        if constexpr (has_bent_lines<std::decay_t<decltype(of.setup())>>)  // whose vertices no matrix has
            edge_angle = paraboloid_edge_angle<double>(shadow_size, of.setup().light.border);
        else
            for (const light_space<double>& light : of.setup().lights()) {
                const auto placed = detail::relative_to(origin, light);
                matrices.emplace_back(placed.projection * placed.view);
            }
        const std::vector<depth_view> views = of.relative_to(origin).depth_views();
        out_ << "{\"kind\":" << literal(kind) << ",\"filter\":" << literal(of.filter().snippet->name)
             << ",\"encoding\":" << literal(encoding) << ",\"calls\":" << literal(kind == "spot_light" ? "tan" : calls)
             << ",\"clip\":" << literal(clip_name_) << ",\"light\":{\"origin\":" << json(origin) << told << given_
             << "},\"edge_angle\":" << json(edge_angle) << ",\"block\":" << bits(&block, sizeof block / 4)
             << ",\"matrices\":" << bits(matrices.data(), 16 * matrices.size())
             << ",\"views\":" << bits(views.data(), 20 * views.size()) << "}\n";
    }

    std::ostream& out_;
    std::mt19937 random_{1};
    std::string_view clip_name_;
    clip_space clip_;
    std::string given_;
};

}  // namespace
}  // namespace package

int main(int argc, char** argv) {
    if (argc != 2) return 2;
    std::ofstream file(argv[1], std::ios::binary);
    package::writer out(file);
    package::for_each_clip_space(
        [&](std::string_view name, const umbrage::clip_space& clip) { out.of_clip_space(name, clip); });
    if (file) return 0;
    std::cerr << "write_values: cannot write " << argv[1] << '\n';
    return 1;
}
