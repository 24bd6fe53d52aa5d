// SPDX-License-Identifier: MIT
//
// WebGL 1 and WebGL 2 in a headless browser, on SwiftShader; webgl.js draws. WebGPU without a browser; webgpu.js draws.
#include <memory>

#include "block.hpp"
#include "remote.hpp"

namespace parity {
namespace {

class webgl final : public remote {
public:
    webgl() : remote({UMBRAGE_NODE, UMBRAGE_SCRIPTS "/webgl.js", UMBRAGE_CHROMIUM, UMBRAGE_NODE_MODULES}) {
        for (version v : {version::v100, version::v300_es}) name_ = hello(v);
    }

    [[nodiscard]] std::string name() const override {
        return name_.find("SwiftShader") == std::string::npos ? "WebGL on " + name_ : "SwiftShader (" + name_ + ")";
    }
    [[nodiscard]] identity about(dialect) const override { return {.api = "WebGL", .device = name_}; }
    [[nodiscard]] std::vector<dialect> dialects() const override { return {version::v100, version::v300_es}; }
    [[nodiscard]] std::string label(dialect d) const override { return "WebGL " + web_version(d); }

private:
    std::string name_;
};

class webgpu final : public remote {
public:
    webgpu() : remote({UMBRAGE_NODE, UMBRAGE_SCRIPTS "/webgpu.js", UMBRAGE_NODE_MODULES, UMBRAGE_SWIFTSHADER}) {
        name_ = "Tint (Dawn on " + hello(dialect::wgsl) + ")";
    }

    [[nodiscard]] std::string name() const override { return name_; }
    [[nodiscard]] identity about(dialect) const override { return {.api = "WebGPU", .device = name_}; }
    [[nodiscard]] std::vector<dialect> dialects() const override { return {dialect::wgsl}; }

private:
    std::string name_;
};

template <class Backend>
backends one_if(bool possible) {
    backends all;
    if (possible) all.push_back(std::make_unique<Backend>());
    return all;
}

}  // namespace

backends webgl_backends() {
    return one_if<webgl>(all_exist({UMBRAGE_NODE, UMBRAGE_CHROMIUM, UMBRAGE_NODE_MODULES "/playwright-core"}));
}

backends webgpu_backends() {
    return one_if<webgpu>(all_exist({UMBRAGE_NODE, UMBRAGE_NODE_MODULES "/webgpu", UMBRAGE_SWIFTSHADER}));
}

}  // namespace parity
