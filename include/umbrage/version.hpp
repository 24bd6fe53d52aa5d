// SPDX-License-Identifier: MIT
//
// The version of umbrage. CMake reads it from here.
#pragma once

#define UMBRAGE_VERSION_MAJOR 0
#define UMBRAGE_VERSION_MINOR 1
#define UMBRAGE_VERSION_PATCH 0
