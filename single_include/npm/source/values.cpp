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

static int maps = 0, moments = 0;
int umbrage_maps() { return maps; }
/// Floats of the empty texel of a map of moments; 0 of depths.
int umbrage_moments() { return moments; }
/// @return   floats of the block; 16 of the matrix of each map follow it, then 20 of each map's view, and the moments
int umbrage_values(int kind, int filter, int encoding) {
    umbrage::set_error_handler(umbrage_fail);
    const package::answered all = package::values(kind, filter, encoding, input, seen);
    output = all.block;
    for (const auto* part : {&all.matrices, &all.views, &all.cleared})
        output.insert(output.end(), part->begin(), part->end());
    maps = static_cast<int>(all.views.size() / 20);
    moments = static_cast<int>(all.cleared.size());
    return static_cast<int>(all.block.size());
}
}
