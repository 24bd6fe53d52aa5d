// umbrage 0.1.0, MIT License: project_depth

#include <metal_stdlib>
#pragma METAL fp math_mode(safe)
#pragma METAL fp contract(off)

#ifndef UMBRAGE_HAS_PROJECT_DEPTH
#define UMBRAGE_HAS_PROJECT_DEPTH
// umbrage_project_depth: z / w; for w <= 0.0 cleared, which is 1.0, or 0.0 when reversed
inline float umbrage_project_depth(float z, float w, float cleared) {
    return w > 0.0 ? z / w : cleared;
}
#endif
