// SPDX-License-Identifier: MIT
//
// Forms of filters for comparison samplers that filter linearly: one fetch compares and weights four texels.
//
//     const umbrage::glsl::linear_form form = umbrage::glsl::linear_form_of(umbrage::filters::tent<3>);
//     // form.what is glsl::window_hardware<3>, form.weights are ", 1.0, 2.0"
//
// A shadow that is bound with `.linear = true` calls them (in_shader.hpp).
// See also: pcf_2x2_hardware.hpp, window_hardware.hpp, disc_hardware.hpp.
#pragma once

#include <string>

#include <umbrage/filter/pcf/disc.hpp>
#include <umbrage/filter/pcf/disc_hardware.hpp>
#include <umbrage/filter/pcf/pcf_2x2.hpp>
#include <umbrage/filter/pcf/pcf_2x2_hardware.hpp>
#include <umbrage/filter/pcf/window_hardware.hpp>
#include <umbrage/filter/pcf/windows.hpp>

namespace umbrage::glsl {

/// Form of a filter for a linear comparison sampler.
struct linear_form {
    const snippet* what = nullptr;  ///< the same filter by the sampler; none where there is no such form
    std::string weights{};          ///< numbers that its function takes after the receiver: ", 1.0, 2.0"
};

/// Form of a filter that has none.
[[nodiscard]] inline linear_form linear_form_of(const auto&) { return {}; }

[[nodiscard]] inline linear_form linear_form_of(const filters::pcf_2x2&) { return {&pcf_2x2_hardware}; }

[[nodiscard]] inline linear_form linear_form_of(const filters::disc& filter) {
    return {filter.points == 8 ? &disc_hardware<8> : filter.points == 16 ? &disc_hardware<16> : &disc_hardware<32>};
}

/// Kernels of 3, 5 and 7 weights have one, if no weight is 0.
[[nodiscard]] inline linear_form linear_form_of(const filters::window& filter) {
    const window_row& row = filter.row;
    if (row.quadratic || (row.size != 3 && row.size != 5 && row.size != 7)) return {};
    linear_form form{row.size == 3 ? &window_hardware<3> : row.size == 5 ? &window_hardware<5> : &window_hardware<7>};
    for (int i = 0; i <= row.size / 2; ++i) {
        if (!(row.weight(i) > 0.0f)) return {};
        std::string weight = std::to_string(row.weight(i));
        while (weight.back() == '0' && weight[weight.size() - 2] != '.') weight.pop_back();
        form.weights += ", " + weight;
    }
    return form;
}

}  // namespace umbrage::glsl
