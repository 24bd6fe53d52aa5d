// SPDX-License-Identifier: MIT
#include "verdict.hpp"

#include <algorithm>
#include <cmath>

#include "numbers.hpp"

namespace check {
namespace {

std::string quoted(std::string_view text) {
    std::string all = "\"";
    for (char c : text) {
        if (c == '"' || c == '\\') all += '\\';
        all += c == '\n' ? ' ' : c;
    }
    return all + '"';
}

/// JSON has no NaN and no infinity: as strings they are not lost.
std::string number(float v) { return umbrage::is_finite(v) ? exact(v) : quoted(exact(v)); }

template <class Values, class Print>
std::string listed(const Values& values, const Print& print) {
    std::string all;
    for (const auto& v : values) all += (all.empty() ? "" : ", ") + print(v);
    return '[' + all + ']';
}

std::string components(const glm::vec4& v) {
    const float all[]{v.x, v.y, v.z, v.w};
    return listed(all, number);
}

std::string pair(glm::ivec2 v) { return '[' + std::to_string(v.x) + ", " + std::to_string(v.y) + ']'; }

std::string findings(const std::vector<finding>& all) {
    return listed(
        all, [](const finding& f) { return "{\"kind\": " + quoted(f.kind) + ", \"says\": " + quoted(f.says) + '}'; });
}

/// Values up to the last that is not 0.
std::string values(const glm::vec4& v) {
    int count = 4;
    while (count > 1 && v[count - 1] == 0.0f) --count;
    std::string all;
    for (int i = 0; i < count; ++i) all += (i ? ", " : "") + exact(v[i]);
    return count > 1 ? '(' + all + ')' : all;
}

std::string described(const difference& d) {
    if (d.size.x == 0) return values(d.input);
    std::string all = std::to_string(d.size.x) + " x " + std::to_string(d.size.y) + " map";
    if (d.map.size() <= 4) {
        all += " of";
        for (float depth : d.map) all += ' ' + exact(depth);
    } else if (d.map.size() <= 256) {
        const auto odd = std::find_if(d.map.begin(), d.map.end(), [&](float v) { return v != d.map.back(); });
        const auto at = static_cast<int>(odd - d.map.begin());
        all += " of " + exact(d.map.back()) + ", but " + exact(*odd) + " at texel (" + std::to_string(at % d.size.x) +
               ", " + std::to_string(at / d.size.x) + ')';
    } else {
        all += " of random depths";
    }
    return all + ", coord (" + exact(d.input.x) + ", " + exact(d.input.y) + "), receiver " + exact(d.input.z);
}

/// The footprint as a grid of texels' weights in percent, for a coordinate in the center of its texel.
std::string picture(const footprint& f) {
    std::string all;
    for (int y = 0; y < f.size.y; y += f.steps) {
        std::string line;
        bool any = false;
        for (int x = 0; x < f.size.x; x += f.steps) {
            const float weight = f.weights[std::size_t(y * f.size.x + x)];
            char digits[16];
            const long percent = std::lround(double(weight) * 100);
            any |= percent != 0;
            std::snprintf(digits, sizeof digits, percent ? "%5ld" : "    .", percent);
            line += digits;
        }
        if (any) all += "    " + line + '\n';
    }
    return all;
}

}  // namespace

std::string_view name(agreement a) {
    constexpr std::string_view names[]{"same_bits", "same_but", "other", "unknown"};
    return names[static_cast<std::size_t>(a)];
}

std::string text(const verdict& v) {
    std::string all;
    const auto count = [&] { return std::to_string(v.inputs); };
    if (v.how == agreement::unknown) {
        all += "is none of the functions known here\n";
    } else {
        all += v.how == agreement::same_bits                   ? "is " + v.function + ": the same bits\n"
               : v.how == agreement::same_but && v.but.empty() ? "is " + v.function + '\n'
               : v.how == agreement::same_but                  ? "is " + v.function + ", but for what follows\n"
                                                               : "is " + v.function;
        if (v.how == agreement::other) {
            for (const finding& f : v.slips) all += ", " + f.says;
            all += v.function != v.expected ? "; not " + v.expected + '\n' : "\n";
        }
    }
    for (const finding& f : v.but) all += "  but: " + f.says + '\n';
    if (!v.outside.empty()) all += "  outside the map: " + v.outside + '\n';
    if (v.inputs > 0 && v.how != agreement::unknown) {
        all += "  " + std::to_string(v.same_bits) + " of " + count() + " results have the bits of " + v.expected + '\n';
        if (v.how == agreement::other) all += "  " + std::to_string(v.explained) + " are explained by the above\n";
    }
    if (v.first)
        all += "  smallest input that differs: " + described(*v.first) + "\n    yours gives " + values(v.first->got) +
               ", " + v.expected + " gives " + values(v.first->expected) + '\n';
    if (v.how == agreement::unknown && !v.seen.weights.empty())
        if (const std::string grid = picture(v.seen); !grid.empty())
            all += "  weight in percent of texels around the coordinate, up is the first row:\n" + grid;
    return all;
}

std::string json(const verdict& v) {
    std::string all = "{\"how\": " + quoted(name(v.how)) + ", \"function\": " + quoted(v.function) +
                      ", \"expected\": " + quoted(v.expected) + ", \"outside\": " + quoted(v.outside) +
                      ", \"slips\": " + findings(v.slips) + ", \"but\": " + findings(v.but) +
                      ", \"inputs\": " + std::to_string(v.inputs) + ", \"same_bits\": " + std::to_string(v.same_bits) +
                      ", \"explained\": " + std::to_string(v.explained);
    if (v.first)
        all += ", \"first\": {\"size\": " + pair(v.first->size) + ", \"map\": " + listed(v.first->map, number) +
               ", \"input\": " + components(v.first->input) + ", \"got\": " + components(v.first->got) +
               ", \"expected\": " + components(v.first->expected) + '}';
    if (!v.seen.weights.empty())
        all += ", \"seen\": {\"steps\": " + std::to_string(v.seen.steps) + ", \"first\": [" + number(v.seen.first.x) +
               ", " + number(v.seen.first.y) + "], \"size\": " + pair(v.seen.size) +
               ", \"weights\": " + listed(v.seen.weights, number) + '}';
    return all + '}';
}

}  // namespace check
