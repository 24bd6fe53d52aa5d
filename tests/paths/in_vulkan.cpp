// SPDX-License-Identifier: MIT
//
// Draws paths in Vulkan:  paths_in_vulkan glsl|hlsl PICTURE JOB...
//
// Each job is a frame. PICTURE then holds the visibility of each frame's pixels from above, a byte each.
#include "../../examples/recipes/vulkan_device.hpp"

#include <cstdio>
#include <exception>
#include <string_view>

#include "../parity/backends/spirv.hpp"
#include "vulkan_pipeline.hpp"
#include "vulkan_texts.hpp"

namespace {

using namespace paths;
using usage = vk::ImageUsageFlagBits;

/// What the vertex shader is given.
struct pass_uniforms {
    glm::mat4 to_clip;
    glm::vec4 anchor;
    float number;
};

vk::Format format_of(const job& j, const told& sun) {
    if (is_depth(j)) return j.text("encoding") == "depth16" ? vk::Format::eD16Unorm : vk::Format::eD32Sfloat;
    if (sun.floats) return vk::Format::eR32Sfloat;
    return sun.channels == 2 ? vk::Format::eR8G8Unorm : vk::Format::eR8G8B8A8Unorm;
}

/// Draws frames on one device.
class program {
public:
    program(bool hlsl, std::string picture) : hlsl_(hlsl), picture_(std::move(picture)) {}

