const snippets = require('./snippets.cjs');

const looks = {
    "": {
        needs: filter => [snippets.acne_free_bias, snippets.biased, filter],
        text: `
// umbrage_look: visibility of a receiver in one map
float umbrage_look(UMBRAGE_MAP map, float4 terms, float4 filter_terms, float3 at, float2 slope) {
    float bias = umbrage_acne_free_bias(slope, terms.z, terms.w);
    float receiver = umbrage_biased(at.z, bias);
    return umbrage_FILTER(map, float2(terms.x, terms.y), float2(at.x, at.y), receiver);
}
`,
    },
    "radius": {
        needs: filter => [snippets.acne_free_bias, snippets.biased, filter],
        text: `
// umbrage_look: visibility of a receiver in one map
float umbrage_look(UMBRAGE_MAP map, float4 terms, float4 filter_terms, float3 at, float2 slope) {
    float bias = umbrage_acne_free_bias(slope, terms.z, terms.w);
    float receiver = umbrage_biased(at.z, bias);
    return umbrage_FILTER(map, float2(terms.x, terms.y), float2(at.x, at.y), receiver, int(filter_terms.x));
}
`,
    },
    "radius, rotation": {
        needs: filter => [snippets.acne_free_disc_bias, snippets.biased, filter, snippets.disc_rotation],
        text: `
// umbrage_look: visibility of a receiver in one map
float umbrage_look(UMBRAGE_MAP map, float4 terms, float4 filter_terms, float3 at, float2 slope, float2 pixel) {
    float bias = umbrage_acne_free_disc_bias(slope, filter_terms.y, terms.w);
    float receiver = umbrage_biased(at.z, bias);
    return umbrage_FILTER(map, float2(terms.x, terms.y), float2(at.x, at.y), receiver, filter_terms.x,
                          umbrage_disc_rotation(pixel));
}
`,
    },
    "softness, rotation": {
        needs: filter => [snippets.acne_free_bias, snippets.biased, filter, snippets.disc_rotation],
        text: `
// umbrage_look: visibility of a receiver in one map
float umbrage_look(UMBRAGE_MAP map, float4 terms, float4 filter_terms, float3 at, float2 slope, float2 pixel) {
    float2 receiver_slope = slope;
    float2 receiver_coord = float2(at.x, at.y);
    float bias = umbrage_acne_free_bias(slope, 0.5, terms.w);
    float receiver = umbrage_biased(at.z, bias);
    return umbrage_FILTER(map, float2(terms.x, terms.y), float2(at.x, at.y), receiver,
                          float3(filter_terms.x, filter_terms.y, filter_terms.z), umbrage_disc_rotation(pixel));
}
`,
    },
    "min_variance": {
        needs: filter => [snippets.acne_free_bias, snippets.biased, filter],
        text: `
// umbrage_look: visibility of a receiver in one map
float umbrage_look(UMBRAGE_MAP map, float4 terms, float4 filter_terms, float3 at, float2 slope) {
    float bias = umbrage_acne_free_bias(slope, terms.z, terms.w);
    float receiver = umbrage_biased(at.z, bias);
    return umbrage_FILTER(map, float2(terms.x, terms.y), float2(at.x, at.y), receiver, filter_terms.x);
}
`,
    },
    "exponent": {
        needs: filter => [snippets.acne_free_bias, snippets.biased, filter],
        text: `
// umbrage_look: visibility of a receiver in one map
float umbrage_look(UMBRAGE_MAP map, float4 terms, float4 filter_terms, float3 at, float2 slope) {
    float bias = umbrage_acne_free_bias(slope, terms.z, terms.w);
    float receiver = umbrage_biased(at.z, bias);
    return umbrage_FILTER(map, float2(terms.x, terms.y), float2(at.x, at.y), receiver, filter_terms.x);
}
`,
    },
    "exponent, deviation": {
        needs: filter => [snippets.acne_free_bias, snippets.biased, filter],
        text: `
// umbrage_look: visibility of a receiver in one map
float umbrage_look(UMBRAGE_MAP map, float4 terms, float4 filter_terms, float3 at, float2 slope) {
    float bias = umbrage_acne_free_bias(slope, terms.z, terms.w);
    float receiver = umbrage_biased(at.z, bias);
    return umbrage_FILTER(map, float2(terms.x, terms.y), float2(at.x, at.y), receiver, filter_terms.x, filter_terms.y);
}
`,
    },
    "exponents, deviations": {
        needs: filter => [snippets.acne_free_bias, snippets.biased, filter],
        text: `
// umbrage_look: visibility of a receiver in one map
float umbrage_look(UMBRAGE_MAP map, float4 terms, float4 filter_terms, float3 at, float2 slope) {
    float bias = umbrage_acne_free_bias(slope, terms.z, terms.w);
    float receiver = umbrage_biased(at.z, bias);
    return umbrage_FILTER(map, float2(terms.x, terms.y), float2(at.x, at.y), receiver,
                         float2(filter_terms.x, filter_terms.y), float2(filter_terms.z, filter_terms.w));
}
`,
    },
    "bias": {
        needs: filter => [snippets.acne_free_bias, snippets.biased, filter],
        text: `
// umbrage_look: visibility of a receiver in one map
float umbrage_look(UMBRAGE_MAP map, float4 terms, float4 filter_terms, float3 at, float2 slope) {
    float bias = umbrage_acne_free_bias(slope, terms.z, terms.w);
    float receiver = umbrage_biased(at.z, bias);
    return umbrage_FILTER(map, float2(terms.x, terms.y), float2(at.x, at.y), receiver,
                       float2(filter_terms.x, filter_terms.y));
}
`,
    },
};

module.exports = {
    looks,
};
