// SPDX-License-Identifier: MIT
//
// The module of WebAssembly behind umbrage/values: numbers in, a block and matrices out.
#include <algorithm>
#include <vector>

#include "values.hpp"

extern "C" {

__attribute__((import_module("umbrage"), import_name("fail"))) void umbrage_fail(const char* message);

static package::asked input;
static std::vector<package::seen_point> seen;
static float output[2048];

double* umbrage_input() { return &input.hand; }
/// Memory for points that the camera sees: eight floats each.
float* umbrage_seen(int count) {
    seen.resize(static_cast<std::size_t>(count));
    return reinterpret_cast<float*>(seen.data());
}
float* umbrage_output() { return output; }

/// @return   floats of the block; those of the matrices follow it, their number in umbrage_matrices
static int matrices = 0;
int umbrage_matrices() { return matrices; }
int umbrage_values(int kind, int filter, int encoding) {
    umbrage::set_error_handler(umbrage_fail);
    const package::answered all = package::values(kind, filter, encoding, input, seen);
    std::copy(all.matrices.begin(), all.matrices.end(), std::copy(all.block.begin(), all.block.end(), output));
    matrices = static_cast<int>(all.matrices.size());
    return static_cast<int>(all.block.size());
}
}
