// SPDX-License-Identifier: MIT
#include <algorithm>
#include <cmath>
#include <map>
#include <sstream>
#include <string>

#include <names.hpp>
#include <soft.hpp>

#include <check.hpp>

using namespace shadow_render_check;

namespace {

const std::string tiny = "--scene solids --size 48x32 ";

struct row {
    double error, leak;  ///< per cent
    std::string bias;
};

/// The printed table.
std::map<std::string, row> rows(const std::string& options) {
    const example::finished r = run("filters --output " + quoted(folder / "sheet") + tiny + options);
    REQUIRE_MESSAGE(r.code == 0, r.said);
    std::map<std::string, row> out;
    std::istringstream lines(r.said.substr(r.said.find("\n\n")));
    for (std::string line; std::getline(lines, line);) {
        std::istringstream columns(line);
        std::string name, skipped;
        row of{};
        if (columns >> name >> of.error >> skipped >> of.leak >> skipped >> skipped >> skipped >> skipped >> of.bias)
            out[name] = of;
    }
    return out;
}

std::vector<std::string> every_filter() {
    std::vector<std::string> all = example::filter_names();
    for (const auto* more : {&example::hardening_names(), &example::prefilter_names()})
        all.insert(all.end(), more->begin(), more->end());
    return all;
}

}  // namespace

TEST_CASE("studies: the sheet has a cell for every filter, each with its own picture") {
    const auto table = rows("--map-size 128");
    const auto sheet = picture("sheet", "filters.png");
    constexpr int top = 112, width = 64, height = 120;  // of the title, of a cell
    const auto lines = static_cast<int>(every_filter().size() + 4) / 4;
    REQUIRE(sheet.size() == glm::ivec2(4 * width, top + lines * height));

    int cell = 0;  // the first is the rays'
    for (const std::string& filter : every_filter()) {
        ++cell;
        CAPTURE(filter);
        REQUIRE(table.contains(filter));
        CHECK(table.at(filter).error > 0);
        CHECK(table.at(filter).error < 30);
        const glm::ivec2 at(cell % 4 * width, top + cell / 4 * height);
        int ink = 0;
        for (int y = 32; y < height; ++y)
            for (int x = 0; x < width; ++x) ink += sheet[at + glm::ivec2(x, y)].r > 200;
        CHECK(ink > 50);  // a name and numbers
        if (filter != "hard" && filter != "disc16" && filter != "pcss16" && filter != "evsm4") continue;
        REQUIRE(example::run_line(quoted(SHADOW_RENDER) + output("alone") + tiny + "--map-size 128 --filter " + filter)
                    .code == 0);
        const auto alone = picture("alone", "picture.png");
        int differ = 0;
        for (int y = 0; y < 32; ++y)
            for (int x = 0; x < 48; ++x) differ += alone[{x, y}] != sheet[at + glm::ivec2(x, y)];
        CHECK(differ == 0);
    }
}

TEST_CASE("studies: errors are those against a light of the size that was asked for") {
    const auto point = rows("--bias acne_free --light-size 0 --map-size 1024"),
               wide = rows("--bias acne_free --light-size 0.8 --map-size 1024");
    CHECK(point.at("hard").error < 2);
    CHECK(point.at("hard").error < point.at("tent7").error);
    CHECK(wide.at("tent7").error < wide.at("hard").error);
    for (const std::string hardening : {"pcss16", "pcss32"}) {  // which knows that size
        CHECK(wide.at(hardening).error < wide.at("tent7").error);
        CHECK(point.at(hardening).error < point.at("tent7").error);
    }
}

TEST_CASE("studies: each filter has a bias under which a wide one errs by less than a hard one") {
    const auto usual = rows("--map-size 1024"), offset = rows("--map-size 1024 --bias normal_offset");
    for (const auto& [filter, row] : usual) {
        CAPTURE(filter);
        const bool hardens = filter.starts_with("pcss") || filter.starts_with("dpcf");
        CHECK(row.bias == (hardens ? "receiver_plane" : "acne_free"));
        CHECK(offset.at(filter).bias == "normal_offset");
    }
    for (const std::string wide : {"castano7", "pcss16", "dpcf16", "tent7", "box"}) {
        CAPTURE(wide);
        CHECK(usual.at(wide).error < usual.at("hard").error);
        CHECK(2 * usual.at(wide).error < offset.at(wide).error);
    }
    CHECK(usual.at("pcss16").error < usual.at("castano7").error);
}

TEST_CASE("studies: what filters cost on a GPU is read from a table, or is a dash") {
    const std::string table = file("shaders.tsv",
                                   "job\twhose\tshader\tinstructions\tinv. thrpt\tlatency\n"
                                   "every snippet\tumbrage\ttent3\t158\t232\t819\n"
                                   "every snippet\tother\thard\t1\t2\t3\n");
    const example::finished r =
        run("filters --output " + quoted(folder / "sheet") + tiny + "--map-size 128 --shaders " + table);
    REQUIRE_MESSAGE(r.code == 0, r.said);
    CHECK(r.said.find("158 instructions, 232 cycles") != std::string::npos);
    CHECK(std::ranges::count(r.said.substr(r.said.find("RDNA2\n")), '-') ==
          static_cast<int>(every_filter().size()) - 1);
    fails(output("sheet") + tiny + "filters --shaders " + file("no_table.tsv", "once upon a time\n"), 1, "not a table");
    fails(output("sheet") + tiny + "filters --shaders none.tsv", 1, "none.tsv");
    fails("filters --scene outdoor", 2, "--scene");
}
