const snippets = require('./snippets.cjs');

const looks = {
    "": {
        needs: filter => [snippets.acne_free_bias, snippets.biased, filter],
        text: `
// umbrage_look: visibility of a receiver in one map
UMBRAGE_HIGHP float umbrage_look(UMBRAGE_MAP map, UMBRAGE_HIGHP vec4 terms, UMBRAGE_HIGHP vec4 filter_terms, UMBRAGE_HIGHP vec3 at, UMBRAGE_HIGHP vec2 slope) {
    UMBRAGE_HIGHP float bias = umbrage_acne_free_bias(slope, terms.z, terms.w);
    UMBRAGE_HIGHP float receiver = umbrage_biased(at.z, bias);
    return umbrage_FILTER(map, vec2(terms.x, terms.y), vec2(at.x, at.y), receiver);
}
`,
    },
    "radius": {
        needs: filter => [snippets.acne_free_bias, snippets.biased, filter],
        text: `
// umbrage_look: visibility of a receiver in one map
UMBRAGE_HIGHP float umbrage_look(UMBRAGE_MAP map, UMBRAGE_HIGHP vec4 terms, UMBRAGE_HIGHP vec4 filter_terms, UMBRAGE_HIGHP vec3 at, UMBRAGE_HIGHP vec2 slope) {
    UMBRAGE_HIGHP float bias = umbrage_acne_free_bias(slope, terms.z, terms.w);
    UMBRAGE_HIGHP float receiver = umbrage_biased(at.z, bias);
    return umbrage_FILTER(map, vec2(terms.x, terms.y), vec2(at.x, at.y), receiver, int(filter_terms.x));
}
`,
    },
    "radius, rotation": {
        needs: filter => [snippets.acne_free_disc_bias, snippets.biased, filter, snippets.disc_rotation],
        text: `
// umbrage_look: visibility of a receiver in one map
UMBRAGE_HIGHP float umbrage_look(UMBRAGE_MAP map, UMBRAGE_HIGHP vec4 terms, UMBRAGE_HIGHP vec4 filter_terms, UMBRAGE_HIGHP vec3 at, UMBRAGE_HIGHP vec2 slope, UMBRAGE_HIGHP vec2 pixel) {
    UMBRAGE_HIGHP float bias = umbrage_acne_free_disc_bias(slope, filter_terms.y, terms.w);
    UMBRAGE_HIGHP float receiver = umbrage_biased(at.z, bias);
    return umbrage_FILTER(map, vec2(terms.x, terms.y), vec2(at.x, at.y), receiver, filter_terms.x, umbrage_disc_rotation(pixel));
}
`,
    },
    "softness, rotation": {
        needs: filter => [snippets.acne_free_bias, snippets.biased, filter, snippets.disc_rotation],
        text: `
// umbrage_look: visibility of a receiver in one map
UMBRAGE_HIGHP float umbrage_look(UMBRAGE_MAP map, UMBRAGE_HIGHP vec4 terms, UMBRAGE_HIGHP vec4 filter_terms, UMBRAGE_HIGHP vec3 at, UMBRAGE_HIGHP vec2 slope, UMBRAGE_HIGHP vec2 pixel) {
    UMBRAGE_HIGHP vec2 receiver_slope = slope;
    UMBRAGE_HIGHP vec2 receiver_coord = vec2(at.x, at.y);
    UMBRAGE_HIGHP float bias = umbrage_acne_free_bias(slope, 0.5, terms.w);
    UMBRAGE_HIGHP float receiver = umbrage_biased(at.z, bias);
    return umbrage_FILTER(map, vec2(terms.x, terms.y), vec2(at.x, at.y), receiver, vec3(filter_terms.x, filter_terms.y, filter_terms.z), umbrage_disc_rotation(pixel));
}
`,
    },
    "min_variance": {
        needs: filter => [snippets.acne_free_bias, snippets.biased, filter],
        text: `
// umbrage_look: visibility of a receiver in one map
UMBRAGE_HIGHP float umbrage_look(UMBRAGE_MAP map, UMBRAGE_HIGHP vec4 terms, UMBRAGE_HIGHP vec4 filter_terms, UMBRAGE_HIGHP vec3 at, UMBRAGE_HIGHP vec2 slope) {
    UMBRAGE_HIGHP float bias = umbrage_acne_free_bias(slope, terms.z, terms.w);
    UMBRAGE_HIGHP float receiver = umbrage_biased(at.z, bias);
    return umbrage_FILTER(map, vec2(terms.x, terms.y), vec2(at.x, at.y), receiver, filter_terms.x);
}
`,
    },
    "exponent": {
        needs: filter => [snippets.acne_free_bias, snippets.biased, filter],
        text: `
// umbrage_look: visibility of a receiver in one map
UMBRAGE_HIGHP float umbrage_look(UMBRAGE_MAP map, UMBRAGE_HIGHP vec4 terms, UMBRAGE_HIGHP vec4 filter_terms, UMBRAGE_HIGHP vec3 at, UMBRAGE_HIGHP vec2 slope) {
    UMBRAGE_HIGHP float bias = umbrage_acne_free_bias(slope, terms.z, terms.w);
    UMBRAGE_HIGHP float receiver = umbrage_biased(at.z, bias);
    return umbrage_FILTER(map, vec2(terms.x, terms.y), vec2(at.x, at.y), receiver, filter_terms.x);
}
`,
    },
    "exponent, deviation": {
        needs: filter => [snippets.acne_free_bias, snippets.biased, filter],
        text: `
// umbrage_look: visibility of a receiver in one map
UMBRAGE_HIGHP float umbrage_look(UMBRAGE_MAP map, UMBRAGE_HIGHP vec4 terms, UMBRAGE_HIGHP vec4 filter_terms, UMBRAGE_HIGHP vec3 at, UMBRAGE_HIGHP vec2 slope) {
    UMBRAGE_HIGHP float bias = umbrage_acne_free_bias(slope, terms.z, terms.w);
    UMBRAGE_HIGHP float receiver = umbrage_biased(at.z, bias);
    return umbrage_FILTER(map, vec2(terms.x, terms.y), vec2(at.x, at.y), receiver, filter_terms.x, filter_terms.y);
}
`,
    },
    "exponents, deviations": {
        needs: filter => [snippets.acne_free_bias, snippets.biased, filter],
        text: `
// umbrage_look: visibility of a receiver in one map
UMBRAGE_HIGHP float umbrage_look(UMBRAGE_MAP map, UMBRAGE_HIGHP vec4 terms, UMBRAGE_HIGHP vec4 filter_terms, UMBRAGE_HIGHP vec3 at, UMBRAGE_HIGHP vec2 slope) {
    UMBRAGE_HIGHP float bias = umbrage_acne_free_bias(slope, terms.z, terms.w);
    UMBRAGE_HIGHP float receiver = umbrage_biased(at.z, bias);
    return umbrage_FILTER(map, vec2(terms.x, terms.y), vec2(at.x, at.y), receiver, vec2(filter_terms.x, filter_terms.y), vec2(filter_terms.z, filter_terms.w));
}
`,
    },
    "bias": {
        needs: filter => [snippets.acne_free_bias, snippets.biased, filter],
        text: `
// umbrage_look: visibility of a receiver in one map
UMBRAGE_HIGHP float umbrage_look(UMBRAGE_MAP map, UMBRAGE_HIGHP vec4 terms, UMBRAGE_HIGHP vec4 filter_terms, UMBRAGE_HIGHP vec3 at, UMBRAGE_HIGHP vec2 slope) {
    UMBRAGE_HIGHP float bias = umbrage_acne_free_bias(slope, terms.z, terms.w);
    UMBRAGE_HIGHP float receiver = umbrage_biased(at.z, bias);
    return umbrage_FILTER(map, vec2(terms.x, terms.y), vec2(at.x, at.y), receiver, vec2(filter_terms.x, filter_terms.y));
}
`,
    },
};

module.exports = {
    looks,
};
