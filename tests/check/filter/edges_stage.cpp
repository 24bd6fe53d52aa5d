// SPDX-License-Identifier: MIT
#include <algorithm>
#include <limits>

#include "stages.hpp"

namespace check {
namespace {

constexpr float nan = std::numeric_limits<float>::quiet_NaN(), infinity = std::numeric_limits<float>::infinity();

class edges final : public stage {
public:
    explicit edges(filter_knowledge& k) : k_(k) {}

    std::optional<batch> ask() override {
        if (k_.lost || asked_) return std::nullopt;
        asked_ = true;
        batch b{{4, 4}, std::vector<float>(16, 0.5f), {}};
        for (float z : beyond) b.inputs.push_back({2.25f, 2.25f, k_.compare.receiver_of(z), 0});
        for (float z : {0.25f, 0.75f}) {
            b.inputs.push_back({nan, 2.25f, k_.compare.receiver_of(z), 0});
            b.inputs.push_back({2.25f, nan, k_.compare.receiver_of(z), 0});
        }
        b.inputs.push_back({2.25f, 2.25f, nan, 0});
        return b;
    }

    void learn(const batch& b, std::span<const glm::vec4> out) override {
        filter_model model = k_.best;
        model.geometry = {};  // over a map of one depth and away from its edges it does not matter
        const auto differ = [&](std::size_t first, std::size_t last) {
            for (std::size_t i = first; i < last; ++i)
                if (!(model(b, b.inputs[i]) == out[i].x)) return true;
            return false;
        };
        const std::size_t numbers = std::size(beyond);
        if (differ(0, numbers))
            k_.found->but.push_back({"beyond_far", "receivers beyond the far plane are compared; here they are lit"});
        if (differ(numbers, b.inputs.size()))
            k_.found->but.push_back({"nan",
                                     "NaN gives another result; here a coordinate of NaN is lit, a receiver of NaN "
                                     "in shadow"});
    }

private:
    static constexpr float beyond[]{1.5f, 2.0f, infinity};

    filter_knowledge& k_;
    bool asked_ = false;
};

}  // namespace

std::unique_ptr<stage> edges_stage(filter_knowledge& k) { return std::make_unique<edges>(k); }

}  // namespace check
