// SPDX-License-Identifier: MIT
#include "session.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <sstream>

#include <choices.hpp>
#include <command_line.hpp>
#include <names.hpp>
#include <soft.hpp>

#include "stored_as.hpp"

namespace viewer {
namespace {

const example::shadow_system& system_called(std::string_view name) {
    if (name == outdoor_system.name) return outdoor_system;
    return *std::ranges::find(example::systems, name, &example::shadow_system::name);
}

/// The list's own copy of a name, which stays.
const std::string& listed(const std::vector<std::string>& names, std::string_view name) {
    return *std::ranges::find(names, name);
}

/// The name after this one; after the last the first.
const std::string& after(const std::vector<std::string>& names, std::string_view name) {
    const auto next = std::ranges::find(names, name) + 1;
    return next == names.end() ? names.front() : *next;
}

/// A scene outdoors, and how it is usually seen.
struct ground {
    std::string_view name;
    example::scene (*make)();
    float elevation, distance, fov;
};
constexpr std::array grounds{ground{"outdoor", example::outdoor_scene, 4, 64, 50},
                             ground{"plain", example::plain_scene, 1, 100, 60},
                             ground{"solids", example::solids_scene, 25, 7.5f, 35}};
const ground& ground_called(std::string_view name) { return *std::ranges::find(grounds, name, &ground::name); }

example::scene in_parts(example::scene s) {
    if (s.parts.empty()) s.parts = {{s.geometry, {glm::mat4(1)}}};
    return s;
}

float turned(float degrees, float by) { return std::remainder(degrees + by, 360.0f); }

bool runs_on_es2(const example::shadow_system& s) { return encoding_called(s.encoding).on_es2(); }

}  // namespace

const std::vector<std::string>& ground_names() {
    static const std::vector<std::string> names = [] {
        std::vector<std::string> all;
        for (const ground& g : grounds) all.emplace_back(g.name);
        return all;
    }();
    return names;
}

const std::vector<std::string>& filter_names() {
    static const std::vector<std::string> names = [] {
        std::vector<std::string> all = example::filter_names();
        all.insert(all.end(), example::hardening_names().begin(), example::hardening_names().end());
        all.insert(all.end(), example::prefilter_names().begin(), example::prefilter_names().end());
        return all;
    }();
    return names;
}

bool filters_layers(std::string_view filter) {
    return filter != "four_tap" && filter != "pcf_2x2_dx_sdk" && !example::hardens(filter) &&
           !example::filters_ahead(filter);
}

session::session(const options& o)
    : placement(o.placement),
      es2(o.es2),
      mask(o.mask),
      tint(o.tint),
      text(o.text),
      map(o.map),
      ground_(o.ground),
      mesh_file_(o.mesh),
      up_(o.up) {
    camera.aspect = static_cast<float>(o.width) / static_cast<float>(o.height);
    select(system_called(o.system));
    if (o.azimuth) system.azimuth = *o.azimuth;
    if (o.elevation) system.elevation = *o.elevation;
    if (o.encoding) encode(*o.encoding);
    if (o.filter) filter(*o.filter);
    if (o.radius) radius(*o.radius);
    if (o.light_size) system.light_size = *o.light_size;
    if (o.bias) bias(*o.bias);
    if (o.map_size != glm::ivec2(0)) system.map_size = o.map_size;
    if (o.epsilon) system.epsilon = *o.epsilon;
    if (o.reach) system.reach = *o.reach;
}

void session::select(const example::shadow_system& s) {
    if (es2 && !runs_on_es2(s))
        throw example::usage_error(std::string(s.name) + " needs a float map, which OpenGL ES 2 has not");
    const bool other_scene =
        scenes == 0 || s.scene_scale != system.scene_scale || outdoor() != (s.name == outdoor_system.name);
    system = s;
    bias_chosen_ = false;
    if (other_scene) {
        scene = outdoor() ? in_parts(ground_called(ground_).make()) : example::make_scene(system, mesh_file_, up_);
        ++scenes;
    }
    camera = usual_camera();
}

example::camera_setup session::usual_camera() const {
    if (!outdoor()) return example::make_camera_setup(system, scene, camera.aspect);
    const ground& g = ground_called(ground_);
    return {.target = scene.target,
            .azimuth = 0,
            .elevation = g.elevation,
            .distance = g.distance,
            .fov = g.fov,
            .aspect = camera.aspect,
            .z_near = scene.z_near,
            .z_far = scene.z_far};
}

void session::encode(std::string_view name) {
    if (es2 && !encoding_called(name).on_es2())
        throw example::usage_error("OpenGL ES 2 cannot do the encoding " + std::string(name));
    system.encoding = listed(example::encoding_names(), name);
    settle_receiver();
}

/// An original's own receivers go with its own encoding, and with depths that stay as they are stored.
void session::settle_receiver() {
    const example::shadow_system& original = system_called(system.name);
    const bool own = system.encoding == original.encoding && !example::compares_along_plane(system.bias) &&
                     !example::hardens(system.filter) && !example::filters_ahead(system.filter);
    system.receiver = own ? original.receiver : example::receiver_kind::plain;
}

void session::filter(std::string_view name) {
    if (es2 && example::filters_ahead(name))
        throw example::usage_error("OpenGL ES 2 has no float maps for the filter " + std::string(name));
    system.filter = listed(filter_names(), name);
    const example::shadow_system& original = system_called(system.name);
    if (!bias_chosen_) system.bias = name == original.filter ? original.bias : example::usual_bias(name);
    system.reach =
        example::covered(example::soft_reach(name, system.max_radius).value_or(example::reach_of(name, system.radius)));
    settle_receiver();
}

void session::radius(float texels) {
    system.radius = std::clamp(texels, 0.0f, largest_radius);
    filter(system.filter);
}

void session::bias(std::string_view name) {
    system.bias = listed(example::bias_names(), name);
    bias_chosen_ = true;
    settle_receiver();
}

void session::next_filter() {
    std::string_view next = system.filter;
    do {
        next = after(filter_names(), next);
    } while ((outdoor() && !filters_layers(next)) || (es2 && example::filters_ahead(next)));
    filter(next);
}

void session::next_encoding() {
    std::string_view next = system.encoding;
    do { next = after(example::encoding_names(), next); } while (es2 && !encoding_called(next).on_es2());
    encode(next);
}

void session::press(int pressed) {
    constexpr float step = 3, usual_radius = 2;
    switch (pressed) {
        case '1':
        case '2':
        case '3':
        case '4': {
            const example::shadow_system& s = example::systems[static_cast<std::size_t>(pressed - '1')];
            if (!es2 || runs_on_es2(s)) select(s);
            break;
        }
        case '5':
            if (!es2) select(outdoor_system);
            break;
        case 'O': placement = after(placement_names(), placement); break;
        case 'C': tint = !tint; break;
        case 'E':
            if (!outdoor()) next_encoding();
            break;
        case 'F': next_filter(); break;
        case 'B':
            if (!outdoor()) bias(after(example::bias_names(), system.bias));
            break;
        case 'J': radius(system.radius.value_or(usual_radius) - 1); break;
        case 'K': radius(system.radius.value_or(usual_radius) + 1); break;
        case 'S': system.light_size *= 0.8f; break;
        case 'D': system.light_size = std::min(system.light_size * 1.25f, largest_light); break;
        case '+': system.epsilon *= 1.25f; break;
        case '-': system.epsilon *= 0.8f; break;
        case 'M': system.map_size = glm::min(system.map_size * 2, largest_map / 2); break;
        case 'N': system.map_size = glm::max(system.map_size / 2, smallest_map); break;
        case 'T': map = !map; break;
        case 'V': mask = !mask; break;
        case 'H': text = !text; break;
        case 'L': turning = !turning; break;
        case 'R': select(system_called(system.name)); break;
        case key::left: turn_light(-step, 0); break;
        case key::right: turn_light(step, 0); break;
        case key::up: turn_light(0, step); break;
        case key::down: turn_light(0, -step); break;
        default: break;
    }
}

void session::turn_camera(float azimuth, float elevation) {
    camera.azimuth = turned(camera.azimuth, azimuth);
    camera.elevation = std::clamp(camera.elevation + elevation, 1.0f, 90.0f);
}

void session::turn_light(float azimuth, float elevation) {
    system.azimuth = turned(system.azimuth, azimuth);
    system.elevation = std::clamp(system.elevation + elevation, lowest_light, 90.0f);
}

glm::vec3 session::lamp_position() const {
    return scene.target + 0.375f * usual_camera().distance * example::direction_at(system.azimuth, system.elevation);
}

void session::zoom(float steps) {
    const float usual = usual_camera().distance;
    camera.distance = std::clamp(camera.distance * std::pow(0.9f, steps), 0.4f * usual, 4 * usual);
}

void session::resize(glm::ivec2 size) {
    if (size.x > 0 && size.y > 0) camera.aspect = static_cast<float>(size.x) / static_cast<float>(size.y);
}

std::string session::describe() const {
    std::ostringstream out;
    out << system.title << "\nencoding " << system.encoding << ", filter " << system.filter;
    if (system.radius) out << " (radius " << *system.radius << " if any)";
    if (example::hardens(system.filter)) out << " (light " << system.light_size << " across)";
    const glm::ivec2 size = outdoor() && !cascaded() ? 2 * system.map_size : system.map_size;
    out << "\nbias " << system.bias << ", epsilon " << system.epsilon
        << (outdoor() && cascaded() ? "\n4 cascades, "
            : outdoor() && paged()  ? "\npages in "
            : outdoor() && lamp()   ? "\nas many texels as "
                                    : "\nmap ")
        << size.x << " x " << size.y << "\nlight: azimuth " << system.azimuth << ", elevation " << system.elevation
        << '\n';
    return out.str();
}

}  // namespace viewer
