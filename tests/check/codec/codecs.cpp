// SPDX-License-Identifier: MIT
#include "codecs.hpp"

#include <cmath>

#include <umbrage/depth/encodings.hpp>

#include "../stage.hpp"

namespace check {
namespace {

template <class Encoding>
codec make_codec(std::string name, const Encoding& encoding) {
    using target = typename Encoding::target;
    constexpr int channels = target::channels;
    const float most = largest_channel(target::bits);
    const auto kept = [most](const typename Encoding::texel& t) { return glm::floor(target::load(t) * most + 0.5f); };
    std::function<glm::vec4(float)> truncated;
    if constexpr (requires { encoding.write(1.0f); })
        truncated = [encoding, kept](float depth) {
            return kept(target::store(encoding.write(depth), umbrage::unorm_store::truncates));
        };
    return {std::move(name),
            target::bits,
            channels,
            [encoding, kept](float depth) { return kept(encoding.encode(depth)); },
            std::move(truncated),
            [encoding, most](glm::vec4 k) {
                if constexpr (channels == 1) return encoding.decode(target::store(k.x / most));
                else return encoding.decode(target::store(glm::vec<channels, float>(k / most)));
            }};
}

std::vector<codec> make_codecs() {
    std::vector<codec> all;
    umbrage::for_each_encoding([&]<class Encoding>(Encoding encoding) {
        if constexpr (Encoding::target::to_unorm != nullptr) {
            const std::string name(encoding.name);
            all.push_back(make_codec(name, encoding));
            if constexpr (umbrage::has_edge<Encoding>) {
                encoding.edge = 0.0f;
                all.push_back(make_codec(name + " lower edge", encoding));
                encoding.edge = 0.5f;
                all.push_back(make_codec(name + " center", encoding));
            }
        }
    });
    return all;
}

}  // namespace

const std::vector<codec>& codecs() {
    static const std::vector<codec> all = make_codecs();
    return all;
}

std::vector<std::string> encoding_names() {
    std::vector<std::string> all;
    for (const codec& c : codecs()) all.push_back(c.name);
    return all;
}

}  // namespace check
