// SPDX-License-Identifier: MIT
#include "vulkan.hpp"

#include <algorithm>
#include <cstdlib>
#include <cstring>
#include <string>
#include <utility>

#include <vulkan/vulkan.h>

#include "vulkan_queue.hpp"

namespace bench {
namespace {

constexpr std::uint32_t binding_count = 8;
constexpr std::uint32_t uniforms_binding = 7;
constexpr VkDescriptorType texture_type = VK_DESCRIPTOR_TYPE_COMBINED_IMAGE_SAMPLER;
constexpr VkDescriptorType uniforms_type = VK_DESCRIPTOR_TYPE_UNIFORM_BUFFER;
constexpr VkFormat target_format = VK_FORMAT_R8G8B8A8_UNORM;

class vulkan_device final : public device, vulkan_queue {
public:
    vulkan_device(VkPhysicalDevice physical, bool statistics) {
        physical_ = physical;
        vkGetPhysicalDeviceProperties(physical_, &properties_);
        std::uint32_t count = 0;
        vkGetPhysicalDeviceQueueFamilyProperties(physical_, &count, nullptr);
        std::vector<VkQueueFamilyProperties> families(count);
        vkGetPhysicalDeviceQueueFamilyProperties(physical_, &count, families.data());
        for (std::uint32_t i = count; i-- > 0;)
            if (families[i].queueFlags & VK_QUEUE_GRAPHICS_BIT) family_ = i;

        VkPhysicalDevicePipelineExecutablePropertiesFeaturesKHR executable{
            .sType = VK_STRUCTURE_TYPE_PHYSICAL_DEVICE_PIPELINE_EXECUTABLE_PROPERTIES_FEATURES_KHR,
            .pipelineExecutableInfo = VK_TRUE};
        VkPhysicalDeviceVulkan13Features features{.sType = VK_STRUCTURE_TYPE_PHYSICAL_DEVICE_VULKAN_1_3_FEATURES,
                                                  .pNext = statistics ? &executable : nullptr,
                                                  .dynamicRendering = VK_TRUE};
        const float priority = 1.0f;
        const VkDeviceQueueCreateInfo queue{.sType = VK_STRUCTURE_TYPE_DEVICE_QUEUE_CREATE_INFO,
                                            .queueFamilyIndex = family_,
                                            .queueCount = 1,
                                            .pQueuePriorities = &priority};
        const char* extension = VK_KHR_PIPELINE_EXECUTABLE_PROPERTIES_EXTENSION_NAME;
        const VkDeviceCreateInfo info{.sType = VK_STRUCTURE_TYPE_DEVICE_CREATE_INFO,
                                      .pNext = &features,
                                      .queueCreateInfoCount = 1,
                                      .pQueueCreateInfos = &queue,
                                      .enabledExtensionCount = statistics ? 1u : 0u,
                                      .ppEnabledExtensionNames = &extension};
        check(vkCreateDevice(physical_, &info, nullptr, &device_), "vkCreateDevice");

        std::vector<VkDescriptorSetLayoutBinding> bindings;
        for (std::uint32_t i = 0; i < binding_count; ++i)
            bindings.push_back(
                {i, i == uniforms_binding ? uniforms_type : texture_type, 1, VK_SHADER_STAGE_FRAGMENT_BIT, nullptr});
        set_layout_ = make<VkDescriptorSetLayout>(
            device_, vkCreateDescriptorSetLayout,
            VkDescriptorSetLayoutCreateInfo{.sType = VK_STRUCTURE_TYPE_DESCRIPTOR_SET_LAYOUT_CREATE_INFO,
                                            .bindingCount = binding_count,
                                            .pBindings = bindings.data()});
        const VkPushConstantRange constants{VK_SHADER_STAGE_FRAGMENT_BIT, 0, 8};
        layout_ =
            make<VkPipelineLayout>(device_, vkCreatePipelineLayout,
                                   VkPipelineLayoutCreateInfo{.sType = VK_STRUCTURE_TYPE_PIPELINE_LAYOUT_CREATE_INFO,
                                                              .setLayoutCount = 1,
                                                              .pSetLayouts = &set_layout_,
                                                              .pushConstantRangeCount = 1,
                                                              .pPushConstantRanges = &constants});
    }

