// SPDX-License-Identifier: MIT
//
// Programs in other languages that do a part of the work; frames.js is their end.
#pragma once

#include <fcntl.h>
#include <sys/wait.h>
#include <unistd.h>

#include <csignal>
#include <cstdint>
#include <filesystem>
#include <initializer_list>
#include <iostream>
#include <stdexcept>
#include <string>
#include <vector>

namespace parity {

/// True when all of these files exist. Prints the name of a missing one.
inline bool all_exist(std::initializer_list<std::filesystem::path> files) {
    for (const std::filesystem::path& file : files) {
        if (exists(file)) continue;
        std::cout << "missing: " << file.string() << '\n';
        return false;
    }
    return true;
}

/// Program that exchanges blocks of bytes through its standard input and output.
class child {
public:
    explicit child(std::vector<std::string> words) {
        int in[2], out[2];
        if (pipe(in) != 0 || pipe(out) != 0) throw std::runtime_error("no pipe");
        for (int end : {in[0], in[1], out[0], out[1]}) fcntl(end, F_SETFD, FD_CLOEXEC);  // not for other children
        std::signal(SIGPIPE, SIG_IGN);
        id_ = fork();
        if (id_ == 0) {
            dup2(in[0], STDIN_FILENO);
            dup2(out[1], STDOUT_FILENO);
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

    /// Answer of the process to a block.
    /// @throws std::runtime_error   with its words
    std::string answer(const std::string& block) {
        auto length = static_cast<std::uint32_t>(block.size());
        all(::write, to_, reinterpret_cast<char*>(&length), sizeof length);
        all(::write, to_, block.data(), block.size());
        all(::read, from_, reinterpret_cast<char*>(&length), sizeof length);
        std::string result(length, '\0');
        all(::read, from_, result.data(), length);
        const bool good = result.at(0) == 0;
        result.erase(0, 1);
        if (!good) throw std::runtime_error(result);
        return result;
    }

private:
    template <class Move, class Bytes>
    static void all(Move move, int end, Bytes bytes, std::size_t count) {
        for (std::size_t done = 0; done < count;) {
            const ssize_t n = move(end, bytes + done, count - done);
            if (n <= 0) throw std::runtime_error("the program has gone");
            done += static_cast<std::size_t>(n);
        }
    }

    pid_t id_ = 0;
    int to_ = -1, from_ = -1;
};

}  // namespace parity
