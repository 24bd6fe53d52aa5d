// SPDX-License-Identifier: MIT
#include <umbrage/umbrage.hpp>

#include <cstdio>
#include <string>

std::string shader();  // second.cpp
#ifdef WITH_IMAGES
bool shadows();  // images.cpp
#else
static bool shadows() { return true; }
#endif

int main() {
    const glm::vec2 value = umbrage::to_unorm(glm::vec2(255.0f, 0.0f));
    const bool ok = umbrage::store_unorm(value) == glm::vec<2, std::uint8_t>(255, 0) && shadows() &&
                    shader().find("float umbrage_to_unorm(") != std::string::npos;
    std::printf("umbrage %d.%d.%d: %s\n", UMBRAGE_VERSION_MAJOR, UMBRAGE_VERSION_MINOR, UMBRAGE_VERSION_PATCH,
                ok ? "ok" : "wrong");
    return ok ? 0 : 1;
}
