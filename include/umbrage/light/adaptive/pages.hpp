// SPDX-License-Identifier: MIT
//
// Pages of a virtual shadow map (adaptive shadow map), for shadows as fine as the screen.
// A cache finds the pages that a view needs, and assigns them to slots of an atlas. Pages keep their slots from frame
// to frame. The least recently needed ones are evicted.
//
//     umbrage::page_cache cache({.slots = {16, 16}, .deepest_level = 10});
//     for (;;) {  // receivers: umbrage::page_receiver{coordinate in the root, longest_extent in a map of one page}
//         const umbrage::page_update update = cache.update(receivers);
//         umbrage::draw_pages(atlas, layout, root, update.drawn, draw);  // see images/page_atlas.hpp
//     }
//
// Also called: virtual shadow maps (Unreal), adaptive shadow maps (ASM), sparse or quadtree shadow maps (page_cache).
// See also: page_table.hpp, root.hpp.
#pragma once

#include <algorithm>
#include <cmath>
#include <compare>
#include <cstddef>
#include <cstdint>
#include <span>
#include <vector>

#include <glm/common.hpp>
#include <glm/vec2.hpp>

#include <umbrage/core/check.hpp>
#include <umbrage/core/config.hpp>
#include <umbrage/core/scalar.hpp>
#include <umbrage/light/adaptive/page_table.hpp>
#include <umbrage/light/light_space.hpp>

namespace umbrage {

/// Square part of the root. Its side is the root's over 2^level. x counts from the left, and y from the first row.
struct page {
    int level = 0, x = 0, y = 0;

