// SPDX-License-Identifier: MIT
//
// A module as Node's require takes it.
#pragma once

#include <regex>
#include <sstream>
#include <stdexcept>
#include <string>

namespace package {

/// The module with imports as calls and exports at the end. Each statement of import or export is one line.
inline std::string as_commonjs(const std::string& module) {
    static const std::regex import(R"(import (\* as )?(.+) from '(.+)\.mjs';)"),
        from(R"(export (\*|\* as (\w+)|\{ (.+) \}) from '(.+)\.mjs';)"),
        own(R"(export ((const|function|async function) (\w+).*))");
    std::istringstream lines(module);
    std::string out, exported;
    for (std::string line; std::getline(lines, line); out += '\n') {
        std::smatch m;
        if (!line.starts_with("import ") && !line.starts_with("export ")) out += line;
        else if (std::regex_match(line, m, import)) out += "const " + m.str(2) + " = require('" + m.str(3) + ".cjs');";
        else if (std::regex_match(line, m, own)) {
            out += m.str(1);
            exported += "    " + m.str(3) + ",\n";
        } else if (std::regex_match(line, m, from)) {
            const std::string file = "require('" + m.str(4) + ".cjs')";
            if (m[3].matched) out += "const { " + m.str(3) + " } = " + file + ';';
            exported += m[3].matched   ? "    " + m.str(3) + ",\n"
                        : m[2].matched ? "    " + m.str(2) + ": " + file + ",\n"
                                       : "    ..." + file + ",\n";
        } else throw std::runtime_error("not understood: " + line);
    }
    return out + "\nmodule.exports = {\n" + exported + "};\n";
}

}  // namespace package
