// SPDX-License-Identifier: MIT
#include "page.hpp"

#include <algorithm>
#include <cstddef>
#include <fstream>
#include <iterator>
#include <stdexcept>
#include <utility>

#include "template.hpp"

namespace gallery {
namespace {

using namespace umbrage;

std::string contents(const std::filesystem::path& path) {
    std::ifstream in(path, std::ios::binary);
    std::string out{std::istreambuf_iterator<char>(in), {}};
    if (out.empty()) throw std::runtime_error("cannot read " + path.string());
    return out;
}

std::string base64(std::string_view bytes) {
    constexpr char digits[] = "ABCDEFGHIJKLMNOPQRSTUVWXYZabcdefghijklmnopqrstuvwxyz0123456789+/";
    std::string out;
    for (std::size_t i = 0; i < bytes.size(); i += 3) {
        const auto byte = [&](std::size_t j) { return j < bytes.size() ? static_cast<unsigned char>(bytes[j]) : 0u; };
        const unsigned three = byte(i) << 16 | byte(i + 1) << 8 | byte(i + 2);
        for (std::size_t j = 0; j < 4; ++j) out += i + j > bytes.size() ? '=' : digits[three >> (18 - 6 * j) & 63];
    }
    return out;
}

/// Width and height of a PNG, as the attributes of its <img>.
std::string extent(std::string_view png) {
    const auto number = [&](std::size_t at) {
        unsigned n = 0;
        for (std::size_t i = 0; i < 4; ++i) n = n << 8 | static_cast<unsigned char>(png.at(at + i));
        return std::to_string(n);
    };
    return "width=\"" + number(16) + "\" height=\"" + number(20) + '"';
}

std::string name_of(glsl::version v) {
    switch (v) {
        case glsl::version::v100: return "GLSL 100: ES 2, WebGL 1";
        case glsl::version::v300_es: return "GLSL 300 es: ES 3, WebGL 2";
        case glsl::version::vulkan: return "GLSL 450 for Vulkan";
        default: return "GLSL " + std::string(glsl::directive(v));
    }
}

std::string tier_of(const glsl::snippet& s) {
    switch (s.exactness) {
        case glsl::tier::a: return "Tier A: the same bits as umbrage::" + std::string(s.name) + " in C++, everywhere";
        case glsl::tier::b:
            return "Tier B: the same bits as in C++ where + - * round to nearest in written order, elsewhere " +
                   glsl::bound_in_words(s);
        case glsl::tier::c: return "Tier C: " + glsl::bound_in_words(s);
    }
    return {};
}

/// One text for every version: its conditionals are left to the compiler.
std::string text_of(const code& c) {
    std::string text = glsl::text(c.snippets);
    for (const char* end : {"</script", "<!--"})
        if (text.find(end) != std::string::npos) throw std::logic_error(c.label + " cannot stand in a page");
    return text;
}

}  // namespace

std::string escaped(std::string_view text) {
    std::string out;
    for (char c : text) switch (c) {
            case '&': out += "&amp;"; break;
            case '<': out += "&lt;"; break;
            case '"': out += "&quot;"; break;
            default: out += c;
        }
    return out;
}

std::vector<code> together_and_alone(const std::vector<glsl::snippet>& snippets, const glsl::binding& map) {
    std::vector<code> out;
    if (snippets.size() > 1) {
        code all{"all of these together", {snippets.begin(), snippets.end()}};
        if (map != glsl::binding())
            for (glsl::bound& b : all.snippets) b = bind(b.what, "", map);
        out.push_back(std::move(all));
    }
    for (const glsl::snippet& s : snippets) out.push_back({std::string(s.name), {s}});
    return out;
}

page::page(std::filesystem::path folder) : folder_(std::move(folder)) {}

std::string page::file(const std::filesystem::path& path) {
    const std::string png = contents(path);
    return "src=\"data:image/png;base64," + base64(png) + "\" " + extent(png);
}

void page::section(std::string_view id, std::string_view title, std::string_view text) {
    if (open_) body_ += "</section>\n";
    open_ = true;
    const std::string heading(title), anchor(id);
    const std::string link = "<a href=\"#" + anchor + "\"><b>" + escaped(heading) + "</b></a>\n";
    sections_ += link, links_ += "<br>" + link;
    body_ += "<section id=\"" + anchor + "\">\n<h2>" + escaped(heading) + "</h2>\n<p>" + escaped(text) + "</p>\n";
}

void page::entry(std::string_view id, std::string_view title, std::string_view text, const std::vector<figure>& figures,
                 const std::vector<number>& numbers, const std::vector<code>& codes) {
    const std::string heading = escaped(title), anchor(id);
    links_ += "<a href=\"#" + anchor + "\">" + heading + "</a>\n";
    body_ += "<article id=\"" + anchor + "\">\n<h3>" + heading + "</h3>\n<p>" + escaped(text) +
             "</p>\n<div class=\"pictures\">\n";
    for (const figure& f : figures)
        body_ += "<figure><img " + f.image + " alt=\"" + heading + ": " + escaped(f.caption) + "\"><figcaption>" +
                 escaped(f.caption) + "</figcaption></figure>\n";
    body_ += "</div>\n";
    if (!numbers.empty()) body_ += "<dl>\n";
    for (const number& n : numbers)
        body_ += "<div><dt>" + escaped(n.name) + "</dt><dd>" + escaped(n.value) + "</dd></div>\n";
    if (!numbers.empty()) body_ += "</dl>\n";
    body_ += "<div class=\"code\" data-texts=\"";
    for (std::size_t i = 0; i < codes.size(); ++i)
        body_.append(i > 0 ? " " : "").append(std::to_string(number_of(codes[i])));
    body_ += "\"></div>\n</article>\n";
}

int page::number_of(const code& c) {
    const std::string text = text_of(c);
    const auto [at, fresh] = numbers_.try_emplace(c.label + '\n' + text, static_cast<int>(numbers_.size()));
    if (fresh) {
        std::size_t lowest = 0;
        while (
            !std::ranges::all_of(c.snippets, [&](const glsl::bound& s) { return supports(s, glsl::versions[lowest]); }))
            ++lowest;
        texts_ += "<script type=\"text/plain\" id=\"text-" + std::to_string(at->second) + "\" data-label=\"" +
                  escaped(c.label) + "\" data-lowest=\"" + std::to_string(lowest) + "\" data-tier=\"" +
                  (c.snippets.size() == 1 ? escaped(tier_of(c.snippets.front().what)) : "") + "\">" + text +
                  "</script>\n";
    }
    return at->second;
}

void page::write(const std::filesystem::path& to, std::string_view made) const {
    std::ofstream out(to, std::ios::binary);
    out << head
        << "<header>\n<h1>umbrage</h1>\n<p>Shadow mapping primitives for C++ and GLSL, with their pictures. The "
           "program "
           "that wrote this page computed every picture and every number. Below them are the snippets that do the same "
           "in a shader.</p>\n</header>\n<nav>"
        << "<span class=\"sections\">" << sections_ << "</span><details><summary>All entries</summary>"
        << links_.substr(links_.find('>') + 1) << "</details></nav>\n<main>\n"
        << body_ << "</section>\n</main>\n"
        << "<footer>" << escaped(made) << "</footer>\n"
        << texts_ << box_before_dialects;
    for (std::size_t i = 0; i < glsl::versions.size(); ++i) {
        const glsl::version v = glsl::versions[i];
        const std::string directive(glsl::directive(v)), name = v == glsl::version::vulkan ? "vulkan" : directive;
        out << "<option value=\"" << name << "\" data-order=\"" << i << "\" data-directive=\"" << directive << "\">"
            << name_of(v) << "</option>\n";
    }
    out << box_after_dialects << script;
    out.flush();
    if (!out) throw std::runtime_error("cannot write " + to.string());
}

}  // namespace gallery
