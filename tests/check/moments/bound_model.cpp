// SPDX-License-Identifier: MIT
#include "bound_model.hpp"

#include <algorithm>
#include <cmath>

#include <umbrage/filter/prefiltered/chebyshev.hpp>

#include "../numbers.hpp"

namespace check {
namespace {

double variance_of(second_channel second, double mean, double held) {
    switch (second) {
        case second_channel::deviation: return held * held;
        case second_channel::half_deviation: return held * held / 4;
        case second_channel::variance: return held;
        default: return held - mean * mean;
    }
}

}  // namespace

float second_of(second_channel second, float mean, float variance) {
    switch (second) {
        case second_channel::deviation: return std::sqrt(variance);
        case second_channel::half_deviation: return 2 * std::sqrt(variance);
        case second_channel::variance: return variance;
        default: return mean * mean + variance;
    }
}

double bound_model::operator()(glm::vec2 moments, float receiver) const {
    const double mean = double(moments.x), d = double(receiver) - mean;
    const double variance = (std::max)(variance_of(second, mean, double(moments.y)), min_variance);
    const double bound = variance + d * d > 0 ? variance / (variance + d * d) : 0;
    const bool lit = one_sided && (reversed ? d >= 0 : d <= 0);
    const double visibility = lit ? 1 : std::clamp((bound - from) / (to - from), 0.0, 1.0);
    return in_shadow ? 1 - visibility : visibility;
}

float bound_model::own(glm::vec2 moments, float receiver) const {
    const float bound = umbrage::chebyshev(moments, receiver, static_cast<float>(min_variance));
    return from > 0 ? umbrage::reduce_light_bleeding(bound, static_cast<float>(from)) : bound;
}

std::optional<double> bound_model::bound_of(float result) const {
    const double visibility = in_shadow ? 1 - double(result) : double(result);
    if (!(visibility > 0.01 && visibility < 0.99)) return std::nullopt;
    return from + visibility * (to - from);
}

std::string bound_model::name() const {
    return "chebyshev(" + shortened(min_variance) + ')' +
           (from > 0 ? ", reduce_light_bleeding(" + shortened(from) + ')' : "");
}

std::vector<finding> bound_model::slips() const {
    std::vector<finding> all;
    constexpr const char* held[]{"", "its standard deviation", "twice its standard deviation", "its variance"};
    if (second != second_channel::mean_square)
        all.push_back({"second", "the second channel is not the mean of squared depths, but " +
                                     std::string(held[static_cast<std::size_t>(second)])});
    if (reversed) all.push_back({"direction", "compared as reversed depth"});
    if (in_shadow) all.push_back({"in_shadow", "1 in shadow, 0 lit"});
    if (!one_sided)
        all.push_back({"sides", "receivers nearer than the mean are shadowed too: no comparison with the mean"});
    if (to != 1) all.push_back({"levels", "a bound of " + shortened(to) + " is lit already"});
    return all;
}

}  // namespace check
