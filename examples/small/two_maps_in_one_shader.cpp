// SPDX-License-Identifier: MIT
//
// A sun's cascades in a texture array, and a spot light's map of two bytes per texel, in one shader of each language.
#include <cstdio>
#include <sstream>
#include <string>
#include <vector>

#include <umbrage/umbrage.hpp>

namespace {

/// Bytes of a uniform block, as its declaration in GLSL has them.
std::size_t declared_bytes(const std::string& text, const std::string& block) {
    std::istringstream lines(text.substr(text.find("uniform " + block)));
    std::size_t bytes = 0;
    for (std::string line; std::getline(lines, line) && line != "};";)
        bytes += line.find("mat4 ") != line.npos ? 64 : line.find("vec4 ") != line.npos ? 16 : 0;
    return bytes;
}

}  // namespace

int main() {
    namespace glsl = umbrage::glsl;
    const umbrage::cascade_fit<float> fit{
        .camera = {.position = {0, 12, 64}, .direction = {0, -0.2f, -1}, .tan_half_x = 1, .tan_half_y = 0.6f},
        .direction = {1, -0.6f, 0.3f},
        .scene = {{-64, -2, -64}, {64, 7, 64}},
        .overlap = 0.1f,
        .clip = umbrage::opengl_clip_space};
    const umbrage::shadow sun(umbrage::make_stable_cascades<3>(fit, umbrage::practical_splits<3>(1.0f, 140.0f, 0.8f)),
                              fit.map_size, umbrage::filters::tent<3>);
    const umbrage::shadow spot(
        umbrage::make_spot_light(
            {.position = {2, 6, 3}, .direction = {-2, -6, -3}, .clip = umbrage::opengl_clip_space}),
        {512, 512}, umbrage::filters::box{.radius = 2}, umbrage::rg<11>{});

    // A name, a block and a texture for each: the rest follows from the shadows.
    const std::vector<glsl::bound> both{glsl::bind(sun, "sun", {.block = 0, .texture = 1, .map = glsl::texture::array}),
                                        glsl::bind(spot, "spot", {.block = 2, .texture = 3})};
    const std::string shader = glsl::source(glsl::version::v330, both) + R"GLSL(
in vec3 world, normal;
out vec4 color;
void main() { color = vec4(0.7 * umbrage_sun(world, normal) + vec3(0.3, 0.2, 0.1) * umbrage_spot(world, normal), 1.0); }
)GLSL";

    // Functions that both maps share are there once. Functions that read a map are there for each map, under its name.
    int shared = 0, of_sun = 0, of_spot = 0;
    const std::string mark = "// ";
    std::istringstream lines(shader);
    for (std::string line; std::getline(lines, line);) {
        if (!line.starts_with(mark + "umbrage_")) continue;
        const std::string function = line.substr(mark.size(), line.find(':') - mark.size());
        ++(function.ends_with("_sun") ? of_sun : function.ends_with("_spot") ? of_spot : shared);
    }
    std::printf("%d functions for both, %d of the sun's map, %d of the spot's\n", shared, of_sun, of_spot);

    bool right = of_sun > 0 && of_spot > 0;
    for (const std::string& text :
         {shader, umbrage::hlsl::text(both), umbrage::wgsl::text(both), umbrage::msl::text(both)})
        for (const char* function : {"umbrage_sun(", "umbrage_spot("}) {
            const auto at = text.find(function), first = text.rfind('\n', at) + 1;
            right = right && at != text.npos;
            if (right) std::puts(text.substr(first, text.find('{', at) - first).c_str());
        }

    // Bytes that the application copies into the blocks' buffers whenever a light moves.
    const auto sun_block = sun.uniforms();
    const auto spot_block = spot.uniforms();
    right = right && sizeof sun_block == declared_bytes(shader, "umbrage_sun_block") &&
            sizeof spot_block == declared_bytes(shader, "umbrage_spot_block");
    std::printf("Blocks: the sun's %zu bytes, the spot's %zu%s\n", sizeof sun_block, sizeof spot_block,
                right ? "" : ": wrong");
    return right ? 0 : 1;
}
