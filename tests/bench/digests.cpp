// SPDX-License-Identifier: MIT
//
// Digests of whole images of every setup's shadow, a line for each setup, filter and order of receivers, and whether
// each receiver alone has the image's bits. Compare two runs on one machine to find bits that changed.
//
//     bench_digests > before.txt
#include <cinttypes>
#include <cstdio>
#include <string>

#include "../proof/hostile/digest.hpp"
#include "whole.hpp"

int main() {
    using namespace bench::whole;
    for_each_setup([]<class Light>(const std::string& name, const Light& light, glm::ivec2 map_size) {
        const umbrage::image<float> map = drawn(umbrage::shadow(light, map_size, umbrage::filters::hard{}));
        umbrage::image<float> out(image_size);
        for_each_filter<Light>([&](const std::string& filter_name, const auto& filter) {
            const umbrage::shadow s(light, map_size, filter);
            for (const bench::order o : {bench::order::coherent, bench::order::random}) {
                const receivers of(o);
                s.visibility(map, of.points, of.normals, out);
                hostile::digest sum;
                for (const float visibility : out.texels()) sum(visibility);
                std::printf("%s, %s, %s\t%016" PRIx64 "\t%s\n", name.c_str(), filter_name.c_str(),
                            o == bench::order::coherent ? "coherent" : "random", sum.hash,
                            same_alone(s, map, of, out) ? "alone the same" : "alone others");
            }
        });
    });
}
