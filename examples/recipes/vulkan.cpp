// SPDX-License-Identifier: MIT
//
// Vulkan 1.3 with reversed depth: a spot light's map, a sun's cascades in an array under a comparison sampler, a fence
// with holes. Umbrage's part is marked.    vulkan PICTURE.png
#include "vulkan_device.hpp"

#include <cstdio>
#include <exception>

#include <umbrage/umbrage.hpp>

namespace {

namespace glsl = umbrage::glsl;
constexpr std::uint32_t side = 1024;  // side of a map, texels
constexpr vk::Extent2D picture{scene::picture_size.x, scene::picture_size.y};

// Umbrage begins.
constexpr umbrage::clip_space make_clip() {
    umbrage::clip_space clip = umbrage::vulkan_clip_space;
    clip.direction = umbrage::depth_direction::reversed;
    return clip;
}
const umbrage::shadow spot(scene::make_spot(make_clip()), {side, side}, umbrage::filters::tent<3>);
const umbrage::shadow sun(scene::make_cascades(make_clip()), {side, side}, umbrage::filters::tent<3>);
const float cleared = spot.cleared();

const std::string depth_fragment =
    "#version 450\nlayout(location = 2) in vec2 uv;\n" + scene::shading + "void main() { if (is_hole(uv)) discard; }";
std::string view_fragment() {
    return glsl::source(glsl::version::vulkan,
                        {glsl::bind(spot, "spot", {.block = 0, .texture = 1, .map = glsl::texture::depth}),
                         glsl::bind(sun, "sun", {.block = 2, .texture = 3, .map = glsl::texture::shadow_array})}) +
           scene::shading + R"(
        layout(location = 0) in vec3 world;
        layout(location = 1) in vec3 normal;
        layout(location = 2) in vec2 uv;
        layout(location = 0) out vec4 color;
        void main() {
            if (is_hole(uv)) discard;
            color = vec4(shade(world, normal, umbrage_spot(world, normal), umbrage_sun(world, normal)), 1.0);
        })";
}
// Umbrage ends.

}  // namespace