    [[nodiscard]] std::string name() const override { return properties_.deviceName; }

    [[nodiscard]] std::vector<statistic> statistics(const spirv& vertex, const spirv& fragment) override {
        const VkPipeline pipeline = make_pipeline(vertex, fragment, VK_PIPELINE_CREATE_CAPTURE_STATISTICS_BIT_KHR);
        const auto executables = reinterpret_cast<PFN_vkGetPipelineExecutablePropertiesKHR>(
            vkGetDeviceProcAddr(device_, "vkGetPipelineExecutablePropertiesKHR"));
        const auto statistics_of = reinterpret_cast<PFN_vkGetPipelineExecutableStatisticsKHR>(
            vkGetDeviceProcAddr(device_, "vkGetPipelineExecutableStatisticsKHR"));
        const VkPipelineInfoKHR info{.sType = VK_STRUCTURE_TYPE_PIPELINE_INFO_KHR, .pipeline = pipeline};
        std::uint32_t count = 0;
        check(executables(device_, &info, &count, nullptr), "executables");
        std::vector<VkPipelineExecutablePropertiesKHR> all(
            count, {.sType = VK_STRUCTURE_TYPE_PIPELINE_EXECUTABLE_PROPERTIES_KHR});
        check(executables(device_, &info, &count, all.data()), "executables");
        std::vector<statistic> result;
        for (std::uint32_t i = 0; i < count; ++i) {
            if (!(all[i].stages & VK_SHADER_STAGE_FRAGMENT_BIT)) continue;
            const VkPipelineExecutableInfoKHR one{
                .sType = VK_STRUCTURE_TYPE_PIPELINE_EXECUTABLE_INFO_KHR, .pipeline = pipeline, .executableIndex = i};
            std::uint32_t lines = 0;
            check(statistics_of(device_, &one, &lines, nullptr), "statistics");
            std::vector<VkPipelineExecutableStatisticKHR> found(
                lines, {.sType = VK_STRUCTURE_TYPE_PIPELINE_EXECUTABLE_STATISTIC_KHR});
            check(statistics_of(device_, &one, &lines, found.data()), "statistics");
            for (const auto& s : found) result.push_back({s.name, s.value.u64});
        }
        vkDestroyPipeline(device_, pipeline, nullptr);
        return result;
    }