    friend auto operator<=>(const page&, const page&) = default;  ///< coarse pages first
};

/// Page of a level that holds a point.
/// @param coord   position, 1 to 2 across the root, without 2
/// @param level   a page's side is the root's over 2^level; 0 to 15
/// @edge          outside the root, or NaN: x and y are -1, which no page has
template <class = detail::on_use>
[[nodiscard]] inline page page_at(glm::dvec2 coord, int level) {
    const auto in_root = [](double v) { return !is_nan(v) && v >= 1.0 && v < 2.0; };
    if (!in_root(coord.x) || !in_root(coord.y)) return {level, -1, -1};
    const double across = std::ldexp(1.0, level);
    return {level, static_cast<int>((coord.x - 1.0) * across), static_cast<int>((coord.y - 1.0) * across)};
}

/// Point that the view sees.
struct page_receiver {
    glm::vec2 coord{1};   ///< position, 1 to 2 across the root
    float extent = 0.0f;  ///< longest_extent of a texel of the coarsest page, in pixels
};

namespace detail {

/// Lowest level whose texels cover at most `target` pixels along their longer axis. -1 for receivers that need no page.
template <class = on_use>
[[nodiscard]] inline int wanted_level(const page_receiver& r, double target, int deepest) {
    const auto in_root = [](float v) { return v >= 1.0f && v < 2.0f; };
    if (!in_root(r.coord.x) || !in_root(r.coord.y) || !is_finite(r.extent) || !(r.extent > 0.0f)) return -1;
    return static_cast<int>((glm::clamp)(std::ceil(std::log2(double(r.extent) / target)), 0.0, double(deepest)));
}

/// Adds a page to a list, unless it is already the last one there.
template <class = on_use>
inline void add(const page& p, std::vector<page>& pages) {
    if (pages.empty() || p != pages.back()) pages.push_back(p);
}
/// Sorts pages, coarse ones first, and removes duplicates.
template <class = on_use>
void tidy(std::vector<page>& pages) {
    std::sort(pages.begin(), pages.end());
    pages.erase(std::unique(pages.begin(), pages.end()), pages.end());
}

}  // namespace detail

/// Pages of the lowest level whose texels cover at most `target` pixels along their longer axis.
/// @param receivers       points that the view sees
/// @param target          pixels per texel, > 0
/// @param deepest_level   highest level, 0 to 15. It applies even if texels then cover more pixels
/// @return                each page once, coarse ones first
/// @edge                  receivers outside the root, or with an extent that is not finite or not above 0: no page
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

/// Limits of a page cache.
struct page_budget {
    glm::ivec2 slots{16};    ///< columns and rows of pages in the atlas, each 1 to 256
    int deepest_level = 10;  ///< level of the finest pages, 0 to 15. A table has 2^deepest_level texels per side
    double target = 1.0;     ///< pixels that a texel may cover, > 0 and no denormal
};

/// Page and its slot in the atlas.
struct placed_page {
    umbrage::page page;
    glm::ivec2 slot;
};

/// Changes of a page cache from one view to the next.
struct page_update {
    std::vector<placed_page> drawn{};  ///< pages to draw, coarse ones first
    double target = 0.0;               ///< largest number of pixels per texel: the budget's target, or more
    std::size_t kept = 0;              ///< needed pages that were already there
    std::size_t given_up = 0;          ///< pages evicted for others
    std::size_t forced = 0;            ///< evicted pages that the view needs for the budget's target: shadows pop
};

/// Cache of pages, which keep their slots until other pages need them.
///
/// The root's own page is always there, so that the whole root has shadows. Pages that the view no longer needs serve
/// until others take their slots. If the view needs more pages than there are slots, the target rises in steps of 1/16
/// octave until they fit. It falls again when 7/8 of the slots suffice, which prevents oscillation. A cache that was
/// moved from holds no page; update() fills it again.
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
        detail::require(detail::is_normal(budget.target) && budget.target > 0.0, function, "target",
                        "above 0, finite and no denormal", budget.target);  // denormals would not rise in small steps
    }

    /// Updates the cache for the points that a view sees.
    template <class = detail::on_use>
    page_update update(std::span<const page_receiver> receivers) {
        if (resident_.empty() && free_.empty())  // at the first update, or after a move
            for (int y = budget_.slots.y; y-- > 0;)
                for (int x = budget_.slots.x; x-- > 0;) free_.push_back({x, y});
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

    /// Drops all pages, so that they are drawn again. Call it when casters or the light have moved.
    template <class = detail::on_use>
    void forget() {
        for (const held& h : resident_) free_.push_back(h.slot);
        resident_.clear();
    }

    [[nodiscard]] const page_budget& budget() const { return budget_; }
    [[nodiscard]] std::size_t size() const { return resident_.size(); }

    /// Calls use(page, slot) for every page in the cache, coarse ones first.
    template <class Use>
    void for_each(Use&& use) const {
        for (const held& h : resident_) use(h.page, h.slot);
    }

    /// Level of the finest page that holds a point, or -1 if there is none.
    /// @param coord   position, 1 to 2 across the root, without 2
    /// @edge          outside the root, or NaN: -1
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
        std::uint64_t needed;  ///< number of the last update that needed it
    };

    [[nodiscard]] std::size_t slots() const {
        return static_cast<std::size_t>(budget_.slots.x) * static_cast<std::size_t>(budget_.slots.y);
    }

    /// Pointer to a page in the cache, or nullptr.
    template <class = detail::on_use>
    [[nodiscard]] const held* find(const page& p) const {
        const auto at = std::lower_bound(resident_.begin(), resident_.end(), p,
                                         [](const held& h, const page& sought) { return h.page < sought; });
        return at != resident_.end() && at->page == p ? &*at : nullptr;
    }

    /// Root page and wanted pages, with the target adjusted until they fit.
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
            const double finer = (glm::max)(target_ / step, budget_.target);
            std::vector<page> more = wanted(finer);
            if (more.size() * 8 > slots() * 7) break;
            target_ = finer;
            pages.swap(more);
        }
        return pages;
    }

    /// Frees slots. Among the pages not needed now it evicts the least recently needed, and of these the finest.
    /// @return   evicted pages, coarse ones first
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

    /// Number of evicted pages that a receiver used, and would still use at the budget's target.
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
