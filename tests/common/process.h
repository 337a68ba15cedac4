// SPDX-License-Identifier: GPL-2.0-or-later
// A program that runs beside the test, and is ended with the object. For tests only.
#pragma once

#include <fcntl.h>
#include <spawn.h>
#include <sys/wait.h>
#include <unistd.h>

#include <csignal>
#include <map>
#include <string>
#include <vector>

extern char** environ;

namespace vigil::test {

class Process {
public:
    /// Starts words[0], looked for in PATH where it has no slash, with `variables` added to the
    /// environment. Standard output and error are appended to the file `log`.
    Process(std::vector<std::string> words, const std::string& log,
            const std::map<std::string, std::string>& variables = {}) {
        std::vector<std::string> environment;
        for (char** variable = environ; *variable != nullptr; ++variable) {
            const std::string text = *variable;
            if (!variables.contains(text.substr(0, text.find('=')))) environment.push_back(text);
        }
        for (const auto& [name, value] : variables)
            environment.push_back(name + "=" + value);
        posix_spawn_file_actions_t actions;
        posix_spawn_file_actions_init(&actions);
        posix_spawn_file_actions_addopen(&actions, STDOUT_FILENO, log.c_str(),
                                         O_WRONLY | O_CREAT | O_APPEND, 0600);
        posix_spawn_file_actions_adddup2(&actions, STDOUT_FILENO, STDERR_FILENO);
        if (posix_spawnp(&id_, words[0].c_str(), &actions, nullptr, pointers_to(words).data(),
                         pointers_to(environment).data()) != 0)
            id_ = 0;
        posix_spawn_file_actions_destroy(&actions);
    }
    ~Process() {
        if (!running()) return;
        send(SIGKILL);
        wait();
    }
    Process(const Process&) = delete;
    Process& operator=(const Process&) = delete;

    bool running() {
        if (id_ > 0 && waitpid(id_, &status_, WNOHANG) == id_) id_ = 0;
        return id_ > 0;
    }
    void send(int signal) {
        if (running()) kill(id_, signal);
    }
    /// Until it ends: its exit status, or 128 and the signal that ended it; 127 if it never ran.
    int wait() {
        if (id_ > 0) waitpid(id_, &status_, 0);
        id_ = 0;
        return WIFEXITED(status_) ? WEXITSTATUS(status_) : 128 + WTERMSIG(status_);
    }

private:
    static std::vector<char*> pointers_to(std::vector<std::string>& texts) {
        std::vector<char*> pointers;
        for (std::string& text : texts)
            pointers.push_back(text.data());
        pointers.push_back(nullptr);
        return pointers;
    }

    pid_t id_ = 0;
    int status_ = 127 << 8; // as wait() tells of exit status 127
};

} // namespace vigil::test
