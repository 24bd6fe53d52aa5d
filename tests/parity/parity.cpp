// SPDX-License-Identifier: MIT
//
// Entries on one implementation, in its dialects, against C++. `usage` says how it is called.
#include <algorithm>
#include <chrono>
#include <iomanip>
#include <iostream>
#include <memory>
#include <sstream>
#include <stdexcept>
#include <string>
#include <string_view>
#include <utility>

#include <unistd.h>

#include "expected.hpp"
#include "report.hpp"
#include "shader.hpp"

namespace parity {
namespace {

constexpr const char* usage = R"(Every entry on one implementation, in all its dialects, against C++.

    parity --backend BACKEND [--filter TEXT] [--versions "100,300 es,450"] [--count N] [--other-count N]
           [--every N] [--other-every N] [--whole N] [--out FOLDER] [--report FOLDER] [--mistake FROM=TO]

  --backend      c++ fused llvmpipe softpipe lavapipe lavapipe_compute swiftshader swiftshader_vulkan metal naga tint
                 hardware
  --filter       only entries whose names have this in them; without it all, which takes minutes
  --versions     only these dialects
  --count        inputs of an entry in the main dialects, 1048576; --other-count: in the others, 65536
  --every        one in N entries in the main dialects, by a hash of both names; in the last dialect all
  --other-every  one in N in the other dialects, and of entries with bound maps or alike
  --whole        as many of each enumeration, in one dialect, 65536; 16777216 is all of every one
  --out          where parity-BACKEND.tsv goes, the table of all entries; without a filter alone
  --report       folder of a page for each API, report-*.md, with a probe of its arithmetic; hardware is always probed
  --mistake      printers write TO for FROM; the exit status is 0 when results differ for it

Exit status: 0 agrees, 1 differs, 2 called wrongly, 77 nothing here to run on.
)";

struct options {
    std::string driver, filter, versions, out = ".", report, command;
    std::size_t count = std::size_t(1) << 20;        ///< in the main dialects: one of each kind of GLSL, and languages
    std::size_t other_count = std::size_t(1) << 16;  ///< in the others
    std::size_t every = 1, other_every = 1;
    std::size_t whole = std::size_t(1) << 16;  ///< of an enumeration, in the last of the main dialects of GLSL

