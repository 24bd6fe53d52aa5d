// SPDX-License-Identifier: MIT
//
// Vulkan without a window; SPIR-V from the reference compiler, or of WGSL from naga. A device that cannot draw runs
// compute shaders.
#include <algorithm>
#include <array>
#include <cstddef>
#include <cstdint>
#include <cstdlib>
#include <cstring>
#include <exception>
#include <iostream>
#include <memory>
#include <string>
#include <utility>
#include <vector>

#include "../backend.hpp"
#include "child.hpp"
#include "../shader.hpp"
#include "spirv.hpp"
#include "../texture.hpp"
#include "vulkan_device.hpp"
#include "vulkan_pipeline.hpp"

namespace parity {
namespace {

struct render_target {
    vk::Format format;
    vk::raii::RenderPass pass = nullptr;
    picture color{};
    vk::raii::Framebuffer frame = nullptr;
};

class vulkan final : public backend, vulkan_device {
public:
    /// @param draws   false: in compute shaders even where it can
    /// @param naga    what compiles WGSL; empty: the others
    vulkan(vk::raii::PhysicalDevice physical, bool draws, std::unique_ptr<child> naga)
        : vulkan_device(std::move(physical), draws), naga_(std::move(naga)) {
        using type = vk::DescriptorType;
        const vk::ShaderStageFlags stages =
            draws_ ? vk::ShaderStageFlagBits::eFragment : vk::ShaderStageFlagBits::eCompute;
        std::vector<vk::DescriptorSetLayoutBinding> bindings;
        for (std::uint32_t i = 0; i < max_bindings; ++i)
            bindings.push_back({.binding = i,
                                .descriptorType = i < max_textures ? type::eCombinedImageSampler : type::eSampler,
                                .descriptorCount = 1,
                                .stageFlags = stages});
        if (!draws_)
            bindings.push_back({.binding = target_binding,
                                .descriptorType = type::eStorageImage,
                                .descriptorCount = 1,
                                .stageFlags = stages});
        set_layout_ = {device_,
                       vk::DescriptorSetLayoutCreateInfo{.bindingCount = static_cast<std::uint32_t>(bindings.size()),
                                                         .pBindings = bindings.data()}};
        layout_ = {device_, vk::PipelineLayoutCreateInfo{.setLayoutCount = 1, .pSetLayouts = &*set_layout_}};
        const std::array sizes{vk::DescriptorPoolSize{type::eCombinedImageSampler, max_textures},
                               vk::DescriptorPoolSize{type::eSampler, max_bindings - max_textures},
                               vk::DescriptorPoolSize{type::eStorageImage, 1}};
        set_pool_ = {device_,
                     vk::DescriptorPoolCreateInfo{.flags = vk::DescriptorPoolCreateFlagBits::eFreeDescriptorSet,
                                                  .maxSets = 1,
                                                  .poolSizeCount = sizes.size(),
                                                  .pPoolSizes = sizes.data()}};
        set_ = std::move(
            vk::raii::DescriptorSets(
                device_, {.descriptorPool = *set_pool_, .descriptorSetCount = 1, .pSetLayouts = &*set_layout_})
                .front());
        for (std::size_t unit = 0; unit < textures_.size(); ++unit)
            upload({unit, {.size = {1, 1}}, {vec4(0.0f)}});  // all must be there
        const float corners[] = {-1, -1, 3, -1, -1, 3};
        reserve(corners_, sizeof corners);
        std::memcpy(corners_.mapped, corners, sizeof corners);
        if (!draws_) return;
        for (render_target& t : targets_) t.pass = make_pass(device_, t.format);
    }

