// SPDX-License-Identifier: MIT
//
// Pipelines of one shader: a triangle that fills a target, or a compute shader.
#pragma once

#define VULKAN_HPP_NO_STRUCT_CONSTRUCTORS
#include <vulkan/vulkan_raii.hpp>

#include <array>

#include <glm/vec2.hpp>

namespace parity {

/// A pass with one attachment, which is always in the layout `general`; what was in it is lost.
[[nodiscard]] inline vk::raii::RenderPass make_pass(const vk::raii::Device& device, vk::Format format) {
    const vk::AttachmentDescription color{.format = format,
                                          .loadOp = vk::AttachmentLoadOp::eDontCare,
                                          .storeOp = vk::AttachmentStoreOp::eStore,
                                          .initialLayout = vk::ImageLayout::eGeneral,
                                          .finalLayout = vk::ImageLayout::eGeneral};
    const vk::AttachmentReference first{0, vk::ImageLayout::eGeneral};
    const vk::SubpassDescription subpass{.colorAttachmentCount = 1, .pColorAttachments = &first};
    return {device, vk::RenderPassCreateInfo{
                        .attachmentCount = 1, .pAttachments = &color, .subpassCount = 1, .pSubpasses = &subpass}};
}

/// Corners are vec2 at location 0 of a buffer at binding 0; viewport and scissor are set with the commands.
[[nodiscard]] inline vk::raii::Pipeline make_drawing(const vk::raii::Device& device, vk::PipelineLayout layout,
                                                     vk::RenderPass pass, vk::ShaderModule vertex,
                                                     vk::ShaderModule fragment) {
    const std::array stages{
        vk::PipelineShaderStageCreateInfo{.stage = vk::ShaderStageFlagBits::eVertex, .module = vertex, .pName = "main"},
        vk::PipelineShaderStageCreateInfo{
            .stage = vk::ShaderStageFlagBits::eFragment, .module = fragment, .pName = "main"}};
    const vk::VertexInputBindingDescription binding{0, sizeof(glm::vec2), vk::VertexInputRate::eVertex};
    const vk::VertexInputAttributeDescription attribute{0, 0, vk::Format::eR32G32Sfloat, 0};
    const vk::PipelineVertexInputStateCreateInfo input{.vertexBindingDescriptionCount = 1,
                                                       .pVertexBindingDescriptions = &binding,
                                                       .vertexAttributeDescriptionCount = 1,
                                                       .pVertexAttributeDescriptions = &attribute};
    const vk::PipelineInputAssemblyStateCreateInfo assembly{.topology = vk::PrimitiveTopology::eTriangleList};
    const vk::PipelineViewportStateCreateInfo viewport{.viewportCount = 1, .scissorCount = 1};
    const vk::PipelineRasterizationStateCreateInfo raster{.lineWidth = 1.0f};
    const vk::PipelineMultisampleStateCreateInfo samples{};
    using write = vk::ColorComponentFlagBits;
    const vk::PipelineColorBlendAttachmentState plain{.colorWriteMask = write::eR | write::eG | write::eB | write::eA};
    const vk::PipelineColorBlendStateCreateInfo blend{.attachmentCount = 1, .pAttachments = &plain};
    const std::array varying{vk::DynamicState::eViewport, vk::DynamicState::eScissor};
    const vk::PipelineDynamicStateCreateInfo dynamic{.dynamicStateCount = varying.size(),
                                                     .pDynamicStates = varying.data()};
    return {device, nullptr,
            vk::GraphicsPipelineCreateInfo{.stageCount = stages.size(),
                                           .pStages = stages.data(),
                                           .pVertexInputState = &input,
                                           .pInputAssemblyState = &assembly,
                                           .pViewportState = &viewport,
                                           .pRasterizationState = &raster,
                                           .pMultisampleState = &samples,
                                           .pColorBlendState = &blend,
                                           .pDynamicState = &dynamic,
                                           .layout = layout,
                                           .renderPass = pass}};
}

[[nodiscard]] inline vk::raii::Pipeline make_computing(const vk::raii::Device& device, vk::PipelineLayout layout,
                                                       vk::ShaderModule module) {
    return {device, nullptr,
            vk::ComputePipelineCreateInfo{
                .stage = {.stage = vk::ShaderStageFlagBits::eCompute, .module = module, .pName = "main"},
                .layout = layout}};
}

}  // namespace parity
