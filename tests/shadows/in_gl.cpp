// SPDX-License-Identifier: MIT
//
// Shadows in shaders: a cascaded sun, a spot packed into bytes, one under a comparison sampler and a cube in one; soft
// shadows and prefiltered maps in another; seven cascades, a tetrahedron and paraboloids in a third; warped cascades,
// pages, in an atlas and in an array, and a filter of a user's own in a fourth. OpenGL and C++ have to say the same of
// each receiver.
//
//     shadows_in_gl          prints how many receivers differ, in each dialect; 1 when some do
//     shadows_in_gl --fault  one number of each block is wrong: all must differ
#include <cstdio>
#include <exception>
#include <string>
#include <string_view>
#include <vector>

#include <umbrage/umbrage.hpp>

#include "../../examples/viewer/headless.hpp"
#include "../unit/shadow/own_filter.hpp"
#include "../unit/shadow/scene.hpp"
#include "drawn_in_gl.hpp"

namespace {

using namespace shadows_in_gl;
using glsl::bind;

/// Draws, compares, prints.
/// @return   false where a receiver differs, or with a fault where none does
bool agree(version v, std::vector<tried> all, const receivers& of, bool fault) {
    if (fault)
        for (tried& t : all) t.block[0] += 0.01f;
    const auto wrong = compare(v, all, of.points, of.normals);
    std::printf("GLSL %s, %s: %d receivers, differing:", std::string(directive(v)).c_str(), glGetString(GL_RENDERER),
                target_size.x * target_size.y);
    bool good = true;
    for (std::size_t i = 0; i < all.size(); ++i) {
        std::printf(" %s %d", all[i].name.c_str(), wrong[i]);
        good = good && fault == (wrong[i] != 0);
    }
    std::puts("");
    return good;
}

/// The maps of an atlas one below the other, as an array's layers lie.
template <class Shadow>
image<float> layers_of(const Shadow& s, const image<float>& atlas) {
    const map_grid grid = std::remove_cvref_t<decltype(s.set_up())>::grid;
    const glm::ivec2 size = s.map_size();
    image<float> layers({size.x, size.y * grid.columns * grid.rows});
    for (glm::ivec2 p(0); p.y < layers.size().y; ++p.y)
        for (p.x = 0; p.x < size.x; ++p.x)
            layers[p] = atlas[detail::first_texel(p.y / size.y, grid, size) + glm::ivec2(p.x, p.y % size.y)];
    return layers;
}

}  // namespace