    void frame(const job& j) {
        using kind = vk::DescriptorType;
        const told sun = tell(j, umbrage::vulkan_clip_space);
        const vulkan_texts texts = hlsl_ ? in_hlsl(j, sun) : in_glsl(j, sun);
        const bool depth = is_depth(j), layered = is_layered(j), four = j.text("setup") == "tetrahedron_light";
        const glm::ivec2 grid = layered ? glm::ivec2(1) : glm::ivec2(sun.columns, sun.rows);
        const vk::Extent2D size = extent(sun.map_size * grid),
                           shown = extent({int(j.numbers("picture")[0]), int(j.numbers("picture")[1])});
        const std::uint32_t layers = layered ? std::uint32_t(sun.columns * sun.rows) : 1;
        on_.commands.begin({.flags = vk::CommandBufferUsageFlagBits::eOneTimeSubmit});
        const vulkan::image maps(on_, format_of(j, sun), size, layers,
                                 usage::eSampled | (depth ? usage::eDepthStencilAttachment : usage::eColorAttachment)),
            nearest(on_, vk::Format::eD32Sfloat, size, 1, usage::eDepthStencilAttachment),
            depths(on_, vk::Format::eD32Sfloat, shown, 1, usage::eDepthStencilAttachment),
            colors(on_, vk::Format::eR8G8B8A8Unorm, shown, 1, usage::eColorAttachment | usage::eTransferSrc);
        const auto casters = j.vertices("casters"), receivers = j.vertices("receivers");
        const vulkan::buffer of_casters = filled(casters, vk::BufferUsageFlagBits::eVertexBuffer),
                             of_receivers = filled(receivers, vk::BufferUsageFlagBits::eVertexBuffer),
                             block = filled(sun.block, vk::BufferUsageFlagBits::eUniformBuffer),
                             pixels(on_, 4 * shown.width * shown.height, vk::BufferUsageFlagBits::eTransferDst);

        // What the lookup reads: HLSL has a sampler of its own, where it compares
        const auto sampler = on_.device.createSampler(
            {.compareEnable = compares(j),
             .compareOp = is_reversed(j) ? vk::CompareOp::eGreaterOrEqual : vk::CompareOp::eLessOrEqual});
        const auto view = maps.view(layered ? vk::ImageViewType::e2DArray : vk::ImageViewType::e2D, 0, layers);
        const vk::DescriptorBufferInfo bytes{*block.handle, 0, VK_WHOLE_SIZE};
        const vk::DescriptorImageInfo map{*sampler, *view, vk::ImageLayout::eGeneral};
        std::vector<kind> kinds{kind::eUniformBuffer, hlsl_ ? kind::eSampledImage : kind::eCombinedImageSampler};
        if (hlsl_ && compares(j)) kinds.push_back(kind::eSampler);
        std::vector<vk::DescriptorSetLayoutBinding> bindings;
        std::vector<vk::DescriptorPoolSize> sizes;
        for (const kind k : kinds) {
            bindings.push_back({std::uint32_t(bindings.size()), k, 1, vk::ShaderStageFlagBits::eFragment});
            sizes.push_back({k, 1});
        }
        const auto set_layout = on_.device.createDescriptorSetLayout(
            {.bindingCount = std::uint32_t(bindings.size()), .pBindings = bindings.data()});
        const auto set_pool =
            on_.device.createDescriptorPool({.flags = vk::DescriptorPoolCreateFlagBits::eFreeDescriptorSet,
                                             .maxSets = 1,
                                             .poolSizeCount = std::uint32_t(sizes.size()),
                                             .pPoolSizes = sizes.data()});
        const vk::raii::DescriptorSets sets(
            on_.device, {.descriptorPool = *set_pool, .descriptorSetCount = 1, .pSetLayouts = &*set_layout});
        for (const auto& b : bindings)
            on_.device.updateDescriptorSets(vk::WriteDescriptorSet{.dstSet = *sets[0],
                                                                   .dstBinding = b.binding,
                                                                   .descriptorCount = 1,
                                                                   .descriptorType = b.descriptorType,
                                                                   .pImageInfo = &map,
                                                                   .pBufferInfo = &bytes},
                                            nullptr);
        const vk::PushConstantRange pushed{vk::ShaderStageFlagBits::eVertex | vk::ShaderStageFlagBits::eFragment, 0,
                                           sizeof(pass_uniforms)};
        const auto layout = on_.device.createPipelineLayout({.setLayoutCount = 1,
                                                             .pSetLayouts = &*set_layout,
                                                             .pushConstantRangeCount = 1,
                                                             .pPushConstantRanges = &pushed});
        const auto depth_pass = pipeline(
            *layout, texts.depth_vertex, texts.depth_fragment,
            {depth ? vk::Format::eUndefined : maps.format, depth ? maps.format : nearest.format, is_reversed(j)});
        const auto look =
            pipeline(*layout, texts.view_vertex, texts.view_fragment, {colors.format, depths.format, false});
        on_.commands.bindDescriptorSets(vk::PipelineBindPoint::eGraphics, *layout, 0, *sets[0], nullptr);

        const vk::ClearValue at_far = vk::ClearDepthStencilValue{is_reversed(j) ? 0.0f : 1.0f, 0};
        std::uint32_t number = 0;
        for (const umbrage::depth_view& v : sun.views) {
            const int tile = layered || four ? 0 : int(number);
            const glm::ivec2 corner = glm::ivec2(tile % grid.x, tile / grid.x) * sun.map_size;
            draw({.with = depth_pass,
                  .color = depth ? nullptr : &maps,
                  .depth = depth ? maps : nearest,
                  .layer = layered ? number : 0,
                  .clears = number == 0 || layered,
                  .cleared = sun.cleared,
                  .at_far = at_far,
                  .target = size,
                  .area = {{corner.x, corner.y}, extent(sun.map_size)}},
                 *layout, of_casters, casters.size(), {v.to_clip, v.anchor, float(number)});
            ++number;
        }
        draw({.with = look,
              .color = &colors,
              .depth = depths,
              .cleared = {0, 0, 1, 1},
              .at_far = vk::ClearDepthStencilValue{1.0f, 0},
              .target = shown,
              .area = {{}, shown}},
             *layout, of_receivers, receivers.size(), {glm::mat4(j.matrix("to_clip")), {}, 0});
        on_.commands.copyImageToBuffer(*colors.handle, vk::ImageLayout::eGeneral, *pixels.handle,
                                       vk::BufferImageCopy{.imageSubresource = {colors.all.aspectMask, 0, 0, 1},
                                                           .imageExtent = {shown.width, shown.height, 1}});
        on_.barrier();
        on_.commands.end();
        on_.queue.submit(vk::SubmitInfo{.commandBufferCount = 1, .pCommandBuffers = &*on_.commands});
        on_.queue.waitIdle();
        drawn_into_.clear();
        write(static_cast<const unsigned char*>(pixels.bytes), shown);
    }

private:
    /// Where something is drawn.
    struct pass {
        const vk::raii::Pipeline& with;
        const vulkan::image* color;
        const vulkan::image& depth;
        std::uint32_t layer = 0;
        bool clears = true;
        glm::vec4 cleared;
        vk::ClearValue at_far;
        vk::Extent2D target;
        vk::Rect2D area;
    };
    void draw(const pass& p, vk::PipelineLayout layout, const vulkan::buffer& vertices, std::size_t floats,
              const pass_uniforms& given) {
        const auto attach = [&](const vulkan::image& to, vk::ClearValue clear) {
            drawn_into_.push_back(to.view(vk::ImageViewType::e2D, to.all.layerCount > 1 ? p.layer : 0, 1));
            return vk::RenderingAttachmentInfo{
                .imageView = *drawn_into_.back(),
                .imageLayout = vk::ImageLayout::eGeneral,
                .loadOp = p.clears ? vk::AttachmentLoadOp::eClear : vk::AttachmentLoadOp::eLoad,
                .storeOp = vk::AttachmentStoreOp::eStore,
                .clearValue = clear};
        };
        const auto depth = attach(p.depth, p.at_far);
        vk::RenderingAttachmentInfo color;
        const glm::vec4 c = p.cleared;
        if (p.color != nullptr) color = attach(*p.color, vk::ClearColorValue(std::array{c.r, c.g, c.b, c.a}));
        on_.commands.beginRendering({.renderArea = {{}, p.target},
                                     .layerCount = 1,
                                     .colorAttachmentCount = p.color != nullptr,
                                     .pColorAttachments = &color,
                                     .pDepthAttachment = &depth});
        on_.commands.bindPipeline(vk::PipelineBindPoint::eGraphics, *p.with);
        on_.commands.bindVertexBuffers(0, *vertices.handle, vk::DeviceSize(0));
        on_.commands.setViewport(0, vk::Viewport{float(p.area.offset.x), float(p.area.offset.y),
                                                 float(p.area.extent.width), float(p.area.extent.height), 0, 1});
        on_.commands.setScissor(0, p.area);
        on_.commands.pushConstants<pass_uniforms>(
            layout, vk::ShaderStageFlagBits::eVertex | vk::ShaderStageFlagBits::eFragment, 0, given);
        on_.commands.draw(std::uint32_t(floats / 2), 1, 0, 0);
        on_.commands.endRendering();
        on_.barrier();
    }
    static vk::Extent2D extent(glm::ivec2 size) { return {std::uint32_t(size.x), std::uint32_t(size.y)}; }
    template <class T>
    [[nodiscard]] vulkan::buffer filled(const std::vector<T>& from, vk::BufferUsageFlags flags) const {
        vulkan::buffer made(on_, from.size() * sizeof(T), flags);
        std::memcpy(made.bytes, from.data(), from.size() * sizeof(T));
        return made;
    }
    void write(const unsigned char* pixels, vk::Extent2D size) const {
        std::ofstream file(picture_, std::ios::binary | std::ios::app);
        for (std::uint32_t y = size.height; y-- > 0;)  // as OpenGL's, its first row is below
            for (std::uint32_t x = 0; x < size.width; ++x) file.put(char(pixels[4 * (y * size.width + x)]));
        if (!file) throw std::runtime_error("cannot write " + picture_);
    }
    [[nodiscard]] vk::raii::Pipeline pipeline(vk::PipelineLayout layout, const std::string& vertex,
                                              const std::string& fragment, const targets_of& to) const {
        const auto module = [&](const char* stage, const std::string& text) {
            const auto code =
                compiler_.compile(stage, text, hlsl_ ? parity::spirv_compiler::hlsl : parity::spirv_compiler::glsl);
            return vk::raii::ShaderModule(
                on_.device, vk::ShaderModuleCreateInfo{.codeSize = 4 * code.size(), .pCode = code.data()});
        };
        const auto vertex_module = module("vert", vertex), fragment_module = module("frag", fragment);
        return make_pipeline(on_.device, layout, *vertex_module, *fragment_module, to);
    }

    vulkan::gpu on_;
    parity::spirv_compiler compiler_;
    std::vector<vk::raii::ImageView> drawn_into_;  ///< which live until all is drawn
    bool hlsl_;
    std::string picture_;
};

}  // namespace

int main(int argc, char** argv) try {
    program draws(std::string_view(argv[1]) == "hlsl", argv[2]);
    for (int i = 3; i < argc; ++i) draws.frame(job(argv[i]));
} catch (const std::exception& error) {
    std::fprintf(stderr, "%s\n", error.what());
    return std::string_view(error.what()).starts_with("SKIPPED") ? 77 : 1;
}
