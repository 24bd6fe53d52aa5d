const language = {
    name: "MSL", preprocessor: true, may_reorder: "",
    prelude: `
#include <metal_stdlib>
#pragma METAL fp math_mode(safe)
#pragma METAL fp contract(off)
`,
};

module.exports = {
    language,
};