int main(int argc, char** argv) try {
    const bool fault = argc > 1 && std::string_view(argv[1]) == "--fault";
    const clip_space clip = opengl_clip_space;
    const shadow sun(shadow_scene::cascades(clip), {256, 256}, filters::tent<3>);
    const shadow spot(shadow_scene::spot(clip), {256, 128}, filters::pcf_2x2{}, rg<11>{});
    const shadow sampled(shadow_scene::fitted(clip), {200, 300}, filters::box{.radius = 1});
    const shadow bulb(shadow_scene::bulb(clip), {256, 256}, filters::disc{});
    const auto sun_map = shadow_scene::drawn(sun), sampled_map = shadow_scene::drawn(sampled),
               bulb_map = shadow_scene::drawn(bulb);
    const auto spot_map = shadow_scene::drawn(spot);
    const auto layers = layers_of(sun, sun_map);

    const filters::pcss contact{.softness = {0.05f, 1.0f, 8.0f}};
    const shadow soft(shadow_scene::fitted(clip), {200, 300}, contact);
    const shadow soft_sun(shadow_scene::cascades(clip), {256, 256}, contact);
    const shadow variance(shadow_scene::spot(clip), {256, 256}, prefilters::vsm{});
    const shadow powers(shadow_scene::bulb(clip), {256, 256}, prefilters::evsm4{});
    const auto soft_map = shadow_scene::drawn(soft), soft_sun_map = shadow_scene::drawn(soft_sun);
    const auto variance_map = shadow_scene::drawn(variance);
    const auto powers_map = shadow_scene::drawn(powers);

    const shadow seven(shadow_scene::cascades<7>(clip), {128, 128}, filters::pcf_2x2{});
    const shadow sides(shadow_scene::tetrahedron(clip), {512, 512}, filters::tent<3>);
    const shadow halves(shadow_scene::paraboloids(clip), {512, 512}, filters::pcf_2x2{});
    const auto seven_map = shadow_scene::drawn(seven), sides_map = shadow_scene::drawn(sides),
               halves_map = shadow_scene::drawn(halves);

    const shadow bent(shadow_scene::warped<4>(clip), {256, 256}, filters::tent<3>);
    const shadow paged(shadow_scene::pages(clip), {80, 80}, filters::disc{});
    const shadow own_filter(shadow_scene::cascades(clip), {256, 256}, own::two_taps{});
    const auto own_map = shadow_scene::drawn(own_filter);
    const auto bent_map = shadow_scene::drawn(bent), paged_map = shadow_scene::drawn(paged);
    const auto pages = layers_of(paged, paged_map);

    const receivers of;
    bool good = true;
    for (const version v : {version::v330, version::v450, version::v100}) {
        const bool old = v == version::v100;
        const viewer::headless context(old);
        if (v == version::v450 && epoxy_gl_version() < 45) {
            std::puts("GLSL 450: not here");
            continue;
        }
        const GLint red = old ? GLint(GL_LUMINANCE) : GL_R32F;
        const GLenum format = old ? GL_LUMINANCE : GL_RED;
        const texture_data array{.kind = GL_TEXTURE_2D_ARRAY, .size = {256, 256, 4}, .texels = layers.texels().data()};
        const texture_data tiles{
            .internal = red, .format = format, .size = {512, 512, 1}, .texels = sun_map.texels().data()};
        const texture_data packed{.internal = old ? GLint(GL_LUMINANCE_ALPHA) : GL_RG8,
                                  .format = GLenum(old ? GL_LUMINANCE_ALPHA : GL_RG),
                                  .type = GL_UNSIGNED_BYTE,
                                  .size = {256, 128, 1},
                                  .texels = spot_map.texels().data()};
        texture_data depth{
            .internal = red, .format = format, .size = {200, 300, 1}, .texels = sampled_map.texels().data()};
        if (!old) depth.internal = GL_DEPTH_COMPONENT32F, depth.format = GL_DEPTH_COMPONENT, depth.compares = GL_LEQUAL;
        const texture_data faces{
            .internal = red, .format = format, .size = {768, 512, 1}, .texels = bulb_map.texels().data()};
        std::vector<tried> all;
        all.push_back(make("sun", sun, bind(sun, "sun", {.map = old ? glsl::texture::atlas : glsl::texture::array}),
                           old ? tiles : array, sun_map));
        all.push_back(make("spot", spot, bind(spot, "spot", {.block = 1, .texture = 2}), packed, spot_map));
        if (old) all.back().item.map.depth = "umbrage_decode_rg11(value.xw, 1.0)";  // GL_LUMINANCE_ALPHA: (r, r, r, g)
        all.push_back(
            make("lamp", sampled,
                 bind(sampled, "lamp",
                      {.block = 2, .texture = 3, .map = old ? glsl::texture::texture_2d : glsl::texture::shadow}),
                 depth, sampled_map));
        all.push_back(make("bulb", bulb, bind(bulb, "bulb", {.block = 3, .texture = 4}), faces, bulb_map));
        glPixelStorei(GL_UNPACK_ALIGNMENT, 1);
        good = agree(v, std::move(all), of, fault) && good;

        const auto one_channel = [&](const auto& map) {
            return texture_data{
                .internal = red, .format = format, .size = {map.size(), 1}, .texels = map.texels().data()};
        };
        std::vector<tried> chosen;
        chosen.push_back(make("bent", bent, bind(bent, "bent"), one_channel(bent_map), bent_map));
        chosen.push_back(
            make("paged", paged, bind(paged, "paged", {.block = 1, .texture = 2}), one_channel(paged_map), paged_map));
        if (!old) {
            const texture_data array_of_pages{
                .kind = GL_TEXTURE_2D_ARRAY, .size = {80, 80, 64}, .texels = pages.texels().data()};
            chosen.push_back(make("layers", paged,
                                  bind(paged, "layers", {.block = 2, .texture = 3, .map = glsl::texture::array}),
                                  array_of_pages, paged_map));
        }
        chosen.push_back(make("mine", own_filter, bind(own_filter, "mine", {.block = 3, .texture = 4}),
                              one_channel(own_map), own_map));
        good = agree(v, std::move(chosen), of, fault) && good;
        if (old) continue;  // which has no textures of two or four floats

        const auto floats = [](const auto& map, GLint stored, GLenum channels) {
            return texture_data{
                .internal = stored, .format = channels, .size = {map.size(), 1}, .texels = map.texels().data()};
        };
        std::vector<tried> smooth;
        smooth.push_back(make("soft", soft, bind(soft, "soft"), floats(soft_map, GL_R32F, GL_RED), soft_map));
        smooth.push_back(make("soft_sun", soft_sun, bind(soft_sun, "soft_sun", {.block = 1, .texture = 2}),
                              floats(soft_sun_map, GL_R32F, GL_RED), soft_sun_map));
        smooth.push_back(make("variance", variance, bind(variance, "variance", {.block = 2, .texture = 3}),
                              floats(variance_map, GL_RG32F, GL_RG), variance_map));
        smooth.push_back(make("powers", powers, bind(powers, "powers", {.block = 3, .texture = 4}),
                              floats(powers_map, GL_RGBA32F, GL_RGBA), powers_map));
        good = agree(v, std::move(smooth), of, fault) && good;

        std::vector<tried> others;
        others.push_back(make("seven", seven, bind(seven, "seven"), floats(seven_map, GL_R32F, GL_RED), seven_map));
        others.push_back(make("sides", sides, bind(sides, "sides", {.block = 1, .texture = 2}),
                              floats(sides_map, GL_R32F, GL_RED), sides_map));
        others.push_back(make("halves", halves, bind(halves, "halves", {.block = 2, .texture = 3}),
                              floats(halves_map, GL_R32F, GL_RED), halves_map));
        good = agree(v, std::move(others), of, fault) && good;
    }
    return good ? 0 : 1;
} catch (const viewer::no_context& e) {
    std::puts(e.what());
    return 77;
} catch (const std::exception& e) {
    std::fprintf(stderr, "%s\n", e.what());
    return 1;
}
