const kinds = ["spot_light", "directional_light", "cascades", "cascades_8", "point_light", "tetrahedron_light", "dual_paraboloid_light", "warped_cascades", "adaptive_pages"];
const filters = ["hard", "pcf_2x2", "box", "tent2", "tent3", "quadratic_b_spline", "binomial5", "castano_dyadic5", "castano5", "binomial7", "tent7", "castano7", "disc8", "disc16", "disc32", "pcss8", "pcss16", "pcss32", "dpcf8", "dpcf16", "dpcf32", "vsm", "esm", "evsm2", "evsm4", "msm", "msm_unorm16", "msm_hausdorff"];
const encodings = ["depth32f", "rg9", "rg10", "rg11", "rg12", "rg13", "rg14", "rg15", "rg16", "rgb24", "rgb10", "r16", "float_bits", "threejs_rgba", "threejs_rgb", "threejs_rg", "threejs_legacy", "threejs_legacy_repaired", "base255", "base255_repaired"];

module.exports = {
    kinds,
    filters,
    encodings,
};
