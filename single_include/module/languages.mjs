export const version = "0.1.0";

export const glsl = {
    name: "GLSL", preprocessor: true, may_reorder: "GLSL below 400 and 320 es",
    prelude: `
#ifndef UMBRAGE_HIGHP
#ifdef GL_ES
#define UMBRAGE_HIGHP highp
#else
#define UMBRAGE_HIGHP
#endif
#endif
#ifndef UMBRAGE_PRECISE
#if (defined(GL_ES) && __VERSION__ >= 320) || (!defined(GL_ES) && __VERSION__ >= 400)
#define UMBRAGE_PRECISE precise
#else
#define UMBRAGE_PRECISE
#endif
#endif
`,
};
export const hlsl = {
    name: "HLSL", preprocessor: true, may_reorder: "",
    prelude: ``,
};
export const msl = {
    name: "MSL", preprocessor: true, may_reorder: "",
    prelude: `
#include <metal_stdlib>
#pragma METAL fp math_mode(safe)
#pragma METAL fp contract(off)
`,
};
export const wgsl = {
    name: "WGSL", preprocessor: false, may_reorder: "WGSL",
    prelude: ``,
};
