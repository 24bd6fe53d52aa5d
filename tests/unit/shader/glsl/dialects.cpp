// SPDX-License-Identifier: MIT
//
// Texts for one version of GLSL.
#include <doctest/doctest.h>

#include <set>
#include <sstream>
#include <string>
#include <vector>

#include <umbrage/registry.hpp>
#include <umbrage/shader/glsl.hpp>

#include "../parts_of_text.hpp"

using namespace umbrage::glsl;

TEST_CASE("text for a dialect: what __VERSION__ and GL_ES decide is decided") {
    const std::string forked = "a\n#if __VERSION__ >= 130\nb\n#ifdef A\nc\n#else\nd\n#endif\n#else\ne\n#endif\nf\n";
    CHECK(umbrage::glsl::detail::resolved(forked, 120) == "a\ne\nf\n");
    CHECK(umbrage::glsl::detail::resolved(forked, 130) == "a\nb\n#ifdef A\nc\n#else\nd\n#endif\nf\n");
    const auto prelude_in = [](version v) {
        const std::string all = text({umbrage::glsl::saturate}, v);
        return all.substr(all.find("#ifndef"), all.find("\n\n#ifndef UMBRAGE_HAS") - all.find("#ifndef"));
    };
    const auto of = [](const char* highp, const char* precise) {
        return std::string("#ifndef UMBRAGE_HIGHP\n#define UMBRAGE_HIGHP") + highp +
               "\n#endif\n#ifndef UMBRAGE_PRECISE\n#define UMBRAGE_PRECISE" + precise + "\n#endif";
    };
    CHECK(prelude_in(version::v330) == of("", ""));
    CHECK(prelude_in(version::v430) == of("", " precise"));
    CHECK(prelude_in(version::vulkan) == of("", " precise"));
    CHECK(prelude_in(version::v100) == of(" highp", ""));
    CHECK(prelude_in(version::v310_es) == of(" highp", ""));
    CHECK(prelude_in(version::v320_es) == of(" highp", " precise"));
    CHECK(count(text({umbrage::glsl::texel}, version::v120), "texelFetch") == 0);
    CHECK(count(text({umbrage::glsl::texel}, version::v300_es), "texture2D") == 0);
}

TEST_CASE("text for a dialect: its bound, and precise where the dialect has it, else that sums may be reordered") {
    for (const snippet* s : registry()) {
        CAPTURE(s->name);
        CHECK(second_line_on(text({*s})).starts_with(bounds_note(*s, "GLSL below 400 and 320 es") + "\n#ifndef"));
        for (const version v : versions) {
            if (!supports(*s, v)) continue;
            CAPTURE(directive(v));
            const std::string out = text({*s}, v);
            const bool has_precise = v == version::v320_es || v >= version::v430;
            CHECK((out.find("\n#define UMBRAGE_PRECISE precise\n") != out.npos) == has_precise);
            const std::string note = bounds_note(*s, has_precise ? "" : "GLSL " + std::string(directive(v)));
            CHECK(second_line_on(out).starts_with(note + "\n#ifndef"));
            CHECK(count(out, "UMBRAGE_PRECISE ") >= qualified(s->source.str(), "UMBRAGE_PRECISE ").size());
        }
    }
}

// Engines have preprocessors of their own. PlayCanvas takes every comparison with an unknown name for true; Babylon.js
// looks for a macro with parameters under a name with its bracket, and parts lines at each semicolon, comments too.
TEST_CASE("text for a dialect: directives that preprocessors of engines know") {
    std::vector<std::vector<bound>> texts{{umbrage::glsl::hard, umbrage::glsl::level_rg<11>}};
    for (const snippet* s : registry()) texts.push_back({*s});
    for (const texture kind :
         {texture::texture_2d, texture::array, texture::cube, texture::cube_faces, texture::shadow})
        texts.push_back({bind(umbrage::glsl::pcf_2x2, "a", {.texture = kind})});
    for (const auto& items : texts)
        for (const version v : {version::v100, version::v300_es, version::v450}) {
            if (!supports(items.front(), v)) continue;
            CAPTURE(items.front().what.name);
            std::istringstream lines(text(items, v));
            std::set<std::string> defined;
            for (std::string line; std::getline(lines, line);) {
                CAPTURE(line);
                CHECK(line.find("__VERSION__") == line.npos);
                CHECK(line.find("GL_ES") == line.npos);
                const auto comment = line.find("//"), code = line.find_first_not_of(' ');
                if (comment != line.npos && comment != code) CHECK(line.find(';', comment) == line.npos);
                if (!line.starts_with('#')) continue;
                const std::string directive = line.substr(0, line.find(' '));
                const bool known = directive == "#ifdef" || directive == "#ifndef" || directive == "#else" ||
                                   directive == "#endif" || directive == "#define";
                CHECK(known);
                const auto name = line.find(' ') + 1, bracket = line.find('(');
                if (directive == "#define" && bracket < line.find(' ', name))
                    CHECK((defined.insert(line).second || line.find("UMBRAGE_HAS") != line.npos));
                if (directive != "#ifndef") continue;
                for (const std::string& other : defined)  // else the two branches of one #ifdef
                    CHECK(other.find(" " + line.substr(8) + "(") == other.npos);
            }
        }
}