    [[nodiscard]] double milliseconds(const spirv& vertex, const spirv& fragment, std::uint32_t width,
                                      std::uint32_t height) override {
        if (!commands_) prepare(width, height);
        const VkPipeline pipeline = make_pipeline(vertex, fragment, 0);
        double least = 1e30;
        for (int repeat = 0; repeat < 5; ++repeat) {
            submit([&] {
                vkCmdResetQueryPool(commands_, queries_, 0, 2);
                const VkRenderingAttachmentInfo color{.sType = VK_STRUCTURE_TYPE_RENDERING_ATTACHMENT_INFO,
                                                      .imageView = target_,
                                                      .imageLayout = VK_IMAGE_LAYOUT_GENERAL,
                                                      .loadOp = VK_ATTACHMENT_LOAD_OP_DONT_CARE,
                                                      .storeOp = VK_ATTACHMENT_STORE_OP_STORE};
                const VkRenderingInfo rendering{.sType = VK_STRUCTURE_TYPE_RENDERING_INFO,
                                                .renderArea = {{0, 0}, {width, height}},
                                                .layerCount = 1,
                                                .colorAttachmentCount = 1,
                                                .pColorAttachments = &color};
                const VkViewport viewport{0, 0, float(width), float(height), 0, 1};
                const float size[] = {map_size, map_size};
                vkCmdWriteTimestamp(commands_, VK_PIPELINE_STAGE_TOP_OF_PIPE_BIT, queries_, 0);
                vkCmdBeginRendering(commands_, &rendering);
                vkCmdBindPipeline(commands_, VK_PIPELINE_BIND_POINT_GRAPHICS, pipeline);
                vkCmdBindDescriptorSets(commands_, VK_PIPELINE_BIND_POINT_GRAPHICS, layout_, 0, 1, &set_, 0, nullptr);
                vkCmdPushConstants(commands_, layout_, VK_SHADER_STAGE_FRAGMENT_BIT, 0, sizeof size, size);
                vkCmdSetViewport(commands_, 0, 1, &viewport);
                vkCmdSetScissor(commands_, 0, 1, &rendering.renderArea);
                vkCmdDraw(commands_, 3, 1, 0, 0);
                vkCmdEndRendering(commands_);
                vkCmdWriteTimestamp(commands_, VK_PIPELINE_STAGE_BOTTOM_OF_PIPE_BIT, queries_, 1);
            });
            std::uint64_t ticks[2];
            check(vkGetQueryPoolResults(device_, queries_, 0, 2, sizeof ticks, ticks, sizeof ticks[0],
                                        VK_QUERY_RESULT_64_BIT | VK_QUERY_RESULT_WAIT_BIT),
                  "timestamps");
            least = std::min(least, double(ticks[1] - ticks[0]) * double(properties_.limits.timestampPeriod) * 1e-6);
        }
        vkDestroyPipeline(device_, pipeline, nullptr);
        return least;
    }

private:
    [[nodiscard]] VkPipeline make_pipeline(const spirv& vertex, const spirv& fragment,
                                           VkPipelineCreateFlags flags) const {
        VkPipelineShaderStageCreateInfo stages[2];
        const std::pair<VkShaderStageFlagBits, const spirv*> texts[] = {{VK_SHADER_STAGE_VERTEX_BIT, &vertex},
                                                                        {VK_SHADER_STAGE_FRAGMENT_BIT, &fragment}};
        for (int i = 0; i < 2; ++i) {
            const auto& [stage, code] = texts[i];
            const VkShaderModuleCreateInfo module{.sType = VK_STRUCTURE_TYPE_SHADER_MODULE_CREATE_INFO,
                                                  .codeSize = code->size() * 4,
                                                  .pCode = code->data()};
            stages[i] = {.sType = VK_STRUCTURE_TYPE_PIPELINE_SHADER_STAGE_CREATE_INFO,
                         .stage = stage,
                         .module = make<VkShaderModule>(device_, vkCreateShaderModule, module),
                         .pName = "main"};
        }
        const VkPipelineRenderingCreateInfo rendering{.sType = VK_STRUCTURE_TYPE_PIPELINE_RENDERING_CREATE_INFO,
                                                      .colorAttachmentCount = 1,
                                                      .pColorAttachmentFormats = &target_format};
        const VkPipelineVertexInputStateCreateInfo input{.sType =
                                                             VK_STRUCTURE_TYPE_PIPELINE_VERTEX_INPUT_STATE_CREATE_INFO};
        const VkPipelineInputAssemblyStateCreateInfo assembly{
            .sType = VK_STRUCTURE_TYPE_PIPELINE_INPUT_ASSEMBLY_STATE_CREATE_INFO,
            .topology = VK_PRIMITIVE_TOPOLOGY_TRIANGLE_LIST};
        const VkPipelineViewportStateCreateInfo viewport{
            .sType = VK_STRUCTURE_TYPE_PIPELINE_VIEWPORT_STATE_CREATE_INFO, .viewportCount = 1, .scissorCount = 1};
        const VkPipelineRasterizationStateCreateInfo raster{
            .sType = VK_STRUCTURE_TYPE_PIPELINE_RASTERIZATION_STATE_CREATE_INFO, .lineWidth = 1.0f};
        const VkPipelineMultisampleStateCreateInfo samples{
            .sType = VK_STRUCTURE_TYPE_PIPELINE_MULTISAMPLE_STATE_CREATE_INFO,
            .rasterizationSamples = VK_SAMPLE_COUNT_1_BIT};
        const VkPipelineColorBlendAttachmentState all_channels{.colorWriteMask = 15};
        const VkPipelineColorBlendStateCreateInfo blend{
            .sType = VK_STRUCTURE_TYPE_PIPELINE_COLOR_BLEND_STATE_CREATE_INFO,
            .attachmentCount = 1,
            .pAttachments = &all_channels};
        const VkDynamicState states[] = {VK_DYNAMIC_STATE_VIEWPORT, VK_DYNAMIC_STATE_SCISSOR};
        const VkPipelineDynamicStateCreateInfo dynamic{.sType = VK_STRUCTURE_TYPE_PIPELINE_DYNAMIC_STATE_CREATE_INFO,
                                                       .dynamicStateCount = 2,
                                                       .pDynamicStates = states};
        const VkGraphicsPipelineCreateInfo info{.sType = VK_STRUCTURE_TYPE_GRAPHICS_PIPELINE_CREATE_INFO,
                                                .pNext = &rendering,
                                                .flags = flags,
                                                .stageCount = 2,
                                                .pStages = stages,
                                                .pVertexInputState = &input,
                                                .pInputAssemblyState = &assembly,
                                                .pViewportState = &viewport,
                                                .pRasterizationState = &raster,
                                                .pMultisampleState = &samples,
                                                .pColorBlendState = &blend,
                                                .pDynamicState = &dynamic,
                                                .layout = layout_};
        VkPipeline pipeline{};
        check(vkCreateGraphicsPipelines(device_, VK_NULL_HANDLE, 1, &info, nullptr, &pipeline), "a pipeline");
        for (const auto& stage : stages) vkDestroyShaderModule(device_, stage.module, nullptr);
        return pipeline;
    }

