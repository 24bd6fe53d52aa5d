// SPDX-License-Identifier: MIT
//
// Snippets: the GLSL versions of the C++ functions, one function each. glsl.hpp assembles shader texts from them.
//
#pragma once

#include <array>
#include <cstddef>
#include <initializer_list>
#include <span>
#include <string>
#include <string_view>

#include <umbrage/core/config.hpp>

namespace umbrage::glsl {

/// Agreement between a snippet and its C++ version, called its twin.
///   a  Bit for bit on every implementation with 32-bit floats. In any grouping either no sum rounds, or its error is
///      smaller than the margin of the floor or comparison that follows
///   b  Bit for bit where + - * round to nearest in the order written. In other orders, fused or not, within the bound
///   c  Within the bound on every implementation, or within snippet::within of C++
///
/// The bound is n 2^-23 S, measured from the result in real arithmetic. n is snippet::operations.
/// S is the formula with the magnitude of every value and a plus for every minus. A quotient a / b has S(a) S(b) / b^2.
/// A root of a has S(a) / sqrt(a). min and max have the larger S.
/// The C++ function's comment gives S where its formula does not show it.
/// If denormals are flushed, a product counts at least 2^-103 times its factors above 1.
/// If a comparison or floor decides, the bound applies to the value compared. Within it either side is allowed.
/// No bound holds where S exceeds the largest float.
enum class tier { a, b, c };

/// A GLSL dialect. `vulkan` is GLSL 450 with GL_KHR_vulkan_glsl.
enum class version { v100, v110, v120, v130, v150, v300_es, v310_es, v320_es, v330, v430, v450, v460, vulkan };

/// Dialects of GLSL that texts are written in, oldest first.
inline constexpr std::array versions{version::v100,    version::v110,    version::v120,    version::v130, version::v150,
                                     version::v300_es, version::v310_es, version::v320_es, version::v330, version::v430,
                                     version::v450,    version::v460,    version::vulkan};

/// Text of the `#version` directive, e.g. "300 es".
[[nodiscard]] constexpr std::string_view directive(version v) {
    switch (v) {
        case version::v100: return "100";
        case version::v110: return "110";
        case version::v120: return "120";
        case version::v130: return "130";
        case version::v150: return "150";
        case version::v300_es: return "300 es";
        case version::v310_es: return "310 es";
        case version::v320_es: return "320 es";
        case version::v330: return "330";
        case version::v430: return "430";
        case version::v450: return "450";
        case version::v460: return "460";
        case version::vulkan: return "450";
    }
    return "";
}

/// Part of a shader that depends on the map. The text of such a snippet is for a plain map, a 2D texture of depths.
/// For other maps bind() replaces it.
enum class hook {
    none,
    map_covers,
    cleared_depth,
    beyond_far_plane,
    within_far_plane,
    compare,
    covered,
    texel,
    texel_inside,
    fetch_depth,
    lit,
    lit_2x2,
    gather_lit,
    gather_clamped,
    gather,
    lit_filtered,
    lit_between,
    depth_at,
    chosen
};

struct snippet;

/// GLSL text of a snippet: a literal, or the function that makes it. The function runs only when the text is needed. So
/// files that include the header compile faster.
class snippet_text {
public:
    constexpr snippet_text(const char* written) : written_(written) {}
    constexpr snippet_text(std::string (*make)()) : make_(make) {}
    /// Text of one of several snippets, chosen by a number.
    constexpr snippet_text(std::string (*make)(int), int number) : make_of_(make), number_(number) {}

