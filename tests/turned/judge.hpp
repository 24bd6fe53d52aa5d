// SPDX-License-Identifier: MIT
//
// Judge of a program's shadows: rays from receivers to the light that the program gave, among the triangles that it
// drew.
#pragma once

#include <cstddef>
#include <functional>
#include <string>
#include <vector>

#include <glm/mat4x4.hpp>
#include <glm/vec3.hpp>

#include "../proof/joints/verdict.hpp"

namespace turned {

/// A light as a program gave it, by its arguments and not by what the library made of them.
struct given_light {
    proof::ray_light rays;
    bool clips = false;                             ///< casters before the near plane are left out
    std::function<bool(glm::dvec3)> promises = {};  ///< true where the light's maps must hold a receiver; may be empty
    bool surrounds = false;                         ///< it shines in all directions
};

/// What rays say of a run.
struct report {
    std::size_t shadows = 0;  ///< that were drawn and judged
    std::size_t lit = 0, dark = 0, undecided = 0;
    std::size_t wrong = 0;
    std::string first{};  ///< the first wrong receiver, in words
};
inline report seen;

/// A floor and a square above it, which the pages have too: what the judge draws where a program draws nothing.
inline const std::vector<glm::vec3> own_vertices{{-4, 0, -4}, {4, 0, -4}, {4, 0, 4}, {-4, 0, 4},
                                                 {-1, 1, -1}, {1, 1, -1}, {1, 1, 1}, {-1, 1, 1}};
inline const std::vector<glm::uvec3> own_triangles{{0, 1, 2}, {0, 2, 3}, {4, 5, 6}, {4, 6, 7}};
/// The same, tilted, around a light. Its depth grows towards some seams between maps, where a level floor's falls.
[[nodiscard]] std::vector<glm::vec3> tilted_around(glm::dvec3 light);

void add_wrong(const std::string& what);
/// Counts a value that a program computes by hand, which must be a visibility.
void add_visibility(const char* name, float value);

/// A shadow over what a program drew with it.
struct drawn_shadow {
    proof::shadow_facts facts;
    given_light light;
    glm::dvec3 origin{0};
    bool is_soft = false;  ///< visibility is neither 0 nor 1 for certain: a prefilter's
    std::function<float(glm::vec3, glm::vec3)> visibility;
    std::vector<joints::surface> surfaces{};

    void add(const std::vector<glm::vec3>& positions, const std::vector<glm::uvec3>& triangles);
    /// Judges receivers of its own choice: on all triangles, near the edges of their shadows, and at seams of maps.
    void judge_surfaces() const;
    /// Judges a receiver of the program.
    void judge(glm::vec3 point, glm::vec3 normal, float visibility) const;

private:
    struct ruling {
        joints::verdict is;
        bool is_unheld;  ///< no map has it, though the light promises one
    };
    [[nodiscard]] ruling rule(const joints::receiver& r) const;
    void count(const joints::receiver& r, float visibility) const;
};

}  // namespace turned