    [[nodiscard]] std::string name() const override {
        const std::string device = physical_.getProperties().deviceName.data();
        if (naga_) return "naga (" + device + ")";
        const std::string how = draws_ ? "" : ", computing";
        return device.starts_with("llvmpipe") ? "lavapipe" + how + " (" + device + ")"
                                              : "Vulkan on " + device + how;  // not OpenGL's own, nor WebGL's
    }
    [[nodiscard]] identity about(dialect) const override {
        const vk::PhysicalDeviceProperties of = physical_.getProperties();
        const auto number = [](std::uint32_t v) {
            return std::to_string(VK_API_VERSION_MAJOR(v)) + '.' + std::to_string(VK_API_VERSION_MINOR(v)) + '.' +
                   std::to_string(VK_API_VERSION_PATCH(v));
        };
        identity i{draws_ ? "Vulkan" : "Vulkan compute", number(of.apiVersion), of.deviceName.data(),
                   std::to_string(of.driverVersion)};
        if (of.apiVersion >= VK_API_VERSION_1_2) {
            using driver = vk::PhysicalDeviceDriverProperties;
            const auto chain = physical_.getProperties2<vk::PhysicalDeviceProperties2, driver>();
            i.driver = std::string(chain.get<driver>().driverName) + ' ' + std::string(chain.get<driver>().driverInfo);
        }
        return i;
    }
    [[nodiscard]] std::vector<dialect> dialects() const override {
        if (naga_) return {dialect::wgsl};
        return {version::vulkan, dialect::hlsl};
    }
    [[nodiscard]] std::string label(dialect d) const override {
        return d == version::vulkan ? "Vulkan" : parity::name(d);
    }
    [[nodiscard]] std::string obstacle(const entry& e) const override {
        if (!has_graphics() && std::ranges::any_of(e.bound, &bound_map::has_depths))
            return "a Vulkan queue without graphics cannot fill a depth texture";
        const auto limit = physical_.getProperties().limits.maxImageDimension2D;
        if (e.table.size().x <= static_cast<int>(limit)) return "";
        return "its table is wider than " + std::to_string(limit) + " texels";
    }

    [[nodiscard]] std::vector<vec4> run(dialect d, const job& j, std::size_t count) override {
        const int height = rows(j.count);
        const bool bytes = j.what->output == target::rgba8;
        render_target& t = targets_[bytes ? 1 : 0];
        if (t.color.what.size.y != height) {
            using use = vk::ImageUsageFlagBits;
            t.frame = nullptr;
            t.color = make_picture(t.format, {.size = {width, height}},
                                   (draws_ ? use::eColorAttachment : use::eStorage) | use::eTransferSrc);
            if (draws_)
                t.frame = {device_, vk::FramebufferCreateInfo{.renderPass = *t.pass,
                                                              .attachmentCount = 1,
                                                              .pAttachments = &*t.color.view,
                                                              .width = width,
                                                              .height = static_cast<std::uint32_t>(height),
                                                              .layers = 1}};
        }
        if (serial_ != j.serial) send(j);
        if (entry_ != j.what || dialect_ != d) {
            pipeline_ = make_pipeline(*j.what, d, *t.pass);
            entry_ = j.what, dialect_ = d;
        }
        if (!draws_)  // the set has one target at a time
            describe(target_binding, vk::DescriptorType::eStorageImage,
                     {.imageView = *t.color.view, .imageLayout = vk::ImageLayout::eGeneral});

        const std::size_t size = static_cast<std::size_t>(width * height) * (bytes ? 4 : sizeof(vec4));
        reserve(staging_, size);
        submit([&] {
            if (draws_) draw(t, height);
            else compute(height);
            barrier();
            commands_.copyImageToBuffer(*t.color.image, vk::ImageLayout::eGeneral, *staging_.handle,
                                        whole(t.color.what));
        });
        std::vector<vec4> result(count);
        if (bytes) {
            const auto* read = static_cast<const glm::vec<4, std::uint8_t>*>(staging_.mapped);
            std::copy(read, read + count, result.begin());
        } else {
            std::memcpy(result.data(), staging_.mapped, count * sizeof(vec4));
        }
        return result;
    }

private:
    void draw(const render_target& t, int height) {
        const vk::Extent2D extent{width, static_cast<std::uint32_t>(height)};
        commands_.beginRenderPass({.renderPass = *t.pass, .framebuffer = *t.frame, .renderArea = {{0, 0}, extent}},
                                  vk::SubpassContents::eInline);
        commands_.bindPipeline(vk::PipelineBindPoint::eGraphics, *pipeline_);
        commands_.setViewport(0, vk::Viewport{0, 0, static_cast<float>(width), static_cast<float>(height), 0, 1});
        commands_.setScissor(0, vk::Rect2D{{0, 0}, extent});
        commands_.bindDescriptorSets(vk::PipelineBindPoint::eGraphics, *layout_, 0, *set_, nullptr);
        commands_.bindVertexBuffers(0, *corners_.handle, vk::DeviceSize(0));
        commands_.draw(3, 1, 0, 0);
        commands_.endRenderPass();
    }

