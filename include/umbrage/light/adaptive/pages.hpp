// SPDX-License-Identifier: MIT
//
// Which pages of a light's root square a view needs, so that shadows are as fine as the screen, and which of an
// atlas' slots hold them: pages stay where they are from frame to frame, those least recently needed are given up.
//
//     umbrage::page_cache cache({.slots = {16, 16}, .deepest_level = 10});
//     for (;;) {  // receivers: umbrage::page_receiver{coordinate in the root, longest_extent in a map of one page}
//         const umbrage::page_update update = cache.update(receivers);
//         umbrage::draw_pages(atlas, layout, root, update.drawn, draw);  // see images/page_atlas.hpp
//     }
//
#pragma once

#include <algorithm>
#include <cmath>
#include <compare>
#include <cstddef>
#include <cstdint>
#include <span>
#include <vector>

#include <glm/vec2.hpp>

#include <umbrage/core/check.hpp>
#include <umbrage/core/config.hpp>
#include <umbrage/core/lesser.hpp>
#include <umbrage/core/scalar.hpp>
#include <umbrage/light/adaptive/page_table.hpp>
#include <umbrage/light/light_space.hpp>

namespace umbrage {

/// A square of the root, whose side is the root's over 2^level: the x-th from the left, the y-th from the first row.
struct page {
    int level = 0, x = 0, y = 0;

