// SPDX-License-Identifier: MIT
//
// Error of every encoding over depth, for a plot.
#include "curves.hpp"

#include <algorithm>
#include <cmath>
#include <ostream>

#include <umbrage/depth/encodings.hpp>

void write_curves(std::ostream& out) {
    constexpr int points = 128, inputs = 4096;  // inputs of each point
    out << "encoding\tbytes\tlargest error for depths k / 128 to (k + 1) / 128\n";
    umbrage::for_each_encoding([&](const auto& encoding) {
        out << encoding.name << '\t' << sizeof(typename std::decay_t<decltype(encoding)>::texel);
        for (int k = 0; k < points; ++k) {
            double worst = 0;
            for (int i = 0; i < inputs; ++i) {
                const float depth = (static_cast<float>(k * inputs + i) + 0.382f) / static_cast<float>(points * inputs);
                worst = std::max(worst, std::abs(double(encoding.decode(encoding.encode(depth))) - double(depth)));
            }
            out << '\t' << worst;
        }
        out << '\n';
    });
}