    /// Objects that drawing needs besides a pipeline.
    void prepare(std::uint32_t width, std::uint32_t height) {
        vkGetDeviceQueue(device_, family_, 0, &queue_);
        const auto pool =
            make<VkCommandPool>(device_, vkCreateCommandPool,
                                VkCommandPoolCreateInfo{.sType = VK_STRUCTURE_TYPE_COMMAND_POOL_CREATE_INFO,
                                                        .flags = VK_COMMAND_POOL_CREATE_RESET_COMMAND_BUFFER_BIT,
                                                        .queueFamilyIndex = family_});
        commands_ =
            make<VkCommandBuffer>(device_, vkAllocateCommandBuffers,
                                  VkCommandBufferAllocateInfo{.sType = VK_STRUCTURE_TYPE_COMMAND_BUFFER_ALLOCATE_INFO,
                                                              .commandPool = pool,
                                                              .level = VK_COMMAND_BUFFER_LEVEL_PRIMARY,
                                                              .commandBufferCount = 1});
        queries_ = make<VkQueryPool>(device_, vkCreateQueryPool,
                                     VkQueryPoolCreateInfo{.sType = VK_STRUCTURE_TYPE_QUERY_POOL_CREATE_INFO,
                                                           .queryType = VK_QUERY_TYPE_TIMESTAMP,
                                                           .queryCount = 2});
        target_ = image(target_format, width, height, VK_IMAGE_USAGE_COLOR_ATTACHMENT_BIT, false);
        set_ = descriptor_set(set_layout_, {{texture_type, binding_count - 1}, {uniforms_type, 1}});
        for (std::uint32_t i = 0; i < uniforms_binding; ++i) {
            const bool compares = i == 2 || i == 4 || i == 6;
            const VkFormat format = compares ? VK_FORMAT_D32_SFLOAT : VK_FORMAT_R8G8B8A8_UNORM;
            const VkImageViewType type = i < 3   ? VK_IMAGE_VIEW_TYPE_2D
                                         : i < 5 ? VK_IMAGE_VIEW_TYPE_2D_ARRAY
                                                 : VK_IMAGE_VIEW_TYPE_CUBE;
            const std::uint32_t rows = i == 1 ? 32 : map_size;
            const VkImageView view = image(format, map_size, rows, VK_IMAGE_USAGE_SAMPLED_BIT, true, type);
            const VkDescriptorImageInfo texture{sampler(compares), view, VK_IMAGE_LAYOUT_GENERAL};
            const VkWriteDescriptorSet write{.sType = VK_STRUCTURE_TYPE_WRITE_DESCRIPTOR_SET,
                                             .dstSet = set_,
                                             .dstBinding = i,
                                             .descriptorCount = 1,
                                             .descriptorType = texture_type,
                                             .pImageInfo = &texture};
            vkUpdateDescriptorSets(device_, 1, &write, 0, nullptr);
        }
        const VkDescriptorBufferInfo buffer{uniforms(1024), 0, VK_WHOLE_SIZE};
        const VkWriteDescriptorSet write{.sType = VK_STRUCTURE_TYPE_WRITE_DESCRIPTOR_SET,
                                         .dstSet = set_,
                                         .dstBinding = uniforms_binding,
                                         .descriptorCount = 1,
                                         .descriptorType = uniforms_type,
                                         .pBufferInfo = &buffer};
        vkUpdateDescriptorSets(device_, 1, &write, 0, nullptr);
    }

