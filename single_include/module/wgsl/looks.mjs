import * as snippets from './snippets.mjs';

export const looks = {
    "": {
        needs: filter => [snippets.acne_free_bias, snippets.biased, filter],
        text: `
// umbrage_look: visibility of a receiver in one map
fn umbrage_look(UMBRAGE_MAP map, terms: vec4f, filter_terms: vec4f, at: vec3f, slope: vec2f) -> f32 {
    let bias: f32 = umbrage_acne_free_bias(slope, terms.z, terms.w);
    let receiver: f32 = umbrage_biased(at.z, bias);
    return umbrage_FILTER(map, vec2f(terms.x, terms.y), vec2f(at.x, at.y), receiver);
}
`,
    },
    "radius": {
        needs: filter => [snippets.acne_free_bias, snippets.biased, filter],
        text: `
// umbrage_look: visibility of a receiver in one map
fn umbrage_look(UMBRAGE_MAP map, terms: vec4f, filter_terms: vec4f, at: vec3f, slope: vec2f) -> f32 {
    let bias: f32 = umbrage_acne_free_bias(slope, terms.z, terms.w);
    let receiver: f32 = umbrage_biased(at.z, bias);
    return umbrage_FILTER(map, vec2f(terms.x, terms.y), vec2f(at.x, at.y), receiver, i32(filter_terms.x));
}
`,
    },
    "radius, rotation": {
        needs: filter => [snippets.acne_free_disc_bias, snippets.biased, filter, snippets.disc_rotation],
        text: `
// umbrage_look: visibility of a receiver in one map
fn umbrage_look(UMBRAGE_MAP map, terms: vec4f, filter_terms: vec4f, at: vec3f, slope: vec2f, pixel: vec2f) -> f32 {
    let bias: f32 = umbrage_acne_free_disc_bias(slope, filter_terms.y, terms.w);
    let receiver: f32 = umbrage_biased(at.z, bias);
    return umbrage_FILTER(map, vec2f(terms.x, terms.y), vec2f(at.x, at.y), receiver, filter_terms.x,
                          umbrage_disc_rotation(pixel));
}
`,
    },
    "softness, rotation": {
        needs: filter => [snippets.acne_free_bias, snippets.biased, filter, snippets.disc_rotation],
        text: `
// umbrage_look: visibility of a receiver in one map
fn umbrage_look(UMBRAGE_MAP map, terms: vec4f, filter_terms: vec4f, at: vec3f, slope: vec2f, pixel: vec2f) -> f32 {
    let receiver_slope: vec2f = slope;
    let receiver_coord: vec2f = vec2f(at.x, at.y);
    let bias: f32 = umbrage_acne_free_bias(slope, 0.5, terms.w);
    let receiver: f32 = umbrage_biased(at.z, bias);
    return umbrage_FILTER(map, vec2f(terms.x, terms.y), vec2f(at.x, at.y), receiver,
                          vec3f(filter_terms.x, filter_terms.y, filter_terms.z), umbrage_disc_rotation(pixel));
}
`,
    },
    "min_variance": {
        needs: filter => [snippets.acne_free_bias, snippets.biased, filter],
        text: `
// umbrage_look: visibility of a receiver in one map
fn umbrage_look(UMBRAGE_MAP map, terms: vec4f, filter_terms: vec4f, at: vec3f, slope: vec2f) -> f32 {
    let bias: f32 = umbrage_acne_free_bias(slope, terms.z, terms.w);
    let receiver: f32 = umbrage_biased(at.z, bias);
    return umbrage_FILTER(map, vec2f(terms.x, terms.y), vec2f(at.x, at.y), receiver, filter_terms.x);
}
`,
    },
    "exponent": {
        needs: filter => [snippets.acne_free_bias, snippets.biased, filter],
        text: `
// umbrage_look: visibility of a receiver in one map
fn umbrage_look(UMBRAGE_MAP map, terms: vec4f, filter_terms: vec4f, at: vec3f, slope: vec2f) -> f32 {
    let bias: f32 = umbrage_acne_free_bias(slope, terms.z, terms.w);
    let receiver: f32 = umbrage_biased(at.z, bias);
    return umbrage_FILTER(map, vec2f(terms.x, terms.y), vec2f(at.x, at.y), receiver, filter_terms.x);
}
`,
    },
    "exponent, deviation": {
        needs: filter => [snippets.acne_free_bias, snippets.biased, filter],
        text: `
// umbrage_look: visibility of a receiver in one map
fn umbrage_look(UMBRAGE_MAP map, terms: vec4f, filter_terms: vec4f, at: vec3f, slope: vec2f) -> f32 {
    let bias: f32 = umbrage_acne_free_bias(slope, terms.z, terms.w);
    let receiver: f32 = umbrage_biased(at.z, bias);
    return umbrage_FILTER(map, vec2f(terms.x, terms.y), vec2f(at.x, at.y), receiver, filter_terms.x, filter_terms.y);
}
`,
    },
    "exponents, deviations": {
        needs: filter => [snippets.acne_free_bias, snippets.biased, filter],
        text: `
// umbrage_look: visibility of a receiver in one map
fn umbrage_look(UMBRAGE_MAP map, terms: vec4f, filter_terms: vec4f, at: vec3f, slope: vec2f) -> f32 {
    let bias: f32 = umbrage_acne_free_bias(slope, terms.z, terms.w);
    let receiver: f32 = umbrage_biased(at.z, bias);
    return umbrage_FILTER(map, vec2f(terms.x, terms.y), vec2f(at.x, at.y), receiver,
                         vec2f(filter_terms.x, filter_terms.y), vec2f(filter_terms.z, filter_terms.w));
}
`,
    },
    "bias": {
        needs: filter => [snippets.acne_free_bias, snippets.biased, filter],
        text: `
// umbrage_look: visibility of a receiver in one map
fn umbrage_look(UMBRAGE_MAP map, terms: vec4f, filter_terms: vec4f, at: vec3f, slope: vec2f) -> f32 {
    let bias: f32 = umbrage_acne_free_bias(slope, terms.z, terms.w);
    let receiver: f32 = umbrage_biased(at.z, bias);
    return umbrage_FILTER(map, vec2f(terms.x, terms.y), vec2f(at.x, at.y), receiver,
                       vec2f(filter_terms.x, filter_terms.y));
}
`,
    },
};
