#include "tests/support/command_run.h"
#include "tests/support/places.h"

#include <fcntl.h>
#include <poll.h>
#include <pty.h>
#include <sys/prctl.h>
#include <sys/resource.h>
#include <sys/wait.h>
#include <unistd.h>

#include <array>
#include <csignal>
#include <fstream>
#include <sstream>
#include <stdexcept>

namespace rubble::cli {

namespace {

/// Reads what is there; false once the other end is closed.
bool drain(int descriptor, std::string& text) {
    std::array<char, 4096> buffer{};
    const ssize_t got = read(descriptor, buffer.data(), buffer.size());
    if (got > 0) {
        text.append(buffer.data(), static_cast<std::size_t>(got));
    }
    return got > 0;
}

struct Pipe {
    int readEnd = -1;
    int writeEnd = -1;
};

Pipe openPipe(bool terminal) {
    std::array<int, 2> ends{};
    const int failed = terminal ? openpty(&ends[0], &ends[1], nullptr, nullptr, nullptr) : pipe(ends.data());
    if (failed != 0) {
        throw std::runtime_error("no pipe");
    }
    fcntl(ends[0], F_SETFD, FD_CLOEXEC);
    fcntl(ends[1], F_SETFD, FD_CLOEXEC);
    return {ends[0], ends[1]};
}

}  // namespace

CommandRun& CommandRun::in(std::string folder) {
    m_folder = std::move(folder);
    return *this;
}

CommandRun& CommandRun::with(const std::string& variable, std::optional<std::string> value) {
    m_environment[variable] = std::move(value);
    return *this;
}

CommandRun& CommandRun::fileSizeLimit(std::size_t bytes) {
    m_fileSizeLimit = bytes;
    return *this;
}

CommandRun& CommandRun::errorsToTerminal() {
    m_terminal = true;
    return *this;
}

CommandRun& CommandRun::meanwhile(std::function<void(pid_t)> act) {
    m_meanwhile = std::move(act);
    return *this;
}

void CommandRun::prepareChild(int outDescriptor, int errDescriptor) const {
    // A program that hangs must not outlive the test that is ended for it.
    prctl(PR_SET_PDEATHSIG, SIGKILL);
    dup2(open("/dev/null", O_RDONLY), STDIN_FILENO);
    dup2(outDescriptor, STDOUT_FILENO);
    dup2(errDescriptor, STDERR_FILENO);
    if (!m_folder.empty() && chdir(m_folder.c_str()) != 0) {
        _exit(126);
    }
    for (const auto& [name, value] : m_environment) {
        if (value) {
            setenv(name.c_str(), value->c_str(), 1);
        } else {
            unsetenv(name.c_str());
        }
    }
    if (m_fileSizeLimit > 0) {
        std::signal(SIGXFSZ, SIG_IGN);
        const rlimit limit{m_fileSizeLimit, m_fileSizeLimit};
        setrlimit(RLIMIT_FSIZE, &limit);
    }
}

Outcome CommandRun::run(const std::vector<std::string>& words) {
    const Pipe out = openPipe(false);
    const Pipe err = openPipe(m_terminal);
    std::vector<char*> argv;
    for (const std::string& word : words) {
        argv.push_back(const_cast<char*>(word.c_str()));
    }
    argv.push_back(nullptr);
    const pid_t child = fork();
    if (child == 0) {
        prepareChild(out.writeEnd, err.writeEnd);
        execvp(argv[0], argv.data());
        _exit(127);
    }
    close(out.writeEnd);
    close(err.writeEnd);
    Outcome outcome;
    bool outOpen = true;
    bool errOpen = true;
    while (outOpen || errOpen) {
        std::array<pollfd, 2> waiting{{{outOpen ? out.readEnd : -1, POLLIN, 0}, {errOpen ? err.readEnd : -1, POLLIN, 0}}};
        poll(waiting.data(), waiting.size(), 20);
        outOpen = outOpen && (waiting[0].revents == 0 || drain(out.readEnd, outcome.out));
        errOpen = errOpen && (waiting[1].revents == 0 || drain(err.readEnd, outcome.err));
        if (m_meanwhile) {
            m_meanwhile(child);
        }
    }
    int status = 0;
    waitpid(child, &status, 0);
    close(out.readEnd);
    close(err.readEnd);
    if (WIFEXITED(status)) {
        outcome.exitCode = WEXITSTATUS(status);
    } else {
        outcome.signal = WTERMSIG(status);
    }
    return outcome;
}

Outcome CommandRun::cli(std::vector<std::string> words) {
    words.insert(words.begin(), cliPath());
    return run(words);
}

Outcome cli(std::vector<std::string> words) {
    return CommandRun().cli(std::move(words));
}

bool catches(pid_t process, int signal) {
    std::ifstream status("/proc/" + std::to_string(process) + "/status");
    for (std::string line; std::getline(status, line);) {
        if (line.starts_with("SigCgt:")) {
            return (std::stoull(line.substr(line.find('\t') + 1), nullptr, 16) >> (signal - 1)) & 1u;
        }
    }
    return false;
}

std::string cliPath() {
    return buildPath("bin/rubble-cli");
}

std::string textOf(const std::string& path) {
    std::ifstream stream(path, std::ios::binary);
    if (!stream) {
        throw std::runtime_error("cannot read " + path);
    }
    std::stringstream text;
    text << stream.rdbuf();
    return text.str();
}

}  // namespace rubble::cli
