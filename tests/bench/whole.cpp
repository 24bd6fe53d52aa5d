// SPDX-License-Identifier: MIT
//
// Whole images of every setup's shadow, against one map with the same filter.
#include "whole.hpp"

#include <memory>
#include <string>

#include "bench.hpp"

namespace {

using umbrage::image;

struct state {
    bench::whole::receivers seen{bench::order::coherent};
    image<float> map, single_map, out{bench::whole::image_size}, single_out{bench::whole::image_size};
};

const bench::registration rows([] {
    using namespace bench::whole;
    for_each_setup([&]<class Light>(const std::string& name, const Light& light, glm::ivec2 map_size) {
        if (name == directional_name) return;  // the peer
        const auto of = std::make_shared<state>();
        of->map = drawn(umbrage::shadow(light, map_size, umbrage::filters::hard{}));
        of->single_map = drawn(umbrage::shadow(directional_light(), glm::ivec2(1024), umbrage::filters::hard{}));
        for_each_filter<Light>([&](const std::string& filter_name, const auto& filter) {
            const umbrage::shadow s(light, map_size, filter);
            const umbrage::shadow single(directional_light(), glm::ivec2(1024), filter);
            bench::add(
                {.work = "whole image, " + name + ", " + filter_name,
                 .peer = directional_name,
                 .items = double(image_size.x * image_size.y),
                 .ours = [=] { s.visibility(of->map, of->seen.points, of->seen.normals, of->out); },
                 .theirs =
                     [=] { single.visibility(of->single_map, of->seen.points, of->seen.normals, of->single_out); },
                 .agree = [=] { return same_alone(s, of->map, of->seen, of->out); }});
        });
    });
});

}  // namespace