    void compute(int height) {
        constexpr auto point = vk::PipelineBindPoint::eCompute;
        commands_.bindPipeline(point, *pipeline_);
        commands_.bindDescriptorSets(point, *layout_, 0, *set_, nullptr);
        commands_.dispatch(width / group_width, static_cast<std::uint32_t>(height), 1);
    }

    void describe(std::size_t binding, vk::DescriptorType type, const vk::DescriptorImageInfo& image) {
        device_.updateDescriptorSets(vk::WriteDescriptorSet{.dstSet = *set_,
                                                            .dstBinding = static_cast<std::uint32_t>(binding),
                                                            .descriptorCount = 1,
                                                            .descriptorType = type,
                                                            .pImageInfo = &image},
                                     nullptr);
    }

    void upload(const filled_texture& t) {
        picture& p = textures_[t.unit];
        const texture_image& image = t.image;
        if (p.what != image) {
            constexpr std::array formats{vk::Format::eR32G32B32A32Sfloat, vk::Format::eR32G32B32A32Uint,
                                         vk::Format::eD32Sfloat, vk::Format::eD16Unorm, vk::Format::eR8G8B8A8Unorm};
            p = make_picture(formats[image.format], image,
                             vk::ImageUsageFlagBits::eSampled | vk::ImageUsageFlagBits::eTransferDst);
            const vk::Filter filter = image.linear ? vk::Filter::eLinear : vk::Filter::eNearest;
            const vk::CompareOp operations[] = {vk::CompareOp::eNever, vk::CompareOp::eLessOrEqual,
                                                vk::CompareOp::eGreaterOrEqual};
            p.sampler = {device_, vk::SamplerCreateInfo{.magFilter = filter,
                                                        .minFilter = filter,
                                                        .addressModeU = vk::SamplerAddressMode::eClampToEdge,
                                                        .addressModeV = vk::SamplerAddressMode::eClampToEdge,
                                                        .compareEnable = image.compare != texture_image::none,
                                                        .compareOp = operations[image.compare]}};
            const vk::DescriptorImageInfo sampled{*p.sampler, *p.view, vk::ImageLayout::eGeneral};
            describe(t.unit, vk::DescriptorType::eCombinedImageSampler, sampled);
            if (t.unit >= max_inputs) describe(sampler_binding(t.unit), vk::DescriptorType::eSampler, sampled);
        }
        const std::string bytes = t.bytes();
        reserve(staging_, bytes.size());
        std::memcpy(staging_.mapped, bytes.data(), bytes.size());
        submit(
            [&] { commands_.copyBufferToImage(*staging_.handle, *p.image, vk::ImageLayout::eGeneral, whole(image)); });
    }

    void send(const job& j) {
        for (const filled_texture& t : textures(j)) upload(t);
        serial_ = j.serial;
    }

