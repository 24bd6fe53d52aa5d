// SPDX-License-Identifier: MIT
#include "check.hpp"

#include <algorithm>
#include <cstdlib>

#include <png.hpp>

namespace viewer_check {

picture viewed(const std::string& arguments, const std::string& in) {
    const std::filesystem::path file = folder / "viewed.png";
    std::filesystem::remove(file);
    const example::finished r = example::run_line(in + quoted(VIEWER) + "--screenshot " + quoted(file) + arguments);
    CAPTURE(arguments);
    REQUIRE_MESSAGE(r.code == 0, r.said);
    return example::read_png<glm::u8vec3>(file);
}

int differing(const picture& a, const picture& b) {
    REQUIRE(a.size() == b.size());
    int count = 0;
    for (std::size_t i = 0; i < a.texels().size(); ++i) count += a.texels()[i] != b.texels()[i];
    return count;
}

int differing_by_levels(const picture& a, const picture& b) {
    REQUIRE(a.size() == b.size());
    int most = 0;
    for (std::size_t i = 0; i < a.texels().size(); ++i)
        for (int c = 0; c < 3; ++c) most = std::max(most, std::abs(int(a.texels()[i][c]) - int(b.texels()[i][c])));
    return most;
}

}  // namespace viewer_check
