// SPDX-License-Identifier: MIT
//
// A pipeline of triangles whose vertices have a position and a normal, for targets of any format.
#pragma once

#define VULKAN_HPP_NO_STRUCT_CONSTRUCTORS
#include <vulkan/vulkan_raii.hpp>

#include <array>

#include <glm/vec3.hpp>

namespace paths {

struct targets_of {
    vk::Format color, depth;  ///< color: eUndefined for none
    bool reversed;            ///< direction of depth
};

/// Viewport and scissor are set with the commands. The main functions are called main.
[[nodiscard]] inline vk::raii::Pipeline make_pipeline(const vk::raii::Device& device, vk::PipelineLayout layout,
                                                      vk::ShaderModule vertex, vk::ShaderModule fragment,
                                                      const targets_of& to) {
    const std::array stages{
        vk::PipelineShaderStageCreateInfo{.stage = vk::ShaderStageFlagBits::eVertex, .module = vertex, .pName = "main"},
        vk::PipelineShaderStageCreateInfo{
            .stage = vk::ShaderStageFlagBits::eFragment, .module = fragment, .pName = "main"}};
    const vk::VertexInputBindingDescription binding{0, 2 * sizeof(glm::vec3), vk::VertexInputRate::eVertex};
    const std::array attributes{
        vk::VertexInputAttributeDescription{0, 0, vk::Format::eR32G32B32Sfloat, 0},
        vk::VertexInputAttributeDescription{1, 0, vk::Format::eR32G32B32Sfloat, sizeof(glm::vec3)}};
    const vk::PipelineVertexInputStateCreateInfo input{.vertexBindingDescriptionCount = 1,
                                                       .pVertexBindingDescriptions = &binding,
                                                       .vertexAttributeDescriptionCount = attributes.size(),
                                                       .pVertexAttributeDescriptions = attributes.data()};
    const vk::PipelineInputAssemblyStateCreateInfo assembly{.topology = vk::PrimitiveTopology::eTriangleList};
    const vk::PipelineViewportStateCreateInfo viewport{.viewportCount = 1, .scissorCount = 1};
    const vk::PipelineRasterizationStateCreateInfo raster{.lineWidth = 1.0f};
    const vk::PipelineMultisampleStateCreateInfo samples{};
    const vk::PipelineDepthStencilStateCreateInfo depth{
        .depthTestEnable = true,
        .depthWriteEnable = true,
        .depthCompareOp = to.reversed ? vk::CompareOp::eGreater : vk::CompareOp::eLess};
    using write = vk::ColorComponentFlagBits;
    const vk::PipelineColorBlendAttachmentState plain{.colorWriteMask = write::eR | write::eG | write::eB | write::eA};
    const bool colors = to.color != vk::Format::eUndefined;
    const vk::PipelineColorBlendStateCreateInfo blend{.attachmentCount = colors, .pAttachments = &plain};
    const std::array varying{vk::DynamicState::eViewport, vk::DynamicState::eScissor};
    const vk::PipelineDynamicStateCreateInfo dynamic{.dynamicStateCount = varying.size(),
                                                     .pDynamicStates = varying.data()};
    const vk::PipelineRenderingCreateInfo rendering{
        .colorAttachmentCount = colors, .pColorAttachmentFormats = &to.color, .depthAttachmentFormat = to.depth};
    return {device, nullptr,
            vk::GraphicsPipelineCreateInfo{.pNext = &rendering,
                                           .stageCount = stages.size(),
                                           .pStages = stages.data(),
                                           .pVertexInputState = &input,
                                           .pInputAssemblyState = &assembly,
                                           .pViewportState = &viewport,
                                           .pRasterizationState = &raster,
                                           .pMultisampleState = &samples,
                                           .pDepthStencilState = &depth,
                                           .pColorBlendState = &blend,
                                           .pDynamicState = &dynamic,
                                           .layout = layout}};
}

}  // namespace paths
