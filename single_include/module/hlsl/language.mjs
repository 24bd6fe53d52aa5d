export const language = {
    name: "HLSL", preprocessor: true, may_reorder: "",
    prelude: ``,
};
