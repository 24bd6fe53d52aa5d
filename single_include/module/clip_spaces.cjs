const opengl_clip_space = { hand: "right", range: "minus_one_to_one", direction: "forward", origin: "bottom" };
const vulkan_clip_space = { hand: "right", range: "zero_to_one", direction: "forward", origin: "bottom" };
const direct3d_clip_space = { hand: "left", range: "zero_to_one", direction: "forward", origin: "top" };
const webgpu_clip_space = { hand: "right", range: "zero_to_one", direction: "forward", origin: "top" };
const metal_clip_space = { hand: "right", range: "zero_to_one", direction: "forward", origin: "top" };
const unity_clip_space = { hand: "left", range: "zero_to_one", direction: "reversed", origin: "top" };
const unity_opengl_clip_space = { hand: "left", range: "minus_one_to_one", direction: "forward", origin: "bottom" };
const unreal_clip_space = { hand: "left", range: "zero_to_one", direction: "reversed", origin: "top" };
const godot_clip_space = { hand: "right", range: "zero_to_one", direction: "reversed", origin: "bottom" };
const cpu_clip_space = { hand: "right", range: "zero_to_one", direction: "forward", origin: "bottom" };

module.exports = {
    opengl_clip_space,
    vulkan_clip_space,
    direct3d_clip_space,
    webgpu_clip_space,
    metal_clip_space,
    unity_clip_space,
    unity_opengl_clip_space,
    unreal_clip_space,
    godot_clip_space,
    cpu_clip_space,
};
