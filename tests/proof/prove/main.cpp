// SPDX-License-Identifier: MIT
//
// Every binary32 value and every code through every encoding, every filter over planes of every tilt, on all cores.
// Prints a table, writes it as TSV into the file that the argument names, and fails when anything in it does.
//
//     prove_cpp prove.tsv    or that of one primitive alone: prove_cpp discs.tsv acne_free_disc_bias
#include <algorithm>
#include <atomic>
#include <cstdio>
#include <fstream>
#include <functional>
#include <iomanip>
#include <iostream>
#include <mutex>
#include <optional>
#include <string>
#include <string_view>
#include <thread>
#include <vector>

#include <boost/timer/progress_display.hpp>
#include <unistd.h>

#include <umbrage/depth/float_bits.hpp>
#include <umbrage/depth/foreign/ps14.hpp>

#include "../acne.hpp"
#include "../codecs.hpp"
#include "../page_rays.hpp"
#include "../point_rays.hpp"

namespace {

using count = std::uint64_t;
using proof::nth_float;
using proof::seen;

/// One line of the table: a primitive over one class of inputs, numbered first .. last - 1.
struct line {
    const proof::glsl::snippet& primitive;
    std::string kind;
    count first, last;
    std::function<seen(count first, count last)> run;
    count disorder = 0;  ///< as stated: any other number is a failure
    seen result{};

