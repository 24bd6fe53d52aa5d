// SPDX-License-Identifier: MIT
#include "spirv.hpp"

#include <stdexcept>

#include <glslang/Public/ResourceLimits.h>
#include <glslang/Public/ShaderLang.h>
#include <glslang/SPIRV/GlslangToSpv.h>

namespace parity {

spirv_compiler::spirv_compiler() { glslang::InitializeProcess(); }
spirv_compiler::~spirv_compiler() { glslang::FinalizeProcess(); }

bool spirv_compiler::is_here() { return true; }

std::vector<std::uint32_t> spirv_compiler::compile(const std::string& stage, const std::string& text,
                                                   language in) const {
    const EShLanguage kind = stage == "vert" ? EShLangVertex : stage == "frag" ? EShLangFragment : EShLangCompute;
    const int words = EShMsgSpvRules | EShMsgVulkanRules | (in == hlsl ? EShMsgReadHlsl : EShMsgDefault);
    const auto messages = static_cast<EShMessages>(words);
    const char* const source = text.c_str();
    glslang::TShader shader(kind);
    glslang::TProgram program;
    shader.setStrings(&source, 1);
    shader.setEntryPoint("main");
    shader.setEnvInput(in == hlsl ? glslang::EShSourceHlsl : glslang::EShSourceGlsl, kind, glslang::EShClientVulkan,
                       100);
    shader.setEnvClient(glslang::EShClientVulkan, glslang::EShTargetVulkan_1_0);
    shader.setEnvTarget(glslang::EShTargetSpv, glslang::EShTargetSpv_1_0);
    if (!shader.parse(GetDefaultResources(), 110, false, messages))
        throw std::runtime_error(std::string(shader.getInfoLog()) + '\n' + text);
    program.addShader(&shader);
    if (!program.link(messages)) throw std::runtime_error(std::string(program.getInfoLog()) + '\n' + text);

    std::vector<std::uint32_t> code;
    spv::SpvBuildLogger log;
    glslang::SpvOptions options;
    options.disableOptimizer = false;  // which makes HLSL's textures in parameters what Vulkan allows
    options.validate = in == glsl;     // of HLSL's GatherCmp glslang 12 makes an instruction with an operand too many
    glslang::GlslangToSpv(*program.getIntermediate(kind), code, &log, &options);
    if (const std::string said = log.getAllMessages(); code.empty() || said.find("error") != said.npos)
        throw std::runtime_error(said + '\n' + text);
    return code;
}

}  // namespace parity
