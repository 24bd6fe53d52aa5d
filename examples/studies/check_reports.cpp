// SPDX-License-Identifier: MIT
#include <algorithm>
#include <cmath>
#include <sstream>
#include <string>

#include <setups.hpp>
#include <stability.hpp>

#include <check.hpp>

using namespace shadow_render_check;
using example::setups;

TEST_CASE("studies: the report on lights has a row and a picture for every setup") {
    const example::finished r =
        run("lights --scene solids --size 96x64 --map-size 64 --output " + quoted(folder / "report"));
    REQUIRE_MESSAGE(r.code == 0, r.said);
    const auto sheet = picture("report", "lights.png");
    constexpr int top = 88, width = 48, height = 120;  // of the title, of a cell
    const int count = static_cast<int>(setups().size());
    REQUIRE(sheet.size() == glm::ivec2(4 * width, top + (count + 3) / 4 * height));
    for (int cell = 0; cell < count; ++cell) {
        const std::string& name = setups()[static_cast<std::size_t>(cell)].name;
        CAPTURE(name);
        const std::size_t row = r.said.find("\n" + name + "  ");
        REQUIRE(row != std::string::npos);
        double mean = 0, p95 = 0, greatest = 0, storage = 0, pixels = 0;
        std::istringstream(r.said.substr(row + 1 + name.size())) >> mean >> p95 >> greatest >> storage >> pixels;
        CHECK(mean > 0);
        CHECK(p95 > 0);
        CHECK(std::max(mean, p95) < greatest);
        CHECK(storage > 0);
        CHECK(std::isfinite(greatest + storage));
        CHECK(pixels > 800);
        int colored = 0;
        for (glm::ivec2 p{0}; p.y < 32; ++p.y)
            for (p.x = 0; p.x < width; ++p.x) {
                const glm::u8vec4 c = sheet[glm::ivec2(cell % 4 * width, top + cell / 4 * height) + p];
                colored += c.r != c.g || c.g != c.b;
            }
        CHECK(colored == pixels);
    }
    fails("lights --map-size 15", 2, "--map-size");
}

TEST_CASE("studies: stable cascades stand still, tight ones do not, in the table and on film") {
    const example::finished r =
        run("stability --scene solids --size 96x64 --map-size 128 --output " + quoted(folder / "stability"));
    REQUIRE_MESSAGE(r.code == 0, r.said);
    for (const std::string where : {"", ", 3 km out"}) {
        const auto of = [&](const std::string& name) {
            CAPTURE(name);
            const std::size_t row = r.said.find("\n" + name + where + "  ");
            REQUIRE(row != std::string::npos);
            example::stability_report found;
            double percent = 0;
            std::istringstream(r.said.substr(row + 1 + name.size() + where.size())) >> found.drift >> found.compared >>
                found.changed >> percent >> found.change;
            CHECK(found.compared > 300);
            return found;
        };
        CHECK(of("4 practical spheres, double").drift == 0);
        CHECK(of("4 practical spheres, float").drift < 1e-4);
        CHECK(of("4 practical spheres, float, one matrix").drift < 0.01);
        CHECK(of("4 practical spheres, double").changed == 0);
        CHECK(of("4 practical spheres, float").change < 2.01 / 256);  // a step of weights in x, and in y
        CHECK(of("4 practical tight, float").change > 0.1);
        CHECK(of("4 practical tight, float").drift > 0.3);
        CHECK(of("4 practical tight, float").changed > 0);
    }
    const auto film = picture("stability", "film.png");
    constexpr int top = 88, width = 96, height = 64 + 88;
    REQUIRE(film.size() == glm::ivec2(4 * width, top + 4 * height));
    const auto differ = [&](int row, int frame) {  // from the first frame
        int count = 0;
        for (glm::ivec2 p(0, top + row * height); p.y < top + row * height + 64; ++p.y)
            for (p.x = 0; p.x < width; ++p.x) count += film[p] != film[p + glm::ivec2(frame * width, 0)];
        return count;
    };
    for (int frame : {1, 2, 3}) {
        CHECK(differ(0, frame) > 1000);
        CHECK(differ(1, frame) == 0);
        CHECK(differ(3, frame) > 50);
    }
    const auto sun = picture("stability", "sun.png");
    REQUIRE(sun.size() == glm::ivec2(4 * width, top - 24 + 4 * height));
    for (const std::string name :
         {"light-space perspective", "perspective", "trapezoidal", "light-space perspective or none, by quality"}) {
        CAPTURE(name);
        const std::size_t row = r.said.find("\n" + name + "  ");
        REQUIRE(row != std::string::npos);
        double hands_over = 0, there = 0, off_rays = 0, most = 0;
        std::istringstream(r.said.substr(row + 1 + name.size())) >> hands_over >> there >> off_rays >> most;
        if (name.ends_with("by quality")) CHECK(there < 2);
        else CHECK(there == 0);
        if (name == "light-space perspective" || name == "trapezoidal") CHECK(hands_over == 1);
        CHECK(off_rays > 0);
        CHECK(most < 5);
    }
    CHECK(picture("stability", "pages.png").size() == glm::ivec2(4 * width, top - 24 + 2 * height));
    for (const std::string name : {"256 pages", "36 pages"}) {
        CAPTURE(name);
        const std::size_t row = r.said.find("\n" + name + "  ");
        REQUIRE(row != std::string::npos);
        double drawn = 0, given_up = 0, forced = 0, target = 0, popped = 0, unforced = -1;
        std::istringstream(r.said.substr(row + 1 + name.size())) >> drawn >> given_up >> forced >> target >> popped >>
            unforced;
        const bool suffices = name == "256 pages";
        CHECK(drawn > 36);
        CHECK((forced == 0) == suffices);
        CHECK((target == 1) == suffices);
        CHECK((popped == 0) == suffices);
        CHECK(unforced == 0);
    }
    fails("stability lights", 2, "lights");
    fails("", 2, "study");
    fails("pictures", 2, "study");
}

