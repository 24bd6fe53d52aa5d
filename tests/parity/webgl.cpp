// SPDX-License-Identifier: MIT
//
// WebGL 1 and WebGL 2 in a headless browser, on SwiftShader; webgl.js draws.
#include <filesystem>
#include <iostream>
#include <memory>

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
    [[nodiscard]] std::vector<dialect> dialects() const override { return {version::v100, version::v300_es}; }
    [[nodiscard]] std::string label(dialect d) const override { return "WebGL " + number(d); }

private:
    std::string name_;
};

}  // namespace

backends webgl_backends() {
    backends all;
    for (const char* need : {UMBRAGE_NODE, UMBRAGE_CHROMIUM, UMBRAGE_NODE_MODULES "/playwright-core"}) {
        if (std::filesystem::exists(need)) continue;
        std::cout << "missing: " << need << '\n';
        return all;
    }
    all.push_back(std::make_unique<webgl>());
    return all;
}

}  // namespace parity
