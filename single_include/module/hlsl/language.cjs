const language = {
    name: "HLSL", preprocessor: true, may_reorder: "",
    prelude: ``,
};

module.exports = {
    language,
};
