// SPDX-License-Identifier: MIT
//
// Results of every setup function for input at its limits: an error that names the argument, or a light that holds all
// that it should.
#include <doctest/doctest.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <numbers>
#include <random>
#include <string>
#include <vector>

#include <glm/geometric.hpp>
#include <glm/matrix.hpp>

#include <umbrage/light/texture_matrix.hpp>

#include "../bodies.hpp"
#include "../clip_spaces.hpp"
#include "../setups.hpp"

using namespace setup_functions;

namespace {

/// In every convention: functions that complain of one of the arguments, each of which is followed by what it must be.
template <class T, class Change>
void refused(const std::vector<std::string>& names, const std::vector<std::string>& arguments_named, Change change) {
    for (const clip_space clip : all_clip_spaces())
        for (const std::string& name : names) {
            arguments<T> a{.clip = clip};
            change(a);
            const std::string message = complaint([&] { (void)functions<T>.at(name)(a); });
            CAPTURE(name);
            CAPTURE(message);
            bool named = false;
            for (const std::string& of : arguments_named) named |= message.find(": " + of + " ") != message.npos;
            CHECK(named);
        }
}

/// In every convention: functions that give rotations and finite matrices; then check(lights, arguments).
template <class T, class Change, class Check>
void taken(const std::vector<std::string>& names, Change change, Check check) {
    for (const clip_space clip : all_clip_spaces())
        for (const std::string& name : names) {
            arguments<T> a{.clip = clip};
            change(a);
            CAPTURE(name);
            CAPTURE(to_string(clip));
            std::vector<light_space<T>> lights;
            CHECK(complaint([&] { lights = functions<T>.at(name)(a); }) == "");
            for (const light_space<T>& light : lights) {
                CHECK(umbrage::detail::all_finite(light.projection * light.view));
                CHECK(std::abs(glm::determinant(glm::dmat3(light.view)) - 1) < 1e-5);
            }
            check(name, lights, a);
        }
}
constexpr auto anything = [](const auto&...) {};

/// Inside of a map and its depths, to float's digits.
template <class T>
bool holds(const light_space<T>& light, glm::dvec3 p) {
    const glm::dvec3 at = through(texture_matrix(light, {1, 1}), p);
    return glm::all(glm::greaterThan(at, glm::dvec3(-1e-4))) && glm::all(glm::lessThan(at, glm::dvec3(1 + 1e-4)));
}

}  // namespace

TEST_CASE_TEMPLATE("setups: directions of zero are named, an up along the direction or of zero will do", T, float,
                   double) {
    using vec = glm::vec<3, T>;
    auto directed = setups;
    for (const std::string& name : around_points) std::erase(directed, name);
    refused<T>(directed, {"direction"}, [](auto& a) { a.direction = vec(0); });
    refused<T>(of_camera, {"camera.direction", "frustum.direction"}, [](auto& a) { a.ahead = vec(0); });
    for (const vec up : {vec(T(0.3), T(-1), T(0.2)), vec(T(-3), T(10), T(-2)), vec(0)})
        taken<T>(
            setups, [&](auto& a) { a.up = up; }, anything);
    for (const vec direction : {vec(0, -1, 0), vec(0, 1, 0)})
        taken<T>(
            setups, [&](auto& a) { a.direction = a.ahead = direction, a.position = vec(0); }, anything);
}

TEST_CASE_TEMPLATE("setups: bounds that are empty are named, flat ones will do, a point's are one or the other", T,
                   float, double) {
    std::vector<std::string> bounded = of_camera;
    bounded.emplace_back("fit_spot_light");
    refused<T>(bounded, {"receivers.low", "box.low", "scene.low"},
               [](auto& a) { a.scene.low.y = a.scene.high.y + T(1); });
    taken<T>(
        bounded, [](auto& a) { a.scene.high.y = a.scene.low.y; }, anything);
    for (const std::string& name : bounded) {
        arguments<T> a;
        a.scene.low = a.scene.high = glm::vec<3, T>(a.position) + a.direction;
        std::vector<light_space<T>> lights;
        const std::string message = complaint([&] { lights = functions<T>.at(name)(a); });
        CHECK(lights.empty() == (!message.empty() || name == "fit_spot_light"));
        for (const auto& light : lights) CHECK(umbrage::detail::all_finite(light.projection * light.view));
    }
}

