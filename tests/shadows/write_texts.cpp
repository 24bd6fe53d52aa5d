// SPDX-License-Identifier: MIT
//
// Texts of shadows, for compilers and for what they say of the blocks:  shadows_write_texts FOLDER
//
// FOLDER/all.EXTENSION and FOLDER/glsl, which tests/package/compile.cmake takes, hold shadows of every setup and what
// debugs them. FOLDER/blocks/NAME.* is one shadow; NAME.offsets has a line for each member of its block in C++, "name
// offset components", and NAME.compute.wgsl copies the block's floats in that order.
#include <cstddef>
#include <exception>
#include <filesystem>
#include <fstream>
#include <iostream>
#include <stdexcept>
#include <string>
#include <vector>

#include <umbrage/umbrage.hpp>

#include "../unit/shadow/scene.hpp"

namespace {

using namespace umbrage;
using glsl::bind;
using glsl::bound;
using glsl::version;
namespace fs = std::filesystem;

void write(const fs::path& path, const std::string& text) {
    fs::create_directories(path.parent_path());
    std::ofstream file(path, std::ios::binary);
    if (!(file << text)) throw std::runtime_error("cannot write " + path.string());
}

/// A member of a block, where C++ has it.
struct member {
    std::string name;
    std::size_t offset, components;
};
#define MEMBER(block, name) \
    member { #name, offsetof(block, name), sizeof(block::name) / sizeof(float) }

/// Fields of a shadow's block.
template <class Setup>
std::vector<member> block_of(std::vector<member> all) {
    const std::size_t terms = sizeof(typename Setup::uniforms);  // the setup's fields come first, without gaps
    all.push_back({"terms", terms + offsetof(shadow_terms, map_size), 4});
    all.push_back({"filter_terms", terms + offsetof(shadow_terms, filter_terms), 4});
    return all;
}

/// One shadow's shaders.
void write_block(const fs::path& folder, const bound& item, const std::vector<member>& members) {
    const std::string name = item.declared->name, block = "umbrage_" + name + "_uniforms";
    const bool turns = item.declared->functions[0].arguments.size() > 2;
    const fs::path path = folder / "blocks" / name;
    const std::string call = "umbrage_" + name + "(w, w" + (turns ? ", p.xy)" : ")");
    write(path.string() + ".frag", glsl::source(version::vulkan, {item}) +
                                       "layout(location = 0) in vec3 w;\nlayout(location = 0) out vec4 c;\n"
                                       "void main() { vec4 p = gl_FragCoord; c = vec4(" +
                                       call + "); }\n");
    write(path.string() + ".hlsl", hlsl::text({item}) +
                                       "float4 main(float3 w : TEXCOORD0, float4 p : SV_Position) : SV_Target { return "
                                       "(float4)" +
                                       call + "; }\n");
    write(path.string() + ".metal", msl::text({item}));
    std::string offsets, copies;
    std::size_t count = 0;
    for (const member& m : members) {
        offsets += m.name + " " + std::to_string(m.offset) + " " + std::to_string(m.components) + "\n";
        for (std::size_t c = 0; c < m.components; ++c)
            copies += "    copied[" + std::to_string(count++) + "] = " + block + "." + m.name +
                      (m.components == 16 ? "[" + std::to_string(c / 4) + "]" : "") + "[" + std::to_string(c % 4) +
                      "];\n";
    }
    write(path.string() + ".offsets", offsets);
    write(path.string() + ".compute.wgsl",
          wgsl::text({item}) + "\n@group(1) @binding(0) var<storage, read_write> copied: array<f32>;\n" +
              "@compute @workgroup_size(1) fn copy() {\n" + copies + "}\n");
}

void write_blocks(const fs::path& folder, clip_space clip) {
    const filters::hard filter;
    const shadow spot(shadow_scene::spot(clip), {256, 128}, filter);
    const shadow sun(shadow_scene::cascades(clip), {256, 256}, filters::tent<3>);
    const shadow eight(shadow_scene::cascades<7>(clip), {256, 256}, filters::disc{});
    const shadow bulb(shadow_scene::bulb(clip), {256, 256}, filter);
    const shadow sides(shadow_scene::tetrahedron(clip), {512, 512}, filter);
    const shadow halves(shadow_scene::paraboloids(clip), {512, 512}, filter);
    std::vector<member> of_anchored{MEMBER(anchored_map, to_texels), MEMBER(anchored_map, planes),
                                    MEMBER(anchored_map, anchor), MEMBER(anchored_map, rounding),
                                    MEMBER(anchored_map, slack)};
    write_block(folder, bind(spot, "spot"), block_of<single_map>(of_anchored));
    using cube = cube_maps::uniforms;
    write_block(
        folder, bind(bulb, "bulb"),
        block_of<cube_maps>({MEMBER(cube, face), MEMBER(cube, anchor), MEMBER(cube, rounding), MEMBER(cube, slack)}));
    of_anchored.push_back({"center", sizeof(anchored_map), 4});
    write_block(folder, bind(sides, "sides"), block_of<tetrahedron_map>(of_anchored));
    using four = cascaded_maps<1>::uniforms;
    write_block(folder, bind(sun, "sun"),
                block_of<cascaded_maps<1>>({MEMBER(four, rotation), MEMBER(four, scales), MEMBER(four, offsets),
                                            MEMBER(four, anchor), MEMBER(four, blending)}));
    using both = cascaded_maps<2>::uniforms;
    write_block(folder, bind(eight, "eight"),
                block_of<cascaded_maps<2>>({MEMBER(both, rotation), MEMBER(both, scales), MEMBER(both, offsets),
                                            MEMBER(both, farther_scales), MEMBER(both, farther_offsets),
                                            MEMBER(both, anchor), MEMBER(both, blending)}));
    using paraboloids = paraboloid_maps::uniforms;
    write_block(folder, bind(halves, "halves"),
                block_of<paraboloid_maps>(
                    {MEMBER(paraboloids, position), MEMBER(paraboloids, halves), MEMBER(paraboloids, rounding)}));
    // arrays in C++, members with a number each in shaders
    const auto numbered = [](const std::string& name, std::size_t offset, std::size_t count) {
        std::vector<member> all;
        for (std::size_t i = 0; i < count; ++i)
            all.push_back({name + "_" + std::to_string(i), offset + i * sizeof(glm::mat4), 16});
        return all;
    };
    using warped = warped_maps::uniforms;
    std::vector<member> of_warps = numbered("to_texels", offsetof(warped, to_texels), 4);
    for (const member& m : numbered("planes", offsetof(warped, planes), 4)) of_warps.push_back(m);
    for (const member& m : {MEMBER(warped, rounding), MEMBER(warped, slack), MEMBER(warped, fades),
                            MEMBER(warped, anchor), MEMBER(warped, ahead), MEMBER(warped, ends)})
        of_warps.push_back(m);
    const shadow bent(shadow_scene::warped(clip), {256, 256}, filter);
    write_block(folder, bind(bent, "bent"), block_of<warped_maps>(of_warps));
    using adaptive = adaptive_maps::uniforms;
    std::vector<member> of_pages{MEMBER(adaptive, to_root), MEMBER(adaptive, planes)};
    for (const member& m : numbered("cells", offsetof(adaptive, cells), 8)) of_pages.push_back(m);
    of_pages.push_back(MEMBER(adaptive, anchor));
    of_pages.push_back(MEMBER(adaptive, pages));
    of_pages.push_back(MEMBER(adaptive, slack));
    const shadow paged(shadow_scene::pages(clip), {80, 80}, filter);
    write_block(folder, bind(paged, "paged"), block_of<adaptive_maps>(of_pages));
}

/// Shadows of every setup and kind of filter, with what debugs them, in one text a language.
void write_all(const fs::path& folder, clip_space clip) {
    clip_space reversed = clip;
    reversed.direction = depth_direction::reversed;
    int next = 0;
    std::vector<bound> plain, with_arrays;
    const auto add = [&](std::vector<bound>& all, const auto& s, const std::string& name,
                         glsl::shadow_slots slots = {}) {
        slots.block = next++, slots.texture = next++, slots.sampler = next++, slots.debug = true;
        all.push_back(glsl::bind(s, name, slots));
    };
    const auto add_spot = [&](const auto& filter, const auto&... encoding) {
        add(plain, shadow(shadow_scene::spot(reversed), {256, 128}, filter, encoding...),
            "spot" + std::to_string(next));
    };
    add_spot(filters::tent<3>, rg<11>{});
    add_spot(shadow_scene::sized(filters::pcss{}));
    add_spot(shadow_scene::sized(filters::dpcf{}));
    add_spot(prefilters::vsm{});
    add_spot(prefilters::esm{});
    add_spot(prefilters::evsm2{});
    add_spot(prefilters::evsm4{});
    add_spot(prefilters::msm{});
    const shadow lamp(shadow_scene::fitted(clip), {200, 300}, filters::box{.radius = 1});
    const shadow sun(shadow_scene::cascades(clip), {256, 256}, filters::disc{});
    add(with_arrays, lamp, "lamp", {.map = glsl::texture::shadow, .derivatives = true});
    add(with_arrays, sun, "sun", {.map = glsl::texture::depth_array, .derivatives = true});
    add(with_arrays, shadow(shadow_scene::cascades<7>(clip), {256, 256}, filters::pcf_2x2{}), "eight",
        {.map = glsl::texture::shadow_array});
    add(plain, sun, "atlas");
    add(plain, shadow(shadow_scene::bulb(clip), {256, 256}, filters::hard{}), "bulb");
    add(plain, shadow(shadow_scene::warped(clip), {256, 256}, filters::hard{}), "bent");
    add(plain, shadow(shadow_scene::pages(clip), {80, 80}, filters::hard{}), "paged");
    add(plain, shadow(shadow_scene::tetrahedron(clip), {512, 512}, filters::hard{}), "sides");
    add(plain, shadow(shadow_scene::paraboloids(clip), {512, 512}, filters::hard{}), "halves");
    std::vector<bound> all = plain;
    all.insert(all.end(), with_arrays.begin(), with_arrays.end());
    write(folder / "all.hlsl", hlsl::text(all) + "float4 main() : SV_Target { return (float4)0; }\n");
    write(folder / "all.metal", msl::text(all));
    write(folder / "all.wgsl", wgsl::text(all));
    for (const version v : glsl::versions) {
        const std::string name = v == version::vulkan ? "vulkan" : std::string(directive(v));
        const bool old = v < version::v300_es;
        write(folder / "glsl" / (name + ".frag"), glsl::source(v, old ? plain : all) + "void main() {}\n");
    }
}

}  // namespace

int main(int argc, char** argv) try {
    if (argc != 2) throw std::invalid_argument("one argument");
    write_blocks(argv[1], vulkan_clip_space);
    write_all(argv[1], vulkan_clip_space);
} catch (const std::exception& error) {
    std::cerr << "shadows_write_texts: " << error.what() << '\n';
    return 2;
}
