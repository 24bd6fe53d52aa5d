// SPDX-License-Identifier: MIT
//
// What drive.mjs wants drawn, a line each: a name, then words or numbers.
#pragma once

#include <fstream>
#include <map>
#include <sstream>
#include <stdexcept>
#include <string>
#include <vector>

#include <glm/mat4x4.hpp>
#include <glm/vec3.hpp>

namespace paths {

class job {
public:
    explicit job(const std::string& file) {
        std::ifstream in(file);
        if (!in) throw std::runtime_error("cannot read " + file);
        for (std::string line, name; std::getline(in, line);) {
            std::istringstream words(line);
            words >> name;
            std::getline(words >> std::ws, lines_[name]);
        }
    }
    [[nodiscard]] const std::string& text(const std::string& name) const {
        const auto found = lines_.find(name);
        if (found == lines_.end()) throw std::runtime_error("the job has no " + name);
        return found->second;
    }
    [[nodiscard]] std::vector<double> numbers(const std::string& name) const {
        std::istringstream in(text(name));
        std::vector<double> all;
        for (double n = 0; in >> n;) all.push_back(n);
        return all;
    }
    [[nodiscard]] double number(const std::string& name) const { return numbers(name).at(0); }
    [[nodiscard]] glm::dvec3 point(const std::string& name) const {
        const auto n = numbers(name);
        return {n.at(0), n.at(1), n.at(2)};
    }
    [[nodiscard]] glm::dmat4 matrix(const std::string& name) const {
        const auto n = numbers(name);
        glm::dmat4 m(0);
        for (int i = 0; i < 16; ++i) m[i / 4][i % 4] = n.at(std::size_t(i));
        return m;
    }
    /// Position and normal of each vertex.
    [[nodiscard]] std::vector<glm::vec3> vertices(const std::string& name) const {
        std::ifstream in(text(name), std::ios::binary | std::ios::ate);
        std::vector<glm::vec3> all(static_cast<std::size_t>(in.tellg()) / sizeof(glm::vec3));
        in.seekg(0).read(reinterpret_cast<char*>(all.data()), std::streamsize(all.size() * sizeof all[0]));
        if (!in || all.empty()) throw std::runtime_error("cannot read " + text(name));
        return all;
    }

private:
    std::map<std::string, std::string> lines_;
};

}  // namespace paths