int main(int, char** argv) try {
    glslang::InitializeProcess();
    const vulkan::gpu on;
    on.commands.begin({.flags = vk::CommandBufferUsageFlagBits::eOneTimeSubmit});
    using usage = vk::ImageUsageFlagBits;
    const auto map_usage = usage::eDepthStencilAttachment | usage::eSampled;
    const vulkan::image spot_map(on, vk::Format::eD32Sfloat, {side, side}, 1, map_usage),
        sun_maps(on, vk::Format::eD32Sfloat, {side, side}, 3, map_usage),
        depths(on, vk::Format::eD32Sfloat, picture, 1, usage::eDepthStencilAttachment),
        colors(on, vk::Format::eR8G8B8A8Unorm, picture, 1, usage::eColorAttachment | usage::eTransferSrc);
    const std::vector<scene::vertex> mesh = scene::make_mesh();
    const vulkan::buffer vertices(on, sizeof mesh[0] * mesh.size(), vk::BufferUsageFlagBits::eVertexBuffer),
        pixels(on, 4 * picture.width * picture.height, vk::BufferUsageFlagBits::eTransferDst);
    std::memcpy(vertices.bytes, mesh.data(), sizeof mesh[0] * mesh.size());
    const vulkan::buffer spot_block(on, spot.uniforms()), sun_block(on, sun.uniforms());  // umbrage's bytes

    // Descriptors of the fragment shader: block and map of each shadow
    using type = vk::DescriptorType;
    const auto plain = on.device.createSampler({});
    const auto compares = on.device.createSampler({.compareEnable = true, .compareOp = vk::CompareOp::eGreaterOrEqual});
    const auto spot_view = spot_map.view(vk::ImageViewType::e2D, 0, 1),
               sun_view = sun_maps.view(vk::ImageViewType::e2DArray, 0, 3);
    const std::array blocks{vk::DescriptorBufferInfo{*spot_block.handle, 0, VK_WHOLE_SIZE},
                            vk::DescriptorBufferInfo{*sun_block.handle, 0, VK_WHOLE_SIZE}};
    const std::array maps{vk::DescriptorImageInfo{*plain, *spot_view, vk::ImageLayout::eGeneral},
                          vk::DescriptorImageInfo{*compares, *sun_view, vk::ImageLayout::eGeneral}};
    std::vector<vk::DescriptorSetLayoutBinding> bindings;
    std::vector<vk::WriteDescriptorSet> writes;
    for (std::uint32_t i = 0; i < 4; ++i) {
        const type kind = i % 2 == 0 ? type::eUniformBuffer : type::eCombinedImageSampler;
        bindings.push_back({i, kind, 1, vk::ShaderStageFlagBits::eFragment});
        writes.push_back({.dstBinding = i,
                          .descriptorCount = 1,
                          .descriptorType = kind,
                          .pImageInfo = &maps[i / 2],
                          .pBufferInfo = &blocks[i / 2]});
    }
    const auto set_layout = on.device.createDescriptorSetLayout({.bindingCount = 4, .pBindings = bindings.data()});
    const std::array sizes{vk::DescriptorPoolSize{type::eUniformBuffer, 2},
                           vk::DescriptorPoolSize{type::eCombinedImageSampler, 2}};
    const auto set_pool = on.device.createDescriptorPool({.flags = vk::DescriptorPoolCreateFlagBits::eFreeDescriptorSet,
                                                          .maxSets = 1,
                                                          .poolSizeCount = 2,
                                                          .pPoolSizes = sizes.data()});
    const vk::raii::DescriptorSets sets(
        on.device, {.descriptorPool = *set_pool, .descriptorSetCount = 1, .pSetLayouts = &*set_layout});
    for (vk::WriteDescriptorSet& write : writes) write.dstSet = *sets[0];
    on.device.updateDescriptorSets(writes, nullptr);
    const vk::PushConstantRange matrix{vk::ShaderStageFlagBits::eVertex, 0, sizeof(glm::mat4)};
    const auto layout = on.device.createPipelineLayout({.setLayoutCount = 1,
                                                        .pSetLayouts = &*set_layout,
                                                        .pushConstantRangeCount = 1,
                                                        .pPushConstantRanges = &matrix});
    const auto depth_pass = vulkan::make_pipeline(on, *layout, depth_fragment, false),
               view = vulkan::make_pipeline(on, *layout, view_fragment(), true);

    on.commands.bindVertexBuffers(0, *vertices.handle, vk::DeviceSize(0));
    on.commands.bindDescriptorSets(vk::PipelineBindPoint::eGraphics, *layout, 0, *sets[0], nullptr);
    std::vector<vk::raii::ImageView> targets;  // which live until all is drawn
    const auto draw = [&](const vk::raii::Pipeline& pipeline, const vulkan::image& depth, std::uint32_t layer,
                          vk::Extent2D size, const glm::mat4& to_clip) {
        const auto attach = [&](const vulkan::image& to, vk::ClearValue clear) {
            targets.push_back(to.view(vk::ImageViewType::e2D, to.all.layerCount > 1 ? layer : 0, 1));
            return vk::RenderingAttachmentInfo{.imageView = *targets.back(),
                                               .imageLayout = vk::ImageLayout::eGeneral,
                                               .loadOp = vk::AttachmentLoadOp::eClear,
                                               .storeOp = vk::AttachmentStoreOp::eStore,
                                               .clearValue = clear};
        };
        const auto depth_target = attach(depth, vk::ClearDepthStencilValue{cleared, 0});
        const auto color_target =
            attach(colors, vk::ClearColorValue(std::array{scene::sky.r, scene::sky.g, scene::sky.b, 1.0f}));
        on.commands.beginRendering({.renderArea = {{}, size},
                                    .layerCount = 1,
                                    .colorAttachmentCount = &pipeline == &view,
                                    .pColorAttachments = &color_target,
                                    .pDepthAttachment = &depth_target});
        on.commands.bindPipeline(vk::PipelineBindPoint::eGraphics, *pipeline);
        on.commands.setViewport(0, vk::Viewport{0, 0, float(size.width), float(size.height), 0, 1});
        on.commands.setScissor(0, vk::Rect2D{{}, size});
        on.commands.pushConstants<glm::mat4>(*layout, vk::ShaderStageFlagBits::eVertex, 0, to_clip);
        on.commands.draw(std::uint32_t(mesh.size()), 1, 0, 0);
        on.commands.endRendering();
        on.barrier();
    };
    // Umbrage begins.
    const auto light = spot.setup().lights()[0];
    draw(depth_pass, spot_map, 0, {side, side}, glm::mat4(light.projection * light.view));
    std::uint32_t layer = 0;
    for (const auto& cascade : sun.setup().lights())
        draw(depth_pass, sun_maps, layer++, {side, side}, glm::mat4(cascade.projection * cascade.view));
    // Umbrage ends.
    draw(view, depths, 0, picture, scene::camera_matrix(make_clip()));

    on.commands.copyImageToBuffer(*colors.handle, vk::ImageLayout::eGeneral, *pixels.handle,
                                  vk::BufferImageCopy{.imageSubresource = {colors.all.aspectMask, 0, 0, 1},
                                                      .imageExtent = {picture.width, picture.height, 1}});
    on.barrier();
    on.commands.end();
    on.queue.submit(vk::SubmitInfo{.commandBufferCount = 1, .pCommandBuffers = &*on.commands});
    on.queue.waitIdle();
    const auto* first = static_cast<const glm::u8vec4*>(pixels.bytes);
    scene::write_picture(argv[1], {first, first + picture.width * picture.height}, true);
} catch (const std::exception& error) {
    std::fprintf(stderr, "%s\n", error.what());
    return 1;
}
