// SPDX-License-Identifier: MIT
//
// Names that platform headers define as macros: windows.h the first seven, X11 the rest.
#pragma once

#define near
#define far
#define small char
#define interface struct
#define IN
#define OUT
#undef min
#define min(a, b) ((a) < (b) ? (a) : (b))
#undef max
#define max(a, b) ((a) < (b) ? (b) : (a))

#define None 0L
#define Always 2
#define Success 0
#define Status int
#define Bool int
