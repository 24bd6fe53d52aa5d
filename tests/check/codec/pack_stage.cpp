// SPDX-License-Identifier: MIT
#include <algorithm>
#include <cmath>
#include <limits>
#include <tuple>

#include "../numbers.hpp"
#include "../stage.hpp"
#include "codecs.hpp"

namespace check {
namespace {

using glm::vec4;

/// A slip before packing or behind it, and how it is told.
struct depth_change {
    float scale, offset;
    const char* kind;
    const char* says;
};
constexpr depth_change depth_changes[]{
    {1, 0, "", ""},
    {2, -1, "z_range", "depth in [0, 1] taken to [-1, 1]"},
    {0.5f, 0.5f, "z_range", "depth in [0, 1] taken to [0.5, 1]"},
    {-1, 1, "direction", "depth reversed: 1 - depth"},
    {255.0f / 256, 0, "base", "times 255 / 256: base 255 for 256"},
    {256.0f / 255, 0, "base", "times 256 / 255: base 256 for 255"},
};
struct channel_change {
    bool truncates;
    float added;  ///< to each channel of the store
    const char* kind;
    const char* says;
};
constexpr channel_change channel_changes[]{{false, 0, "", ""},
                                           {true, 0, "truncation", "channels truncated in place of rounded"},
                                           {false, 1, "truncation", "channels one step too high"},
                                           {false, -1, "truncation", "channels one step too low"}};

struct pack_model {
    const codec* what = nullptr;
    const depth_change* depth = depth_changes;
    const channel_change* channel = channel_changes;
    channel_order order{};

    /// Channels that the store keeps, and others are 0.
    [[nodiscard]] vec4 operator()(float z) const {
        const float most = largest_channel(what->bits);
        const auto& encode = channel->truncates ? what->truncated : what->encode;
        vec4 k = encode(depth->scale * z + depth->offset);
        for (int i = 0; i < what->channels; ++i) k[i] = (glm::clamp)(k[i] + channel->added, 0.0f, most);
        for (int i = what->channels; i < 4; ++i) k[i] = 0;
        return order(k);
    }
    [[nodiscard]] bool same(const vec4& a, const vec4& b) const {
        return what->channels == 1 ? a.x == b.x
                                   : a.x == b.x && a.y == b.y && (what->channels < 3 || a.z == b.z) &&
                                         (what->channels < 4 || a.w == b.w);
    }
    /// The same depth but for its last digit: 32 bits are more than a float has.
    [[nodiscard]] bool beside(float z, vec4 got) const {
        channel_order back;
        for (int k = 0; k < 4; ++k) back.from[order.from[k]] = k;
        const float a = what->decode(back((*this)(z))), b = what->decode(back(got));
        return std::abs(a - b) <= 0x1p-22f;
    }
    [[nodiscard]] std::vector<finding> slips() const {
        std::vector<finding> all;
        if (depth->scale != 1) all.push_back({depth->kind, depth->says});
        if (*channel->kind) all.push_back({channel->kind, channel->says});
        if (!order.plain(what->channels))
            all.push_back({"channels", "channels in the order " + order.name(what->channels)});
        return all;
    }
};

/// For each channel of the encoding the one of the results that is most often equal.
channel_order matching(const pack_model& m, const batch& b, const std::vector<vec4>& got) {
    channel_order order;
    const int channels = m.what->channels;
    int counts[4][4]{};
    for (std::size_t i = 0; i < got.size(); i += 16) {
        const vec4 expected = m(b.inputs[i].x);
        for (int k = 0; k < channels; ++k)
            for (int from = 0; from < channels; ++from) counts[k][from] += got[i][k] == expected[from];
    }
    bool taken[4]{};
    for (int round = 0; round < channels; ++round) {  // the surest first
        int best = -1, k_best = 0, from_best = 0;
        for (int k = 0; k < channels; ++k)
            for (int from = 0; from < channels; ++from)
                if (counts[k][from] > best && !taken[from]) best = counts[k][from], k_best = k, from_best = from;
        order.from[k_best] = from_best;
        taken[from_best] = true;
        for (int& c : counts[k_best]) c = -2;
    }
    return order;
}

/// Channels up to the last that varies: an encoding that gives all of them is preferred.
int channels_that_vary(const std::vector<vec4>& got) {
    for (int k = 4; k > 0; --k)
        if (std::any_of(got.begin(), got.end(), [&](const vec4& v) { return v[k - 1] != got[0][k - 1]; })) return k;
    return 0;
}

struct score {
    pack_model model{};
    std::size_t same = 0, explained = 0;
    int covered = 0;  ///< channels that vary, of those that the encoding has
    [[nodiscard]] auto rank() const { return std::tuple(explained, covered, same, -int(model.slips().size())); }
};

class packs final : public stage {
public:
    packs(const expectation& e, std::uint32_t seed, verdict& v) : expected_(e.is), random_(seed), found_(v) {}

