// SPDX-License-Identifier: MIT
//
// Stand-in for your engine, of the recipe of Vulkan: a device, memory, images, and a pipeline of the scene's vertices.
// It waits for everything; speed is no aim.
#pragma once

#define VULKAN_HPP_NO_STRUCT_CONSTRUCTORS
#include <vulkan/vulkan_raii.hpp>

#include <array>
#include <cstring>
#include <stdexcept>
#include <string>
#include <utility>
#include <vector>

#include <glslang/Public/ResourceLimits.h>
#include <glslang/Public/ShaderLang.h>
#include <glslang/SPIRV/GlslangToSpv.h>

#include "scene.hpp"

namespace vulkan {

/// SPIR-V of a shader.
inline std::vector<std::uint32_t> compile(EShLanguage stage, const std::string& text) {
    const char* const source = text.c_str();
    const auto messages = static_cast<EShMessages>(EShMsgSpvRules | EShMsgVulkanRules);
    glslang::TShader shader(stage);
    shader.setStrings(&source, 1);
    shader.setEnvInput(glslang::EShSourceGlsl, stage, glslang::EShClientVulkan, 100);
    shader.setEnvClient(glslang::EShClientVulkan, glslang::EShTargetVulkan_1_3);
    shader.setEnvTarget(glslang::EShTargetSpv, glslang::EShTargetSpv_1_6);
    glslang::TProgram program;
    program.addShader(&shader);
    if (!shader.parse(GetDefaultResources(), 450, false, messages) || !program.link(messages))
        throw std::runtime_error(shader.getInfoLog());
    std::vector<std::uint32_t> code;
    glslang::GlslangToSpv(*program.getIntermediate(stage), code);
    return code;
}

inline vk::raii::PhysicalDevice first_device(const vk::raii::Instance& instance) {
    vk::raii::PhysicalDevices all(instance);
    for (vk::raii::PhysicalDevice& device : all)
        if (device.getProperties().apiVersion >= VK_API_VERSION_1_3) return std::move(device);
    throw std::runtime_error("SKIPPED: no device of Vulkan 1.3");
}

/// A device with one queue, whose first family is taken to draw.
struct gpu {
    vk::ApplicationInfo about{.apiVersion = VK_API_VERSION_1_3};
    vk::raii::Context context{};
    vk::raii::Instance instance{context, vk::InstanceCreateInfo{.pApplicationInfo = &about}};
    vk::raii::PhysicalDevice physical = first_device(instance);
    float priority = 1;
    vk::DeviceQueueCreateInfo queues{.queueCount = 1, .pQueuePriorities = &priority};
    vk::PhysicalDeviceVulkan13Features features{.dynamicRendering = true};
    vk::raii::Device device{
        physical, vk::DeviceCreateInfo{.pNext = &features, .queueCreateInfoCount = 1, .pQueueCreateInfos = &queues}};
    vk::raii::Queue queue{device, 0, 0};
    vk::raii::CommandPool pool{device, vk::CommandPoolCreateInfo{}};
    vk::raii::CommandBuffer commands =
        std::move(vk::raii::CommandBuffers(device, {.commandPool = *pool, .commandBufferCount = 1}).front());

    [[nodiscard]] vk::raii::DeviceMemory allocate(vk::MemoryRequirements need, vk::MemoryPropertyFlags flags) const {
        const auto all = physical.getMemoryProperties();
        for (std::uint32_t i = 0; i < all.memoryTypeCount; ++i)
            if ((need.memoryTypeBits >> i & 1) && (all.memoryTypes[i].propertyFlags & flags) == flags)
                return {device, vk::MemoryAllocateInfo{.allocationSize = need.size, .memoryTypeIndex = i}};
        throw std::runtime_error("no memory of the kind needed");
    }
    void barrier() const {
        using stage = vk::PipelineStageFlagBits;
        using access = vk::AccessFlagBits;
        const vk::MemoryBarrier all{.srcAccessMask = access::eMemoryWrite,
                                    .dstAccessMask = access::eMemoryRead | access::eMemoryWrite};
        commands.pipelineBarrier(stage::eAllCommands, stage::eAllCommands | stage::eHost, {}, all, nullptr, nullptr);
    }
};

/// Bytes that both sides see.
struct buffer {
    vk::raii::Buffer handle;
    vk::raii::DeviceMemory memory;
    void* bytes;

    buffer(const gpu& on, std::size_t size, vk::BufferUsageFlags usage)
        : handle(on.device, vk::BufferCreateInfo{.size = size, .usage = usage}),
          memory(on.allocate(handle.getMemoryRequirements(),
                             vk::MemoryPropertyFlagBits::eHostVisible | vk::MemoryPropertyFlagBits::eHostCoherent)) {
        handle.bindMemory(*memory, 0);
        bytes = memory.mapMemory(0, VK_WHOLE_SIZE);
    }
    buffer(const gpu& on, const auto& values) : buffer(on, sizeof values, vk::BufferUsageFlagBits::eUniformBuffer) {
        std::memcpy(bytes, &values, sizeof values);
    }
};

/// Layers that are drawn into, always in the layout `general`.
struct image {
    vk::raii::Image handle;
    vk::raii::DeviceMemory memory;
    vk::ImageSubresourceRange all;
    vk::Format format;
    const gpu* on;

