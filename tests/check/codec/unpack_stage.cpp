// SPDX-License-Identifier: MIT
#include <algorithm>
#include <array>
#include <cmath>
#include <numeric>
#include <tuple>

#include "../numbers.hpp"
#include "../stage.hpp"
#include "codecs.hpp"

namespace check {
namespace {

using glm::vec4;

/// What a reader adds for a channel of 1, all others 0.
struct weights {
    std::array<float, 4> of{};
    float none = 0;
    /// Channels from the weightiest on.
    [[nodiscard]] std::array<int, 4> descending() const {
        std::array<int, 4> order{0, 1, 2, 3};
        std::stable_sort(order.begin(), order.end(),
                         [&](int a, int b) { return of[std::size_t(a)] > of[std::size_t(b)]; });
        return order;
    }
};

struct unpack_model {
    const codec* what = nullptr;
    channel_order order{};
    float scale = 1, offset = 0;
    const char* kind = "";
    const char* says = "";
    [[nodiscard]] float operator()(const vec4& k) const {
        const float depth = what->decode(order(k));
        return scale == 1 && offset == 0 ? depth : depth * scale + offset;
    }
    [[nodiscard]] std::vector<finding> slips() const {
        std::vector<finding> all;
        if (*kind) all.push_back({kind, says});
        if (!order.plain(what->channels))
            all.push_back({"channels", "channels in the order " + order.name(what->channels)});
        return all;
    }
};

/// Changes of the depth that is returned.
constexpr unpack_model returned[]{
    {.scale = 1},
    {.scale = 2, .offset = -1, .kind = "z_range", .says = "depth in [0, 1] taken to [-1, 1]"},
    {.scale = 0.5f, .offset = 0.5f, .kind = "z_range", .says = "depth in [0, 1] taken to [0.5, 1]"},
    {.scale = -1, .offset = 1, .kind = "direction", .says = "depth reversed: 1 - depth"},
    {.scale = 255.0f / 256, .kind = "base", .says = "times 255 / 256: base 255 for 256"},
    {.scale = 256.0f / 255, .kind = "base", .says = "times 256 / 255: base 256 for 255"}};

struct score {
    unpack_model model{};
    std::size_t same = 0, explained = 0;
    float worst = 0;
    [[nodiscard]] auto rank() const { return std::tuple(explained, same, -worst); }
};

class unpacks final : public stage {
public:
    unpacks(const expectation& e, std::uint32_t seed, verdict& v) : expected_(e.is), random_(seed), found_(v) {}

    std::optional<batch> ask() override {
        if (done_ || at_ == std::size(channel_bits)) return std::nullopt;
        batch b;
        const float most = largest_channel(channel_bits[at_]);
        b.inputs.push_back(vec4(0));
        for (int k = 0; k < 4; ++k) {
            vec4 one(0);
            one[k] = 1;
            b.inputs.push_back(one);
        }
        while (b.inputs.size() < inputs) {
            vec4 k;
            for (int i = 0; i < 4; ++i) k[i] = float(random_.below(std::uint32_t(most) + 1)) / most;
            b.inputs.push_back(k);
        }
        return b;
    }

    void learn(const batch& b, std::span<const vec4> out) override {
        const int bits = channel_bits[at_++];
        const weights seen = measured(out);
        score best;
        for (const codec& c : codecs()) {
            if (c.bits != bits) continue;
            for (unpack_model m : returned) {
                m.what = &c;
                m.order = matching(c, seen);
                score s{m};
                judge(s, b, out);
                const bool wanted = c.name == expected_ && s.explained == inputs && s.model.slips().empty();
                if (!best.model.what || s.rank() > best.rank() || wanted) best = s;
                if (wanted) return conclude(best, b, out);
            }
        }
        if (best.explained == inputs) return conclude(best, b, out);
        if (at_ == std::size(channel_bits)) give_up(seen);
        else if (at_ == 1) first_seen_ = seen;
    }

private:
    static constexpr std::size_t inputs = 8192;

