// SPDX-License-Identifier: MIT
//
// Writes a page's C++, or a whole program, with its numbers and enumerators taken from a table at run time:
//     write_program ID PAGE.md OUT.cpp        or: write_program ID PROGRAM.cpp OUT.cpp
// A block with a main is a function, as tests/readme has it. Other blocks of a page are one function in their order.
// With `--rebuilt` behind, OUT has a program for each field that an initializer names, without that field, and one for
// each other value of an enumerator that is a constant.
#include <algorithm>
#include <cstdio>
#include <fstream>
#include <iterator>
#include <sstream>
#include <stdexcept>
#include <string>
#include <string_view>
#include <vector>

#include "literals.hpp"

namespace {

using namespace turned;

std::string read(const char* path) {
    std::ifstream file(path);
    if (!file) throw std::runtime_error(std::string("no file ") + path);
    return {std::istreambuf_iterator<char>(file), {}};
}

/// Code of a page, and the line it begins at.
struct block {
    std::string code;
    int line;
};

std::vector<block> blocks_of(const std::string& page) {
    std::vector<block> all;
    std::istringstream lines(page);
    bool is_code = false;
    int number = 0;
    for (std::string line; std::getline(lines, line);) {
        ++number;
        if (is_code && line == "```") is_code = false;
        else if (is_code) all.back().code += line + '\n';
        else if (line == "```cpp") all.push_back({"", number + 1}), is_code = true;
    }
    return all;
}

/// Code that stands in place of other code.
struct replacement {
    std::size_t at, size;
    std::string by;
    std::size_t place_at, place_size;  ///< of what a report shows
    std::string why;
};

/// A program, with its numbers from a table, or with one replacement.
class writer {
public:
    explicit writer(bool is_turned) : is_turned_(is_turned) {}

    /// @param other   in the block; none: null
    void add(const block& b, const replacement* other = nullptr) {
        const std::vector<token> tokens = tokens_of(b.code);
        const std::vector<literal> numbers = literals_of(b.code, tokens);
        std::string text;
        bool has_main = false;
        std::size_t next = 0, copied = 0;
        const auto put = [&](const token& t, const std::string& instead) {
            text += b.code.substr(copied, t.at - copied) + instead;
            copied = t.at + t.size;
        };
        for (const token& t : tokens) {
            const std::string own = b.code.substr(t.at, t.size);
            if (t.at < copied) continue;
            if (other && t.at == other->at) put({token_kind::text, t.at, other->size}, other->by);
            else if (t.kind == token_kind::directive) {
                if (own.starts_with("#include <")) includes_ += own + '\n';
                put(t, "");
            } else if (is_turned_ && next < numbers.size() && numbers[next].at == t.at) {
                const literal& l = numbers[next++];
                put({t.kind, l.at, l.size}, turned_value(b, l));
            } else if (t.kind == token_kind::word && own == "main") {
                const std::string name = "program_" + std::to_string(programs_++);
                put(t, name), has_main = true;
                calls_ += "    " + name + "();\n";
            }
        }
        if (has_main)
            put({token_kind::sign, tokens.back().at, 1}, "return 0;\n}");  // which the last brace may leave out
        text += b.code.substr(copied);
        if (other) places_ = place_of(b, other->place_at, other->place_size, other->why, {});
        if (has_main) functions_ += text + '\n';
        else body_ += text + watched_values(b.code, tokens) + '\n';
    }

    [[nodiscard]] const std::string& includes() const { return includes_; }

