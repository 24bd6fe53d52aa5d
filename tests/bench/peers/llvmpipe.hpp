// SPDX-License-Identifier: MIT
//
// Mesa's llvmpipe on one thread of this machine, running the GLSL twins. Its context stays current on this thread.
#pragma once

#include <memory>
#include <string>
#include <vector>

#include <glm/gtc/type_precision.hpp>

#include <umbrage/core/image.hpp>
#include <umbrage/core/snippet.hpp>

namespace peers::llvmpipe {

class pass {
public:
    virtual ~pass() = default;
    /// A filter for draw(): `arguments` are those behind coordinate and receiver, as ", 2.0".
    [[nodiscard]] virtual unsigned compile(const std::vector<umbrage::glsl::snippet>& snippets,
                                           const std::string& arguments, bool packed) = 0;
    /// The filter of every receiver, finished on return.
    virtual void draw(unsigned filter) = 0;
    virtual void read(std::vector<float>& visibility) = 0;
};

/// @return   null where there is no llvmpipe
[[nodiscard]] std::shared_ptr<pass> start(const umbrage::image<float>& map, const umbrage::image<glm::u8vec2>& packed,
                                          const umbrage::image<glm::vec3>& receivers);

}  // namespace peers::llvmpipe
