// SPDX-License-Identifier: MIT
#include <doctest/doctest.h>

#include <filesystem>
#include <fstream>
#include <string>

#include <umbrage/registry.hpp>

#include "proof.hpp"

namespace {

namespace fs = std::filesystem;

/// A folder of reports, empty at first and gone at last.
struct reports {
    const fs::path folder = fs::current_path() / "proof_test_reports";

    reports() {
        fs::remove_all(folder);
        fs::create_directories(folder);
    }
    ~reports() { fs::remove_all(folder); }

    /// Every snippet once in each dialect, 8 inputs.
    void add(const std::string& backend, const std::string& name, std::initializer_list<const char*> dialects) const {
        std::ofstream file(folder / ("parity-" + backend + ".tsv"));
        file << "primitive\ttier\timplementation\tdialect\tinputs\tdiffering\tworst_ulp\tflushed\tclasses\n";
        for (const umbrage::glsl::snippet* s : umbrage::glsl::registry())
            for (const std::string dialect : dialects)
                file << s->name << "\tA\t" << name << '\t' << dialect << "\t8\t0\t0\t0\tzero=8\t\n";
    }
    [[nodiscard]] std::string table() const { return readme::read_proof(folder).implementations; }
};

bool has(const std::string& text, const std::string& part) { return text.find(part) != text.npos; }

const std::string software = "Every implementation above is software";

}  // namespace

TEST_CASE("proof: a row for each language that an implementation runs") {
    const reports all;
    all.add("lavapipe", "lavapipe (LLVM 15)", {"Vulkan", "HLSL"});
    all.add("metal", "Metal as C++", {"MSL"});
    all.add("softpipe", "softpipe", {"100", "330"});
    const std::string table = all.table();
    CHECK(has(table, "\n| lavapipe | CPU | GLSL | 1 | "));
    CHECK(has(table, "\n| lavapipe | CPU | HLSL | 1 | "));
    CHECK(has(table, "\n| Metal as C++ | CPU | Metal | 1 | "));
    CHECK(has(table, "\n| softpipe | CPU | GLSL | 2 | "));
    CHECK(has(table, "\nWGSL was not run.\n"));
    CHECK_FALSE(has(table, "HLSL was not run"));
}

TEST_CASE("proof: it says that all of it is software while no GPU is among them") {
    const reports all;
    all.add("naga", "naga (lavapipe)", {"WGSL"});
    CHECK(has(all.table(), "\n| naga | CPU | WGSL | 1 | "));
    CHECK(has(all.table(), software));
    all.add("hardware", "Some GPU", {"450"});
    CHECK(has(all.table(), "\n| Some GPU | GPU | GLSL | 1 | "));
    CHECK_FALSE(has(all.table(), software));
}
