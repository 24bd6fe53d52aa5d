// SPDX-License-Identifier: MIT
//
// Shaders of all that bind() takes, in every language, to compile:  write_bindings FOLDER
//
// Walks the options of a map; what is refused must be so by name. FOLDER/all.EXTENSION is one shader with all that
// is taken, FOLDER/glsl has one for each dialect. compile.cmake compiles them.
#include <filesystem>
#include <fstream>
#include <iostream>
#include <stdexcept>
#include <vector>

#include "languages.hpp"

namespace package {
namespace {

namespace fs = std::filesystem;
using glsl::binding;
using glsl::bound;

/// True for a message with function, argument, condition and value.
bool is_clear(std::string_view message) {
    return (message.starts_with("umbrage::glsl::bind: ") || message.starts_with("umbrage::glsl::text: ")) &&
           message.find(" must ") != message.npos && message.find("; got ") != message.npos;
}

/// Depths of one channel, two and four, and some on a scale of their own.
std::vector<binding> depths() {
    return {{},
            glsl::stored_as(umbrage::rg<11>{}),
            glsl::stored_as(umbrage::float_bits{}),
            {.depth = "umbrage_level_rg11(value.xy)", .channels = 2, .needs = {glsl::level_rg<11>}}};
}

/// Every option of a map; texts in it are in the language. How depth is read and where the map lies share no text, so
/// that each is tried with one of the other.
std::vector<binding> maps(std::string_view language) {
    const std::string vec2 = language == "wgsl" ? "vec2f" : language == "glsl" ? "vec2" : "float2";
    std::vector<binding> all;
    for (const named_texture& t : textures)
        for (binding map : depths())
            for (const bool gather : {false, true})
                for (const auto outside : {umbrage::outside_map::clamped, umbrage::outside_map::bordered})
                    for (const int region : {0, 1, 2}) {
                        if (!map.depth.empty() && (region > 0 || outside == umbrage::outside_map::clamped)) continue;
                        map.texture = t.kind;
                        map.gather = gather;
                        map.outside = outside;
                        map.direction = static_cast<umbrage::depth_direction>(
                            (outside == umbrage::outside_map::bordered) != gather);
                        map.origin = region > 0 ? vec2 + "(5.0, 3.0)" : "";
                        map.texture_size = region > 1 ? vec2 + "(64.0, 64.0)" : "";
                        all.push_back(map);
                    }
    all.push_back({.compare = (language == "wgsl" ? "f32" : "float") + std::string("(receiver < stored)")});
    all.push_back({.depth = "value.x + texel.x"});
    for (const named_texture& t : textures) all.push_back({.texture = t.kind, .receiver_plane = true});
    all.push_back(glsl::stored_as(umbrage::rg<11>{}, {.receiver_plane = true}));
    return all;
}

class shaders {
public:
    explicit shaders(const shader_language& l) : language_(l) {}

    /// Every option of a map, with filters that compare, gather, sample and want depths.
    void walk() {
        for (const binding& map : maps(language_.name))
            for (const glsl::snippet* s : {&glsl::pcf_2x2, &glsl::pcf_2x2_dx_sdk, &glsl::pcf_2x2_hardware,
                                           &glsl::blockers_hardware<8>, &glsl::summed_moments})
                add(*s, map);
        for (const named_texture& t : textures)  // every snippet that takes a map, on each kind
            for (const glsl::snippet* s : glsl::registry())
                if (glsl::detail::is_of_map(*s)) add(*s, {.texture = t.kind});
    }

    void write(const fs::path& folder) const {
        std::cout << language_.name << ": " << all_.size() << " taken, " << refused_ << " refused\n";
        if (language_.name != "glsl") {
            const std::string_view main =
                language_.name == "hlsl" ? "float4 main() : SV_Target { return (float4)0; }\n" : "";
            write(folder / ("all" + std::string(language_.extension)), language_.text(all_) + std::string(main));
            return;
        }
        for (const glsl::version v : glsl::versions) {
            std::vector<bound> supported;
            for (const bound& item : all_)
                if (supports(item, v)) supported.push_back(item);
            const std::string name = v == glsl::version::vulkan ? "vulkan" : std::string(directive(v));
            write(folder / "glsl" / (name + ".frag"), glsl::source(v, supported) + "void main() {}\n");
        }
    }

    [[nodiscard]] bool failed() const { return failed_; }

private:
    /// Adds a snippet. All snippets of one map share a name, and maps differ by their number.
    void add(const glsl::snippet& s, const binding& map) {
        try {
            if (maps_.empty() || !(maps_.back() == map)) maps_.push_back(map);
            const bound item = glsl::bind(s, "map" + std::to_string(maps_.size()), map);
            (void)language_.text({item});
            all_.push_back(item);
        } catch (const std::invalid_argument& error) {
            ++refused_;
            if (is_clear(error.what())) return;
            failed_ = true;
            std::cerr << language_.name << ": not a clear message: " << error.what() << '\n';
        }
    }

    static void write(const fs::path& path, const std::string& text) {
        fs::create_directories(path.parent_path());
        std::ofstream file(path, std::ios::binary);
        if (!(file << text)) throw std::runtime_error("cannot write " + path.string());
    }

    const shader_language& language_;
    std::vector<binding> maps_;
    std::vector<bound> all_;
    std::size_t refused_ = 0;
    bool failed_ = false;
};

}  // namespace
}  // namespace package

int main(int argc, char** argv) try {
    if (argc != 2) throw std::invalid_argument("one argument");
    bool failed = false;
    for (const package::shader_language& l : package::languages) {
        package::shaders all(l);
        all.walk();
        all.write(argv[1]);
        failed = failed || all.failed();
    }
    return failed;
} catch (const std::exception& error) {
    std::cerr << "write_bindings: " << error.what() << '\n';
    return 2;
}
