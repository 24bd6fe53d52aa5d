// SPDX-License-Identifier: MIT
//
// From a world position to its visibility in the arithmetic that graphics processors may have: which receivers change
// against C++, and how near these lie to a border between texels or to a stored depth.
#include <fstream>
#include <iostream>
#include <stdexcept>
#include <string_view>

#include "arithmetic/vectors.hpp"
#include "end_to_end/change.hpp"
#include "end_to_end/from_world.hpp"

namespace parity::arithmetic {
namespace {

constexpr const char* usage = R"(From world positions to visibility in the arithmetic that graphics processors may have.

    end_to_end [--lights N] [--receivers N] [--in ARITHMETIC] [--out FOLDER] [--share S]

  --lights      of each kind, 16
  --receivers   of each light and filter, 256
  --in          one arithmetic; without it each, then all together
  --out         where end_to_end.md goes
  --share       of the bounds that changed receivers must lie within; a fault, where below 1

Exit status: 0 changed receivers lie within their bounds, 1 one does not, 2 called wrongly. Without --in it is 1 too
where moved receivers do not change.
)";

struct options {
    std::size_t lights = 16, receivers = 256;
    std::string in, out;
    double share = 1.0;
};

options parse(int argc, char** argv) {
    options o;
    for (int i = 1; i < argc; i += 2) {
        const std::string name = argv[i];
        if (i + 1 >= argc) throw std::invalid_argument(name + " needs a value, see --help");
        const std::string value = argv[i + 1];
        if (name == "--lights") o.lights = std::stoull(value);
        else if (name == "--receivers") o.receivers = std::stoull(value);
        else if (name == "--in") o.in = value;
        else if (name == "--out") o.out = value;
        else if (name == "--share") o.share = std::stod(value);
        else throw std::invalid_argument("unknown option " + name + ", see --help");
    }
    return o;
}

const entry& entry_of(ray_kind kind, const filter_steps& filter) {
    for (const entry& e : entries())
        if (e.variant == from_world(kind, filter.name)) return e;
    throw std::logic_error("no entry goes " + from_world(kind, filter.name));
}

/// Positions of receivers: anywhere on triangles, or moved to a change of a filter's result.
enum class place { anywhere, border, depth };

/// One light's receivers as inputs of an entry, and where each lies.
struct receivers {
    job inputs;
    std::vector<ray_light::receiver> at;
    std::vector<bool> told;

    receivers(const entry& e, const ray_light& light, const filter_steps& filter, place where, std::size_t count,
              std::uint64_t seed) {
        inputs.what = &e;
        inputs.map = &light.map();
        inputs.count = count;
        for (std::size_t k = 0; k < max_inputs; ++k)
            if (e.uses(static_cast<int>(k))) inputs.x[k].resize(count);
        for (std::size_t i = 0; i < count; ++i) {
            random r((seed << 32) + i);
            at.push_back(light.draw(r));
            if (where == place::border) light.move_to_border(at.back(), filter.steps);
            told.push_back(where != place::depth && light.is_told(at.back(), filter.reach));
            sample s;
            s.map = light.map().view();
            light.fill(at.back(), filter.reach, s);
            if (where == place::depth) light.move_to_depth(s, e.twin(s));
            for (std::size_t k = 0; k < max_inputs; ++k)
                if (!inputs.x[k].empty()) inputs.x[k][i] = s.x[k];
        }
    }
};

/// World positions as a rasterizer may interpolate them; with each operation rounded to either neighbor.
struct interpolation {
    const char* name;
    vector<3> (*of)(const std::array<vector<3>, 3>& corner, number u, number v);
};
constexpr interpolation interpolations[]{
    {"world interpolated as a + u (b - a) + v (c - a)",
     [](const std::array<vector<3>, 3>& k, number u, number v) {
         return k[0] + (k[1] - k[0]) * u + (k[2] - k[0]) * v;
     }},
    {"world interpolated as (1 - u - v) a + u b + v c",
     [](const std::array<vector<3>, 3>& k, number u, number v) {
         return k[0] * (number(1.0f) - u - v) + k[1] * u + k[2] * v;
     }},
};

job interpolated(const receivers& of, const ray_light& light, const interpolation& by) {
    job j = of.inputs;
    for (std::size_t i = 0; i < j.count; ++i) {
        begin({.rounding = rules::either}, i);
        std::array<vector<3>, 3> corner;
        for (std::size_t k = 0; k < 3; ++k) {
            const vec3 at = light.corners_of(of.at[i])[k];
            corner[k] = {given(at.x), given(at.y), given(at.z)};
        }
        const vector<3> world = by.of(corner, given(of.at[i].share.x), given(of.at[i].share.y));
        for (int c = 0; c < 3; ++c) j.x[0][i][c] = world[c].value();
    }
    return j;
}

/// A table's row.
struct trial {
    std::string name;
    rules by{};
    place where = place::anywhere;
    const interpolation* of_world = nullptr;  ///< nothing is promised then
};

std::vector<trial> trials(const std::string& in) {
    std::vector<trial> all;
    for (const setting& s : arithmetics)
        if (in.empty() || in == s.name) all.push_back({s.name, s.by});
    if (all.empty()) throw std::invalid_argument("no arithmetic is called " + in);
    const trial last = all.back();
    all.push_back({last.name + ", receivers moved to a border", last.by, place::border});
    all.push_back({last.name + ", receivers moved to a stored depth", last.by, place::depth});
    for (const interpolation& by : interpolations) all.push_back({by.name, {}, place::anywhere, &by});
    return all;
}

/// Results of each filter and trial, and of each filter and light in the last arithmetic.
struct results {
    std::vector<trial> rows;
    std::array<std::vector<changes>, std::size(filters_from_world)> of{};
    std::array<std::array<changes, std::size(ray_kinds)>, std::size(filters_from_world)> by_light{};
    std::size_t last = 0;  ///< trial that by_light has

