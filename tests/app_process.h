#pragma once
// What tests of the built program share: a run of it, and what it said.

#include <array>
#include <chrono>
#include <filesystem>
#include <stdexcept>
#include <string>
#include <thread>
#include <utility>
#include <vector>

#include <fcntl.h>
#include <signal.h>
#include <spawn.h>
#include <sys/wait.h>
#include <unistd.h>

#include "tests/temporary_folder.h"

namespace eyeray {

/// A program started with an environment and a working folder of its own. What it prints goes to files; what
/// it reads comes from one.
class Process {
public:
    using Environment = std::vector<std::string>; // NAME=value

    Process(const std::string& program, std::vector<std::string> arguments,
            const std::filesystem::path& folder, const Environment& environment,
            const std::filesystem::path& input = "/dev/null")
        : out_(folder / "stdout"), err_(folder / "stderr") {
        arguments.insert(arguments.begin(), {"env", "-C", folder.string()});
        arguments.insert(arguments.begin() + 3, environment.begin(), environment.end());
        arguments.insert(arguments.begin() + 3 + static_cast<std::ptrdiff_t>(environment.size()), program);
        std::vector<char*> words;
        words.reserve(arguments.size() + 1);
        for (std::string& argument : arguments) words.push_back(argument.data());
        words.push_back(nullptr);
        posix_spawn_file_actions_t files;
        posix_spawn_file_actions_init(&files);
        constexpr int kWrite = O_WRONLY | O_CREAT | O_TRUNC;
        posix_spawn_file_actions_addopen(&files, STDIN_FILENO, input.c_str(), O_RDONLY, 0);
        posix_spawn_file_actions_addopen(&files, STDOUT_FILENO, out_.c_str(), kWrite, 0600);
        posix_spawn_file_actions_addopen(&files, STDERR_FILENO, err_.c_str(), kWrite, 0600);
        const int error = posix_spawnp(&pid_, "env", &files, nullptr, words.data(), environ);
        posix_spawn_file_actions_destroy(&files);
        if (error != 0) throw std::runtime_error("cannot start " + program);
    }
    Process(const Process&) = delete;
    Process& operator=(const Process&) = delete;
    ~Process() {
        if (running()) {
            kill(pid_, SIGKILL);
            wait();
        }
    }

    bool running() {
        if (pid_ > 0 && waitpid(pid_, &status_, WNOHANG) == pid_) pid_ = 0;
        return pid_ > 0;
    }

    void interrupt() const { kill(pid_, SIGINT); }
    void terminate() const { kill(pid_, SIGTERM); }

    /// Its exit code once it has ended; 128 and its number for a signal, as a shell says it.
    int wait() {
        if (pid_ > 0) waitpid(pid_, &status_, 0);
        pid_ = 0;
        return WIFEXITED(status_) ? WEXITSTATUS(status_) : 128 + WTERMSIG(status_);
    }

    std::string out() const { return textOf(out_); }
    std::string err() const { return textOf(err_); }

private:
    std::filesystem::path out_, err_;
    pid_t pid_ = 0;
    int status_ = 0;
};

/// Waits until `condition` holds, with a deadline that no healthy machine reaches.
template <class Condition>
bool eventually(const Condition& condition) {
    constexpr auto kDeadline = std::chrono::seconds(120);
    const auto start = std::chrono::steady_clock::now();
    while (!condition()) {
        if (std::chrono::steady_clock::now() - start > kDeadline) return false;
        std::this_thread::sleep_for(std::chrono::milliseconds(20));
    }
    return true;
}

}