    [[nodiscard]] count failures() const { return result.failures + (result.disorder != disorder); }
};

struct float_class {
    const char* name;
    count first, last;  ///< of nth_float
};

constexpr count negative_nan = (1 << 23) - 1, plus_zero = count(1) << 31, all_floats = count(1) << 32;
constexpr std::array float_classes{
    float_class{"-NaN", 0, negative_nan},
    float_class{"-infinity", negative_nan, negative_nan + 1},
    float_class{"negative", negative_nan + 1, plus_zero - (1 << 23)},
    float_class{"negative denormal", plus_zero - (1 << 23), plus_zero - 1},
    float_class{"-0", plus_zero - 1, plus_zero},
    float_class{"+0", plus_zero, plus_zero + 1},
    float_class{"denormal", plus_zero + 1, plus_zero + (1 << 23)},
    float_class{"in (0, 1)", plus_zero + (1 << 23), plus_zero + 0x3F800000},
    float_class{"1", plus_zero + 0x3F800000, plus_zero + 0x3F800001},
    float_class{"above 1", plus_zero + 0x3F800001, plus_zero + 0x7F800000},
    float_class{"+infinity", plus_zero + 0x7F800000, plus_zero + 0x7F800001},
    float_class{"+NaN", plus_zero + 0x7F800001, all_floats},
};

/// A check of single inputs as a run over many.
template <class Good>
auto each(Good good) {
    return [good](count first, count last) {
        seen s;
        for (count n = first; n < last; ++n) s.failures += !good(n);
        return s;
    };
}

std::uint32_t bits(float v) { return std::bit_cast<std::uint32_t>(v); }

bool saturates(count n) {
    const float v = nth_float(n);
    const std::uint32_t magnitude = bits(v) & 0x7FFFFFFFu;
    const bool one = magnitude > 0x7F800000u || (bits(v) >> 31 == 0 && magnitude >= 0x3F800000u);
    return bits(umbrage::saturate(v)) == (one ? 0x3F800000u : bits(v) >> 31 ? 0u : magnitude);
}

/// Any value of [0, 1] farther than 2^-15 from where two channels meet is read as the nearer one.
bool reads_nearest(count n) {
    const double scaled = double(nth_float(n)) * 255.0;  // exact
    const double k = std::floor(scaled + 0.5);
    return std::abs(scaled + 0.5 - std::floor(scaled + 0.5) - 0.5) > 0.5 - 255.0 / 32768 ||
           umbrage::from_unorm(nth_float(n)) == float(k);
}

bool channel_survives(count n) {
    const auto k = static_cast<std::uint8_t>(n);
    for (auto store : proof::stores)
        if (umbrage::store_unorm(umbrage::to_unorm(float(k)), store) != k) return false;
    return true;
}

/// Reads off by -4096 .. 4096 ulp.
bool channel_is_read(count n) {
    const auto k = static_cast<std::uint8_t>(n / 8193);
    const auto quotient = static_cast<std::int32_t>(bits(float(k) / 255.0f));
    const std::int32_t off = static_cast<std::int32_t>(n % 8193) - 4096;
    return umbrage::from_unorm(std::bit_cast<float>(quotient == 0 ? std::abs(off) : quotient + off)) == float(k);
}

bool keeps_bits(count n) {
    const float v = std::bit_cast<float>(static_cast<std::uint32_t>(n));
    const glm::u8vec4 texel = umbrage::encode_float_bits(v);
    return texel == glm::u8vec4(n, n >> 8, n >> 16, n >> 24) && bits(umbrage::decode_float_bits(texel)) == n;
}

bool reads_bits(count n) {
    const glm::u8vec4 texel(n, n >> 8, n >> 16, n >> 24);
    return bits(umbrage::decode_float_bits(umbrage::load_unorm(texel))) == n;
}

/// x / 2040 within a rounding, and the code can be had back.
bool decodes_ps14(count n) {
    for (auto store : proof::stores) {
        const float u =
            umbrage::decode_ps14(proof::stored(proof::of_code<umbrage::rg<11>>(static_cast<std::uint32_t>(n)), store));
        if (std::abs(double(u) - double(n) / 2040) > 6.4e-8 || std::floor(u * 2040.0f + 0.5f) != float(n)) return false;
    }
    return true;
}

template <class Encoding>
void add_own(std::vector<line>& table) {
    for (const float_class& c : float_classes)
        table.push_back({*Encoding::writer, c.name, c.first, c.last, [](count first, count last) {
                             return seen{proof::own_failures<Encoding>(nth_float, first, last)};
                         }});
    table.push_back({*Encoding::reader, "codes", 0, Encoding::codes,
                     [](count first, count last) { return seen{proof::code_failures<Encoding>(first, last)}; }});
}

template <class Format>
void add_foreign(std::vector<line>& table) {
    for (auto store : proof::stores)
        for (const float_class& c : float_classes) {
            const bool truncates = store == proof::unorm_store::truncates;
            const std::string_view kind = c.name;
            table.push_back(
                {*Format::writer, std::string(kind) + (truncates ? ", store truncates" : ", store rounds"), c.first,
                 c.last,
                 [store](count first, count last) { return proof::look_at<Format>(store, nth_float, first, last); },
                 kind == "in (0, 1)" ? proof::faults_of<Format>.disorder_of_floats[truncates]
                                     : kind == "1" && proof::faults_of<Format>.one < 1.0f});
        }
}

/// Receivers on planes under a filter, in maps of every encoding.
template <class Filter>
line acne_under(const Filter& filter, umbrage::depth_direction direction) {
    char kind[64];
    const char* const way = direction == umbrage::depth_direction::forward ? "" : ", reversed";
    std::snprintf(kind, sizeof kind, "%s, reach %g%s", filter.name.data(), double(filter.reach()), way);
    constexpr bool turned = requires { filter.points; };
    return {turned ? umbrage::glsl::acne_free_disc_bias : umbrage::glsl::acne_free_bias, kind, 0, proof::plane_count,
            [=, erased = proof::any_filter(filter, direction)](count first, count last) {
                seen s;
                for (count n = first; n < last; ++n) {
                    proof::moved_plane moved(n, filter.reach());
                    proof::for_each_decoder(direction, [&](const auto& encoding) {
                        const float bias = umbrage::acne_free_bias(moved.slope, filter, encoding);
                        const auto found = proof::look_for_acne(erased, proof::any_encoding(encoding), bias, moved);
                        s.failures += found.dark + found.loose;
                    });
                }
                return s;
            }};
}

/// Random scenes, lit by every kind of light and fit, looked up, against rays.
seen agrees_with_rays(count first, count last) {
    seen s;
    for (count n = first; n < last; ++n) {
        proof::ray_scene scene(n);
        auto found = scene.compare(umbrage::filters::hard{}, 200);
        found += scene.compare(umbrage::filters::pcf_2x2{}, 200);
        s.failures += found.wrong + found.outside;
    }
    return s;
}

seen pages_agree_with_rays(count first, count last) {
    seen s;
    std::array<int, 16> levels{};
    for (count n = first; n < last; ++n) {
        proof::page_scene scene(n);
        auto found = scene.compare(umbrage::filters::hard{}, 400, levels);
        found += scene.compare(umbrage::filters::pcf_2x2{}, 400, levels);
        s.failures += found.wrong + found.outside;
    }
    return s;
}

/// The same of a point light's maps.
template <class Maps>
seen agrees_around_points(count first, count last) {
    seen s;
    for (count n = first; n < last; ++n)
        s.failures += proof::compare_with_rays<Maps>(n, umbrage::filters::hard{}, 400).wrong +
                      proof::compare_with_rays<Maps>(n, umbrage::filters::pcf_2x2{}, 400).wrong;
    return s;
}

std::vector<line> make_table() {
    namespace glsl = umbrage::glsl;
    std::vector<line> table;
    for (const float_class& c : float_classes)
        table.push_back({glsl::saturate, c.name, c.first, c.last, each(saturates)});
    table.push_back({glsl::to_unorm, "channels", 0, 256, each(channel_survives)});
    table.push_back({glsl::from_unorm, "channels, each off by up to 4096 ulp", 0, 256 * 8193, each(channel_is_read)});
    table.push_back({glsl::from_unorm, "0 .. 1", plus_zero, plus_zero + 0x3F800001, each(reads_nearest)});
    std::apply([&](auto... encoding) { (add_own<decltype(encoding)>(table), ...); }, proof::own_encodings{});
    table.push_back({glsl::decode_ps14, "codes", 0, 2048, each(decodes_ps14)});
    table.push_back({glsl::encode_float_bits, "every pattern", 0, all_floats, each(keeps_bits)});
    table.push_back({glsl::decode_float_bits, "every pattern", 0, all_floats, each(reads_bits)});
    proof::for_each_percentage_closer(
        [&](const auto& filter, auto direction) { table.push_back(acne_under(filter, direction)); });
    table.push_back(
        {glsl::shadow_coordinate, "of fitted lights, to the look-up", 0, 500 * proof::setting_count, agrees_with_rays});
    table.push_back({glsl::page_coordinate, "of pages within a budget, to the look-up", 0,
                     500 * proof::clip_space_count, pages_agree_with_rays});
    table.push_back({glsl::dual_paraboloid_coordinate, "of lights, to the look-up", 0, 500 * proof::clip_space_count,
                     agrees_around_points<proof::paraboloid_maps>});
    table.push_back({glsl::tetrahedron_coordinate, "of lights, to the look-up", 0, 500 * proof::clip_space_count,
                     agrees_around_points<proof::tetrahedron_map>});
    std::apply([&](auto... format) { (add_foreign<decltype(format)>(table), ...); }, proof::foreign{});
    return table;
}

void run(std::vector<line>& table) {
    struct piece {
        line* of;
        count first, last;
    };
    std::vector<piece> pieces;
    for (line& l : table) {
        const count size = std::clamp<count>((l.last - l.first) / 64, 1, 1 << 22);
        for (count first = l.first; first < l.last; first += size)
            pieces.push_back({&l, first, std::min(first + size, l.last)});
    }

    std::optional<boost::timer::progress_display> bar;
    if (isatty(STDERR_FILENO)) bar.emplace(pieces.size(), std::cerr, "", "", "");
    std::mutex reporting;
    std::atomic<std::size_t> next = 0;
    const auto work = [&] {
        for (std::size_t i; (i = next++) < pieces.size();) {
            const seen s = pieces[i].of->run(pieces[i].first, pieces[i].last);
            const std::lock_guard lock(reporting);
            seen& all = pieces[i].of->result;
            all = {all.failures + s.failures, all.disorder + s.disorder, std::max(all.error, s.error)};
            if (bar) ++*bar;
        }
    };
    std::vector<std::jthread> threads(std::max(1u, std::thread::hardware_concurrency()));
    for (std::jthread& thread : threads) thread = std::jthread(work);
}

}  // namespace

