#include "app/cli/frame/virtual_display.h"

#include <fcntl.h>
#include <poll.h>
#include <sys/prctl.h>
#include <sys/types.h>
#include <sys/wait.h>
#include <unistd.h>

#include <array>
#include <csignal>
#include <cstdlib>
#include <string>

#include "core/base/error.h"
#include "widgets/figures/figure_file.h"

namespace rubble::cli {

namespace {

constexpr int startTimeoutMs = 30000;
constexpr int endPollMs = 20;
/// Where the child finds the end of the pipe to which it writes its display number.
constexpr int displayDescriptor = 3;

WorldError serverError(const std::string& reason) {
    return WorldError({"cli.no_display", "No display answers and Xvfb could not be started: {0}.", {reason}},
                      {"cli.no_display.remedy", "Install the package xvfb, or set DISPLAY to an X server that answers.", {}});
}

[[noreturn]] void becomeServer(int writeEnd, pid_t parent) {
    // The server must not outlive the program, and Ctrl-C is for the program to handle.
    prctl(PR_SET_PDEATHSIG, SIGTERM);
    if (getppid() != parent) {
        _exit(127);
    }
    setpgid(0, 0);
    const int nothing = open("/dev/null", O_RDWR);
    dup2(nothing, STDIN_FILENO);
    dup2(nothing, STDOUT_FILENO);
    dup2(nothing, STDERR_FILENO);
    if (writeEnd == displayDescriptor) {
        fcntl(writeEnd, F_SETFD, 0);
    } else {
        dup2(writeEnd, displayDescriptor);
    }
    execlp("Xvfb", "Xvfb", "-displayfd", "3", "-screen", "0", "1280x1024x24", "-nolisten", "tcp", "-noreset",
           static_cast<char*>(nullptr));
    _exit(127);
}

/// The display number that the server writes once it is ready; empty if it ends or stays silent.
std::string readDisplayNumber(int readEnd) {
    std::string text;
    std::array<char, 16> buffer{};
    pollfd waiting{readEnd, POLLIN, 0};
    while (text.find('\n') == std::string::npos) {
        if (poll(&waiting, 1, startTimeoutMs) <= 0) {
            return {};
        }
        const ssize_t got = read(readEnd, buffer.data(), buffer.size());
        if (got <= 0) {
            return {};
        }
        text.append(buffer.data(), static_cast<std::size_t>(got));
    }
    return text.substr(0, text.find('\n'));
}

/// Xvfb, for as long as this lives.
class Server {
public:
    Server() {
        std::array<int, 2> ends{};
        if (pipe2(ends.data(), O_CLOEXEC) != 0) {
            throw serverError("no pipe could be opened");
        }
        const pid_t parent = getpid();
        m_process = fork();
        if (m_process == 0) {
            becomeServer(ends[1], parent);
        }
        close(ends[1]);
        const std::string number = m_process > 0 ? readDisplayNumber(ends[0]) : std::string();
        close(ends[0]);
        if (number.empty()) {
            end();
            throw serverError("it is missing, or did not get ready in time");
        }
        setenv("DISPLAY", (":" + number).c_str(), 1);
    }
    ~Server() { end(); }
    Server(const Server&) = delete;
    Server& operator=(const Server&) = delete;

private:
    void end() {
        if (m_process > 0) {
            // Xvfb that is just going to sleep notices a signal only when it wakes, minutes later.
            do {
                kill(m_process, SIGTERM);
                poll(nullptr, 0, endPollMs);
            } while (waitpid(m_process, nullptr, WNOHANG) == 0);
        }
    }

    pid_t m_process = 0;
};

}  // namespace

VirtualDisplay::VirtualDisplay() {
    if (!figures::displayAvailable()) {
        static const Server server;
    }
}

}  // namespace rubble::cli
