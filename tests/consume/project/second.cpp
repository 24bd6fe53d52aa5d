// SPDX-License-Identifier: MIT
#include <string>

#include <umbrage/umbrage.hpp>  // again, as main.cpp does

std::string shader() { return umbrage::glsl::source(umbrage::glsl::version::v330, {umbrage::glsl::to_unorm}); }
