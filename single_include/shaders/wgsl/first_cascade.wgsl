// umbrage 0.1.0, first_cascade: first of four cascades that holds a point and its filter. Exactness: tier A.
// SPDX-License-Identifier: MIT
// Copyright (c) 2026 the umbrage authors. License text: LICENSE in the umbrage repository.

// umbrage_first_cascade: number of the first of four cascades that holds a point and its filter, its edge, and the edge
// of the next one; (4.0, 65536.0, 65536.0) for none
//   edges   umbrage_cascade_edge of each
fn umbrage_first_cascade(edges: vec4f) -> vec3f {
    var found: vec3f = select(vec3f(4.0, 65536.0, 65536.0), vec3f(3.0, edges.w, 65536.0), edges.w <= 0.0);
    found = select(found, vec3f(2.0, edges.z, edges.w), edges.z <= 0.0);
    found = select(found, vec3f(1.0, edges.y, edges.z), edges.y <= 0.0);
    return select(found, vec3f(0.0, edges.x, edges.y), edges.x <= 0.0);
}