    /// @param suffix   of the namespace, which is another one for each program
    [[nodiscard]] std::string program(const std::string& id, const std::string& suffix = "") const {
        std::string name = "turned_" + id + suffix;
        for (char& c : name)
            if (c == '.' || c == '-') c = '_';
        const std::string add = is_turned_ ? "::turned::add" : "::turned::add_rebuilt";
        return "\nnamespace " + name + " {\nnamespace umbrage = ::watched;\nnamespace {\n\n" + functions_ +
               "void code() {\n" + body_ + "}\n\nconst bool known = " + add + "({\"" + id + "\", {\n" + places_ +
               "}, [] {\n" + calls_ + "    code();\n}});\n\n}  // namespace\n}  // namespace " + name + "\n";
    }

private:
    static std::string place_of(const block& b, std::size_t at, std::size_t size, std::string_view why,
                                const std::vector<std::string_view>& others) {
        const std::size_t from = b.code.rfind('\n', at) + 1;  // npos + 1 is 0
        const std::string line = b.code.substr(from, b.code.find('\n', at) - from);
        std::string names;
        for (const std::string_view other : others) names += '"' + std::string(other) + "\", ";
        const auto lines = std::count(b.code.begin(), b.code.begin() + std::ptrdiff_t(at), '\n');
        return "    {" + std::to_string(b.line + lines) + ", " + std::to_string(at - from) + ", " +
               std::to_string(size) + ", \"" + std::string(why) + "\", R\"~~(" + line + ")~~\", {" + names + "}},\n";
    }
    std::string turned_value(const block& b, const literal& l) {
        places_ += place_of(b, l.at, l.size, name_of(l.why), l.others);
        const std::string own = b.code.substr(l.at, l.size), place = std::to_string(count_++);
        const std::string function = l.others.empty() ? "::turned::number(" : "::turned::enumerator(";
        return l.why == kept::no ? function + place + ", " + own + ")" : own;
    }
    /// Pages name floats `dark` and `lit`, which are visibilities.
    [[nodiscard]] static std::string watched_values(const std::string& code, std::vector<token> tokens) {
        std::erase_if(tokens, [](const token& t) { return t.kind == token_kind::text; });
        std::string calls;
        bool is_float = false;
        int depth = 0;
        const auto text = [&](std::size_t i) { return std::string_view(code).substr(tokens[i].at, tokens[i].size); };
        for (std::size_t i = 0; i + 1 < tokens.size(); ++i) {
            const std::string_view s = text(i);
            if (s == "{" || s == "(") ++depth;
            if (s == "}" || s == ")") --depth;
            if (depth == 0 && (i == 0 || text(i - 1) == ";")) is_float = s == "float";
            if (depth == 0 && is_float && (s == "dark" || s == "lit") && text(i + 1) == "=")
                calls += "::turned::add_visibility(\"" + std::string(s) + "\", " + std::string(s) + ");\n";
        }
        return calls;
    }

    std::string includes_, functions_, body_, places_, calls_;
    int programs_ = 0, count_ = 0;
    bool is_turned_;
};

/// What a build more changes in a block: each field is left out, and each constant enumerator has each other value.
std::vector<replacement> replacements_of(const std::string& code) {
    const std::vector<token> tokens = tokens_of(code);
    std::vector<replacement> all;
    for (const field& f : fields_of(code, tokens))
        all.push_back({f.at, f.size, "", f.name_at, f.name_size, "left out"});
    for (const literal& l : literals_of(code, tokens))
        for (const std::string_view other : l.others) {
            if (l.why != kept::in_constant) continue;
            const std::string own = code.substr(l.at, l.size), spaces = own.substr(0, own.rfind(':') + 1);
            all.push_back({l.at, l.size, spaces + std::string(other), l.at, l.size, std::string(other)});
        }
    return all;
}

std::string programs_rebuilt(const std::string& id, const std::vector<block>& blocks) {
    std::string all, includes;
    int count = 0;
    for (const block& changed : blocks)
        for (const replacement& r : replacements_of(changed.code)) {
            writer w(false);
            for (const block& b : blocks) w.add(b, &b == &changed ? &r : nullptr);
            includes = w.includes();
            all += w.program(id, "_rebuilt_" + std::to_string(count++));
        }
    return includes + "#include \"program.hpp\"\n" + all;
}

}  // namespace

int main(int argc, char** argv) try {
    const bool is_rebuilt = argc == 5 && std::string_view(argv[4]) == "--rebuilt";
    if (argc != 4 && !is_rebuilt) return 2;
    const std::string text = read(argv[2]), id = argv[1];
    const std::vector<block> blocks =
        std::string_view(argv[2]).ends_with(".md") ? blocks_of(text) : std::vector<block>{{text, 1}};
    std::ofstream out(argv[3]);
    out << "// SPDX-License-Identifier: MIT\n";
    if (is_rebuilt) return out << programs_rebuilt(id, blocks), 0;
    writer w(true);
    for (const block& b : blocks) w.add(b);
    out << w.includes() << "#include \"program.hpp\"\n" << w.program(id);
    return 0;
} catch (const std::exception& e) {
    std::fprintf(stderr, "write_program: %s\n", e.what());
    return 1;
}
