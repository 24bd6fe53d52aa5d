// SPDX-License-Identifier: MIT
//
// Prefiltered maps from depth to visibility: encode, blur of 7 taps, lookup. Summed tables: a large box against a
// small one.
#include <algorithm>
#include <cmath>
#include <functional>
#include <memory>
#include <numeric>
#include <string>
#include <utility>

#include <umbrage/images/blur.hpp>
#include <umbrage/images/moment_table.hpp>
#include <umbrage/images/prefilter.hpp>
#include <umbrage/images/variance_table.hpp>

#include "bench.hpp"
#include "data.hpp"
#include "peers/glm_prefiltered.hpp"

namespace {

template <class Filter>
struct state {
    using texel = typename Filter::texel;
    umbrage::image<float> depth = bench::make_map(), ours{bench::screen}, theirs{bench::screen};
    umbrage::image<glm::vec3> receivers = bench::make_receivers(bench::order::coherent);
    umbrage::image<texel> moments{bench::map_size}, blurred{bench::map_size};
    umbrage::blur_kernel kernel = umbrage::make_gaussian_kernel(7, 1.5f);

    /// But for the weights of texels, in steps of 1/256 of ours, and rounding near the least variance.
    [[nodiscard]] bool close() const {
        const auto far = [](float a, float b) { return std::abs(a - b) > 0.02f; };
        const auto differ = std::inner_product(ours.texels().begin(), ours.texels().end(), theirs.texels().begin(),
                                               std::size_t(0), std::plus<>(), far);
        return differ * 1000 < ours.texels().size();
    }
};

template <class Filter, class Peer>
void add_row(const Filter& filter, const Peer& peer) {
    const auto s = std::make_shared<state<Filter>>();
    bench::add({.work = std::string(filter.name) + ": encode, blur 7 taps, look-up, 1920 x 1080",
                .peer = "GLM",
                .at_least = 6.0,
                .items = bench::pixels,
                .ours =
                    [=] {
                        umbrage::encode_moments(std::as_const(s->depth).view(), s->moments.view(), filter);
                        umbrage::blur(s->moments.view(), s->blurred.view(), s->kernel);
                        umbrage::visibility(std::as_const(s->blurred).view(), filter,
                                            std::as_const(s->receivers).view(), s->ours.view(), umbrage::serial{},
                                            umbrage::outside_map::clamped);
                    },
                .theirs =
                    [=] {
                        peers::glm_code::encode(peer, s->depth, s->moments);
                        peers::glm_code::blur(s->moments, s->blurred, s->kernel.weights, {0, 1});
                        peers::glm_code::blur(s->blurred, s->moments, s->kernel.weights, {1, 0});
                        peers::glm_code::look_up(peer, s->moments, s->receivers, s->theirs);
                    },
                .agree = [=] { return s->close(); }});
}

/// A table's boxes, which all are to cost the same.
template <class Of>
void add_boxes(const std::string& name, const Of& of, umbrage::image<glm::u16vec4> table) {
    struct state {
        Of of;
        umbrage::image<glm::u16vec4> table;
        umbrage::image<float> out{bench::screen};
        umbrage::image<glm::vec3> receivers = bench::make_receivers(bench::order::coherent);
    };
    const auto s = std::make_shared<state>(state{of, std::move(table)});
    const auto boxes = [s](int radius) {
        return [=] {
            umbrage::visibility(std::as_const(s->table).view(), s->of, std::as_const(s->receivers).view(), radius,
                                s->out.view(), umbrage::serial{}, umbrage::outside_map::clamped);
        };
    };
    bench::add({.work = name + ": box of 33 x 33, 1920 x 1080",
                .peer = "3 x 3",
                .at_least = 0.9,
                .items = bench::pixels,
                .ours = boxes(16),
                .theirs = boxes(1),
                .agree = {}});
}

const bench::registration rows([] {
    add_row(umbrage::prefilters::vsm{1e-4f}, peers::glm_code::vsm{1e-4f});
    const umbrage::prefilters::evsm4 evsm;
    add_row(evsm, peers::glm_code::evsm4{evsm.parameters.exponents, evsm.parameters.deviations});
    add_row(umbrage::prefilters::msm{}, peers::glm_code::msm{umbrage::msm_bias_32});
    const umbrage::image<float> depth = bench::make_map();
    const umbrage::variance_table variance{.radius = 16};
    const umbrage::moment_table moments{.radius = 16};
    add_boxes("summed variance", variance, umbrage::make_variance_table(depth.view(), variance));
    add_boxes("summed moments", moments, umbrage::make_moment_table(depth.view(), moments));
});

}  // namespace