TEST_CASE_TEMPLATE("setups: planes out of order and opening angles from 180 degrees on are named", T, float, double) {
    auto planed = setups;
    std::erase(planed, "make_dual_paraboloid_light");  // which has a range alone
    refused<T>({"make_dual_paraboloid_light"}, {"range"}, [](auto& a) { a.z_far = T(-1); });
    std::erase(planed, "fit_spot_light");  // whose planes follow from receivers
    taken<T>(
        {"fit_spot_light"}, [](auto& a) { a.z_near = T(60); },
        [](const std::string&, const auto& lights, const auto&) { CHECK(lights.empty()); });
    for (const T z_far : {T(60), T(30), T(-1)})
        refused<T>(planed, {"z_far", "frustum.z_far", "z_near and z_far", "splits", "receivers"},
                   [&](auto& a) { a.z_near = T(60), a.z_far = z_far; });
    const T infinity = std::numeric_limits<T>::infinity(), pi = std::numbers::pi_v<T>;
    for (const T angle : {T(1.501), pi / 2, T(2), pi, infinity})
        refused<T>(of_spots, {"outer_angle_radians"}, [&](auto& a) { a.angle = angle; });
    for (const T tangent : {std::tan(T(2)), T(0), infinity})
        refused<T>(of_camera, {"camera.tan_half_x", "frustum.tan_half_x"}, [&](auto& a) { a.tangent = tangent; });
}

TEST_CASE_TEMPLATE("setups: a light inside the scene holds what of it is in its cone", T, float, double) {
    std::mt19937 random(1);
    int held = 0;
    taken<T>(
        of_spots, [](auto&) {},
        [&](const std::string&, const auto& lights, const arguments<T>& a) {
            for (int i = 0; i < 100; ++i) {
                const glm::dvec3 p =
                    glm::mix(glm::dvec3(a.scene.low), glm::dvec3(a.scene.high), bodies::random_vector(random, 0, 1));
                const glm::dvec3 way = p - glm::dvec3(a.position), axis = glm::normalize(glm::dvec3(a.direction));
                const double z = glm::dot(way, axis);
                if (z < double(a.z_near) || glm::length(way - z * axis) > z * std::tan(double(a.angle))) continue;
                CHECK(holds(lights[0], p));
                ++held;
            }
        });
    CHECK(held > 50);
    taken<T>(
        around_points, [](auto&) {}, anything);
}

TEST_CASE_TEMPLATE(
    "setups: a camera inside a caster that looks along the light, against it and anywhere: what it sees is held, and "
    "what of the scene is between that and the light",
    T, float, double) {
    std::mt19937 random(2);
    int held = 0;
    for (const T towards : {T(1), T(-1), T(0)})
        taken<T>(
            of_camera,
            [&](auto& a) {
                if (towards != T(0)) a.ahead = towards * a.direction;
            },
            [&](const std::string&, const auto& lights, const arguments<T>& a) {
                const glm::dvec3 light = glm::normalize(glm::dvec3(a.direction)), low(a.scene.low), high(a.scene.high);
                const glm::dmat4 view =
                    look_along(glm::dvec3(a.eye), glm::dvec3(a.ahead), glm::dvec3(a.up), handedness::right);
                for (int i = 0; i < 100; ++i) {
                    const glm::dvec3 p = glm::mix(low, high, bodies::random_vector(random, 0, 1));
                    const glm::dvec3 seen(view * glm::dvec4(p, 1));
                    const double z = -seen.z;
                    if (z < double(a.z_near) || std::abs(seen.x) > z * double(a.tangent) || std::abs(seen.y) > z * 0.5)
                        continue;
                    const bool far = lights.size() > 1 && z > double(a.z_near + a.z_far) / 2;
                    const light_space<T>& own = lights[far ? 1 : 0];
                    double out = 1e9;  // of the scene, towards the light
                    for (glm::length_t k = 0; k < 3; ++k)
                        out = std::min(out, ((light[k] > 0 ? low : high)[k] - p[k]) / -light[k]);
                    for (const double share : {0.0, 0.5, 1.0}) CHECK(holds(own, p - share * out * light));
                    ++held;
                }
            });
    CHECK(held > 200);
}
