// SPDX-License-Identifier: MIT
//
// A Vulkan device with one queue: memory, images, and commands that are waited for. Speed is no aim.
#pragma once

#define VULKAN_HPP_NO_STRUCT_CONSTRUCTORS
#include <vulkan/vulkan_raii.hpp>

#include <array>
#include <cstddef>
#include <cstdint>
#include <optional>
#include <stdexcept>
#include <utility>

#include "../texture.hpp"

namespace parity {

/// Every image is in the layout `general` from its making on.
struct picture {
    texture_image what{};
    vk::raii::DeviceMemory memory = nullptr;
    vk::raii::Image image = nullptr;
    vk::raii::ImageView view = nullptr;
    vk::raii::Sampler sampler = nullptr;
};

struct buffer {
    std::size_t size = 0;
    void* mapped = nullptr;
    vk::raii::DeviceMemory memory = nullptr;
    vk::raii::Buffer handle = nullptr;
};

class vulkan_device {
public:
    /// @param draws   with a queue that draws, where the device has one; else one that computes
    vulkan_device(vk::raii::PhysicalDevice physical, bool draws)
        : physical_(std::move(physical)),
          draws_(draws && family_with(vk::QueueFlagBits::eGraphics)),
          family_(family_with(draws_ ? vk::QueueFlagBits::eGraphics : vk::QueueFlagBits::eCompute).value()),
          device_(make_device()),
          queue_(device_, family_, 0),
          pool_(device_, {.flags = vk::CommandPoolCreateFlagBits::eResetCommandBuffer, .queueFamilyIndex = family_}),
          commands_(
              std::move(vk::raii::CommandBuffers(device_, {.commandPool = *pool_, .commandBufferCount = 1}).front())) {}

protected:
    /// At least `size` bytes that both sides see.
    void reserve(buffer& b, std::size_t size) const {
        if (b.size >= size) return;
        using usage = vk::BufferUsageFlagBits;
        b.handle = {device_,
                    vk::BufferCreateInfo{.size = size,
                                         .usage = usage::eTransferSrc | usage::eTransferDst | usage::eVertexBuffer}};
        b.memory = allocate(b.handle.getMemoryRequirements(),
                            vk::MemoryPropertyFlagBits::eHostVisible | vk::MemoryPropertyFlagBits::eHostCoherent);
        b.handle.bindMemory(*b.memory, 0);
        b.mapped = b.memory.mapMemory(0, VK_WHOLE_SIZE);
        b.size = size;
    }

    void barrier() {
        using stage = vk::PipelineStageFlagBits;
        using access = vk::AccessFlagBits;
        commands_.pipelineBarrier(stage::eAllCommands, stage::eAllCommands | stage::eHost, {},
                                  vk::MemoryBarrier{.srcAccessMask = access::eMemoryWrite,
                                                    .dstAccessMask = access::eMemoryRead | access::eMemoryWrite},
                                  nullptr, nullptr);
    }

    template <class Record>
    void submit(Record record) {
        commands_.begin({.flags = vk::CommandBufferUsageFlagBits::eOneTimeSubmit});
        record();
        barrier();
        commands_.end();
        queue_.submit(vk::SubmitInfo{.commandBufferCount = 1, .pCommandBuffers = &*commands_});
        queue_.waitIdle();
    }

    [[nodiscard]] bool has_graphics() const { return has(family_, vk::QueueFlagBits::eGraphics); }

    static vk::ImageAspectFlagBits aspect(const texture_image& what) {
        return what.has_depths() ? vk::ImageAspectFlagBits::eDepth : vk::ImageAspectFlagBits::eColor;
    }

    static vk::BufferImageCopy whole(const texture_image& what) {
        return {.imageSubresource = {aspect(what), 0, 0, static_cast<std::uint32_t>(what.layers)},
                .imageExtent = {static_cast<std::uint32_t>(what.size.x), static_cast<std::uint32_t>(what.size.y), 1}};
    }

    [[nodiscard]] picture make_picture(vk::Format format, const texture_image& what, vk::ImageUsageFlags usage) {
        const auto layers = static_cast<std::uint32_t>(what.layers);
        const vk::ImageSubresourceRange all{aspect(what), 0, 1, 0, layers};
        const bool cube = what.shape == texture_image::cube;
        using view = vk::ImageViewType;
        picture p;
        p.what = what;
        p.image = {device_, vk::ImageCreateInfo{
                                .flags = cube ? vk::ImageCreateFlagBits::eCubeCompatible : vk::ImageCreateFlags(),
                                .imageType = vk::ImageType::e2D,
                                .format = format,
                                .extent = whole(what).imageExtent,
                                .mipLevels = 1,
                                .arrayLayers = layers,
                                .usage = usage}};
        p.memory = allocate(p.image.getMemoryRequirements(), vk::MemoryPropertyFlagBits::eDeviceLocal);
        p.image.bindMemory(*p.memory, 0);
        p.view = {device_,
                  vk::ImageViewCreateInfo{.image = *p.image,
                                          .viewType = std::array{view::e2D, view::e2DArray, view::eCube}[what.shape],
                                          .format = format,
                                          .subresourceRange = all}};
        submit([&] {
            using stage = vk::PipelineStageFlagBits;
            commands_.pipelineBarrier(stage::eTopOfPipe, stage::eAllCommands, {}, nullptr, nullptr,
                                      vk::ImageMemoryBarrier{.dstAccessMask = vk::AccessFlagBits::eMemoryWrite,
                                                             .newLayout = vk::ImageLayout::eGeneral,
                                                             .image = *p.image,
                                                             .subresourceRange = all});
        });
        return p;
    }

    vk::raii::PhysicalDevice physical_;
    bool draws_;
    std::uint32_t family_;
    vk::raii::Device device_;
    vk::raii::Queue queue_;
    vk::raii::CommandPool pool_;
    vk::raii::CommandBuffer commands_;

private:
    [[nodiscard]] bool has(std::uint32_t family, vk::QueueFlagBits ability) const {
        return bool(physical_.getQueueFamilyProperties()[family].queueFlags & ability);
    }
    [[nodiscard]] std::optional<std::uint32_t> family_with(vk::QueueFlagBits ability) const {
        const std::size_t count = physical_.getQueueFamilyProperties().size();
        for (std::uint32_t i = 0; i < count; ++i)
            if (has(i, ability)) return i;
        return {};
    }

    [[nodiscard]] vk::raii::Device make_device() const {
        const float priority = 1.0f;
        const vk::DeviceQueueCreateInfo queue{
            .queueFamilyIndex = family_, .queueCount = 1, .pQueuePriorities = &priority};
        return {physical_, vk::DeviceCreateInfo{.queueCreateInfoCount = 1, .pQueueCreateInfos = &queue}};
    }

    [[nodiscard]] vk::raii::DeviceMemory allocate(vk::MemoryRequirements need, vk::MemoryPropertyFlags flags) const {
        const auto all = physical_.getMemoryProperties();
        for (std::uint32_t i = 0; i < all.memoryTypeCount; ++i)
            if ((need.memoryTypeBits >> i & 1) && (all.memoryTypes[i].propertyFlags & flags) == flags)
                return {device_, vk::MemoryAllocateInfo{.allocationSize = need.size, .memoryTypeIndex = i}};
        throw std::runtime_error("no Vulkan memory of the kind needed");
    }
};

}  // namespace parity
