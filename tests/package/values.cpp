// SPDX-License-Identifier: MIT
//
// The module of WebAssembly behind umbrage/values: numbers in, a block and matrices out.
#include <algorithm>

#include "values.hpp"

extern "C" {

__attribute__((import_module("umbrage"), import_name("fail"))) void umbrage_fail(const char* message);

static package::asked input;
static float output[1024];

double* umbrage_input() { return &input.hand; }
float* umbrage_output() { return output; }

/// @return   floats of the block; those of the matrices follow it, their number in umbrage_matrices
static int matrices = 0;
int umbrage_matrices() { return matrices; }
int umbrage_values(int kind, int filter, int encoding) {
    umbrage::set_error_handler(umbrage_fail);
    const package::answered all = package::values(kind, filter, encoding, input);
    std::copy(all.matrices.begin(), all.matrices.end(), std::copy(all.block.begin(), all.block.end(), output));
    matrices = static_cast<int>(all.matrices.size());
    return static_cast<int>(all.block.size());
}
}
