// SPDX-License-Identifier: MIT
//
// What a host's own shader said of its receivers, said again by C++:
//     hosts_twin FILTER[.SCENE] RECEIVERS MAP WIDTH HEIGHT SIZE PER_CODE COMPARE
//
// PER_CODE is that of a softness. COMPARE is that of the sampler: less, greater or less_equal. RECEIVERS
// are floats: (x, y) in texels, depth and visibility of each pixel, from below. MAP has SIZE x SIZE depths. Prints
// receivers, those in penumbra and those that differ. Exit status 1: one differs, or nothing was tried.
#include <cstdio>
#include <exception>
#include <filesystem>
#include <fstream>
#include <stdexcept>
#include <string>
#include <vector>

#include <umbrage/umbrage.hpp>

namespace {

using namespace umbrage;

std::vector<float> floats_of(const std::string& path, std::size_t count) {
    std::vector<float> all(count);
    std::ifstream in(path, std::ios::binary);
    const auto bytes = static_cast<std::streamsize>(count * sizeof(float));
    if (!in.read(reinterpret_cast<char*>(all.data()), bytes) || in.peek() != EOF)
        throw std::runtime_error(path + " has not " + std::to_string(count) + " floats");
    return all;
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
float visibility(const std::string& filter, const image<float>& map, const float* r, glm::vec2 rotation, float per_code,
                 Compare is_lit) {
    const auto texels = bordered(map, is_lit(0.0f, 1.0f) ? 1.0f : 0.0f);
    const glm::vec2 at(r[0], r[1]);
    if (filter == "hard") return hard(texels, at, r[2], is_lit);
    if (filter == "castano_dyadic5") return castano_dyadic<5>(texels, at, r[2], is_lit);
    if (filter == "disc16") return disc<16>(texels, at, r[2], 3.0f, rotation, is_lit);
    if (filter == "pcss16") return pcss<16>(texels, at, r[2], glm::vec3(per_code, 16, 256), rotation, is_lit);
    throw std::invalid_argument("no filter is called " + filter);
}

}  // namespace

int main(int argc, char** argv) try {
    if (argc != 9) throw std::invalid_argument("FILTER[.SCENE] RECEIVERS MAP WIDTH HEIGHT SIZE PER_CODE COMPARE");
    const std::string name = argv[1], filter = name.substr(0, name.find('.'));
    const int width = std::stoi(argv[4]), height = std::stoi(argv[5]), size = std::stoi(argv[6]);
    const float per_code = std::stof(argv[7]);
    const std::string compare = argv[8];
    const std::vector<float> receivers = floats_of(argv[2], std::size_t(width * height) * 4);
    const std::vector<float> depths = floats_of(argv[3], std::size_t(size * size));
    image<float> map({size, size});
    std::copy(depths.begin(), depths.end(), map.texels().begin());
    int tried = 0, in_penumbra = 0, differing = 0;
    for (int y = 0; y < height; ++y)
        for (int x = 0; x < width; ++x) {
            const float* const r = &receivers[std::size_t(y * width + x) * 4];
            if (r[0] == 0 && r[1] == 0 && r[2] == 0 && r[3] == 0) continue;  // where nothing was drawn
            const glm::vec2 rotation = disc_rotation(glm::vec2(float(x) + 0.5f, float(y) + 0.5f));
            const auto expected_by = [&](auto is_lit) {
                return visibility(filter, map, r, rotation, per_code, is_lit);
            };
            const float expected = compare == "less"      ? expected_by(less{})
                                   : compare == "greater" ? expected_by(greater{})
                                                          : expected_by(less_equal{});
            ++tried;
            in_penumbra += expected > 0 && expected < 1;
            differing += expected != r[3];
        }
    std::printf("%s: %d receivers, %d in penumbra, %d differ\n", name.c_str(), tried, in_penumbra, differing);
    return tried > 10000 && differing == 0 ? 0 : 1;
} catch (const std::exception& error) {
    std::fprintf(stderr, "hosts_twin: %s\n", error.what());
    return 2;
}
