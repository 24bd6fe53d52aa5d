// SPDX-License-Identifier: MIT
#include <algorithm>
#include <cstring>
#include <memory>
#include <vector>

#include <umbrage/images/encode.hpp>

#include "bench.hpp"
#include "data.hpp"
#include "peers/glm.hpp"

namespace {

struct state {
    umbrage::image<float> depth = bench::make_map(), back{bench::map_size};
    umbrage::image<glm::u8vec2> packed{bench::map_size};
    std::vector<float> glm_depth{depth.texels().begin(), depth.texels().end()}, glm_back = glm_depth;
    std::vector<glm::u8vec2> glm_packed = std::vector<glm::u8vec2>(glm_depth.size());
    std::vector<char> from = std::vector<char>(1u << 26, 1), to = from;
};

const bench::registration rows([] {
    const auto s = std::make_shared<state>();
    const auto encode = [s] { umbrage::encode(s->depth, s->packed, umbrage::rg<11>{}); };
    const auto decode = [s] { umbrage::decode(s->packed, s->back, umbrage::rg<11>{}); };
    const auto copy = [s] {
        std::memcpy(s->to.data(), s->from.data(), std::size_t(bench::map_texels) * 3);
    };  // reads and writes 6 bytes
    bench::add({.work = "encode 11 bits, 2048 x 2048",
                .peer = "memcpy",
                .at_least = 0.9,
                .items = bench::map_texels,
                .ours = encode,
                .theirs = copy,
                .agree = {}});
    bench::add({.work = "encode 11 bits, 2048 x 2048",
                .peer = "GLM code",
                .at_least = 10,
                .items = bench::map_texels,
                .ours = encode,
                .theirs = [s] { peers::glm_code::encode(s->glm_depth, s->glm_packed); },
                .agree = [s] { return std::ranges::equal(s->packed.texels(), s->glm_packed); }});
    bench::add({.work = "decode 11 bits, 2048 x 2048",
                .peer = "memcpy",
                .at_least = 0.9,
                .items = bench::map_texels,
                .ours = decode,
                .theirs = copy,
                .agree = {}});
    bench::add({.work = "decode 11 bits, 2048 x 2048",
                .peer = "GLM code",
                .items = bench::map_texels,
                .ours = decode,
                .theirs = [s] { peers::glm_code::decode(s->glm_packed, s->glm_back); },
                .agree = [s] { return std::ranges::equal(s->back.texels(), s->glm_back); }});
});

}  // namespace
