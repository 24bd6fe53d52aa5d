// SPDX-License-Identifier: MIT
//
// Shadows in shaders, a few to a text: a cascaded sun, a spot packed into bytes, one under a comparison sampler and a
// cube; warped cascades, pages, in an atlas and in an array; a filter and a setup of a user's own; soft shadows of four
// setups; prefiltered maps; a cube and a sun under comparison samplers; seven cascades, a tetrahedron and paraboloids;
// a linear comparison sampler; depth textures of 16 and 24 bits. OpenGL and C++ have to say the same of each receiver.
//
//     shadows_in_gl          prints how many receivers differ, in each dialect; 1 when some do
//     shadows_in_gl --fault  one number of each block is wrong: all must differ
#include <cstdint>
#include <cstdio>
#include <exception>
#include <string>
#include <string_view>
#include <vector>

#include <umbrage/umbrage.hpp>

#include "../../examples/viewer/headless.hpp"
#include "../unit/shadow/own_filter.hpp"
#include "../unit/shadow/own_setup.hpp"
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

/// tent<3> by a linear comparison sampler: each 2 x 2 texels are compared with the plane's depth where they meet.
template <class Shadow>
float by_sampler(const Shadow& s, const image<float>& map, glm::vec3 world, glm::vec3 normal) {
    const auto u = s.uniforms();
    const map_place place = s.setup().places(u.maps, u.terms, world, normal)[0];
    const glm::vec2 coord(place.at), x = coord - 0.5f, texel = glm::floor(x), moved = x - texel;
    const float z = place.at.z, steep = glm::abs(place.slope.x) + glm::abs(place.slope.y),
                receiver = z > 1.0f ? z : z - clamp_bias(u.terms.error + place.slack + 0.5f * steep);
    if (!in_filter_domain(coord, receiver)) return 1;
    const auto weight = [](int i, float by) {
        const float here = tent_row<3>.weight(i), before = tent_row<3>.weight(i - 1);
        return here + by * (before - here);
    };
    float sum = 0;
    for (int j = 0; j < 4; ++j)
        for (int i = 0; i < 4; ++i) {
            const glm::vec2 meet = texel + glm::vec2(i / 2 * 2, j / 2 * 2) - 0.5f;
            const float reference = plane_reference(receiver, place.slope, coord, meet);
            sum += weight(i, moved.x) * weight(j, moved.y) *
                   lit(bordered(map), glm::ivec2(texel) + glm::ivec2(i - 1, j - 1), reference);
        }
    return sum / 256.0f;
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

    const auto contact = shadow_scene::sized(filters::pcss{});
    const shadow soft(shadow_scene::fitted(clip), {200, 300}, contact);
    const shadow soft_sun(shadow_scene::cascades(clip), {256, 256}, contact);
    const shadow soft_bulb(shadow_scene::bulb(clip), {256, 256}, shadow_scene::sized(filters::dpcf{}));
    const shadow soft_pages(shadow_scene::pages(clip), {80, 80}, contact);
    const auto soft_bulb_map = shadow_scene::drawn(soft_bulb), soft_pages_map = shadow_scene::drawn(soft_pages);
    const shadow variance(shadow_scene::spot(clip), {256, 256}, prefilters::vsm{});
    const shadow powers(shadow_scene::bulb(clip), {256, 256}, prefilters::evsm4{});
    const auto soft_map = shadow_scene::drawn(soft), soft_sun_map = shadow_scene::drawn(soft_sun);
    const auto variance_map = shadow_scene::drawn(variance);
    const auto powers_map = shadow_scene::drawn(powers);

    const shadow seven(shadow_scene::cascades<7>(clip), {256, 256}, filters::pcf_2x2{});
    const shadow sides(shadow_scene::tetrahedron(clip), {512, 512}, filters::tent<3>);
    const shadow halves(shadow_scene::paraboloids(clip), {512, 512}, filters::pcf_2x2{});
    const auto seven_map = shadow_scene::drawn(seven), sides_map = shadow_scene::drawn(sides),
               halves_map = shadow_scene::drawn(halves);

    const shadow bent(shadow_scene::warped<4>(clip), {256, 256}, filters::tent<3>);
    const shadow paged(shadow_scene::pages(clip), {80, 80}, filters::disc{});
    const shadow own_filter(shadow_scene::cascades(clip), {256, 256}, own::two_taps{});
    const shadow own_setup(own::up_and_down{{0.5, 8, 0.25}, clip}, {256, 256}, filters::tent<3>);
    const auto own_map = shadow_scene::drawn(own_filter), both_map = shadow_scene::drawn(own_setup);
    const auto bent_map = shadow_scene::drawn(bent), paged_map = shadow_scene::drawn(paged);
    const auto pages = layers_of(paged, paged_map);

    const shadow shorts(shadow_scene::spot(clip), {256, 128}, filters::tent<3>, depth16{});
    const shadow words(shadow_scene::fitted(clip), {200, 300}, filters::pcf_2x2{}, depth24{});
    const auto shorts_map = shadow_scene::drawn(shorts);
    const auto words_map = shadow_scene::drawn(words);
    auto uploaded = words_map;  // 32 bits whose first 24 are the texel's
    for (std::uint32_t& k : uploaded.texels()) k = k << 8 | k >> 16;

    const shadow sampled_bulb(shadow_scene::bulb(clip), {256, 256}, filters::tent<3>);
    const shadow sampled_sun(shadow_scene::cascades(clip), {256, 256}, filters::castano<5>);
    const auto sampled_bulb_map = shadow_scene::drawn(sampled_bulb), sampled_sun_map = shadow_scene::drawn(sampled_sun);
    const auto sampled_faces = layers_of(sampled_bulb, sampled_bulb_map);
    const auto sampled_cascades = layers_of(sampled_sun, sampled_sun_map);

    const shadow fitted(shadow_scene::fitted(clip), {200, 300}, filters::tent<3>);
    const auto fitted_map = shadow_scene::drawn(fitted);

    const receivers of(target_size);
    bool good = true;
    for (const version v : {version::v330, version::v450, version::v100}) {
        const bool old = v == version::v100, gathers = v == version::v450;
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
        all.push_back(make(
            "sun", sun, bind(sun, "sun", {.map = old ? glsl::texture::atlas : glsl::texture::array, .gather = gathers}),
            old ? tiles : array, sun_map));
        all.push_back(
            make("spot", spot, bind(spot, "spot", {.block = 1, .texture = 2, .gather = gathers}), packed, spot_map));
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
        chosen.push_back(make("bent", bent, bind(bent, "bent", {.gather = gathers}), one_channel(bent_map), bent_map));
        chosen.push_back(
            make("paged", paged, bind(paged, "paged", {.block = 1, .texture = 2}), one_channel(paged_map), paged_map));
        if (!old) {
            const texture_data array_of_pages{
                .kind = GL_TEXTURE_2D_ARRAY, .size = {80, 80, 64}, .texels = pages.texels().data()};
            chosen.push_back(make("layers", paged,
                                  bind(paged, "layers", {.block = 2, .texture = 3, .map = glsl::texture::array}),
                                  array_of_pages, paged_map));
        }
        good = agree(v, std::move(chosen), of, fault) && good;

        std::vector<tried> own;
        own.push_back(make("mine", own_filter, bind(own_filter, "mine"), one_channel(own_map), own_map));
        own.push_back(make("both", own_setup, bind(own_setup, "both", {.block = 1, .texture = 2}),
                           one_channel(both_map), both_map));
        good = agree(v, std::move(own), of, fault) && good;
        if (old) continue;  // which has no textures of two or four floats

        const auto floats = [](const auto& map, GLint stored, GLenum channels) {
            return texture_data{
                .internal = stored, .format = channels, .size = {map.size(), 1}, .texels = map.texels().data()};
        };
        std::vector<tried> smooth;
        smooth.push_back(make("soft", soft, bind(soft, "soft"), floats(soft_map, GL_R32F, GL_RED), soft_map));
        smooth.push_back(make("soft_sun", soft_sun, bind(soft_sun, "soft_sun", {.block = 1, .texture = 2}),
                              floats(soft_sun_map, GL_R32F, GL_RED), soft_sun_map));
        smooth.push_back(make("soft_bulb", soft_bulb, bind(soft_bulb, "soft_bulb", {.block = 2, .texture = 3}),
                              floats(soft_bulb_map, GL_R32F, GL_RED), soft_bulb_map));
        smooth.push_back(make("soft_pages", soft_pages, bind(soft_pages, "soft_pages", {.block = 3, .texture = 4}),
                              floats(soft_pages_map, GL_R32F, GL_RED), soft_pages_map));
        good = agree(v, std::move(smooth), of, fault) && good;

        std::vector<tried> moments;
        moments.push_back(make("variance", variance, bind(variance, "variance"), floats(variance_map, GL_RG32F, GL_RG),
                               variance_map));
        moments.push_back(make("powers", powers, bind(powers, "powers", {.block = 1, .texture = 2}),
                               floats(powers_map, GL_RGBA32F, GL_RGBA), powers_map));
        good = agree(v, std::move(moments), of, fault) && good;

        std::vector<tried> others;
        others.push_back(make("seven", seven, bind(seven, "seven", {.gather = gathers}),
                              floats(seven_map, GL_R32F, GL_RED), seven_map));
        others.push_back(make("sides", sides, bind(sides, "sides", {.block = 1, .texture = 2, .gather = gathers}),
                              floats(sides_map, GL_R32F, GL_RED), sides_map));
        others.push_back(make("halves", halves, bind(halves, "halves", {.block = 2, .texture = 3, .gather = gathers}),
                              floats(halves_map, GL_R32F, GL_RED), halves_map));
        good = agree(v, std::move(others), of, fault) && good;

        const auto compared_layers = [](const image<float>& maps) {
            return texture_data{.kind = GL_TEXTURE_2D_ARRAY,
                                .internal = GL_DEPTH_COMPONENT32F,
                                .format = GL_DEPTH_COMPONENT,
                                .size = {256, 256, maps.size().y / 256},
                                .texels = maps.texels().data(),
                                .compares = GL_LEQUAL};
        };
        std::vector<tried> arrays;
        arrays.push_back(make("sampled_bulb", sampled_bulb,
                              bind(sampled_bulb, "sampled_bulb", {.map = glsl::texture::shadow_array}),
                              compared_layers(sampled_faces), sampled_bulb_map));
        arrays.push_back(
            make("sampled_sun", sampled_sun,
                 bind(sampled_sun, "sampled_sun", {.block = 1, .texture = 2, .map = glsl::texture::shadow_array}),
                 compared_layers(sampled_cascades), sampled_sun_map));
        good = agree(v, std::move(arrays), of, fault) && good;

        // softpipe compares with a filtered depth, it does not filter comparisons
        const bool filters_depths =
            std::string_view(reinterpret_cast<const char*>(glGetString(GL_RENDERER))).find("softpipe") == 0;
        std::vector<tried> linear;
        linear.push_back({"linear",
                          bind(fitted, "linear", {.map = glsl::texture::shadow, .linear = true}),
                          make("linear", fitted, bind(fitted, "linear"), {}, fitted_map).block,
                          {.internal = GL_DEPTH_COMPONENT32F,
                           .format = GL_DEPTH_COMPONENT,
                           .size = {fitted_map.size(), 1},
                           .texels = fitted_map.texels().data(),
                           .compares = GL_LEQUAL,
                           .filter = GL_LINEAR},
                          [&](glm::vec3 world, glm::vec3 normal, glm::ivec2) {
                              return by_sampler(fitted, fitted_map, world, normal);
                          },
                          "umbrage_linear(world, normal)",
                          [](glm::vec3) { return 1.0f / 64.0f; }});
        if (!filters_depths) good = agree(v, std::move(linear), of, fault) && good;

        const auto compared = [](const auto& map, GLint stored, GLenum type) {
            return texture_data{.internal = stored,
                                .format = GL_DEPTH_COMPONENT,
                                .type = type,
                                .size = {map.size(), 1},
                                .texels = map.texels().data(),
                                .compares = GL_LEQUAL};
        };
        std::vector<tried> integers;
        integers.push_back(make("shorts", shorts, bind(shorts, "shorts", {.map = glsl::texture::shadow}),
                                compared(shorts_map, GL_DEPTH_COMPONENT16, GL_UNSIGNED_SHORT), shorts_map));
        integers.push_back(make("words", words,
                                bind(words, "words", {.block = 1, .texture = 2, .map = glsl::texture::shadow}),
                                compared(uploaded, GL_DEPTH_COMPONENT24, GL_UNSIGNED_INT), words_map));
        good = agree(v, std::move(integers), of, fault) && good;
    }
    return good ? 0 : 1;
} catch (const viewer::no_context& e) {
    std::puts(e.what());
    return 77;
} catch (const std::exception& e) {
    std::fprintf(stderr, "%s\n", e.what());
    return 1;
}
