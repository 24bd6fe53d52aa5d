// SPDX-License-Identifier: MIT
//
// Oracle of visibility over images: the filter called for each receiver. Each path must give the same bits.
#pragma once

#include "../../unit/images/paths.hpp"

#include <functional>
#include <map>

#include <umbrage/filter/filters.hpp>
#include <umbrage/images/visibility.hpp>

#include "../../forced_form.hpp"

namespace paths {

/// Any map's texel as its depth: filters are compiled for no other fetch, here as in visibility().
using any_fetch = umbrage::detail::erased_fetch;
using umbrage::detail::erase;

using any_receivers = std::function<glm::vec3(glm::ivec2)>;

/// A filter, whichever: what is held against it is compiled once for all of them.
struct any_filter {
    std::function<float(const any_fetch&, glm::vec3, glm::ivec2)> at;
    float far = 1.0f;

    template <class Filter>
    explicit any_filter(const Filter& filter)
        : at([=](const any_fetch& fetch, glm::vec3 receiver, glm::ivec2 pixel) {
              if constexpr (requires { filter(fetch, glm::vec2(), 0.0f, pixel); })
                  return filter(fetch, glm::vec2(receiver), receiver.z, pixel);
              else return filter(fetch, glm::vec2(receiver), receiver.z);
          }) {
        far = umbrage::cleared_depth(filter.direction);
    }
};

/// Results of the filter for each receiver alone, in several rounding modes.
class one_by_one {
public:
    one_by_one(const any_filter& filter, const any_fetch& fetch, glm::ivec2 size, const any_receivers& at) {
        each_rounding(modes_, [&](int mode) {
            image<float>& out = wanted_.emplace(mode, size).first->second;
            for (int y = 0; y < out.size().y; ++y)
                for (int x = 0; x < out.size().x; ++x) out[{x, y}] = filter.at(fetch, at({x, y}), {x, y});
        });
    }
    [[nodiscard]] const std::vector<int>& modes() const { return modes_; }
    [[nodiscard]] glm::ivec2 size() const { return wanted_.begin()->second.size(); }
    one_by_one(const any_filter& filter, const any_fetch& fetch, const image<glm::vec3>& receivers)
        : one_by_one(filter, fetch, receivers.size(), [&](glm::ivec2 pixel) { return receivers[pixel]; }) {}
    /// Pixels that have other bits, in the rounding mode of now.
    int differing(const image<float>& from) const {
        const image<float>& wanted = wanted_.at(std::fegetround());
        int differ = 0;
        for (std::size_t i = 0; i < from.texels().size(); ++i)
            differ += visibility_bits(wanted.texels()[i]) != visibility_bits(from.texels()[i]);
        return differ;
    }

private:
    std::vector<int> modes_ = rounding_modes();
    std::map<int, image<float>> wanted_;
};

using render = std::function<void(image<float>&)>;

/// That each path gives what the filter gives for each receiver alone.
inline void check_each_path(const one_by_one& wanted, const render& to) {
    for_each_path(wanted.modes(), [&] {
        image<float> out(wanted.size());
        to(out);
        CHECK(wanted.differing(out) == 0);
    });
}

}  // namespace paths