TEST_CASE("setups: one map and four from measured depths, on a kilometre of ground under suns all around") {
    example::scene ground;
    ground.low = {-600, 0, -1000}, ground.high = {600, 10, 200};
    ground.geometry = {{{-600, 0, -1000}, {600, 0, -1000}, {600, 0, 200}, {-600, 0, 200}},
                       std::vector(4, glm::vec3(0, 1, 0)),
                       std::vector(4, glm::vec3(1)),
                       {{0, 2, 1}, {0, 3, 2}}};
    const glm::ivec2 screen(1280, 720);
    const glm::vec3 eye(0, 2, 0), ahead(0, 0, -1), up(0, 1, 0);
    const float fov = glm::radians(60.0f), tangent = std::tan(fov / 2), aspect = 1280.0f / 720;
    const example::camera camera{
        eye,
        glm::perspectiveRH_ZO(fov, aspect, 0.5f, 1000.0f) * glm::lookAtRH(eye, ahead + eye, up),
        {eye, ahead, up, tangent * aspect, tangent, 0.5, 1000}};
    struct row {
        float elevation, azimuth;
        double p95, greatest, cascades_p95, cascades_greatest;
    };
    // of an implementation apart from this one, by finite differences
    for (const row& r : {row{90, 180, 116, 143, 5.05, 5.51},
                         {45, 90, 116, 143, 6.67, 7.17},
                         {20, 90, 117, 144, 9.57, 10.2},
                         {45, 0, 116, 143, 5.40, 6.49},
                         {15, 0, 117, 145, 8.21, 11.0}}) {
        CAPTURE(r.elevation);
        const glm::dvec3 direction(-example::direction_at(r.azimuth, r.elevation));
        const auto v = example::make_lit_view(ground, camera, screen, {{}, direction, ahead, 0.5}, 2048);
        const auto of = [&](const char* name) {
            const auto s = std::ranges::find(setups(), name, &example::setup::name);
            REQUIRE(s != setups().end());
            return measure(*s, v, 4);
        };
        const auto one = of("tight"), four = of("4 logarithmic tight, measured");
        CHECK(one.p95 == doctest::Approx(r.p95).epsilon(0.1));
        CHECK(one.greatest == doctest::Approx(r.greatest).epsilon(0.1));
        CHECK(four.p95 == doctest::Approx(r.cascades_p95).epsilon(0.1));
        CHECK(four.greatest == doctest::Approx(r.cascades_greatest).epsilon(0.1));
        CHECK(of("4 uniform tight, measured").p95 > 5 * four.p95);
        CHECK(of("256 pages").p95 * 20 < one.p95);
    }
}