    friend auto operator<=>(const page&, const page&) = default;  ///< coarse ones first
};

/// The page of a level that holds a point.
/// @param coord   1 .. 2 across the root, 2 not included
template <class = detail::on_use>
[[nodiscard]] inline page page_at(glm::dvec2 coord, int level) {
    const double across = std::ldexp(1.0, level);
    return {level, static_cast<int>((coord.x - 1.0) * across), static_cast<int>((coord.y - 1.0) * across)};
}

/// A point that the view sees.
struct page_receiver {
    glm::vec2 coord{1};   ///< 1 .. 2 across the root
    float extent = 0.0f;  ///< longest_extent of a texel of the coarsest page, pixels
};

namespace detail {

/// The least level in which no texel's longer axis covers more pixels than wanted; -1 of receivers that want none.
template <class = on_use>
[[nodiscard]] inline int wanted_level(const page_receiver& r, double target, int deepest) {
    const auto in_root = [](float v) { return v >= 1.0f && v < 2.0f; };
    if (!in_root(r.coord.x) || !in_root(r.coord.y) || !is_finite(r.extent) || !(r.extent > 0.0f)) return -1;
    return static_cast<int>(detail::limited(std::ceil(std::log2(double(r.extent) / target)), 0.0, double(deepest)));
}

/// To pages in the making, where it is not the last already.
template <class = on_use>
inline void add(const page& p, std::vector<page>& pages) {
    if (pages.empty() || p != pages.back()) pages.push_back(p);
}
/// Each once, coarse ones first.
template <class = on_use>
void tidy(std::vector<page>& pages) {
    std::sort(pages.begin(), pages.end());
    pages.erase(std::unique(pages.begin(), pages.end()), pages.end());
}

}  // namespace detail

/// The pages of the least level in which no texel's longer axis covers more pixels than wanted.
/// @param receivers       those beside the root, and of an extent that is not finite or not above 0, want none
/// @param target          pixels, > 0
/// @param deepest_level   0 .. 15, whatever that leaves
/// @return                each once, coarse ones first
/// @formula               level = ceil(log2(extent / target))
/// @throws std::invalid_argument  target or deepest_level out of range
template <class = detail::on_use>
[[nodiscard]] std::vector<page> wanted_pages(std::span<const page_receiver> receivers, double target,
                                             int deepest_level) {
    constexpr auto function = "wanted_pages";
    detail::require(is_finite(target) && target > 0.0, function, "target", "finite and above 0", target);
    detail::require(deepest_level >= 0 && deepest_level <= deepest_page_level, function, "deepest_level",
                    "from 0 to 15", deepest_level);
    std::vector<page> pages;
    for (const page_receiver& r : receivers) {
        const int level = detail::wanted_level(r, target, deepest_level);
        if (level < 0) continue;
        detail::add(page_at(glm::dvec2(r.coord), level), pages);
    }
    detail::tidy(pages);
    return pages;
}

/// What a cache is made for.
struct page_budget {
    glm::ivec2 slots{16};    ///< columns and rows of pages that the atlas has, each 1 .. 256
    int deepest_level = 10;  ///< 0 .. 15: of the finest pages; a table has 2^deepest_level texels a side
    double target = 1.0;     ///< pixels that a texel may cover, > 0
};

/// A page and where the atlas holds it.
struct placed_page {
    umbrage::page page;
    glm::ivec2 slot;
};

/// What has changed from one view to the next.
struct page_update {
    std::vector<placed_page> drawn{};  ///< pages that are to be drawn, coarse ones first
    double target = 0.0;               ///< pixels that a texel covers at most: the budget's target, or more
    std::size_t kept = 0;              ///< pages needed that were there
    std::size_t given_up = 0;          ///< pages that others took the place of,
    std::size_t forced = 0;            ///< and of these such as the view needs for the budget's target: shadows pop
};

/// Pages that stay in their slots as long as nothing finer, nearer or newer wants these.
///
/// The root's own page is always there, so that there is shadow everywhere in it; where the view needs no finer pages
/// any more, those that are left serve until others need their slots. Where the wanted pages are more than the slots,
/// the target is raised by steps of a sixteenth of an octave until they fit; it comes down again when as many as seven
/// eighths of the slots suffice, so that it does not swing.
/// @cite   Fernando, Fernandez, Bala, Greenberg: Adaptive Shadow Maps, SIGGRAPH 2001
class page_cache {
public:
    /// @throws std::invalid_argument  slots, deepest_level or target out of range
    template <class = detail::on_use>
    explicit page_cache(const page_budget& budget) : budget_(budget), target_(budget.target) {
        constexpr auto function = "page_cache";
        const auto fits = [](int n) { return n >= 1 && n <= 256; };
        detail::require(fits(budget.slots.x) && fits(budget.slots.y), function, "slots", "from 1 to 256 each",
                        budget.slots);
        detail::require(budget.deepest_level >= 0 && budget.deepest_level <= deepest_page_level, function,
                        "deepest_level", "from 0 to 15", budget.deepest_level);
        detail::require(is_finite(budget.target) && budget.target > 0.0, function, "target", "finite and above 0",
                        budget.target);
        for (int y = budget.slots.y; y-- > 0;)
            for (int x = budget.slots.x; x-- > 0;) free_.push_back({x, y});
    }

    /// Takes in what a view sees.
    template <class = detail::on_use>
    page_update update(std::span<const page_receiver> receivers) {
        ++now_;
        page_update result;
        std::vector<page> missing;
        const std::vector<page> needed = fitting(receivers);
        auto here = resident_.begin();
        for (const page& p : needed) {
            while (here != resident_.end() && here->page < p) ++here;
            if (here == resident_.end() || here->page != p) missing.push_back(p);
            else here->needed = now_, ++result.kept;
        }
        const std::vector<page> given_up =
            give_up(missing.size() > free_.size() ? missing.size() - free_.size() : std::size_t(0));
        for (const page& p : missing) {
            result.drawn.push_back({p, free_.back()});
            resident_.push_back({p, free_.back(), now_});
            free_.pop_back();
        }
        std::sort(resident_.begin(), resident_.end(), [](const held& a, const held& b) { return a.page < b.page; });
        result.target = target_;
        result.given_up = given_up.size();
        if (target_ > budget_.target && !given_up.empty()) result.forced = popped(receivers, given_up);
        return result;
    }

    /// All that must be drawn anew: casters or the light have moved.
    template <class = detail::on_use>
    void forget() {
        for (const held& h : resident_) free_.push_back(h.slot);
        resident_.clear();
    }

