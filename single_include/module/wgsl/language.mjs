export const language = {
    name: "WGSL", preprocessor: false, may_reorder: "WGSL",
    prelude: ``,
};