    VkPhysicalDeviceProperties properties_{};
    VkDescriptorSetLayout set_layout_{};
    VkPipelineLayout layout_{};
    VkQueryPool queries_{};
    VkImageView target_{};
    VkDescriptorSet set_{};
};

std::vector<VkPhysicalDevice> physical_devices() {
    const VkApplicationInfo application{.sType = VK_STRUCTURE_TYPE_APPLICATION_INFO, .apiVersion = VK_API_VERSION_1_3};
    const VkInstanceCreateInfo info{.sType = VK_STRUCTURE_TYPE_INSTANCE_CREATE_INFO, .pApplicationInfo = &application};
    VkInstance instance{};
    std::uint32_t count = 0;
    if (vkCreateInstance(&info, nullptr, &instance) != VK_SUCCESS) return {};
    if (vkEnumeratePhysicalDevices(instance, &count, nullptr) != VK_SUCCESS) return {};
    std::vector<VkPhysicalDevice> all(count);
    check(vkEnumeratePhysicalDevices(instance, &count, all.data()), "vkEnumeratePhysicalDevices");
    return all;
}

VkPhysicalDeviceProperties properties_of(VkPhysicalDevice physical) {
    VkPhysicalDeviceProperties properties;
    vkGetPhysicalDeviceProperties(physical, &properties);
    return properties;
}

}  // namespace

device* rdna2() {
    setenv("RADV_FORCE_FAMILY", "navi21", 1);
    setenv("MESA_SHADER_CACHE_DISABLE", "true", 1);
    device* found = nullptr;
    for (VkPhysicalDevice physical : physical_devices())
        if (!found && std::strstr(properties_of(physical).deviceName, "NAVI21"))
            found = new vulkan_device(physical, true);
    unsetenv("RADV_FORCE_FAMILY");
    return found;
}

std::vector<device*> gpus(bool software) {
    std::vector<device*> all;
    for (VkPhysicalDevice physical : physical_devices()) {
        const VkPhysicalDeviceProperties p = properties_of(physical);
        if (p.apiVersion < VK_API_VERSION_1_3 || (p.deviceType == VK_PHYSICAL_DEVICE_TYPE_CPU && !software)) continue;
        all.push_back(new vulkan_device(physical, false));
    }
    return all;
}

}  // namespace bench
