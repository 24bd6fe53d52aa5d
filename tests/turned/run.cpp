// SPDX-License-Identifier: MIT
#include "run.hpp"

#include <array>
#include <cstdio>
#include <cstdlib>
#include <cstring>
#include <exception>
#include <regex>
#include <stdexcept>

#include <fcntl.h>
#include <sys/resource.h>
#include <sys/wait.h>
#include <unistd.h>

namespace turned {

namespace {

/// What a run says at its end.
struct reply {
    ending how = ending::wrong;
    std::size_t lit = 0, dark = 0;
    std::array<char, 400> message{};

    void say(const std::string& text) { std::snprintf(message.data(), message.size(), "%s", text.c_str()); }
};

constexpr rlim_t longest_run = 20;  ///< seconds of the processor

/// The library's one form of errors, which names function and argument.
bool names_argument(const std::string& message) {
    static const std::regex form("umbrage::[a-z_0-9:<>]+: .+ must be .+; got [^]*");
    return std::regex_match(message, form);
}

reply answer(const program& p, change c) {
    reply r;
    chosen = c, is_running = true;
    try {
        p.run();
        judge_unused_lights();
        r.how = seen.wrong > 0 ? ending::wrong : ending::right;
        r.lit = seen.lit, r.dark = seen.dark;
        r.say(seen.wrong > 0 ? std::to_string(seen.wrong) + " wrong, the first: " + seen.first : "right");
    } catch (const no_change&) {
        r.how = ending::no_change, r.say("no change");
    } catch (const std::invalid_argument& e) {
        r.how = names_argument(e.what()) ? ending::refused : ending::wrong;
        r.say(e.what());
    } catch (const std::exception& e) { r.say(std::string("another exception: ") + e.what()); }
    return r;
}

}  // namespace

outcome run(const program& p, change c) {
    std::fflush(stdout);
    std::array<int, 2> ends{};
    if (pipe(ends.data()) != 0) throw std::runtime_error("no pipe");
    const pid_t child = fork();
    if (child < 0) throw std::runtime_error("no process");
    if (child == 0) {
        close(ends[0]);
        const int nowhere = open("/dev/null", O_WRONLY);
        dup2(nowhere, STDOUT_FILENO);
        const rlimit limit{longest_run, longest_run + 1};
        setrlimit(RLIMIT_CPU, &limit);
        const reply r = answer(p, c);
        const bool is_sent = write(ends[1], &r, sizeof r) == ssize_t(sizeof r);
        std::_Exit(is_sent ? 0 : 1);
    }
    close(ends[1]);
    reply r;
    const bool is_whole = read(ends[0], &r, sizeof r) == ssize_t(sizeof r);
    close(ends[0]);
    int status = 0;
    waitpid(child, &status, 0);
    if (is_whole) return {r.how, r.lit, r.dark, r.lit + r.dark, r.message.data()};
    const int signal = WIFSIGNALED(status) ? WTERMSIG(status) : 0;
    return {ending::wrong, 0, 0, 0, signal == SIGXCPU ? "does not end" : std::string("ends by ") + strsignal(signal)};
}

}  // namespace turned