    [[nodiscard]] bool wants(const backend& b, dialect d) const {
        return versions.empty() || ("," + versions + ",").find("," + b.label(d) + ",") != std::string::npos;
    }
    [[nodiscard]] static bool main(dialect d) {
        return d.in != dialect::glsl || d == version::v100 || d == version::v300_es || d == version::v450 ||
               d == version::vulkan;
    }
    [[nodiscard]] std::size_t inputs(const entry& e, dialect d, bool only) const {
        return (only || main(d) ? count : std::min(count, other_count)) / e.share;
    }
    /// Samples, but for the last dialect, where no snippet is left out.
    [[nodiscard]] bool samples(const entry& e, const backend& b, dialect d) const {
        if (e.bound.empty() && d == b.dialects().back()) return true;
        return sampled(e.name() + b.label(d), e.bound.empty() && !e.alike && main(d) ? every : other_every);
    }
    /// True when the implementation may reorder sums. Tiers B and C then have to keep their bounds.
    [[nodiscard]] bool may_reorder() const { return driver == "hardware" || driver == "fused"; }
    /// A table lists every entry or is not written.
    [[nodiscard]] bool tables() const { return filter.empty() && planted.from.empty(); }
};

options parse(int argc, char** argv) {
    options o;
    for (int i = 0; i < argc; ++i) o.command += (i ? " " : "") + std::string(i ? argv[i] : "parity");
    for (int i = 1; i < argc; i += 2) {
        const std::string name = argv[i];
        if (i + 1 >= argc) throw std::invalid_argument(name + " needs a value");
        const std::string value = argv[i + 1];
        if (name == "--backend") o.driver = value;
        else if (name == "--filter") o.filter = value;
        else if (name == "--versions") o.versions = value;
        else if (name == "--out") o.out = value;
        else if (name == "--report") o.report = value;
        else if (name == "--mistake") planted = {value.substr(0, value.find('=')), value.substr(value.find('=') + 1)};
        else if (name == "--whole") o.whole = std::stoull(value);
        else if (name == "--count") o.count = std::stoull(value);
        else if (name == "--other-count") o.other_count = std::stoull(value);
        else if (name == "--every") o.every = std::stoull(value);
        else if (name == "--other-every") o.other_every = std::stoull(value);
        else throw std::invalid_argument("unknown option " + name + ", see --help");
    }
    if (o.driver.empty()) throw std::invalid_argument("which --backend? See --help");
    const auto wanted = [&](const entry& e) { return e.name().find(o.filter) != std::string::npos; };
    if (std::ranges::none_of(entries(), wanted))
        throw std::invalid_argument("no entry's name has " + o.filter + " in it");
    return o;
}

constexpr std::size_t at_most = std::size_t(1) << 20;  // inputs of one draw

std::vector<row> run(const entry& e, backend& b, const options& o) {
    const bool only = b.dialects().size() == 1;
    std::vector<dialect> dialects;
    for (dialect d : b.dialects())
        if (e.runs_in(d) && o.wants(b, d) && o.samples(e, b, d) && o.inputs(e, d, only) > 0) dialects.push_back(d);
    std::vector<row> rows;
    for (dialect d : dialects) rows.push_back({e.name(), promised(e), b.name(), b.label(d), b.obstacle(e)});
    if (rows.empty() || !rows.front().obstacle.empty()) return rows;

    std::size_t most = 0;
    for (dialect d : dialects) most = std::max(most, o.inputs(e, d, only));
    static std::uint64_t serial = 0;
    bool told = false;  // one dialect's differences in full are enough
    const auto judge = [&](const job& j, const expectation& expected, std::size_t d, std::size_t count) {
        row& r = rows[d];
        if (!r.broken.empty()) return;
        std::ostringstream log;
        try {
            compare(j, expected, b.run(dialects[d], j, count), r.t, log);
        } catch (const std::exception& error) {
            r.broken = error.what();
            std::cout << "BROKEN: " << e.name() << " in " << r.language << ": " << r.broken << std::endl;
        }
        if (log.str().empty()) return;
        r.take_example(log.str());
        std::cout << "in " << r.language << '\n';
        std::cout << (std::exchange(told, true) ? "  differs: " + e.name() + '\n' : log.str());
    };

    const std::size_t maps = std::max<std::size_t>(e.maps.size(), 1);
    for (std::size_t m = 0; m < maps; ++m) {
        const texels* map = e.maps.empty() ? nullptr : &e.maps[m];
        const texels flat = map ? flush(*map) : texels();
        for (std::size_t first = 0; first < most / maps; first += at_most) {
            const job j = make_job(e, map, first, std::min(at_most, most / maps - first), serial++);
            const expectation expected = expect(j, map ? &flat : nullptr, o.may_reorder());
            for (std::size_t d = 0; d < dialects.size(); ++d) {
                const std::size_t wanted = o.inputs(e, dialects[d], only) / maps;
                if (wanted > first) judge(j, expected, d, std::min(j.count, wanted - first));
            }
        }
    }

    const std::size_t whole = std::min<std::size_t>(o.whole, e.whole.count);
    const texels flat = e.maps.empty() ? texels() : flush(e.maps.front());
    std::size_t last = dialects.size() - 1;
    while (last > 0 && !(dialects[last].in == dialect::glsl && options::main(dialects[last]))) --last;
    for (std::size_t first = 0; first < whole; first += at_most) {
        const job j = make_whole_job(e, first, std::min(at_most, whole - first), serial++);
        judge(j, expect(j, e.maps.empty() ? nullptr : &flat, o.may_reorder()), last, j.count);
    }
    return rows;
}

backends find(const std::string& driver) {
    if (driver == "c++") return cpp_backends();
    if (driver == "fused") return fused_backends();
    if (driver == "metal") return metal_backends();
    for (const char* vulkan : {"lavapipe", "lavapipe_compute", "swiftshader_vulkan"})
        if (driver == vulkan) return vulkan_backends(driver);
    if (driver == "naga") return naga_backends({UMBRAGE_NODE, UMBRAGE_SCRIPTS "/naga.js", UMBRAGE_NODE_MODULES});
    if (driver == "swiftshader") return webgl_backends();
    if (driver == "tint") return webgpu_backends();
    if (driver != "llvmpipe" && driver != "softpipe" && driver != "hardware")
        throw std::invalid_argument("no backend is called " + driver + ", see --help");
    backends all = egl_backends(driver);
    if (driver == "hardware")
        for (auto& b : vulkan_backends(driver)) all.push_back(std::move(b));
    return all;
}

void print_arithmetic(const report& r) {
    std::cout << "arithmetic of " << r.of.api << ", " << r.probed_in;
    if (!r.probed) std::cout << "; not probed: " << r.unprobed;
    else
        for (const std::string& line : described(*r.probed)) std::cout << "; " << line;
    std::cout << std::endl;
}

/// How far a run is, on stderr: in a terminal one line that changes. Elsewhere a run that writes pages has a line each
/// quarter.
class progress {
public:
    explicit progress(bool has_pages) : has_pages_(has_pages) {}
    progress(const progress&) = delete;
    progress& operator=(const progress&) = delete;
    ~progress() {
        if (is_terminal_) std::cerr << "\r\33[K";
    }
    /// @param done, of   entries before this one, and all that run
    void at(const entry& e, std::size_t done, std::size_t of) {
        const std::size_t percent = 100 * done / of;
        if (is_terminal_) std::cerr << "\r\33[K" << percent << " % " << e.name() << std::flush;
        else if (has_pages_ && percent / 25 > quarter_) {
            quarter_ = percent / 25;
            std::cerr << quarter_ * 25 << " %" << std::endl;
        }
    }

private:
    bool has_pages_, is_terminal_ = isatty(STDERR_FILENO) != 0;
    std::size_t quarter_ = 0;
};

/// A page for each API, of the rows in its dialects.
void write(const std::vector<report>& reports, const std::vector<row>& rows, const options& o) {
    for (report r : reports) {
        for (const row& one : rows)
            if (std::ranges::find(r.dialects, one.language) != r.dialects.end()) r.rows.push_back(one);
        std::cout << "written: " << write(r, o.command, o.report) << '\n';
    }
}

int run_all(int argc, char** argv) {
    if (argc == 1 || (argc == 2 && std::string_view(argv[1]) == "--help")) {
        std::cout << usage;
        return 0;
    }
    const options o = parse(argc, argv);
    const auto start = std::chrono::steady_clock::now();
    const backends all = find(o.driver);
    if (all.empty()) {
        const bool gpu = o.driver == "hardware";
        std::cout << "SKIPPED: " << (gpu ? "neither EGL nor Vulkan has a GPU here" : "no " + o.driver + " here")
                  << '\n';
        return 77;
    }
    std::vector<const entry*> chosen;
    for (const entry& e : entries())
        if (e.name().find(o.filter) != std::string::npos) chosen.push_back(&e);
    std::vector<row> rows;
    for (const auto& b : all) {
        std::cout << o.driver << " is " << b->name() << std::endl;
        std::vector<report> reports;
        if (o.driver == "hardware" || !o.report.empty()) reports = probe_all(*b);
        for (const report& r : reports) print_arithmetic(r);
        const std::size_t first = rows.size();
        progress told(!o.report.empty());
        for (std::size_t i = 0; i < chosen.size(); ++i) {
            told.at(*chosen[i], i, chosen.size());
            const auto some = run(*chosen[i], *b, o);
            rows.insert(rows.end(), some.begin(), some.end());
        }
        if (!o.report.empty()) write(reports, {rows.begin() + first, rows.end()}, o);
    }
    print(std::cout, rows);
    print(std::cout, by_tier(rows));
    if (o.tables()) write(rows, o.out + "/parity-" + o.driver + ".tsv");

    std::uint64_t inputs = 0, different = 0, starved = 0, not_run = 0, broken = 0;
    for (const row& r : rows) {
        inputs += r.t.total;
        different += r.t.different;
        not_run += r.obstacle.empty() ? 0 : 1;
        broken += r.broken.empty() ? 0 : 1;
        for (const auto& [name, n] : r.t.inputs) starved += n == 0 ? 1 : 0;
    }
    const std::chrono::duration<double> seconds = std::chrono::steady_clock::now() - start;
    std::cout << "parity on " << o.driver << ": " << entries().size() << " entries, " << rows.size() - not_run
              << " runs, " << not_run << " not possible here, " << inputs << " inputs, " << different
              << " differing results, " << broken << " broken runs, " << starved << " classes without input, "
              << std::fixed << std::setprecision(1) << seconds.count() << " s\n";
    if (!planted.from.empty()) return different ? 0 : 1;
    return different || broken || starved || inputs == 0 ? 1 : 0;
}

}  // namespace
}  // namespace parity

int main(int argc, char** argv) try { return parity::run_all(argc, argv); } catch (const std::exception& error) {
    std::cerr << "parity: " << error.what() << '\n';
    return 2;
}