    [[nodiscard]] std::string str() const { return make_of_ ? make_of_(number_) : (make_ ? make_() : written_); }

private:
    const char* written_ = "";
    std::string (*make_)() = nullptr;
    std::string (*make_of_)(int) = nullptr;
    int number_ = 0;
};

/// One GLSL function (with its overloads), and its properties.
struct snippet {
    std::string_view name;       ///< name of the C++ version; the GLSL function is umbrage_<name>
    std::string_view summary{};  ///< one line
    tier exactness = tier::a;
    int operations = 0;              ///< tiers b and c: n of the bound; a division counts 2.5, a root 4.5
    float within = 0.0f;             ///< tier c without n: largest difference from C++; relative for results above 1
    bool as_written = false;         ///< `within` holds only where + - * round to nearest in the order written
    version lowest = version::v100;  ///< v100: every dialect; v300_es: 300 es and 330 upwards
    std::span<const snippet* const> needs{};  ///< snippets that this one calls, a list<>
    hook role = hook::none;
    bool scaled = false;  ///< gives depths on another scale, on which 1.0 is not the far plane
    snippet_text source;

    /// Compares names: no two snippets share one.
    friend constexpr bool operator==(const snippet& a, const snippet& b) { return a.name == b.name; }
};

/// Short form of a snippet's promise, e.g. "A", "B, n = 6", "C, within 1/128".
[[nodiscard]] inline std::string promise(const snippet& s) {
    if (s.exactness == tier::a) return "A";
    std::string text = s.exactness == tier::b ? "B, " : "C, ";
    if (s.within > 0.0f)
        text += "within 1/" + std::to_string(static_cast<int>(1.0f / s.within)) + (s.as_written ? " as written" : "");
    else text += "n = " + std::to_string(s.operations);
    return text;
}

/// The bound of tiers B and C in words, for the head of a shader text.
[[nodiscard]] inline std::string bound_in_words(const snippet& s) {
    if (s.within == 0.0f) return "within " + std::to_string(s.operations) + " x 2^-23 x S of the exact result.";
    return "within 1/" + std::to_string(static_cast<int>(1.0f / s.within)) + " of C++" +
           (s.as_written ? " as written. Reordered: no bound, but a visibility is in [0, 1]." : ".");
}

/// List of the snippets that a snippet needs.
template <const snippet*... Snippets>
inline constexpr const snippet* list[sizeof...(Snippets)]{Snippets...};

/// True when `s` compiles in dialect `v`.
[[nodiscard]] constexpr bool supports(const snippet& s, version v) {
    return s.lowest == version::v100 || v >= version::v300_es;
}

namespace detail {

struct constant {
    char key;  ///< `$key` in the text
    int value;
    std::string_view text{};  ///< text to insert instead of the value, even if it is ""
};

/// Appends `text` with each `$key` replaced by the decimal digits of its value, or its text.
template <class Text>
constexpr void append(Text& out, std::string_view text, std::initializer_list<constant> constants) {
    for (std::size_t i = 0; i < text.size(); ++i) {
        if (text[i] != '$') {
            out.push_back(text[i]);
            continue;
        }
        ++i;
        for (const constant& c : constants) {
            if (c.key != text[i]) continue;
            for (char letter : c.text) out.push_back(letter);
            if (c.text.data() != nullptr) continue;
            if (c.value < 0) out.push_back('-');
            const int digits = c.value < 0 ? -c.value : c.value;
            int unit = 1;
            while (digits / unit >= 10) unit *= 10;
            for (; unit > 0; unit /= 10) out.push_back(static_cast<char>('0' + digits / unit % 10));
        }
    }
}

/// Text of one member of a family of snippets.
[[nodiscard]] inline std::string filled(std::string_view text, std::initializer_list<constant> constants) {
    std::string out;
    append(out, text, constants);
    return out;
}

/// Name of one member of a family of snippets, at compile time.
struct short_name {
    char data[24]{};
    std::size_t size = 0;

    constexpr short_name(std::string_view text, std::initializer_list<constant> constants) {
        append(*this, text, constants);
    }
    constexpr void push_back(char letter) { data[size++] = letter; }
    [[nodiscard]] constexpr std::string_view view() const { return {data, size}; }
};

}  // namespace detail
}  // namespace umbrage::glsl
