const language = {
    name: "WGSL", preprocessor: false, may_reorder: "WGSL",
    prelude: ``,
};

module.exports = {
    language,
};
