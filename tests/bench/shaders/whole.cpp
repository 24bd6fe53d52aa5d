// SPDX-License-Identifier: MIT
//
// Whole shadows, from a point x0 of the world with normal x2 to visibility: every setup under six filters, as bind()
// prints it from texels and with a comparison sampler. Engines' own whole shadows stand beside them.
#include "jobs.hpp"

#include <type_traits>
#include <utility>

#include <umbrage/shadow/in_shader.hpp>

#include "../../unit/shadow/scene.hpp"

namespace bench {

namespace {

namespace glsl = umbrage::glsl;

/// Ways in which a shadow reads its map.
enum class reading { texels, gathers, comparisons, linear_comparisons };
constexpr const char* names[]{"from texels", "by gathers", "by comparison sampler", "by linear comparison sampler"};

/// A whole shadow's shader.
template <class Shadow>
shader bound(const Shadow& s, reading how) {
    const bool compares = how == reading::comparisons || how == reading::linear_comparisons;
    constexpr auto grid = std::remove_cvref_t<decltype(s.setup())>::grid;
    constexpr bool several = grid.columns * grid.rows > 1;
    glsl::shadow_slots slots{.block = 7, .texture = 0};
    if (compares && several) slots.texture = 4, slots.map = glsl::texture::shadow_array;
    else if (compares) slots.texture = 2, slots.map = glsl::texture::shadow;
    if (how == reading::gathers) slots.gather = true;
    if (how == reading::gathers && several) slots.texture = 3, slots.map = glsl::texture::array;
    slots.linear = how == reading::linear_comparisons;
    const glsl::bound item = glsl::bind(s, "sun", slots);
    const bool turns = item.declared->functions[0].arguments.size() > 2;
    return {"umbrage",
            names[int(how)],
            "",
            {item},
            std::string("vec4(umbrage_sun(x0.xyz, x2.xyz") + (turns ? ", gl_FragCoord.xy))" : "))")};
}

/// A job of one light for each filter.
template <class Light>
void add(const std::string& name, const Light& light, int map_size, const whole_shaders& theirs,
         std::vector<job>& all) {
    const auto add_filter = [&]<class Filter>(const char* filter_name, const Filter& filter) {
        if constexpr (shadow_scene::go_together<Light, Filter>) {
            const umbrage::shadow s(light, glm::ivec2(map_size), filter);
            const std::string full = name + ", " + filter_name;
            job whole{"whole shadow, " + full, {bound(s, reading::texels)}, true};
            if (!umbrage::detail::contact_hardening<Filter>) whole.shaders.push_back(bound(s, reading::comparisons));
            if constexpr (!umbrage::has_bent_lines<typename umbrage::setup_for<Light>::type>)
                if (glsl::linear_form_of(filter).what) whole.shaders.push_back(bound(s, reading::linear_comparisons));
            if (glsl::detail::calls(*filter.snippet, glsl::hook::lit_2x2, glsl::hook::lit_2x2))
                whole.shaders.push_back(bound(s, reading::gathers));
            for (auto [i, last] = theirs.equal_range(full); i != last; ++i) whole.shaders.push_back(i->second);
            all.push_back(std::move(whole));
        }
    };
    add_filter("hard", umbrage::filters::hard{});
    add_filter("pcf_2x2", umbrage::filters::pcf_2x2{});
    add_filter("tent<3>", umbrage::filters::tent<3>);
    add_filter("castano<5>", umbrage::filters::castano<5>);
    add_filter("disc 16", umbrage::filters::disc{16});
    add_filter("pcss<16>", shadow_scene::sized(umbrage::filters::pcss{}));
}

}  // namespace

std::vector<job> whole(const std::string& folder) {
    constexpr umbrage::clip_space clip = umbrage::vulkan_clip_space;
    const whole_shaders theirs = engines(folder);
    std::vector<job> all;
    add("spot light", shadow_scene::spot(clip), 256, theirs, all);
    add("directional light", shadow_scene::fitted(clip), 256, theirs, all);
    add("four cascades", shadow_scene::cascades<4>(clip), 256, theirs, all);
    add("four warped cascades", shadow_scene::warped<4>(clip), 256, theirs, all);
    add("pages", shadow_scene::pages(clip), 80, theirs, all);
    add("cube", shadow_scene::bulb(clip), 256, theirs, all);
    add("tetrahedron", shadow_scene::tetrahedron(clip), 512, theirs, all);
    add("paraboloids", shadow_scene::paraboloids(clip), 512, theirs, all);
    return all;
}

}  // namespace bench