    [[nodiscard]] const page_budget& budget() const { return budget_; }
    [[nodiscard]] std::size_t size() const { return resident_.size(); }

    /// Calls use(page, slot) for every page that is there, coarse ones first.
    template <class Use>
    void for_each(Use&& use) const {
        for (const held& h : resident_) use(h.page, h.slot);
    }

    /// The level of the finest page that holds a point; -1 where there is none.
    /// @param coord   1 .. 2 across the root, 2 not included
    template <class = detail::on_use>
    [[nodiscard]] int level_at(glm::dvec2 coord) const {
        int level = budget_.deepest_level;
        while (level >= 0 && !find(page_at(coord, level))) --level;
        return level;
    }

private:
    struct held {
        umbrage::page page;
        glm::ivec2 slot;
        std::uint64_t needed;  ///< in which update last
    };

    [[nodiscard]] std::size_t slots() const {
        return static_cast<std::size_t>(budget_.slots.x) * static_cast<std::size_t>(budget_.slots.y);
    }

    /// nullptr: the page is not there.
    template <class = detail::on_use>
    [[nodiscard]] const held* find(const page& p) const {
        const auto at = std::lower_bound(resident_.begin(), resident_.end(), p,
                                         [](const held& h, const page& sought) { return h.page < sought; });
        return at != resident_.end() && at->page == p ? &*at : nullptr;
    }

    /// The root and what is wanted besides, with the target moved until it fits.
    template <class = detail::on_use>
    [[nodiscard]] std::vector<page> fitting(std::span<const page_receiver> receivers) {
        const double step = std::exp2(1.0 / 16.0);
        const auto wanted = [&](double target) {
            std::vector<page> pages = wanted_pages(receivers, target, budget_.deepest_level);
            if (pages.empty() || pages.front() != page{}) pages.insert(pages.begin(), page{});
            return pages;
        };
        std::vector<page> pages = wanted(target_);
        while (pages.size() > slots()) pages = wanted(target_ *= step);
        while (target_ > budget_.target) {
            const double finer = detail::greater(target_ / step, budget_.target);
            std::vector<page> more = wanted(finer);
            if (more.size() * 8 > slots() * 7) break;
            target_ = finer;
            pages.swap(more);
        }
        return pages;
    }

    /// Frees slots: of the pages not needed now the least recently needed, of these the finest.
    /// @return   the pages, in their order
    template <class = detail::on_use>
    std::vector<page> give_up(std::size_t count) {
        std::vector<page> pages;
        if (count == 0) return pages;
        std::sort(resident_.begin(), resident_.end(), [](const held& a, const held& b) {
            return a.needed != b.needed ? a.needed > b.needed : a.page < b.page;
        });
        for (std::size_t i = 0; i < count; ++i) {
            pages.push_back(resident_.back().page);
            free_.push_back(resident_.back().slot);
            resident_.pop_back();
        }
        detail::tidy(pages);
        return pages;
    }

    /// How many of the pages given up some receiver looked into that the budget's target would have it look into still.
    template <class = detail::on_use>
    [[nodiscard]] std::size_t popped(std::span<const page_receiver> receivers,
                                     const std::vector<page>& given_up) const {
        std::vector<page> pops;
        for (const page_receiver& r : receivers) {
            const int asked = detail::wanted_level(r, budget_.target, budget_.deepest_level);
            const int found = asked < 0 ? asked : level_at(glm::dvec2(r.coord));
            if (found >= asked) continue;
            for (int level = budget_.deepest_level; level > found; --level) {
                const page p = page_at(glm::dvec2(r.coord), level);
                if (!std::binary_search(given_up.begin(), given_up.end(), p)) continue;
                detail::add(p, pops);
                break;
            }
        }
        detail::tidy(pops);
        return pops.size();
    }

    page_budget budget_;
    double target_;
    std::uint64_t now_ = 0;
    std::vector<held> resident_;  // coarse pages first
    std::vector<glm::ivec2> free_;
};

}  // namespace umbrage
