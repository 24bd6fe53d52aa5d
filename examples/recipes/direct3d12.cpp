// SPDX-License-Identifier: MIT
//
// Direct3D 12, compiled and not run: draws and binds a spot light's map and a sun's cascades, all under comparison
// samplers. Your engine brings device, command list, heaps and swap chain.
#include <d3d12.h>

#include <array>
#include <cstring>

#include "shaders.hpp"

using shaders::spot, shaders::sun;
constexpr UINT side = 1024;  // side of a map, texels

/// Root parameters: 0 the matrix of a pass (b2), 1 and 2 the blocks (b0, b1), 3 the maps (t0, t1); samplers s0, s1.
ID3D12RootSignature* make_root_signature(ID3D12Device* device) {
    const D3D12_DESCRIPTOR_RANGE maps{D3D12_DESCRIPTOR_RANGE_TYPE_SRV, 2, 0, 0, 0};
    std::array<D3D12_ROOT_PARAMETER, 4> parameters{};
    parameters[0].ParameterType = D3D12_ROOT_PARAMETER_TYPE_32BIT_CONSTANTS;
    parameters[0].Constants = {2, 0, 16};
    for (const UINT block : {0u, 1u}) {
        parameters[block + 1].ParameterType = D3D12_ROOT_PARAMETER_TYPE_CBV;
        parameters[block + 1].Descriptor = {block, 0};
    }
    parameters[3].ParameterType = D3D12_ROOT_PARAMETER_TYPE_DESCRIPTOR_TABLE;
    parameters[3].DescriptorTable = {1, &maps};
    std::array<D3D12_STATIC_SAMPLER_DESC, 2> samplers{};
    for (const UINT i : {0u, 1u}) {
        samplers[i].Filter = D3D12_FILTER_COMPARISON_MIN_MAG_MIP_POINT;
        samplers[i].AddressU = samplers[i].AddressV = samplers[i].AddressW = D3D12_TEXTURE_ADDRESS_MODE_CLAMP;
        samplers[i].ComparisonFunc = D3D12_COMPARISON_FUNC_LESS_EQUAL;  // reversed depth: GREATER_EQUAL
        samplers[i].ShaderRegister = i;
    }
    const D3D12_ROOT_SIGNATURE_DESC all{UINT(parameters.size()), parameters.data(), UINT(samplers.size()),
                                        samplers.data(), D3D12_ROOT_SIGNATURE_FLAG_ALLOW_INPUT_ASSEMBLER_INPUT_LAYOUT};
    ID3DBlob *text = nullptr, *errors = nullptr;
    ID3D12RootSignature* made = nullptr;
    if (FAILED(D3D12SerializeRootSignature(&all, D3D_ROOT_SIGNATURE_VERSION_1, &text, &errors))) return nullptr;
    device->CreateRootSignature(0, text->GetBufferPointer(), text->GetBufferSize(), IID_PPV_ARGS(&made));
    return made;
}

/// Pipeline of the depth passes; that of the picture has your render target and the entry point `color`.
D3D12_GRAPHICS_PIPELINE_STATE_DESC describe_depth_pass(ID3D12RootSignature* root, D3D12_SHADER_BYTECODE place,
                                                       D3D12_SHADER_BYTECODE depth) {
    static const D3D12_INPUT_ELEMENT_DESC elements[]{
        {"POSITION", 0, DXGI_FORMAT_R32G32B32_FLOAT, 0, 0, D3D12_INPUT_CLASSIFICATION_PER_VERTEX_DATA, 0},
        {"NORMAL", 0, DXGI_FORMAT_R32G32B32_FLOAT, 0, 12, D3D12_INPUT_CLASSIFICATION_PER_VERTEX_DATA, 0},
        {"TEXCOORD", 0, DXGI_FORMAT_R32G32_FLOAT, 0, 24, D3D12_INPUT_CLASSIFICATION_PER_VERTEX_DATA, 0}};
    D3D12_GRAPHICS_PIPELINE_STATE_DESC all{};
    all.pRootSignature = root, all.VS = place, all.PS = depth;
    all.InputLayout = {elements, 3};
    all.PrimitiveTopologyType = D3D12_PRIMITIVE_TOPOLOGY_TYPE_TRIANGLE, all.DSVFormat = DXGI_FORMAT_D32_FLOAT;
    all.SampleMask = ~0u, all.SampleDesc.Count = 1;
    all.RasterizerState = {
        .FillMode = D3D12_FILL_MODE_SOLID, .CullMode = D3D12_CULL_MODE_NONE, .DepthClipEnable = TRUE};
    all.DepthStencilState = {.DepthEnable = TRUE,
                             .DepthWriteMask = D3D12_DEPTH_WRITE_MASK_ALL,
                             .DepthFunc = D3D12_COMPARISON_FUNC_LESS};  // reversed depth: GREATER
    return all;
}

