// SPDX-License-Identifier: MIT
//
// A Vulkan device with a queue for drawing: memory, images, and commands that are waited for.
#pragma once

#include <cstdint>
#include <cstring>
#include <initializer_list>
#include <stdexcept>
#include <string>
#include <type_traits>
#include <typeinfo>

#include <vulkan/vulkan.h>

namespace bench {

inline void check(VkResult result, const char* what) {
    if (result != VK_SUCCESS) throw std::runtime_error(std::string(what) + ": VkResult " + std::to_string(result));
}

/// One handle from a vkCreate... or vkAllocate... function.
template <class Handle, class Function, class Info>
Handle make(VkDevice device, Function create, const Info& info) {
    Handle handle{};
    if constexpr (std::is_invocable_v<Function, VkDevice, const Info*, const VkAllocationCallbacks*, Handle*>)
        check(create(device, &info, nullptr, &handle), typeid(Info).name());
    else check(create(device, &info, &handle), typeid(Info).name());
    return handle;
}

class vulkan_queue {
protected:
    /// Records, runs and waits.
    template <class Record>
    void submit(Record&& record) {
        const VkCommandBufferBeginInfo begin{.sType = VK_STRUCTURE_TYPE_COMMAND_BUFFER_BEGIN_INFO};
        check(vkBeginCommandBuffer(commands_, &begin), "vkBeginCommandBuffer");
        record();
        check(vkEndCommandBuffer(commands_), "vkEndCommandBuffer");
        const VkSubmitInfo info{
            .sType = VK_STRUCTURE_TYPE_SUBMIT_INFO, .commandBufferCount = 1, .pCommandBuffers = &commands_};
        check(vkQueueSubmit(queue_, 1, &info, VK_NULL_HANDLE), "vkQueueSubmit");
        check(vkQueueWaitIdle(queue_), "vkQueueWaitIdle");
    }

    [[nodiscard]] VkDeviceMemory memory_for(const VkMemoryRequirements& need, VkMemoryPropertyFlags flags) const {
        VkPhysicalDeviceMemoryProperties memory;
        vkGetPhysicalDeviceMemoryProperties(physical_, &memory);
        for (std::uint32_t i = 0; i < memory.memoryTypeCount; ++i)
            if (need.memoryTypeBits >> i & 1 && (memory.memoryTypes[i].propertyFlags & flags) == flags)
                return make<VkDeviceMemory>(device_, vkAllocateMemory,
                                            VkMemoryAllocateInfo{.sType = VK_STRUCTURE_TYPE_MEMORY_ALLOCATE_INFO,
                                                                 .allocationSize = need.size,
                                                                 .memoryTypeIndex = i});
        throw std::runtime_error("no memory of the kind needed");
    }

    /// An image in the general layout, an array's of four layers; with noise, its first is filled with it. Views and
    /// images are never destroyed.
    VkImageView image(VkFormat format, std::uint32_t width, std::uint32_t height, VkImageUsageFlags usage, bool noise,
                      VkImageViewType type = VK_IMAGE_VIEW_TYPE_2D) {
        const bool cube = type == VK_IMAGE_VIEW_TYPE_CUBE;
        const std::uint32_t layers = cube ? 6 : type == VK_IMAGE_VIEW_TYPE_2D ? 1 : 4;
        const VkImageCreateFlags flags = cube ? VK_IMAGE_CREATE_CUBE_COMPATIBLE_BIT : 0;
        const VkImage handle = make<VkImage>(device_, vkCreateImage,
                                             VkImageCreateInfo{.sType = VK_STRUCTURE_TYPE_IMAGE_CREATE_INFO,
                                                               .flags = flags,
                                                               .imageType = VK_IMAGE_TYPE_2D,
                                                               .format = format,
                                                               .extent = {width, height, 1},
                                                               .mipLevels = 1,
                                                               .arrayLayers = layers,
                                                               .samples = VK_SAMPLE_COUNT_1_BIT,
                                                               .tiling = VK_IMAGE_TILING_OPTIMAL,
                                                               .usage = usage | VK_IMAGE_USAGE_TRANSFER_DST_BIT});
        VkMemoryRequirements need;
        vkGetImageMemoryRequirements(device_, handle, &need);
        const VkDeviceMemory room = memory_for(need, VK_MEMORY_PROPERTY_DEVICE_LOCAL_BIT);
        check(vkBindImageMemory(device_, handle, room, 0), "vkBindImageMemory");
        const bool depth = format == VK_FORMAT_D32_SFLOAT;
        const VkImageAspectFlags aspect = depth ? VK_IMAGE_ASPECT_DEPTH_BIT : VK_IMAGE_ASPECT_COLOR_BIT;

        const VkBuffer staging = make<VkBuffer>(device_, vkCreateBuffer,
                                                VkBufferCreateInfo{.sType = VK_STRUCTURE_TYPE_BUFFER_CREATE_INFO,
                                                                   .size = VkDeviceSize(4) * width * height,
                                                                   .usage = VK_BUFFER_USAGE_TRANSFER_SRC_BIT});
        vkGetBufferMemoryRequirements(device_, staging, &need);
        const VkDeviceMemory memory =
            memory_for(need, VK_MEMORY_PROPERTY_HOST_VISIBLE_BIT | VK_MEMORY_PROPERTY_HOST_COHERENT_BIT);
        check(vkBindBufferMemory(device_, staging, memory, 0), "vkBindBufferMemory");
        void* bytes = nullptr;
        check(vkMapMemory(device_, memory, 0, VK_WHOLE_SIZE, 0, &bytes), "vkMapMemory");
        std::uint32_t random = 1;
        for (std::uint32_t i = 0; noise && i < width * height; ++i) {
            random = random * 1664525u + 1013904223u;
            const float value = float(random >> 8) / float(1 << 24);
            std::memcpy(static_cast<char*>(bytes) + 4 * i, depth ? static_cast<const void*>(&value) : &random, 4);
        }
        submit([&] {
            const VkImageMemoryBarrier ready{.sType = VK_STRUCTURE_TYPE_IMAGE_MEMORY_BARRIER,
                                             .dstAccessMask = VK_ACCESS_TRANSFER_WRITE_BIT,
                                             .oldLayout = VK_IMAGE_LAYOUT_UNDEFINED,
                                             .newLayout = VK_IMAGE_LAYOUT_GENERAL,
                                             .srcQueueFamilyIndex = VK_QUEUE_FAMILY_IGNORED,
                                             .dstQueueFamilyIndex = VK_QUEUE_FAMILY_IGNORED,
                                             .image = handle,
                                             .subresourceRange = {aspect, 0, 1, 0, layers}};
            vkCmdPipelineBarrier(commands_, VK_PIPELINE_STAGE_TOP_OF_PIPE_BIT, VK_PIPELINE_STAGE_ALL_COMMANDS_BIT, 0, 0,
                                 nullptr, 0, nullptr, 1, &ready);
            const VkBufferImageCopy whole{.imageSubresource = {aspect, 0, 0, 1}, .imageExtent = {width, height, 1}};
            if (noise) vkCmdCopyBufferToImage(commands_, staging, handle, VK_IMAGE_LAYOUT_GENERAL, 1, &whole);
        });
        vkDestroyBuffer(device_, staging, nullptr);
        vkFreeMemory(device_, memory, nullptr);
        return make<VkImageView>(device_, vkCreateImageView,
                                 VkImageViewCreateInfo{.sType = VK_STRUCTURE_TYPE_IMAGE_VIEW_CREATE_INFO,
                                                       .image = handle,
                                                       .viewType = type,
                                                       .format = format,
                                                       .subresourceRange = {aspect, 0, 1, 0, layers}});
    }