    static weights measured(std::span<const vec4> out) {
        weights w;
        w.none = out[0].x;
        for (std::size_t k = 0; k < 4; ++k) w.of[k] = out[k + 1].x - out[0].x;
        return w;
    }

    /// The order in which the weightiest channel of the shader is that of the encoding, and so on.
    static channel_order matching(const codec& c, const weights& seen) {
        weights own;
        const float most = largest_channel(c.bits);
        own.none = c.decode(vec4(0));
        for (int k = 0; k < c.channels; ++k) {
            vec4 one(0);
            one[k] = most;
            own.of[std::size_t(k)] = c.decode(one) - own.none;
        }
        weights positive = seen;  // of a reversed depth they are negative
        if (std::accumulate(seen.of.begin(), seen.of.end(), 0.0f) < 0)
            for (float& v : positive.of) v = -v;
        const auto from = positive.descending(), to = own.descending();
        channel_order order;
        for (std::size_t k = 0; k < 4; ++k) order.from[to[k]] = from[k];
        return order;
    }

    static void judge(score& s, const batch& b, std::span<const vec4> out) {
        const float most = largest_channel(s.model.what->bits);
        for (std::size_t i = 0; i < inputs; ++i) {
            const float expected = s.model(glm::floor(b.inputs[i] * most + 0.5f)), got = out[i].x;
            const bool same = same_bits(expected, got);
            const float off = same ? 0.0f : std::abs(expected - got);
            s.same += same;
            s.explained += same || off <= 0x1p-22f;  // four ulp below 1
            s.worst = (std::max)(s.worst, off);
        }
    }

    void conclude(const score& best, const batch& b, std::span<const vec4> out) {
        done_ = true;
        unpack_model wanted{best.model.what};
        for (const codec& c : codecs())
            if (c.name == expected_) wanted.what = &c;
        found_.function = best.model.what->name, found_.expected = wanted.what->name;
        found_.slips = best.model.slips();
        found_.inputs = inputs, found_.explained = best.explained;
        const bool slipped = !found_.slips.empty() || found_.function != found_.expected;
        const float most = largest_channel(wanted.what->bits);
        for (std::size_t i = 0; i < inputs; ++i) {
            const float expected = wanted(glm::floor(b.inputs[i] * most + 0.5f)), got = out[i].x;
            const bool same = same_bits(expected, got);
            found_.same_bits += same;
            const bool differs = slipped ? std::abs(expected - got) > 0x1p-22f : !same;
            if (differs && !found_.first)
                found_.first = {{}, {}, b.inputs[i], vec4(out[i].x, 0, 0, 0), {expected, 0, 0, 0}};
        }
        if (best.same < inputs)
            found_.but.push_back({"rounding", "sums are rounded otherwise: off by up to " + shortened(best.worst)});
        found_.how = slipped ? agreement::other : found_.but.empty() ? agreement::same_bits : agreement::same_but;
    }

    void give_up(const weights& seen) {
        const weights& w = at_ > 1 ? first_seen_ : seen;
        std::string all;
        for (std::size_t k = 0; k < 4; ++k) all += (k ? ", " : "") + exact(w.of[k]);
        found_.how = agreement::unknown, found_.inputs = inputs;
        found_.but.push_back({"weights", "no encoding gives these depths. Its channels add " + all +
                                             " where they are 1" + (w.none != 0 ? ", to " + exact(w.none) : "")});
    }

    std::string expected_;
    dice random_;
    verdict& found_;
    std::size_t at_ = 0;
    bool done_ = false;
    weights first_seen_{};
};

}  // namespace

std::unique_ptr<stage> investigate_unpack(const expectation& e, std::uint32_t seed, verdict& v) {
    return std::make_unique<unpacks>(e, seed, v);
}

}  // namespace check
