// SPDX-License-Identifier: MIT
//
// WebGL 1 and WebGL 2 in a headless browser, on SwiftShader; webgl.js draws.
#include <sys/wait.h>
#include <unistd.h>

#include <csignal>
#include <cstring>
#include <filesystem>
#include <iostream>
#include <sstream>
#include <stdexcept>

#include "backend.hpp"
#include "shader.hpp"

namespace parity {
namespace {

/// A program on whose standard input and output blocks of bytes go to and fro.
class child {
public:
    explicit child(std::vector<std::string> words) {
        int in[2], out[2];
        if (pipe(in) != 0 || pipe(out) != 0) throw std::runtime_error("no pipe");
        std::signal(SIGPIPE, SIG_IGN);
        id_ = fork();
        if (id_ == 0) {
            dup2(in[0], STDIN_FILENO);
            dup2(out[1], STDOUT_FILENO);
            for (int end : {in[0], in[1], out[0], out[1]}) close(end);
            std::vector<char*> arguments;
            for (std::string& w : words) arguments.push_back(w.data());
            arguments.push_back(nullptr);
            execv(arguments[0], arguments.data());
            _exit(127);
        }
        close(in[0]);
        close(out[1]);
        to_ = in[1];
        from_ = out[0];
    }
    ~child() {
        close(to_);  // it ends by itself then
        close(from_);
        waitpid(id_, nullptr, 0);
    }
    child(const child&) = delete;
    child& operator=(const child&) = delete;

    std::string answer(const std::string& block) {
        auto length = static_cast<std::uint32_t>(block.size());
        all(::write, to_, reinterpret_cast<char*>(&length), sizeof length);
        all(::write, to_, block.data(), block.size());
        all(::read, from_, reinterpret_cast<char*>(&length), sizeof length);
        std::string result(length, '\0');
        all(::read, from_, result.data(), length);
        return result;
    }

private:
    template <class Move, class Bytes>
    static void all(Move move, int end, Bytes bytes, std::size_t count) {
        for (std::size_t done = 0; done < count;) {
            const ssize_t n = move(end, bytes + done, count - done);
            if (n <= 0) throw std::runtime_error("the browser has gone");
            done += static_cast<std::size_t>(n);
        }
    }

    pid_t id_ = 0;
    int to_ = -1, from_ = -1;
};

class webgl final : public backend {
public:
    static constexpr int width = 1024;

    webgl() : browser_({UMBRAGE_NODE, UMBRAGE_WEBGL_JS, UMBRAGE_CHROMIUM, UMBRAGE_NODE_MODULES}) {
        for (version v : {version::v100, version::v300_es})
            name_ = ask({"{\"hello\": true, \"version\": " + number(v) + "}"});
    }

    [[nodiscard]] std::string name() const override {
        return name_.find("SwiftShader") == std::string::npos ? "WebGL on " + name_ : "SwiftShader (" + name_ + ")";
    }
    [[nodiscard]] std::vector<dialect> dialects() const override { return {version::v100, version::v300_es}; }
    [[nodiscard]] std::string label(dialect d) const override { return "WebGL " + number(d); }

    [[nodiscard]] std::vector<vec4> run(dialect d, const job& j, std::size_t count) override {
        const int height = static_cast<int>((j.count + width - 1) / width);
        const int rows = static_cast<int>((count + width - 1) / width);
        const bool bytes = j.what->output == target::rgba8;
        const vec2 map_size(j.map ? j.map->size() : ivec2(0));
        const shader text = make_shader(*j.what, d);

        std::ostringstream head;
        std::vector<std::string> parts{"", text.vertex, text.fragment};
        head << "{\"version\": " << number(d) << ", \"bytes\": " << (bytes ? "true" : "false") << ", \"size\": ["
             << width << ", " << height << "], \"rows\": " << rows << ", \"map_size\": [" << map_size.x << ", "
             << map_size.y << "], \"spare_unit\": " << max_inputs + 2;
        if (serial_ != j.serial) {
            head << ", \"textures\": [";
            const auto names = samplers(*j.what);
            const auto add = [&](std::size_t unit, const auto& values, ivec2 size) {
                head << (parts.size() > 3 ? ", " : "") << "{\"name\": \"" << names[unit] << "\", \"unit\": " << unit
                     << ", \"size\": [" << size.x << ", " << size.y << "]}";
                std::string floats(static_cast<std::size_t>(size.x * size.y) * sizeof(vec4), '\0');
                std::memcpy(floats.data(), values.data(), values.size() * sizeof(vec4));
                parts.push_back(std::move(floats));
            };
            for (std::size_t k = 0; k < max_inputs; ++k)
                if (!j.x[k].empty()) add(k, j.x[k], {width, height});
            if (j.map) add(max_inputs, j.map->texels(), j.map->size());
            if (!j.what->table.empty()) add(max_inputs + 1, j.what->table.texels(), j.what->table.size());
            head << ']';
            serial_ = j.serial;
        }
        head << '}';
        parts.front() = head.str();

        const std::string pixels = ask(parts);
        std::vector<vec4> result(count);
        if (bytes) {
            const auto* read = reinterpret_cast<const glm::vec<4, std::uint8_t>*>(pixels.data());
            std::copy(read, read + count, result.begin());
        } else {
            std::memcpy(result.data(), pixels.data(), count * sizeof(vec4));
        }
        return result;
    }

private:
    static std::string number(dialect d) { return d == version::v100 ? "1" : "2"; }

    /// Sends parts as webgl.js wants them.
    std::string ask(const std::vector<std::string>& parts) {
        std::string block;
        for (const std::string& p : parts) {
            const auto length = static_cast<std::uint32_t>(p.size());
            block.append(reinterpret_cast<const char*>(&length), sizeof length);
            block += p;
            block.append((4 - p.size() % 4) % 4, '\0');
        }
        std::string answer = browser_.answer(block);
        const bool good = answer.at(0) == 0;
        answer.erase(0, 1);
        if (!good) throw std::runtime_error(answer);
        return answer;
    }

    child browser_;
    std::string name_;
    std::uint64_t serial_ = ~std::uint64_t(0);
};

}  // namespace

backends webgl_backends() {
    backends all;
    for (const char* need : {UMBRAGE_NODE, UMBRAGE_CHROMIUM, UMBRAGE_NODE_MODULES "/playwright-core"}) {
        if (std::filesystem::exists(need)) continue;
        std::cout << "missing: " << need << '\n';
        return all;
    }
    all.push_back(std::make_unique<webgl>());
    return all;
}

}  // namespace parity
