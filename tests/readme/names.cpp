// SPDX-License-Identifier: MIT
#include "names.hpp"

#include <fstream>
#include <regex>
#include <set>
#include <stdexcept>

#include "headers.hpp"

namespace readme {

std::vector<std::string> wrong_names(const std::vector<page>& all, const std::filesystem::path& include,
                                     const std::filesystem::path& list) {
    std::set<std::string> listed, excepted, used;
    const std::regex word("\\w+");
    for (const page& p : all)
        if (p.path != "CHANGELOG.md" && p.path != "MUSEUM.md")
            for (std::sregex_iterator i(p.text.begin(), p.text.end(), word), end; i != end; ++i)
                listed.insert(i->str());
    std::ifstream in(list);
    for (std::string line; std::getline(in, line);)
        if (!line.empty() && !line.starts_with('#')) excepted.insert(line);
    std::vector<std::string> wrong;
    std::size_t names = 0;
    for (const auto& [place, header] : headers(include))
        for (const std::string& name : names_in(header)) {
            ++names;
            if (listed.contains(name)) continue;
            bool found = false;
            for (const std::string& each : {folder_of(place) + '/', place, name})
                if (excepted.contains(each)) used.insert(each), found = true;
            if (!found) wrong.push_back(place + ": no page has `" + name + "`: add it to one, or to " + list.string());
        }
    if (names < 500) throw std::runtime_error("few names in " + include.string());
    for (const std::string& each : excepted)
        if (!used.contains(each)) wrong.push_back(list.string() + ": excepts nothing: " + each);
    return wrong;
}

}  // namespace readme
