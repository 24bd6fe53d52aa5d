// SPDX-License-Identifier: MIT
//
// The module of WebAssembly behind umbrage/values: numbers in, a block and matrices out.
#include <vector>

#include "values.hpp"

extern "C" {

__attribute__((import_module("umbrage"), import_name("fail"))) void umbrage_fail(const char* message);

static package::asked input;
static std::vector<package::seen_point> seen;
static std::vector<float> output;

double* umbrage_input() { return &input.hand; }
/// Memory for points that the camera sees: eight floats each.
float* umbrage_seen(int count) {
    seen.resize(static_cast<std::size_t>(count));
    return reinterpret_cast<float*>(seen.data());
}
float* umbrage_output() { return output.data(); }

/// @return   floats of the block; 16 of the matrix of each map follow it, then 20 of each map's view
static int maps = 0;
int umbrage_maps() { return maps; }
int umbrage_values(int kind, int filter, int encoding) {
    umbrage::set_error_handler(umbrage_fail);
    const package::answered all = package::values(kind, filter, encoding, input, seen);
    output = all.block;
    for (const auto* part : {&all.matrices, &all.views}) output.insert(output.end(), part->begin(), part->end());
    maps = static_cast<int>(all.views.size() / 20);
    return static_cast<int>(all.block.size());
}
}
