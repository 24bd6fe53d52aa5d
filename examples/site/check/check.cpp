// SPDX-License-Identifier: MIT
//
// The investigation of tests/check for a page: engine.ts calls it.
//
// Texts come as UTF-8 that ends with a zero. Bytes go into buffer(size), before the call that takes them.
#include <cstring>
#include <optional>
#include <span>
#include <string>
#include <vector>

#include "check/investigation.hpp"

namespace {

std::string text, bytes;
std::optional<check::investigation> asked;
std::optional<check::batch> current;

const char* give(std::string words) {
    text = std::move(words);
    return text.c_str();
}

}  // namespace

#define PAGE(name) extern "C" __attribute__((export_name(#name))) auto name

PAGE(buffer)(std::size_t size)->char* {
    bytes.assign(size, '\0');
    return bytes.data();
}

/// Names of the functions of a subject, a line each.
PAGE(names)(int subject)->const char* {
    std::string lines;
    for (const std::string& name : check::names(static_cast<check::subject>(subject))) lines += name + '\n';
    return give(lines);
}

/// Begins; the buffer has what the function should be, or nothing.
PAGE(begin)(int subject)->void {
    current.reset();
    asked.emplace(static_cast<check::subject>(subject), check::expectation{.is = bytes});
}

/// Number of inputs of the next batch; 0 when there is a verdict.
PAGE(next)()->std::size_t {
    current = asked->next();
    return current ? current->inputs.size() : 0;
}
PAGE(width)()->int { return current->size.x; }
PAGE(height)()->int { return current->size.y; }
PAGE(texels)()->std::size_t { return current->map.size(); }
PAGE(map)()->const float* { return current->map.data(); }
PAGE(inputs)()->const glm::vec4* { return current->inputs.data(); }

/// Takes the buffer as outputs of the last batch.
PAGE(answer)()->void {
    std::vector<glm::vec4> outputs(bytes.size() / sizeof(glm::vec4));
    std::memcpy(outputs.data(), bytes.data(), outputs.size() * sizeof(glm::vec4));
    asked->answer(outputs);
}

PAGE(verdict)()->const char* { return give(check::json(asked->result())); }
