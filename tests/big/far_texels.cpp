// SPDX-License-Identifier: MIT
//
// Maps of which only some pages are in memory: texels more than 2^31 bytes from the first one, in a moment.
#include <cstddef>
#include <memory>
#include <new>

#include <sys/mman.h>

#include <glm/vec2.hpp>
#include <glm/vec3.hpp>

#include <umbrage/depth/rg.hpp>
#include <umbrage/images/visibility.hpp>

#include "../forced_form.hpp"
#include "works.hpp"

namespace {

using namespace umbrage;

constexpr int side = 1 << 15, patch = 256, rows = 40;

/// Map of zeros, which take no memory until they are written.
template <class T>
class reserved_map {
public:
    reserved_map() : memory_(mmap(nullptr, bytes, PROT_READ | PROT_WRITE, flags, -1, 0)) {
        if (memory_ == MAP_FAILED) throw std::bad_alloc();
    }
    ~reserved_map() { munmap(memory_, bytes); }
    reserved_map(const reserved_map&) = delete;
    reserved_map& operator=(const reserved_map&) = delete;

    [[nodiscard]] image_view<T> view() const { return {static_cast<T*>(memory_), glm::ivec2(side)}; }
    /// The same memory, with the last row first.
    [[nodiscard]] image_view<T> upside_down() const { return {view().row(side - 1), glm::ivec2(side), -view().stride}; }

private:
    static constexpr std::size_t bytes = sizeof(T) * std::size_t(side) * std::size_t(side);
    static constexpr int flags = MAP_PRIVATE | MAP_ANONYMOUS | MAP_NORESERVE;
    void* memory_;
};

/// Parts of a map that have depths: its corners, and where half of its bytes end.
constexpr glm::ivec2 patches[]{
    {0, 0}, {side - patch, 0}, {1000, side / 2 - rows / 2}, {0, side - rows}, {side - patch, side - rows}};

/// Compares visibility in the patches with the filter alone.
template <class Encoding, class Filter>
[[nodiscard]] bool is_same(image_view<const typename Encoding::texel> map, const Encoding& encoding,
                           const Filter& filter) {
    image<glm::vec3> receivers({patch, rows});
    image<float> lit(receivers.size());
    const auto decoded_map = [&](glm::ivec2 at) {
        return inside_map(map.size, at) ? float(decoded(clamped(map), encoding)(at)) : 1.0f;
    };
    for (const glm::ivec2& first : patches) {
        for (glm::ivec2 at{0}; at.y < rows; ++at.y)
            for (at.x = 0; at.x < patch; ++at.x)
                receivers[at] = glm::vec3(glm::vec2(first + at) + 0.75f, float((at.x * 7 + at.y * 5) % 32) / 32);
        visibility(map, encoding, receivers, filter, lit);
        for (glm::ivec2 at{0}; at.y < rows; ++at.y)
            for (at.x = 0; at.x < patch; ++at.x) {
                const glm::vec3 r = receivers[at];
                if (lit[at] != detail::filtered(filter, decoded_map, glm::vec2(r), r.z, at)) return false;
            }
    }
    return true;
}

/// Runs the fast forms, which read texels by offsets of 32 bits.
template <class Texel, class Use>
[[nodiscard]] bool in_both_orders(const auto& texel_of, const Use& use) {
    const reserved_map<Texel> map;
    for (const glm::ivec2& first : patches)
        for (int y = first.y; y < first.y + rows; ++y)
            for (int x = first.x; x < first.x + patch; ++x) map.view().row(y)[x] = texel_of(x, y);
    for (const image_view<const Texel> each :
         {image_view<const Texel>(map.view()), image_view<const Texel>(map.upside_down())})
        if (!detail::form_takes<detail::block_form<filters::pcf_2x2>>(each, true, patch * rows) || !use(each))
            return false;
    return true;
}

prepared reads_far_texels(int) {
    const auto right = std::make_shared<bool>();
    return {double(patch * rows), 1 << 20,
            [right](stopwatch&) {
                constexpr depth32f floats{};
                constexpr rg<11> packing{};
                *right =
                    in_both_orders<float>(depth_of,
                                          [&](image_view<const float> map) {
                                              return is_same(map, floats, filters::hard{}) &&
                                                     is_same(map, floats, filters::pcf_2x2{}) &&
                                                     is_same(map, floats, forced::every_texel{filters::tent<3>}) &&
                                                     is_same(map, floats, forced::every_texel{filters::box{2}}) &&
                                                     is_same(map, floats, forced::every_texel{filters::disc{}}) &&
                                                     is_same(map, floats, filters::pcss{});
                                          }) &&
                    in_both_orders<glm::u8vec2>(
                        [&](int x, int y) { return glm::u8vec2(packing.encode(depth_of(x, y))); },
                        [&](image_view<const glm::u8vec2> map) { return is_same(map, packing, filters::pcf_2x2{}); });
            },
            [right] { return *right; }};
}

const registered here({{"", "texels 2^31 bytes from the first", 16, 0, reads_far_texels}});

}  // namespace
