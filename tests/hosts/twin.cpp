// SPDX-License-Identifier: MIT
//
// What a host's own shader said of its receivers, said again by C++:
//     hosts_twin FILTER[.SCENE] RECEIVERS MAP WIDTH HEIGHT SIZE PER_CODE[,PER_CODE...] COMPARE [LAYERS]
//
// PER_CODE is that of a softness, one for each layer or one for all. COMPARE is that of the map: less, greater,
// less_equal or greater_equal. RECEIVERS are floats: (x, y) in texels, depth and visibility of each pixel, from below.
// MAP has SIZE x SIZE depths, a layer behind the other or one for all. LAYERS are floats: the layer of each pixel, such
// as its cascade. Prints receivers, those in penumbra and those that differ. Exit status 1: one differs, or too few are
// in a layer or in shadow.
#include <algorithm>
#include <cstddef>
#include <cstdio>
#include <exception>
#include <filesystem>
#include <fstream>
#include <map>
#include <sstream>
#include <stdexcept>
#include <string>
#include <vector>

#include <umbrage/umbrage.hpp>

namespace {

using namespace umbrage;

/// Floats of a file: count of them, or a multiple.
std::vector<float> floats_of(const std::string& path, std::size_t count) {
    const std::size_t bytes = std::filesystem::file_size(path);
    std::vector<float> all(bytes / sizeof(float));
    std::ifstream in(path, std::ios::binary);
    if (all.empty() || bytes % (count * sizeof(float)) != 0 ||
        !in.read(reinterpret_cast<char*>(all.data()), static_cast<std::streamsize>(bytes)))
        throw std::runtime_error(path + " has not a multiple of " + std::to_string(count) + " floats");
    return all;
}

std::vector<float> numbers(const std::string& text) {
    std::vector<float> all;
    std::istringstream in(text);
    for (std::string number; std::getline(in, number, ',');) all.push_back(std::stof(number));
    return all;
}

/// What belongs to a layer, or to all of them.
template <class T>
const T& of_layer(const std::vector<T>& all, std::size_t layer) {
    return all.size() == 1 ? all[0] : all.at(layer);
}

/// A sampler's comparison that leaves equal depths in shadow.
struct less {
    bool operator()(float receiver, float stored) const { return receiver < stored; }
};

/// The same of reversed depth.
struct greater {
    bool operator()(float receiver, float stored) const { return receiver > stored; }
};

template <class Compare>
float visibility(const std::string& filter, const image<float>& map, const float* r, glm::vec4 rotation, float per_code,
                 Compare is_lit) {
    const auto texels = bordered(map, is_lit(0.0f, 1.0f) ? 1.0f : 0.0f);
    const glm::vec2 at(r[0], r[1]);
    if (filter == "hard") return hard(texels, at, r[2], is_lit);
    if (filter == "castano_dyadic5") return castano_dyadic<5>(texels, at, r[2], is_lit);
    if (filter == "disc16") return disc<16>(texels, at, r[2], 3.0f, rotation, is_lit);
    if (filter == "pcss16") return pcss<16>(texels, at, r[2], glm::vec4(per_code, per_code, 16, 256), rotation, is_lit);
    throw std::invalid_argument("no filter is called " + filter);
}

}  // namespace

int main(int argc, char** argv) try {
    if (argc != 9 && argc != 10)
        throw std::invalid_argument("FILTER[.SCENE] RECEIVERS MAP WIDTH HEIGHT SIZE PER_CODES COMPARE [LAYERS]");
    const std::string name = argv[1], filter = name.substr(0, name.find('.'));
    const int width = std::stoi(argv[4]), height = std::stoi(argv[5]), size = std::stoi(argv[6]);
    const std::string compare = argv[8];
    const std::size_t pixels = std::size_t(width * height), texels = std::size_t(size * size);
    const std::vector<float> receivers = floats_of(argv[2], pixels * 4), depths = floats_of(argv[3], texels);
    const std::vector<float> layers = argc == 10 ? floats_of(argv[9], pixels) : std::vector<float>(pixels, 0.0f);
    const std::vector<float> per_codes = numbers(argv[7]);
    std::vector<image<float>> maps(depths.size() / texels, image<float>({size, size}));
    for (std::size_t i = 0; i < maps.size(); ++i)
        std::copy_n(depths.begin() + std::ptrdiff_t(i * texels), texels, maps[i].texels().begin());
    int in_shadow = 0, in_penumbra = 0, differing = 0;
    std::map<std::size_t, int> tried;  // layer -> receivers
    for (int y = 0; y < height; ++y)
        for (int x = 0; x < width; ++x) {
            const std::size_t pixel = std::size_t(y * width + x);
            const float* const r = &receivers[pixel * 4];
            if (r[0] == 0 && r[1] == 0 && r[2] == 0 && r[3] == 0) continue;  // where nothing was drawn
            const auto layer = static_cast<std::size_t>(layers[pixel]);
            const glm::vec4 rotation = disc_rotation(glm::vec2(float(x) + 0.5f, float(y) + 0.5f));
            const auto expected_by = [&](auto is_lit) {
                return visibility(filter, of_layer(maps, layer), r, rotation, of_layer(per_codes, layer), is_lit);
            };
            const float expected = compare == "less"            ? expected_by(less{})
                                   : compare == "greater"       ? expected_by(greater{})
                                   : compare == "greater_equal" ? expected_by(greater_equal{})
                                                                : expected_by(less_equal{});
            ++tried[layer];
            in_shadow += expected < 1;
            in_penumbra += expected > 0 && expected < 1;
            differing += expected != r[3];
        }
    int all = 0, fewest = width * height;
    std::string by_layer;
    for (const auto& [layer, count] : tried) {
        all += count, fewest = std::min(fewest, count);
        by_layer += (by_layer.empty() ? "" : " + ") + std::to_string(count);
    }
    std::printf("%s: %s receivers, %d in penumbra, %d differ\n", name.c_str(), by_layer.c_str(), in_penumbra,
                differing);
    const std::size_t wanted = std::max(maps.size(), per_codes.size());
    return all > 10000 && fewest > 1000 && in_shadow > 1000 && tried.size() >= wanted && differing == 0 ? 0 : 1;
} catch (const std::exception& error) {
    std::fprintf(stderr, "hosts_twin: %s\n", error.what());
    return 2;
}
