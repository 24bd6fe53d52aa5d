// SPDX-License-Identifier: MIT
#include <algorithm>
#include <array>
#include <cmath>
#include <functional>
#include <tuple>

#include "stages.hpp"

namespace check {
namespace {

using glm::vec2;
using glm::vec4;

/// Where the weights of a filter without slips have their center, from the coordinate: not 0 for discs.
vec2 own_centroid(const reference& r) {
    constexpr int steps = 8, across = 10 * steps;
    const compare_model plain{};
    const batch b = lone_texel(plain, map_size, lone);
    centroid_sum sum;
    for (int y = 0; y < across; ++y)
        for (int x = 0; x < across; ++x) {
            const vec2 at = vec2(lone) + (vec2(x, y) + 0.5f) / float(steps) - 5.0f;
            const float shadow = 1.0f - r.call({&b}, at, receiver_between(plain));
            if (std::abs(shadow) > 1e-4f) sum.add(at, double(shadow));
        }
    return sum.mean();
}

/// The same of all references(), computed once.
const std::vector<vec2>& own_centroids() {
    static const std::vector<vec2> all = [] {
        std::vector<vec2> found;
        for (const reference& r : references()) found.push_back(own_centroid(r));
        return found;
    }();
    return all;
}

/// A filter against what the shader gave.
struct score {
    filter_model model{};
    std::size_t tried = 0, explained = 0, same = 0;
    double off = 0;
    [[nodiscard]] bool fits() const { return explained == tried; }
    [[nodiscard]] bool has_its_bits() const { return same == tried; }
    [[nodiscard]] auto rank() const {
        const double share = tried ? double(explained) / double(tried) : 0;
        return std::tuple(share, tried ? double(same) / double(tried) : 0, -off);
    }
};

class weighs final : public stage {
public:
    explicit weighs(filter_knowledge& k) : k_(k) {}

    std::optional<batch> ask() override {
        if (k_.lost || asked_) return std::nullopt;
        asked_ = true;
        batch b{map_size, {}, {}};
        for (int i = 0; i < map_size.x * map_size.y; ++i) b.map.push_back(float(k_.random.below(257)) / 256);
        const vec2 size(map_size);
        for (int i = 0; i < inputs; ++i) {
            const bool wide = i % 4 == 3;
            const vec2 unit(k_.random.unit(), k_.random.unit());
            const vec2 at = wide ? unit * (size + 12.0f) - 6.0f : unit * size;
            const float depth = float(k_.random.below(257)) / 256, any = k_.random.unit();
            const bool tie = k_.compare.plain() && i % 2 == 0;
            b.inputs.push_back({at.x, at.y, tie ? depth : (glm::clamp)(k_.compare.receiver_of(any), 0.0f, 1.0f), 0});
        }
        return b;
    }

    void learn(const batch& b, std::span<const vec4> out) override {
        std::vector<score> all;
        for (const reference& r : references()) {
            score s{{&r, k_.compare, k_.geometry, outside::bordered}};
            const vec2 shift = own_centroids()[std::size_t(&r - references().data())] - k_.centroid;
            s.model.geometry.shift = glm::floor(shift * 8.0f + 0.5f) / 8.0f;
            judge(s, b, out, 512);
            if (double(s.explained) > 0.9 * double(s.tried)) judge(s, b, out, b.inputs.size());
            all.push_back(s);
        }
        const auto wanted =
            std::find_if(all.begin(), all.end(), [&](auto& s) { return s.model.filter->name == k_.expected.is; });
        const score& chosen = wanted != all.end() && wanted->fits() ? *wanted : best_of(all);
        k_.found->inputs = b.inputs.size();
        if (!chosen.fits()) {
            k_.found->explained = chosen.explained;
            return k_.give_up("closest", "no filter gives these results. The closest, " + chosen.model.filter->name +
                                             listed(chosen.model.slips()) + ", gives " +
                                             shortened(100.0 * double(chosen.explained) / double(chosen.tried)) +
                                             " % of them");
        }
        k_.best = chosen.model;
        find_outside(b, out);
        k_.wanted = {wanted != all.end() ? wanted->model.filter : k_.best.filter, {}, {}, k_.best.mode};
        if (k_.best.mode != outside::clamped) k_.wanted.mode = outside::bordered;
        k_.found->function = k_.best.filter->name;
        k_.found->expected = k_.wanted.filter->name;
        k_.found->slips = k_.best.slips();
        count(b, out);
    }

private:
    static constexpr int inputs = 8192;