    image(const gpu& g, vk::Format f, vk::Extent2D size, std::uint32_t layers, vk::ImageUsageFlags usage)
        : handle(g.device, vk::ImageCreateInfo{.imageType = vk::ImageType::e2D,
                                               .format = f,
                                               .extent = {size.width, size.height, 1},
                                               .mipLevels = 1,
                                               .arrayLayers = layers,
                                               .usage = usage}),
          memory(g.allocate(handle.getMemoryRequirements(), vk::MemoryPropertyFlagBits::eDeviceLocal)),
          all{usage & vk::ImageUsageFlagBits::eDepthStencilAttachment ? vk::ImageAspectFlagBits::eDepth
                                                                      : vk::ImageAspectFlagBits::eColor,
              0, 1, 0, layers},
          format(f),
          on(&g) {
        handle.bindMemory(*memory, 0);
        using stage = vk::PipelineStageFlagBits;
        g.commands.pipelineBarrier(stage::eTopOfPipe, stage::eAllCommands, {}, nullptr, nullptr,
                                   vk::ImageMemoryBarrier{.dstAccessMask = vk::AccessFlagBits::eMemoryWrite,
                                                          .newLayout = vk::ImageLayout::eGeneral,
                                                          .image = *handle,
                                                          .subresourceRange = all});
    }
    [[nodiscard]] vk::raii::ImageView view(vk::ImageViewType type, std::uint32_t layer, std::uint32_t count) const {
        return {on->device, vk::ImageViewCreateInfo{.image = *handle,
                                                    .viewType = type,
                                                    .format = format,
                                                    .subresourceRange = {all.aspectMask, 0, 1, layer, count}}};
    }
};

inline vk::raii::Pipeline make_pipeline(const gpu& on, vk::PipelineLayout layout, const std::string& fragment,
                                        bool colors) {
    const std::string vertex = R"(#version 450
        layout(location = 0) in vec3 position;
        layout(location = 1) in vec3 vertex_normal;
        layout(location = 2) in vec2 vertex_uv;
        layout(push_constant) uniform matrices { mat4 to_clip; };
        layout(location = 0) out vec3 world;
        layout(location = 1) out vec3 normal;
        layout(location = 2) out vec2 uv;
        void main() {
            gl_Position = to_clip * vec4(position, 1.0), world = position, normal = vertex_normal, uv = vertex_uv;
        })";
    const auto make_module = [&](const std::vector<std::uint32_t>& code) {
        return vk::raii::ShaderModule(on.device,
                                      vk::ShaderModuleCreateInfo{.codeSize = 4 * code.size(), .pCode = code.data()});
    };
    const auto vertex_module = make_module(compile(EShLangVertex, vertex)),
               fragment_module = make_module(compile(EShLangFragment, fragment));
    const std::array stages{
        vk::PipelineShaderStageCreateInfo{
            .stage = vk::ShaderStageFlagBits::eVertex, .module = *vertex_module, .pName = "main"},
        vk::PipelineShaderStageCreateInfo{
            .stage = vk::ShaderStageFlagBits::eFragment, .module = *fragment_module, .pName = "main"}};
    const vk::VertexInputBindingDescription binding{0, sizeof(scene::vertex), vk::VertexInputRate::eVertex};
    using vk::Format;
    const std::array attributes{vk::VertexInputAttributeDescription{0, 0, Format::eR32G32B32Sfloat, 0},
                                vk::VertexInputAttributeDescription{1, 0, Format::eR32G32B32Sfloat, 12},
                                vk::VertexInputAttributeDescription{2, 0, Format::eR32G32Sfloat, 24}};
    const vk::PipelineVertexInputStateCreateInfo input{.vertexBindingDescriptionCount = 1,
                                                       .pVertexBindingDescriptions = &binding,
                                                       .vertexAttributeDescriptionCount = attributes.size(),
                                                       .pVertexAttributeDescriptions = attributes.data()};
    const vk::PipelineInputAssemblyStateCreateInfo assembly{.topology = vk::PrimitiveTopology::eTriangleList};
    const vk::PipelineViewportStateCreateInfo viewport{.viewportCount = 1, .scissorCount = 1};
    const vk::PipelineRasterizationStateCreateInfo raster{.lineWidth = 1.0f};
    const vk::PipelineMultisampleStateCreateInfo samples{};
    const vk::PipelineDepthStencilStateCreateInfo depth{
        .depthTestEnable = true, .depthWriteEnable = true, .depthCompareOp = vk::CompareOp::eGreater};  // reversed
    using write = vk::ColorComponentFlagBits;
    const vk::PipelineColorBlendAttachmentState plain{.colorWriteMask = write::eR | write::eG | write::eB | write::eA};
    const vk::PipelineColorBlendStateCreateInfo blend{.attachmentCount = colors, .pAttachments = &plain};
    const std::array varying{vk::DynamicState::eViewport, vk::DynamicState::eScissor};
    const vk::PipelineDynamicStateCreateInfo dynamic{.dynamicStateCount = varying.size(),
                                                     .pDynamicStates = varying.data()};
    const Format color = Format::eR8G8B8A8Unorm;
    const vk::PipelineRenderingCreateInfo rendering{
        .colorAttachmentCount = colors, .pColorAttachmentFormats = &color, .depthAttachmentFormat = Format::eD32Sfloat};
    return {on.device, nullptr,
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

}  // namespace vulkan