int main(int argc, char** argv) {
    if (argc != 2 && argc != 3) return std::cerr << "usage: prove_cpp TABLE.tsv [PRIMITIVE]\n", 2;
    std::ofstream tsv(argv[1]);
    if (!tsv) {
        std::cerr << "prove_cpp: cannot write " << argv[1] << '\n';
        return 2;
    }
    std::vector<line> table;
    for (const line& l : make_table())
        if (argc == 2 || l.primitive.name == argv[2]) table.push_back(l);
    run(table);

    tsv << "primitive\ttier\timplementation\tclass\tinputs\tfailures\n";
    count failures = 0, inputs = 0;
    for (const line& l : table) {
        const char tier = static_cast<char>('A' + static_cast<int>(l.primitive.exactness));
        tsv << l.primitive.name << '\t' << tier << "\tC++\t" << l.kind << '\t' << l.last - l.first << '\t'
            << l.failures() << '\n';
        std::cout << std::left << std::setw(30) << l.primitive.name << tier << "  " << std::setw(38) << l.kind
                  << std::right << std::setw(12) << l.last - l.first << std::setw(10) << l.failures();
        if (l.result.error > 0) std::cout << "   worst 2^" << std::log2(l.result.error);
        if (l.result.disorder > 0) std::cout << "   out of order " << l.result.disorder;
        std::cout << '\n';
        failures += l.failures();
        inputs += l.last - l.first;
    }
    std::cout << inputs << " inputs, " << failures << " failures\n";
    return inputs > 0 && failures == 0 ? 0 : 1;
}