    static std::string listed(const std::vector<finding>& slips) {
        std::string all;
        for (const finding& f : slips) all += ", " + f.says;
        return all;
    }

    /// One with the same bits; else the first that fits, as the list goes from the plain to the special: of two that
    /// differ by rounding alone, the number of equal bits says how a GPU rounds, and not which of them was meant.
    static const score& best_of(const std::vector<score>& all) {
        for (auto is : {&score::has_its_bits, &score::fits})
            if (const auto found = std::find_if(all.begin(), all.end(), std::mem_fn(is)); found != all.end())
                return *found;
        return *std::max_element(all.begin(), all.end(), [](auto& x, auto& y) { return x.rank() < y.rank(); });
    }

    static void judge(score& s, const batch& b, std::span<const vec4> out, std::size_t count) {
        s.tried = s.explained = s.same = 0, s.off = 0;
        for (std::size_t i = 0; i < count; ++i) {
            if (!s.model.inside(b, b.inputs[i])) continue;
            const float expected = s.model(b, b.inputs[i]), got = out[i].x;
            const bool same = same_bits(expected, got);
            ++s.tried, s.same += same;
            s.off += same ? 0 : std::abs(double(expected) - double(got));
            s.explained += same || beside(s.model, b, b.inputs[i], got);
        }
    }

    /// The kind of outside with which most results agree.
    void find_outside(const batch& b, std::span<const vec4> out) {
        std::size_t most = 0, edges = 0;
        filter_model trial = k_.best;
        for (outside mode : outside_modes) {
            trial.mode = mode;
            std::size_t explained = 0;
            edges = 0;
            for (std::size_t i = 0; i < b.inputs.size(); ++i) {
                if (trial.inside(b, b.inputs[i])) continue;
                ++edges;
                explained += same_bits(trial(b, b.inputs[i]), out[i].x) || beside(trial, b, b.inputs[i], out[i].x);
            }
            if (explained > most) most = explained, k_.best.mode = mode;
        }
        k_.found->outside = name(k_.best.mode);
        if (most < edges)
            k_.found->but.push_back({"edges", shortened(100 - 100.0 * double(most) / double(edges)) +
                                                  " % of the lookups at the map's edges and outside it differ"});
        else if (k_.best.mode != outside::clamped && k_.best.mode != outside::bordered)
            k_.found->but.push_back({"edges", "outside the map: " + std::string(name(k_.best.mode))});
    }

    void count(const batch& b, std::span<const vec4> out) {
        verdict& v = *k_.found;
        bool weights = false;
        const bool slipped = !v.slips.empty() || v.function != v.expected;
        for (std::size_t i = 0; i < b.inputs.size(); ++i) {
            const float best = k_.best(b, b.inputs[i]), wanted = k_.wanted(b, b.inputs[i]), got = out[i].x;
            v.same_bits += same_bits(wanted, got);
            const bool inside = k_.best.inside(b, b.inputs[i]);
            v.explained += same_bits(best, got) || beside(k_.best, b, b.inputs[i], got);
            weights |= inside && !same_bits(best, got);
            const auto differs = [&] {
                return slipped ? !beside(k_.wanted, b, b.inputs[i], got) : !same_bits(wanted, got);
            };
            if (!k_.worst && differs())
                k_.worst = {b.size, b.map, b.inputs[i], vec4(out[i].x, 0, 0, 0), vec4(wanted, 0, 0, 0)};
        }
        if (weights)
            v.but.push_back({"weights",
                             "weights are rounded otherwise, as a sampler's 8 bits do: within that of a "
                             "coordinate 1/256 texel away"});
    }

    filter_knowledge& k_;
    bool asked_ = false;
};

}  // namespace

std::unique_ptr<stage> weights_stage(filter_knowledge& k) { return std::make_unique<weighs>(k); }

}  // namespace check
