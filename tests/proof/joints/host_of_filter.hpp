// SPDX-License-Identifier: MIT
//
// The hosts of each filter, which are compiled apart.
#pragma once

#include <memory>

#include <umbrage/depth/encodings.hpp>
#include <umbrage/filter/blocker/dpcf.hpp>
#include <umbrage/filter/blocker/pcss.hpp>
#include <umbrage/filter/pcf/box.hpp>
#include <umbrage/filter/pcf/disc.hpp>
#include <umbrage/filter/pcf/hard.hpp>
#include <umbrage/filter/pcf/pcf_2x2.hpp>
#include <umbrage/filter/pcf/windows.hpp>

#include "host.hpp"

namespace joints {

/// Encoding that a filter has besides depth32f, depth16 and rg<11>, which all of them have.
template <class Filter>
struct fourth_of;
template <>
struct fourth_of<umbrage::filters::hard> {
    using type = umbrage::float_bits;
};
template <>
struct fourth_of<umbrage::filters::pcf_2x2> {
    using type = umbrage::r16;
};
template <>
struct fourth_of<umbrage::filters::box> {
    using type = umbrage::rgb24;
};
template <>
struct fourth_of<umbrage::filters::window> {
    using type = umbrage::depth24;
};
template <>
struct fourth_of<umbrage::filters::disc> {
    using type = umbrage::rgb10;
};
template <>
struct fourth_of<umbrage::filters::pcss> {
    using type = umbrage::threejs_rgba;
};
template <>
struct fourth_of<umbrage::filters::dpcf> {
    using type = umbrage::threejs_rgb;
};
template <class Filter>
using fourth_encoding = typename fourth_of<Filter>::type;

[[nodiscard]] std::unique_ptr<any_host> host_of_filter(const choices&, const lit_scene&, glm::dvec3 origin,
                                                       const umbrage::filters::hard&);
[[nodiscard]] std::unique_ptr<any_host> host_of_filter(const choices&, const lit_scene&, glm::dvec3 origin,
                                                       const umbrage::filters::pcf_2x2&);
[[nodiscard]] std::unique_ptr<any_host> host_of_filter(const choices&, const lit_scene&, glm::dvec3 origin,
                                                       const umbrage::filters::box&);
[[nodiscard]] std::unique_ptr<any_host> host_of_filter(const choices&, const lit_scene&, glm::dvec3 origin,
                                                       const umbrage::filters::window&);
[[nodiscard]] std::unique_ptr<any_host> host_of_filter(const choices&, const lit_scene&, glm::dvec3 origin,
                                                       const umbrage::filters::disc&);
[[nodiscard]] std::unique_ptr<any_host> host_of_filter(const choices&, const lit_scene&, glm::dvec3 origin,
                                                       const umbrage::filters::pcss&);
[[nodiscard]] std::unique_ptr<any_host> host_of_filter(const choices&, const lit_scene&, glm::dvec3 origin,
                                                       const umbrage::filters::dpcf&);

}  // namespace joints