/// A map: typeless, as the depth pass writes depths and the shader reads floats.
ID3D12Resource* make_map(ID3D12Device* device, UINT16 layers) {
    const D3D12_HEAP_PROPERTIES heap{.Type = D3D12_HEAP_TYPE_DEFAULT};
    const D3D12_RESOURCE_DESC what{.Dimension = D3D12_RESOURCE_DIMENSION_TEXTURE2D,
                                   .Width = side,
                                   .Height = side,
                                   .DepthOrArraySize = layers,
                                   .MipLevels = 1,
                                   .Format = DXGI_FORMAT_R32_TYPELESS,
                                   .SampleDesc = {1, 0},
                                   .Flags = D3D12_RESOURCE_FLAG_ALLOW_DEPTH_STENCIL};
    const D3D12_CLEAR_VALUE cleared{.Format = DXGI_FORMAT_D32_FLOAT, .DepthStencil = {spot.cleared(), 0}};
    ID3D12Resource* made = nullptr;
    device->CreateCommittedResource(&heap, D3D12_HEAP_FLAG_NONE, &what, D3D12_RESOURCE_STATE_DEPTH_WRITE, &cleared,
                                    IID_PPV_ARGS(&made));
    return made;
}

/// Views: one to draw for each map from `drawn` on, two to read from `read` on.
void make_views(ID3D12Device* device, ID3D12Resource* spot_map, ID3D12Resource* sun_maps,
                D3D12_CPU_DESCRIPTOR_HANDLE drawn, D3D12_CPU_DESCRIPTOR_HANDLE read) {
    for (UINT i = 0; i < 4; ++i) {
        D3D12_DEPTH_STENCIL_VIEW_DESC one{.Format = DXGI_FORMAT_D32_FLOAT,
                                          .ViewDimension = D3D12_DSV_DIMENSION_TEXTURE2DARRAY};
        one.Texture2DArray = {0, i == 0 ? 0 : i - 1, 1};
        device->CreateDepthStencilView(i == 0 ? spot_map : sun_maps, &one, drawn);
        drawn.ptr += device->GetDescriptorHandleIncrementSize(D3D12_DESCRIPTOR_HEAP_TYPE_DSV);
    }
    D3D12_SHADER_RESOURCE_VIEW_DESC all{.Format = DXGI_FORMAT_R32_FLOAT,
                                        .ViewDimension = D3D12_SRV_DIMENSION_TEXTURE2D,
                                        .Shader4ComponentMapping = D3D12_DEFAULT_SHADER_4_COMPONENT_MAPPING};
    all.Texture2D.MipLevels = 1;
    device->CreateShaderResourceView(spot_map, &all, read);
    read.ptr += device->GetDescriptorHandleIncrementSize(D3D12_DESCRIPTOR_HEAP_TYPE_CBV_SRV_UAV);
    all.ViewDimension = D3D12_SRV_DIMENSION_TEXTURE2DARRAY;
    all.Texture2DArray = {0, 1, 0, 3, 0, 0};
    device->CreateShaderResourceView(sun_maps, &all, read);
}

/// A frame's shadows: blocks into mapped upload buffers, then the maps. The picture follows, with root parameters 1 to
/// 3 set, behind barriers from DEPTH_WRITE to PIXEL_SHADER_RESOURCE.
void draw_shadows(ID3D12Device* device, ID3D12GraphicsCommandList* list, D3D12_CPU_DESCRIPTOR_HANDLE drawn,
                  void* spot_bytes, void* sun_bytes, UINT vertices) {
    const auto upload = [](void* to, const auto& block) { std::memcpy(to, &block, sizeof block); };
    upload(spot_bytes, spot.uniforms()), upload(sun_bytes, sun.uniforms());
    const D3D12_VIEWPORT whole{0, 0, side, side, 0, 1};  // and the scissor rectangle likewise
    list->RSSetViewports(1, &whole);
    auto lights = sun.setup().lights();
    lights.insert(lights.begin(), spot.setup().lights()[0]);
    for (const auto& light : lights) {
        const glm::mat4 to_clip(light.projection * light.view);
        list->OMSetRenderTargets(0, nullptr, FALSE, &drawn);
        list->ClearDepthStencilView(drawn, D3D12_CLEAR_FLAG_DEPTH, spot.cleared(), 0, 0, nullptr);
        list->SetGraphicsRoot32BitConstants(0, 16, &to_clip, 0);
        list->DrawInstanced(vertices, 1, 0, 0);
        drawn.ptr += device->GetDescriptorHandleIncrementSize(D3D12_DESCRIPTOR_HEAP_TYPE_DSV);
    }
}