    /// The one set of a pool of its own.
    [[nodiscard]] VkDescriptorSet descriptor_set(VkDescriptorSetLayout layout,
                                                 std::initializer_list<VkDescriptorPoolSize> all) const {
        const auto pool =
            make<VkDescriptorPool>(device_, vkCreateDescriptorPool,
                                   VkDescriptorPoolCreateInfo{.sType = VK_STRUCTURE_TYPE_DESCRIPTOR_POOL_CREATE_INFO,
                                                              .maxSets = 1,
                                                              .poolSizeCount = static_cast<std::uint32_t>(all.size()),
                                                              .pPoolSizes = all.begin()});
        return make<VkDescriptorSet>(
            device_, vkAllocateDescriptorSets,
            VkDescriptorSetAllocateInfo{.sType = VK_STRUCTURE_TYPE_DESCRIPTOR_SET_ALLOCATE_INFO,
                                        .descriptorPool = pool,
                                        .descriptorSetCount = 1,
                                        .pSetLayouts = &layout});
    }

    /// Uniforms, all 0; never destroyed.
    [[nodiscard]] VkBuffer uniforms(VkDeviceSize size) const {
        const VkBuffer buffer = make<VkBuffer>(device_, vkCreateBuffer,
                                               VkBufferCreateInfo{.sType = VK_STRUCTURE_TYPE_BUFFER_CREATE_INFO,
                                                                  .size = size,
                                                                  .usage = VK_BUFFER_USAGE_UNIFORM_BUFFER_BIT});
        VkMemoryRequirements need;
        vkGetBufferMemoryRequirements(device_, buffer, &need);
        const VkDeviceMemory memory =
            memory_for(need, VK_MEMORY_PROPERTY_HOST_VISIBLE_BIT | VK_MEMORY_PROPERTY_HOST_COHERENT_BIT);
        check(vkBindBufferMemory(device_, buffer, memory, 0), "vkBindBufferMemory");
        void* bytes = nullptr;
        check(vkMapMemory(device_, memory, 0, VK_WHOLE_SIZE, 0, &bytes), "vkMapMemory");
        std::memset(bytes, 0, size);
        return buffer;
    }

    [[nodiscard]] VkSampler sampler(bool compares) const {
        const VkFilter filter = compares ? VK_FILTER_LINEAR : VK_FILTER_NEAREST;
        const VkSamplerAddressMode edge = VK_SAMPLER_ADDRESS_MODE_CLAMP_TO_EDGE;
        return make<VkSampler>(device_, vkCreateSampler,
                               VkSamplerCreateInfo{.sType = VK_STRUCTURE_TYPE_SAMPLER_CREATE_INFO,
                                                   .magFilter = filter,
                                                   .minFilter = filter,
                                                   .addressModeU = edge,
                                                   .addressModeV = edge,
                                                   .addressModeW = edge,
                                                   .compareEnable = compares,
                                                   .compareOp = VK_COMPARE_OP_LESS_OR_EQUAL});
    }

    VkPhysicalDevice physical_{};
    std::uint32_t family_ = 0;
    VkDevice device_{};
    VkQueue queue_{};
    VkCommandBuffer commands_{};
};

}  // namespace bench
