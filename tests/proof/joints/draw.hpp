// SPDX-License-Identifier: MIT
//
// One draw: a shadow of random parts over a random scene, and its receivers against rays.
#pragma once

#include <algorithm>
#include <cstdint>
#include <cstring>
#include <functional>
#include <memory>
#include <stdexcept>
#include <string>
#include <vector>

#include "choices.hpp"
#include "host.hpp"
#include "penumbra.hpp"
#include "promises.hpp"
#include "scene.hpp"
#include "setups.hpp"
#include "tweaks.hpp"
#include "verdict.hpp"

namespace joints {

/// Answers of draws at receivers that rays decide.
struct tally {
    std::uint64_t receivers = 0, lit = 0, dark = 0, penumbra = 0;
    std::uint64_t falsely_dark = 0, falsely_lit = 0;  ///< darker, or lighter, than rays allow
    std::uint64_t unheld = 0;                         ///< not in the map, though the fit says so
    std::uint64_t differs = 0;                        ///< another answer over an image than alone

    [[nodiscard]] std::uint64_t wrong() const { return falsely_dark + falsely_lit + unheld + differs; }
    tally& operator+=(const tally& o) {
        receivers += o.receivers, lit += o.lit, dark += o.dark, penumbra += o.penumbra;
        falsely_dark += o.falsely_dark, falsely_lit += o.falsely_lit;
        unheld += o.unheld, differs += o.differs;
        return *this;
    }
};

/// A shadow over a scene, ready to be asked.
class drawn {
public:
    /// @throws std::invalid_argument   where the setup or the shadow is refused
    explicit drawn(const choices& c)
        : choices_(c),
          scene_(c),
          lit_(make_setup(c, scene_, reach_of(c.filter))),
          promises_(promises_of(c, scene_)),
          host_(make_host(c, lit_, scene_.origin)) {
        for (int i = 0; i < c.image.x * c.image.y; ++i) receivers_.push_back(scene_.draw_receiver());
        for (std::size_t i = 0; i < receivers_.size(); ++i) verdicts_.push_back(verdict_at(i));
    }

