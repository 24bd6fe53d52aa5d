// SPDX-License-Identifier: MIT
//
// Shaders of random snippets and maps, for compilers to accept:  write_texts FOLDER SEED COUNT
//
// Each is N.frag in a random dialect of GLSL, and N.wgsl. What the composer refuses is left out. Exit status 1: it has
// refused by other words than a clear message, or nearly all.
#include <filesystem>
#include <fstream>
#include <iostream>
#include <random>
#include <stdexcept>
#include <string>
#include <vector>

#include <umbrage/depth/encodings.hpp>
#include <umbrage/registry.hpp>
#include <umbrage/shader/glsl.hpp>
#include <umbrage/shader/wgsl.hpp>

namespace {

using namespace umbrage;

class writer {
public:
    writer(std::filesystem::path folder, unsigned seed) : folder_(std::move(folder)), engine_(seed) {}

    void write(const std::string& name) {
        std::vector<glsl::bound> items;
        for (int i = below(4); i >= 0; --i) {
            const glsl::snippet& what = *glsl::registry()[std::size_t(below(int(glsl::registry().size())))];
            const std::string map = std::string("map") + static_cast<char>('a' + i);
            unless_refused(
                [&] { items.push_back(below(4) == 0 ? glsl::bound(what) : glsl::bind(what, map, random_map())); });
        }
        const glsl::version version = glsl::versions[std::size_t(below(int(std::size(glsl::versions))))];
        const bool es = glsl::directive(version).ends_with("es") || version == glsl::version::v100;
        if (version != glsl::version::vulkan)  // a host of low precision, as in tests/parity
            unless_refused([&] {
                save(name + ".frag",
                     glsl::source(version, items, es ? "precision mediump float;\nprecision mediump int;\n" : "") +
                         "\nvoid main() {}\n");
            });
        unless_refused([&] { save(name + ".wgsl", wgsl::text(items) + "\nfn nothing() {}\n"); });
    }

    [[nodiscard]] int written() const { return written_; }

private:
    [[nodiscard]] int below(int count) { return std::uniform_int_distribution(0, count - 1)(engine_); }

    [[nodiscard]] glsl::binding random_map() {
        glsl::binding map;
        map.texture = static_cast<glsl::texture>(below(10));
        map.gather = below(3) == 0;
        map.receiver_plane = below(4) == 0;
        if (below(2) == 0) map.outside = below(2) == 0 ? outside_map::bordered : outside_map::clamped;
        if (below(4) == 0) map.origin = "vec2(5.0, 3.0)";
        if (below(4) == 0) map.texture_size = "vec2(64.0, 32.0)";
        if (below(8) == 0) map.compare = "(stored - receiver) * 0.5 + 0.5";
        int left = below(40);
        for_each_encoding([&](auto encoding) {
            encoding.direction = left % 2 == 0 ? depth_direction::forward : depth_direction::reversed;
            if (left-- == 0) map = glsl::stored_as(encoding, map);
        });
        return map;
    }

    template <class Use>
    static void unless_refused(const Use& use) {
        try {
            use();
        } catch (const std::invalid_argument& error) {
            const std::string_view words = error.what();
            if (!words.starts_with("umbrage::") || words.find("; got ") == words.npos) throw;
        }
    }

    void save(const std::string& name, const std::string& text) {
        if (!(std::ofstream(folder_ / name) << text).flush()) throw std::runtime_error("cannot write " + name);
        ++written_;
    }

    std::filesystem::path folder_;
    std::mt19937 engine_;
    int written_ = 0;
};

}  // namespace

int main(int argc, char** argv) try {
    if (argc != 4) throw std::invalid_argument("three arguments");
    const std::filesystem::path folder = argv[1];
    std::filesystem::remove_all(folder);
    std::filesystem::create_directories(folder);
    writer texts(folder, static_cast<unsigned>(std::stoul(argv[2])));
    const int count = std::stoi(argv[3]);
    for (int i = 0; i < count; ++i) texts.write(std::to_string(i));
    std::cout << texts.written() << " texts of " << count << " lists\n";
    return texts.written() * 4 < count;
} catch (const std::exception& error) {
    std::cerr << "write_texts: " << error.what() << '\n';
    return 1;
}
