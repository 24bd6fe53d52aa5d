// SPDX-License-Identifier: MIT
//
// What is constant where GLM's vectors are aligned: GLM itself has few functions that are.
#include <umbrage/umbrage.hpp>

constexpr auto table = umbrage::make_rg_table<11, glm::u8vec4>();
static_assert(table[255].x == 255 && table[255].y == 0 && table[256].x == 0 && table[256].y == 32);
static_assert(table[2047].z == 0 && table[2047].w == 0 && sizeof(table) == 2048 * 4);
static_assert(umbrage::make_rg_table<12>()[4095].y == 240);