    explicit results(const std::string& in) : rows(trials(in)) {
        for (auto& all : of) all.resize(rows.size());
        while (rows[last + 1].where == place::anywhere) ++last;
    }
};

void run_light(ray_kind kind, const ray_light& light, std::uint64_t seed, std::size_t count, double share,
               results& all) {
    for (std::size_t f = 0; f < std::size(filters_from_world); ++f) {
        const filter_steps& filter = filters_from_world[f];
        const entry& e = entry_of(kind, filter);
        std::vector<receivers> at;
        for (const place where : {place::anywhere, place::border, place::depth})
            at.emplace_back(e, light, filter, where, count, seed);
        for (std::size_t t = 0; t < all.rows.size(); ++t) {
            const trial& row = all.rows[t];
            const receivers& those = at[static_cast<std::size_t>(row.where)];
            const job inputs = row.of_world ? interpolated(those, light, *row.of_world) : those.inputs;
            const caller run(inputs);
            changes some;
            for (std::size_t i = 0; i < count; ++i)
                some.add(run(i, row.by, (seed << 32) + i), e.twin(those.inputs.at(i)), filter, light.map(),
                         those.told[i], row.of_world ? 0.0 : share);
            all.of[f][t].add(some);
            if (t == all.last) all.by_light[f][static_cast<std::size_t>(kind)].add(some);
        }
    }
}

void write_tables(const results& all, const options& o, std::ostream& out) {
    out << o.lights << " lights of each kind, " << o.receivers << " receivers of each.\n";
    for (std::size_t f = 0; f < std::size(filters_from_world); ++f) {
        const filter_steps& filter = filters_from_world[f];
        out << "\n`" << filter.name << "`, whose result changes at multiples of 1/" << filter.steps << " texel:\n\n";
        write_head("arithmetic", out);
        for (std::size_t t = 0; t < all.rows.size(); ++t)
            write_row(all.rows[t].name, all.of[f][t], !all.rows[t].of_world, out);
    }
    out << '\n' << all.rows[all.last].name << ", by light:\n\n";
    write_head("light, filter", out);
    for (const ray_kind kind : ray_kinds)
        for (std::size_t f = 0; f < std::size(filters_from_world); ++f)
            write_row(std::string(name(kind)) + ", " + std::string(filters_from_world[f].name),
                      all.by_light[f][static_cast<std::size_t>(kind)], true, out);
}

int run(int argc, char** argv) {
    if (argc == 2 && std::string_view(argv[1]) == "--help") {
        std::cout << usage;
        return 0;
    }
    const options o = parse(argc, argv);
    results all(o.in);
    for (const ray_kind kind : ray_kinds) {
        const std::vector<ray_light> lights = ray_lights(kind, o.lights);
        for (std::size_t n = 0; n < lights.size(); ++n) run_light(kind, lights[n], n, o.receivers, o.share, all);
    }
    write_tables(all, o, std::cout);
    if (!o.out.empty()) {
        std::ofstream page(o.out + "/end_to_end.md");
        write_tables(all, o, page);
        if (!page) throw std::runtime_error("cannot write " + o.out + "/end_to_end.md");
    }
    changes sum;
    int unchanged = 0;  // filters that change none of the receivers that were moved for it
    for (const auto& rows : all.of)
        for (std::size_t t = 0; t < rows.size(); ++t) {
            const trial& row = all.rows[t];
            if (!row.of_world) sum.add(rows[t]);
            const cause& moved_to = row.where == place::border ? rows[t].border : rows[t].tie;
            if (row.where != place::anywhere && o.in.empty()) unchanged += moved_to.changed == 0;
        }
    std::cout << '\n'
              << sum.receivers << " receivers, " << sum.changed() << " changed, " << sum.outside
              << " farther than its bound from what changes it\n"
              << sum.example;
    return sum.outside > 0 || unchanged > 0 ? 1 : 0;
}

}  // namespace
}  // namespace parity::arithmetic

int main(int argc, char** argv) try {
    return parity::arithmetic::run(argc, argv);
} catch (const std::exception& error) {
    std::cerr << "end_to_end: " << error.what() << '\n';
    return 2;
}