    /// The shadow as the library has it, alone and over an image.
    [[nodiscard]] tally right() {
        host_->draw(scene_);
        umbrage::image<glm::vec3> points(choices_.image), normals(choices_.image);
        umbrage::image<float> seen(choices_.image);
        for (std::size_t i = 0; i < receivers_.size(); ++i)
            points[pixel(i)] = receivers_[i].point, normals[pixel(i)] = receivers_[i].normal;
        host_->visibility(points.view(), normals.view(), seen.view());
        tally found = count([&](const looked_up& r) { return host_->visibility(r); });
        for (std::size_t i = 0; i < receivers_.size(); ++i) {
            const float alone = host_->visibility(looked(i)), over = seen[pixel(i)];
            if (std::memcmp(&alone, &over, sizeof alone) != 0) ++found.differs;
        }
        return found;
    }
    /// The same with a program's mistake; none where this draw has no such step.
    [[nodiscard]] std::optional<tally> wrong(const tweaks& t) {
        if (!host_->draw_wrong(scene_, t)) return std::nullopt;
        return count([&](const looked_up& r) { return host_->wrong_visibility(r); });
    }
    /// True when the steps of a program, none of them wrong, have the shadow's own bits.
    [[nodiscard]] bool has_steps() {
        if (!host_->draw_wrong(scene_, {})) return false;
        std::vector<float> steps;
        for (std::size_t i = 0; i < receivers_.size(); ++i) steps.push_back(host_->wrong_visibility(looked(i)));
        host_->draw(scene_);
        for (std::size_t i = 0; i < receivers_.size(); ++i)
            if (host_->visibility(looked(i)) != steps[i]) return false;
        return true;
    }
    /// Calls use(number, verdict, receiver, visibility) for each wrong receiver.
    void list(const std::function<void(std::size_t, verdict, const looked_up&, float)>& use) const {
        for (std::size_t i = 0; i < receivers_.size(); ++i) {
            const float v = host_->visibility(looked(i));
            if (!verdicts_[i].holds(v)) use(i, verdicts_[i], looked(i), v);
        }
    }
    [[nodiscard]] const any_host& host() const { return *host_; }
    [[nodiscard]] const scene& of() const { return scene_; }
    [[nodiscard]] const lit_scene& lit() const { return lit_; }

private:
    [[nodiscard]] glm::ivec2 pixel(std::size_t i) const {
        return {int(i) % choices_.image.x, int(i) / choices_.image.x};
    }
    [[nodiscard]] looked_up looked(std::size_t i) const {
        return {receivers_[i].point, receivers_[i].normal, pixel(i), &scene_.surfaces[receivers_[i].own]};
    }
    template <class Look>
    [[nodiscard]] tally count(const Look& look) const {
        tally t{.receivers = receivers_.size(), .unheld = unheld_};
        for (std::size_t i = 0; i < receivers_.size(); ++i) {
            const verdict& rays = verdicts_[i];
            if (rays.is_open()) continue;
            const float v = look(looked(i));
            ++(rays.is_lit() ? t.lit : rays.is_dark() ? t.dark : t.penumbra);
            t.falsely_dark += !(v >= rays.least);
            t.falsely_lit += !(v <= rays.most);
        }
        return t;
    }
    /// What rays say in the maps that a receiver is looked up in.
    [[nodiscard]] verdict verdict_at(std::size_t i) {
        const receiver& r = receivers_[i];
        verdict all{1, 0};
        bool is_in = true;
        const float beyond = host_->facts.places(r.point, r.normal, [&](const umbrage::map_place& place) {
            const bool is_before = glm::abs(place.at.x) < 65000.0f;
            is_in = is_in && is_before && is_held(map_of(place, r), r.point, 0, rounding_of(place));
            const verdict here = has_no_page(place) ? fully_lit : is_before ? verdict_in(place, i) : verdict{};
            all = {std::min(all.least, here.least), std::max(all.most, here.most)};
        });
        unheld_ += !is_in && promises_(glm::dvec3(r.point));
        if (all.least > all.most) return {};  // in no map
        return beyond > 0 ? verdict{all.least, 1} : all;
    }
    /// True for a receiver outside all pages, as page_coordinate says it: all filters take it as lit.
    [[nodiscard]] static bool has_no_page(const umbrage::map_place& place) {
        return glm::vec2(place.at) == glm::vec2(32768);
    }
    [[nodiscard]] verdict verdict_in(const umbrage::map_place& place, std::size_t i) const {
        const receiver& r = receivers_[i];
        const proof::shadow_facts& facts = host_->facts;
        const proof::traced_map& map = map_of(place, r);
        const double more = double(facts.terms.reach) - facts.reach, reach = facts.reach + more + 1.0 / 16;
        if (std::abs(map.depth(r.point) - 1) <= rounding_of(place)) return {};  // on the far plane, or beyond it
        const double stated = double(facts.detaches(r.point, r.normal));
        verdict here = verdict_of(map, lit_.light, scene_.surfaces, r, reach, stated, lit_.clips);
        if (here.is_open() && choices_.filter.hardens() && umbrage::detail::is_seen(place)) {
            const double hidden = 2 * double(facts.terms.error + place.slack) + facts.farther + 0x1p-22;
            const soft_look look{choices_.filter, pixel(i), reach, 0.5 + more + 1.0 / 16, hidden};
            here = penumbra_rays(map, lit_.light, scene_.surfaces, r, lit_.clips, look).visibility();
        }
        return is_held(map, r.point, reach + 1) ? here : verdict{here.least, 1};
    }
    [[nodiscard]] const proof::traced_map& map_of(const umbrage::map_place& place, const receiver& r) const {
        return host_->facts.map_of(place, r.point);
    }
    /// Depth by which a place may be off.
    [[nodiscard]] double rounding_of(const umbrage::map_place& place) const {
        return double(place.slack - host_->facts.spare(place)) + 0x1p-22;
    }
    /// @param spare   depth beyond the far plane that counts as before it
    [[nodiscard]] bool is_held(const proof::traced_map& map, glm::vec3 p, double least, double spare = 0) const {
        const proof::shadow_facts& facts = host_->facts;
        const glm::dvec4 h = map.placed(p);
        const auto within = [&](double v, float size) { return v >= least && v <= double(size) - least; };
        return h.w > 0 && h.z >= 0 && h.z <= h.w * (1 + spare) &&
               (!facts.bordered ||
                (within(h.x / h.w, facts.terms.map_size.x) && within(h.y / h.w, facts.terms.map_size.y)));
    }

    choices choices_;
    scene scene_;
    lit_scene lit_;
    std::function<bool(glm::dvec3)> promises_;
    std::unique_ptr<any_host> host_;
    std::vector<receiver> receivers_;
    std::vector<verdict> verdicts_;
    std::uint64_t unheld_ = 0;
};

}  // namespace joints