    std::optional<batch> ask() override {
        if (asked_) return std::nullopt;
        asked_ = true;
        batch b;
        for (float z : round_depths) b.inputs.push_back({z, 0, 0, 0});
        while (b.inputs.size() < inputs) b.inputs.push_back({random_.unit(), 0, 0, 0});
        for (float z : ends) b.inputs.push_back({z, 0, 0, 0});
        return b;
    }

    void learn(const batch& b, std::span<const vec4> out) override {
        score best;
        std::vector<vec4> channels;
        for (int bits : channel_bits) {
            std::vector<vec4> got;
            for (const vec4& v : out)
                got.push_back(glm::floor((glm::clamp)(v, 0.0f, 1.0f) * largest_channel(bits) + 0.5f));
            if (score s = best_of(b, got, bits); !best.model.what || s.rank() > best.rank())
                best = s, channels = std::move(got);
        }
        found_.inputs = inputs;
        if (best.explained < inputs) {
            found_.how = agreement::unknown, found_.explained = best.explained;
            found_.but.push_back({"closest", "no encoding gives these channels. The closest, " + best.model.what->name +
                                                 ", gives " + shortened(100.0 * double(best.explained) / inputs) +
                                                 " % of them"});
            return;
        }
        conclude(best, b, channels);
    }

private:
    static constexpr std::size_t inputs = 8192;
    static constexpr float round_depths[]{0.5f,   0.25f, 0.75f, 0.125f, 0.375f, 0.625f,
                                          0.875f, 0.1f,  0.2f,  0.3f,   0.9f,   0.99f};
    static constexpr float ends[]{0, 1, -0.5f, 1.5f, std::numeric_limits<float>::quiet_NaN()};
    static constexpr const char* end_names[]{"0", "1", "-0.5", "1.5", "NaN"};

    score best_of(const batch& b, const std::vector<vec4>& got, int bits) const {
        score best;
        const int varying = channels_that_vary(got);
        const auto judge = [&](score& s, std::size_t count) {
            s.same = s.explained = 0;
            for (std::size_t i = 0; i < count; ++i) {
                const bool same = s.model.same(s.model(b.inputs[i].x), got[i]);
                s.same += same;
                s.explained += same || s.model.beside(b.inputs[i].x, got[i]);
            }
        };
        for (const codec& c : codecs()) {
            if (c.bits != bits) continue;
            for (const depth_change& d : depth_changes)
                for (const channel_change& ch : channel_changes) {
                    if (ch.truncates && !c.truncated) continue;
                    score s{{&c, &d, &ch}};
                    s.covered = (std::min)(c.channels, varying);
                    s.model.order = matching(s.model, b, got);
                    judge(s, 256);
                    if (s.explained < 240) continue;
                    judge(s, inputs);
                    const bool wanted = c.name == expected_ && s.explained == inputs && s.model.slips().empty();
                    if (!best.model.what || s.rank() > best.rank() || wanted) best = s;
                    if (wanted) return best;
                }
        }
        if (!best.model.what) best.model.what = &codecs().front();
        return best;
    }

    void conclude(const score& best, const batch& b, const std::vector<vec4>& got) {
        pack_model wanted{best.model.what};
        for (const codec& c : codecs())
            if (c.name == expected_) wanted.what = &c;
        found_.function = best.model.what->name, found_.expected = wanted.what->name;
        found_.slips = best.model.slips();
        found_.explained = best.explained;
        for (std::size_t i = 0; i < inputs; ++i) {
            const vec4 expected = wanted(b.inputs[i].x);
            const bool same = wanted.what->bits == best.model.what->bits && wanted.same(expected, got[i]);
            found_.same_bits += same;
            if (!same && !found_.first) found_.first = {{}, {}, b.inputs[i], got[i], expected};
        }
        const bool slipped = !found_.slips.empty() || found_.function != found_.expected;
        if (!slipped && found_.same_bits < inputs)
            found_.but.push_back({"rounding", "the last channel is rounded otherwise in some results"});
        std::string differing;
        for (std::size_t i = 0; i < std::size(ends); ++i)
            if (!best.model.same(best.model(ends[i]), got[inputs + i])) {
                differing += (differing.empty() ? "" : ", ") + std::string(end_names[i]);
                if (!slipped && !found_.first)
                    found_.first = {{}, {}, b.inputs[inputs + i], got[inputs + i], wanted(ends[i])};
            }
        if (!differing.empty()) found_.but.push_back({"edges", "another result for " + differing});
        found_.how = slipped ? agreement::other : found_.but.empty() ? agreement::same_bits : agreement::same_but;
    }

    std::string expected_;
    dice random_;
    verdict& found_;
    bool asked_ = false;
};

}  // namespace

std::unique_ptr<stage> investigate_pack(const expectation& e, std::uint32_t seed, verdict& v) {
    return std::make_unique<packs>(e, seed, v);
}

}  // namespace check
