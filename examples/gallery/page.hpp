// SPDX-License-Identifier: MIT
//
// One HTML page that needs nothing else: pictures within it, numbers beside them, snippets to copy below.
//
//     gallery::page page(folder);                                  // for pictures on their way into the page
//     page.section("filters", "Filters", "Each over the same edge.");
//     page.entry("pcf_2x2", "2x2 PCF", "Bilinear.", {{page.picture(image), "enlarged"}}, {{"taps", "4"}},
//                {{"pcf_2x2", {umbrage::glsl::pcf_2x2}}});
//     page.write("index.html");
//
#pragma once

#include <filesystem>
#include <map>
#include <string>
#include <string_view>
#include <vector>

#include <umbrage/core/image.hpp>
#include <umbrage/shader/glsl.hpp>

#include <png.hpp>

namespace gallery {

struct figure {
    std::string image;  ///< as page::picture or page::file give it
    std::string caption;
};

struct number {
    std::string name, value;
};

/// Text to copy.
struct code {
    std::string label;
    std::vector<umbrage::glsl::bound> snippets;
};

/// A choice of each snippet alone, after all of them together, for a map of some kind.
[[nodiscard]] std::vector<code> together_and_alone(const std::vector<umbrage::glsl::snippet>& snippets,
                                                   const umbrage::glsl::binding& map = {});

/// Text as HTML.
[[nodiscard]] std::string escaped(std::string_view text);

class page {
public:
    explicit page(std::filesystem::path folder);

    template <class Pixel>
    [[nodiscard]] std::string picture(const umbrage::image<Pixel>& pixels) {
        example::write_png(folder_ / "picture.png", pixels.view());
        return file(folder_ / "picture.png");
    }
    /// A PNG file, byte for byte.
    [[nodiscard]] static std::string file(const std::filesystem::path& png);

    void section(std::string_view id, std::string_view title, std::string_view text);
    void entry(std::string_view id, std::string_view title, std::string_view text, const std::vector<figure>& figures,
               const std::vector<number>& numbers, const std::vector<code>& codes);
    /// @param made   machine and settings, at the page's end
    void write(const std::filesystem::path& to, std::string_view made) const;

private:
    int number_of(const code& c);

    std::filesystem::path folder_;
    std::string sections_, links_, body_, texts_;
    std::map<std::string, int> numbers_;  ///< numbers of the texts. The page has each text once
    bool open_ = false;
};

}  // namespace gallery
