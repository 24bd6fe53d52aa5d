// SPDX-License-Identifier: MIT
//
// The parity suite for a page: it makes jobs, takes the pixels that the page has drawn of them, and writes the report.
//
// An implementation is called by its number: 1 and 2 are WebGL's versions, 3 is WebGPU. Texts come as UTF-8 that ends
// with a zero, and stay until the next call. Bytes go into buffer(size), before the call that takes them.
#include <cstdint>
#include <memory>
#include <optional>
#include <sstream>
#include <string>

#include "digest.hpp"
#include "expected.hpp"
#include "probe_jobs.hpp"
#include "report.hpp"
#include "shader.hpp"

namespace page {
namespace {

using namespace parity;

std::string text, bytes;
std::optional<probe_jobs> probing;
parity::report about;
dialect in = version::v300_es;
job current;

const char* give(std::string words) {
    text = std::move(words);
    return text.c_str();
}

dialect dialect_of(int implementation) {
    return implementation == 1   ? dialect(version::v100)
           : implementation == 2 ? dialect(version::v300_es)
                                 : dialect(dialect::wgsl);
}

const entry& at(int i) { return entries()[static_cast<std::size_t>(i)]; }

std::size_t maps_of(const entry& e) { return std::max<std::size_t>(1, e.maps.size()); }

/// Inputs of an entry's part: a map of several, or behind those the enumeration.
job make_part(const entry& e, std::size_t part, std::size_t count) {
    const std::size_t maps = maps_of(e);
    if (part == maps) return make_whole_job(e, 0, std::min<std::size_t>(count, e.whole.count), part);
    const std::size_t share = std::max<std::size_t>(count / maps / e.share, 1);
    return make_job(e, e.maps.empty() ? nullptr : &e.maps[part], 0, share, part);
}

row& row_of(const entry& e) {
    if (about.rows.empty() || about.rows.back().primitive != e.name())
        about.rows.push_back({e.name(), promised(e), about.of.device, about.probed_in});
    return about.rows.back();
}

/// Verdict, inputs, identical, different, worst ulp, worst distance; then the first difference.
std::string described(const row& r) {
    std::ostringstream all;
    const tally& t = r.t;
    all << (r.ran() ? verdict_names[static_cast<std::size_t>(verdict_of(t))] : "not run") << '\t' << t.total << '\t'
        << t.identical << '\t' << t.different << '\t' << t.worst_ulp << '\t' << t.worst_distance << '\t'
        << (r.broken.empty() ? r.example : r.broken);
    return all.str();
}

}  // namespace
}  // namespace page

using namespace page;

#define PAGE(name) extern "C" __attribute__((export_name(#name))) auto name

PAGE(buffer)(std::size_t size)->char* {
    bytes.assign(size, '\0');
    return bytes.data();
}

PAGE(entry_count)()->int { return static_cast<int>(entries().size()); }

/// Name, tier, promise, and parts.
PAGE(entry_at)(int i)->const char* {
    const entry& e = at(i);
    const std::string promise = promised(e);
    return give(e.name() + '\t' + promise[0] + '\t' + promise + '\t' +
                std::to_string(maps_of(e) + (e.whole.count ? 1 : 0)));
}
PAGE(runs_in)(int i, int implementation)->bool { return at(i).runs_in(dialect_of(implementation)); }

/// Plants a mistake into the shaders, "FROM=TO" of the buffer; none of an empty one.
PAGE(plant)()->void {
    const std::size_t middle = bytes.find('=');
    planted = middle == bytes.npos ? mistake{} : mistake{bytes.substr(0, middle), bytes.substr(middle + 1)};
}

/// Begins an implementation. The buffer has its API, its device and the system, parted by newlines.
PAGE(begin)(int implementation)->void {
    about = {};
    in = dialect_of(implementation);
    std::istringstream lines(bytes);
    std::getline(lines, about.of.api);
    std::getline(lines, about.of.device);
    std::getline(lines, about.system);
    about.probed_in = in.in == dialect::wgsl ? name(in) : "GLSL " + name(in);
    about.dialects = {about.probed_in};
}

/// Number of the probe's jobs.
PAGE(probe_count)()->int {
    probing.emplace(in);
    (void)probe(*probing, in);
    return static_cast<int>(probing->blocks.size());
}
PAGE(probe_block)(int k)->const char* {
    text = probing->blocks[static_cast<std::size_t>(k)];
    return text.data();
}
PAGE(probe_drawn)()->void { probing->drawn.push_back(bytes); }
/// What the probe says, in lines. `failed`: the buffer says why there is no result.
PAGE(probe_result)(bool failed)->const char* {
    if (failed) about.unprobed = bytes;
    else about.probed = probe(*probing, in);
    probing.reset();
    std::string lines;
    if (about.probed)
        for (const std::string& line : parity::described(*about.probed)) lines += line + '\n';
    return give(lines);
}

/// Makes a job; text_size() is the block's.
PAGE(block)(int i, int part, std::size_t count)->const char* {
    current = make_part(at(i), static_cast<std::size_t>(part), count);
    text = block_of(in, current, current.count, true);
    return text.data();
}
PAGE(text_size)()->std::size_t { return text.size(); }

/// Compares the buffer's pixels with C++.
PAGE(judge)()->const char* {
    const texels flat = current.map ? flush(*current.map) : texels();
    std::ostringstream log;
    row& r = row_of(*current.what);
    compare(current, expect(current, current.map ? &flat : nullptr, true),
            results_of(current, current.count, bytes.data()), r.t, log);
    r.take_example(log.str());
    return give(page::described(r));
}
/// Notes why an entry did not run; the buffer says it.
PAGE(not_run)(int i)->const char* {
    row& r = row_of(at(i));
    r.broken = bytes;
    return give(page::described(r));
}

/// A line for each tier: entries identical, as promised, different, not run; inputs.
PAGE(sums)()->const char* {
    std::ostringstream all;
    for (const tier_sum& t : by_tier(about.rows)) {
        for (const int n : t.entries) all << n << '\t';
        all << t.not_run << '\t' << t.inputs << '\n';
    }
    return give(all.str());
}

/// The report, as `make gpu` writes it. The buffer has the command.
PAGE(report)()->const char* {
    std::ostringstream all;
    print(all, about, bytes);
    return give(all.str());
}

/// A line of parity_digest.
PAGE(digest)(int i, std::size_t count)->const char* { return give(digest_line(at(i), count)); }
