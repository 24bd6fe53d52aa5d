// SPDX-License-Identifier: MIT
//
// With exceptions and RTTI switched off: bad input reaches the program's handler, and ends it where there is none.
#include <umbrage/umbrage.hpp>

#include <csignal>
#include <cstdio>
#include <cstdlib>
#include <string>

#include <sys/wait.h>
#include <unistd.h>

namespace {

void bad_input() {
    (void)umbrage::make_spot_light({.position = {0, 5, 0}, .direction = {0, 0, 0}, .clip = umbrage::cpu_clip_space});
}

void handler(const char* message) {
    std::fprintf(stderr, "handled: %s", message);
    std::_Exit(3);
}

struct ending {
    int status = 0;
    std::string said;  ///< on standard error
};

/// bad_input in a process of its own.
ending end_of(umbrage::error_handler handles) {
    int ends[2];
    if (pipe(ends) != 0) return {};
    const pid_t child = fork();
    if (child == 0) {
        dup2(ends[1], STDERR_FILENO);
        close(ends[0]);
        umbrage::set_error_handler(handles);
        bad_input();
        std::_Exit(0);
    }
    close(ends[1]);
    ending end;
    char text[256];
    for (ssize_t n; (n = read(ends[0], text, sizeof text)) > 0;) end.said.append(text, static_cast<std::size_t>(n));
    close(ends[0]);
    waitpid(child, &end.status, 0);
    return end;
}

}  // namespace

int main() {
    const ending alone = end_of(nullptr), handled = end_of(handler), returned = end_of([](const char*) {});
    const bool has_message = alone.said.starts_with("umbrage") && alone.said.find("direction") != std::string::npos;
    const bool ok = has_message && WIFSIGNALED(alone.status) && WTERMSIG(alone.status) == SIGABRT &&
                    handled.said + "\n" == "handled: " + alone.said && WIFEXITED(handled.status) &&
                    WEXITSTATUS(handled.status) == 3 && returned.said.empty() && WIFSIGNALED(returned.status) &&
                    umbrage::set_error_handler(handler) == nullptr && umbrage::set_error_handler(nullptr) == handler;
    std::printf("without a handler: %swith one: %s\n%s\n", alone.said.c_str(), handled.said.c_str(),
                ok ? "ok" : "wrong");
    return ok ? 0 : 1;
}
