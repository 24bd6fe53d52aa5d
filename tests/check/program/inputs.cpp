// SPDX-License-Identifier: MIT
#include "inputs.hpp"

#include <algorithm>
#include <cctype>
#include <string_view>

namespace check {
namespace {

bool is_word(char c) { return std::isalnum(static_cast<unsigned char>(c)) || c == '_'; }

bool is_space(char c) { return std::isspace(static_cast<unsigned char>(c)); }

/// Where a comment or a preprocessor's line that begins here ends; here, if none does.
std::size_t past_comment(std::string_view text, std::size_t at) {
    const auto past = [&](std::string_view end) {
        const std::size_t found = text.find(end, at + 1);
        return found == text.npos ? text.size() : found + end.size();
    };
    const std::string_view rest = text.substr(at);
    return rest.starts_with("/*") ? past("*/") : rest.starts_with("//") || rest.starts_with("#") ? past("\n") : at;
}

}  // namespace

std::string with_uniform_inputs(const std::string& text) {
    std::string all;
    std::size_t kept = 0, begin = 0;  // what is copied, and where the present declaration begins
    int depth = 0;
    for (std::size_t at = 0; at < text.size();) {
        if (const std::size_t end = past_comment(text, at); end > at) {
            if (std::all_of(text.begin() + long(begin), text.begin() + long(at), is_space)) begin = end;
            at = end;
            continue;
        }
        const char c = text[at];
        depth += c == '(' || c == '{' ? 1 : c == ')' || c == '}' ? -1 : 0;
        if (depth == 0 && (c == ';' || c == '}')) begin = at + 1;
        std::size_t end = at;
        while (end < text.size() && is_word(text[end])) ++end;
        if (depth == 0 && text.substr(at, end - at) == "in") {
            // before it stand qualifiers that no uniform has: layout, flat, centroid
            all.append(text, kept, begin - kept);
            all.append(std::size_t(std::count(text.begin() + long(begin), text.begin() + long(at), '\n')), '\n');
            all += "uniform";
            kept = end;
        }
        at = (std::max)(end, at + 1);
    }
    return all.append(text, kept);
}

}  // namespace check
