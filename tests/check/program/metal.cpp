// SPDX-License-Identifier: MIT
#include "metal.hpp"

#include <fcntl.h>
#include <sys/resource.h>

#include <cstring>
#include <fstream>
#include <sstream>

#include "backends/child.hpp"
#include "backends/metal/run.hpp"
#include "shader.hpp"
#include "texture.hpp"

namespace check {
namespace {

using std::filesystem::path;

/// A folder that lives as long as this.
class scratch {
public:
    scratch() {
        std::string name = (std::filesystem::temp_directory_path() / "umbrage-check-XXXXXX").string();
        if (!mkdtemp(name.data())) throw std::runtime_error("cannot make a folder " + name);
        folder_ = name;
    }
    ~scratch() {
        std::error_code ignored;
        remove_all(folder_, ignored);
    }
    scratch(const scratch&) = delete;
    scratch& operator=(const scratch&) = delete;
    [[nodiscard]] path file(const char* name) const { return folder_ / name; }

private:
    path folder_;
};

/// True if a program ends well within a minute of processor time. What it prints goes to a file.
bool succeeds(std::vector<std::string> words, const path& log) {
    const pid_t id = fork();
    if (id == 0) {
        const rlimit minute{60, 60};
        setrlimit(RLIMIT_CPU, &minute);
        const int to = open(log.c_str(), O_WRONLY | O_CREAT | O_TRUNC, 0600);
        dup2(to, STDOUT_FILENO);
        dup2(to, STDERR_FILENO);
        std::vector<char*> arguments;
        for (std::string& w : words) arguments.push_back(w.data());
        arguments.push_back(nullptr);
        execv(arguments[0], arguments.data());
        _exit(127);
    }
    int status = 1;
    return id > 0 && waitpid(id, &status, 0) == id && status == 0;
}

std::string content(const path& file) {
    std::ostringstream all;
    all << std::ifstream(file).rdbuf();
    return all.str();
}

constexpr const char* head = "#include \"run.hpp\"\n#include <metal_stdlib>\nnamespace guest {\n";
constexpr const char* tail = R"(
#line 1 "the program around the text"
}  // namespace guest
int main(int, char** words) {
    using parity::metal_text::memory;
    parity::metal_text::serve(std::atoi(words[1]), [](const float* c, const memory* maps, float* result) {
        const float4 all = guest::umbrage_call(float4(c[0], c[1], c[2], c[3]), maps);
        for (int i = 0; i < 4; ++i) result[i] = all[i];
    });
}
)";

class metal final : public parity::backend {
public:
    explicit metal(const metal_files& files) : files_(files) {}

    [[nodiscard]] std::string name() const override { return files_.compiler.filename().string(); }
    [[nodiscard]] std::vector<parity::dialect> dialects() const override { return {parity::dialect::msl}; }
    [[nodiscard]] std::vector<parity::vec4> run(parity::dialect, const parity::job& j, std::size_t count) override {
        if (compiled_ != j.what) start(*j.what);
        const std::string bytes = program_->answer(block(j, count));
        std::vector<parity::vec4> results(count);
        if (bytes.size() != count * sizeof results[0]) throw std::runtime_error("the program gave too few results");
        std::memcpy(static_cast<void*>(results.data()), bytes.data(), bytes.size());
        return results;
    }

private:
    /// Compiles an entry's text and starts it. Its files are gone then.
    void start(const parity::entry& e) {
        compiled_ = nullptr;
        const scratch folder;
        const path source = folder.file("guest.cpp"), program = folder.file("guest"), log = folder.file("log");
        std::ofstream(source) << head << e.visitor->text << tail;
        const bool clang = name().find("clang") != std::string::npos;
        const std::vector<std::string> command{files_.compiler.string(), "-std=c++20", "-O1", "-w", "-ffp-contract=off",
                                               "-fno-finite-loops",
                                               // Metal's literals are floats
                                               clang ? "-cl-single-precision-constant" : "-fsingle-precision-constant",
                                               clang ? "-ferror-limit=4" : "-fmax-errors=4",
                                               "-I" + files_.headers.string(), source.string(), "-o", program.string()};
        if (!succeeds(command, log)) throw std::runtime_error(content(log));
        program_ = std::make_unique<parity::child>(std::vector{program.string(), std::to_string(files_.seconds)});
        program_->answer(block({}, 0));  // an answer: it has begun, and needs its file no more
        compiled_ = &e;
    }

    /// As serve() in run.hpp reads it.
    static std::string block(const parity::job& j, std::size_t count) {
        using namespace parity::metal_text;
        std::array<std::string, guest_maps> maps;
        for (std::string& m : maps) m.resize(sizeof(map_header));
        for (const parity::filled_texture& t : j.what ? textures(j) : std::vector<parity::filled_texture>{})
            for (std::size_t k = 0; k < maps.size(); ++k) {
                if (t.unit != parity::map_unit(k)) continue;
                const std::string texels = t.bytes();
                const map_header h{std::uint32_t(t.image.size.x), std::uint32_t(t.image.size.y),
                                   std::uint32_t(t.image.compare), t.image.linear, std::uint32_t(texels.size())};
                std::memcpy(maps[k].data(), &h, sizeof h);
                maps[k] += texels;
            }
        std::string all;
        for (const std::string& m : maps) all += m;
        if (count > 0) all.append(reinterpret_cast<const char*>(j.x[0].data()), count * sizeof(parity::vec4));
        return all;
    }

    metal_files files_;
    const parity::entry* compiled_ = nullptr;
    std::unique_ptr<parity::child> program_{};
};

}  // namespace

std::unique_ptr<parity::backend> metal_as_cpp(const metal_files& files) { return std::make_unique<metal>(files); }

}  // namespace check
