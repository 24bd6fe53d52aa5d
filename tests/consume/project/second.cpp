// SPDX-License-Identifier: MIT
#include <string>

#include <umbrage/images.hpp>  // and with it umbrage.hpp, which main.cpp includes too

std::string shader() {
    return umbrage::glsl::source(umbrage::glsl::version::v330, {umbrage::glsl::to_unorm});
}
