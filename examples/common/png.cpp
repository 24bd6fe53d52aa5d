// SPDX-License-Identifier: MIT
#include "png.hpp"

#include <algorithm>
#include <cstdlib>
#include <memory>
#include <stdexcept>

#include <libdeflate.h>

namespace {

/// zlib stream for stb, which frees it.
/// @param level   compression level of libdeflate
unsigned char* compress(const unsigned char* bytes, int count, int* compressed, int level) {
    const std::unique_ptr<libdeflate_compressor, void (*)(libdeflate_compressor*)> compressor(
        libdeflate_alloc_compressor(level), libdeflate_free_compressor);
    if (!compressor) return nullptr;
    const auto size = static_cast<std::size_t>(count);
    const std::size_t bound = libdeflate_zlib_compress_bound(compressor.get(), size);
    auto* const out = static_cast<unsigned char*>(std::malloc(bound));
    if (out) *compressed = static_cast<int>(libdeflate_zlib_compress(compressor.get(), bytes, size, out, bound));
    return out;
}

}  // namespace

#define STBIW_ZLIB_COMPRESS compress
#define STBIW_CRC32(bytes, count) libdeflate_crc32(0, bytes, static_cast<std::size_t>(count))
#define STB_IMAGE_WRITE_IMPLEMENTATION
#define STB_IMAGE_WRITE_STATIC
#include <stb/stb_image_write.h>

namespace example {
namespace {

template <class T>
void write(const std::filesystem::path& path, umbrage::image_view<const T> pixels, file_size wanted) {
    const bool smallest = wanted == file_size::smallest;
    stbi_write_force_png_filter = smallest ? -1 : 2;  // "up": to try all on each row takes longer than to compress it
    stbi_write_png_compression_level = smallest ? 12 : 6;
    const int channels = static_cast<int>(sizeof(T));
    if (pixels.empty() || !stbi_write_png(path.string().c_str(), pixels.size.x, pixels.size.y, channels, pixels.data,
                                          static_cast<int>(pixels.stride)))
        throw std::runtime_error("cannot write " + path.string());
}

}  // namespace

void write_png(const std::filesystem::path& path, umbrage::image_view<const std::uint8_t> gray) {
    write(path, gray, file_size::quick);
}
void write_png(const std::filesystem::path& path, umbrage::image_view<const glm::u8vec3> rgb, file_size wanted) {
    write(path, rgb, wanted);
}
void write_png(const std::filesystem::path& path, umbrage::image_view<const glm::u8vec4> rgba) {
    write(path, rgba, file_size::quick);
}

}  // namespace example