    [[nodiscard]] std::vector<std::uint32_t> compile(dialect d, const std::string& source) const {
        if (d != dialect::wgsl)
            return compiler_.compile(draws_ ? "frag" : "comp", source,
                                     d == dialect::hlsl ? spirv_compiler::hlsl : spirv_compiler::glsl);
        const std::string module = naga_->answer(source);
        std::vector<std::uint32_t> code(module.size() / 4);
        std::memcpy(code.data(), module.data(), module.size());
        return code;
    }

    [[nodiscard]] vk::raii::ShaderModule make_module(const std::vector<std::uint32_t>& code) const {
        return {device_, vk::ShaderModuleCreateInfo{.codeSize = code.size() * 4, .pCode = code.data()}};
    }

    [[nodiscard]] vk::raii::Pipeline make_pipeline(const entry& e, dialect d, vk::RenderPass pass) {
        const shader_stage of = draws_ ? shader_stage::fragment : shader_stage::compute;
        const auto module = make_module(compile(d, make_shader(e, d, of).fragment));
        if (!draws_) return make_computing(device_, *layout_, *module);
        if (!*vertex_)  // the same for all
            vertex_ = make_module(compiler_.compile("vert", make_shader(e, version::vulkan).vertex));
        return make_drawing(device_, *layout_, pass, *vertex_, *module);
    }

    spirv_compiler compiler_;
    std::unique_ptr<child> naga_;
    vk::raii::DescriptorSetLayout set_layout_ = nullptr;
    vk::raii::PipelineLayout layout_ = nullptr;
    vk::raii::DescriptorPool set_pool_ = nullptr;
    vk::raii::DescriptorSet set_ = nullptr;
    buffer corners_, staging_;
    std::array<picture, max_textures> textures_;
    std::array<render_target, 2> targets_{{{vk::Format::eR32G32B32A32Sfloat}, {vk::Format::eR8G8B8A8Unorm}}};
    vk::raii::ShaderModule vertex_ = nullptr;
    vk::raii::Pipeline pipeline_ = nullptr;
    const entry* entry_ = nullptr;
    dialect dialect_ = version::vulkan;
    std::uint64_t serial_ = ~std::uint64_t(0);
};

/// @param naga   the command that compiles WGSL; empty: the other languages
backends devices(std::string_view driver, const std::vector<std::string>& naga) {
    setenv("MESA_SHADER_CACHE_DISABLE", "true", 1);
    backends all;
    if (!spirv_compiler::is_here()) return all;
    if (driver == "swiftshader_vulkan" && !all_exist({UMBRAGE_SWIFTSHADER})) return all;
    if (driver == "swiftshader_vulkan") setenv("VK_ICD_FILENAMES", UMBRAGE_SWIFTSHADER, 1);
    try {
        static const vk::raii::Context context;  // devices need it and the instance to the end
        const vk::ApplicationInfo application{.apiVersion = context.enumerateInstanceVersion()};
        static const vk::raii::Instance instance(context, vk::InstanceCreateInfo{.pApplicationInfo = &application});
        for (vk::raii::PhysicalDevice& device : vk::raii::PhysicalDevices(instance)) {
            const vk::PhysicalDeviceProperties of = device.getProperties();
            if ((of.deviceType == vk::PhysicalDeviceType::eCpu) != (driver != "hardware")) continue;
            try {
                all.push_back(std::make_unique<vulkan>(std::move(device), driver != "lavapipe_compute",
                                                       naga.empty() ? nullptr : std::make_unique<child>(naga)));
            } catch (const std::exception& error) {  // others may do
                std::cerr << of.deviceName.data() << " is left out: " << error.what() << '\n';
            }
        }
    } catch (const std::exception&) {  // no loader, no driver, no device: nothing to run on
    }
    return all;
}

}  // namespace

backends vulkan_backends(std::string_view driver) { return devices(driver, {}); }

backends naga_backends(const naga_files& f) {
    if (!all_exist({f.node, f.script, f.modules / "naga-wasm"})) return {};
    return devices("lavapipe", {f.node, f.script, f.modules});
}

}  // namespace parity
