#include "io/base/trial.h"

#include <fcntl.h>
#include <poll.h>
#include <sys/resource.h>
#include <sys/wait.h>
#include <unistd.h>

#include <array>
#include <cerrno>
#include <chrono>
#include <csignal>
#include <cstdint>
#include <ctime>
#include <limits>
#include <new>
#include <nlohmann/json.hpp>
#include <optional>
#include <string>

#include "core/base/error.h"
#include "io/base/native_lock.h"

namespace rubble::io {

namespace {

using Json = nlohmann::json;

constexpr rlim_t longestTrial = 120;  // s, of the processor
constexpr int trials = 3;

Json toJson(const Message& message) {
    Json arguments = Json::array();
    for (const Argument& argument : message.arguments) {
        Json value;
        std::visit([&](const auto& content) { value = content; }, argument.value);
        arguments.push_back({value, argument.unit});
    }
    return {message.id, message.pattern, arguments};
}

Message fromJson(const Json& json) {
    Message message{json[0], json[1], {}};
    for (const Json& pair : json[2]) {
        const Json& value = pair[0];
        Argument argument(value.is_string()           ? Argument(value.get<std::string>())
                          : value.is_number_integer() ? Argument(value.get<std::int64_t>())
                          // JSON has no number that is none.
                          : value.is_null() ? Argument(std::numeric_limits<double>::quiet_NaN())
                                            : Argument(value.get<double>()));
        argument.unit = pair[1];
        message.arguments.push_back(std::move(argument));
    }
    return message;
}

void writeAll(int pipe, const std::string& text) {
    for (std::size_t done = 0; done < text.size();) {
        const ssize_t n = ::write(pipe, text.data() + done, text.size() - done);
        if (n <= 0) {
            return;
        }
        done += static_cast<std::size_t>(n);
    }
}

/// Seconds of the processor that a process has had; less than nothing once it has gone.
double processorTime(pid_t process) {
    clockid_t clock{};
    timespec time{};
    if (::clock_getcpuclockid(process, &clock) != 0 || ::clock_gettime(clock, &time) != 0) {
        return -1.0;
    }
    return static_cast<double>(time.tv_sec) + 1e-9 * static_cast<double>(time.tv_nsec);
}

/// All that the child writes until it ends, or nothing once it has made no use of the processor for so long.
std::optional<std::string> readAll(int pipe, pid_t child, std::chrono::seconds longestStill) {
    std::string text;
    std::array<char, 4096> buffer{};
    double used = processorTime(child);
    auto moved = std::chrono::steady_clock::now();
    for (;;) {
        pollfd ready{pipe, POLLIN, 0};
        if (::poll(&ready, 1, 500) == 0) {
            const double now = processorTime(child);
            if (now != used) {
                used = now;
                moved = std::chrono::steady_clock::now();
            } else if (std::chrono::steady_clock::now() - moved > longestStill) {
                return std::nullopt;
            }
            continue;
        }
        const ssize_t n = ::read(pipe, buffer.data(), buffer.size());
        if (n > 0) {
            text.append(buffer.data(), static_cast<std::size_t>(n));
        } else if (n == 0 || errno != EINTR) {
            return text;
        }
    }
}

// The child: silent, without core dumps, mortal; it leaves without running anybody's destructors.
[[noreturn]] void runChild(const std::function<void()>& work, int pipe) {
    // Locked by the parent's thread, whose name this one does not bear; there are no others here.
    new (&nativeLibraries()) std::recursive_mutex;
    for (const int signal : {SIGABRT, SIGSEGV, SIGBUS, SIGFPE, SIGILL, SIGXCPU}) {
        std::signal(signal, SIG_DFL);
    }
    const rlimit noCore{0, 0};
    ::setrlimit(RLIMIT_CORE, &noCore);
    const rlimit mortal{longestTrial, longestTrial};
    ::setrlimit(RLIMIT_CPU, &mortal);
    const int nowhere = ::open("/dev/null", O_WRONLY);
    ::dup2(nowhere, STDOUT_FILENO);
    ::dup2(nowhere, STDERR_FILENO);
    Json outcome;
    try {
        work();
    } catch (const Error& error) {
        const bool world = dynamic_cast<const WorldError*>(&error) != nullptr;
        outcome = {world ? "world" : "parse", toJson(error.message()), toJson(error.remedy())};
    } catch (...) {
        ::_exit(1);
    }
    writeAll(pipe, outcome.dump(-1, ' ', false, Json::error_handler_t::replace));
    ::_exit(0);
}

enum class Outcome : std::uint8_t { Survived, Crashed, StoodStill, NoChild };

/// Throws what the work throws.
Outcome tryInChild(const std::function<void()>& work, std::chrono::seconds longestStill) {
    std::array<int, 2> pipe{};
    if (::pipe2(pipe.data(), O_CLOEXEC) != 0) {
        return Outcome::NoChild;
    }
    const pid_t child = ::fork();
    if (child == 0) {
        runChild(work, pipe[1]);
    }
    ::close(pipe[1]);
    if (child < 0) {
        ::close(pipe[0]);
        return Outcome::NoChild;
    }
    const std::optional<std::string> text = readAll(pipe[0], child, longestStill);
    ::close(pipe[0]);
    if (!text) {
        ::kill(child, SIGKILL);
    }
    int status = 0;
    while (::waitpid(child, &status, 0) < 0 && errno == EINTR) {
    }
    if (!text) {
        return Outcome::StoodStill;
    }
    if (!WIFEXITED(status) || WEXITSTATUS(status) != 0 || text->empty()) {
        return Outcome::Crashed;
    }
    const Json outcome = Json::parse(*text);
    if (outcome.is_null()) {
        return Outcome::Survived;
    }
    if (outcome[0] == "world") {
        throw WorldError(fromJson(outcome[1]), fromJson(outcome[2]));
    }
    throw ParseError(fromJson(outcome[1]), fromJson(outcome[2]));
}

}  // namespace

bool survivesTrial(const std::function<void()>& work, std::chrono::seconds longestStill) {
    Outcome outcome = Outcome::StoodStill;
    for (int trial = 0; trial < trials && outcome == Outcome::StoodStill; ++trial) {
        outcome = tryInChild(work, longestStill);
    }
    if (outcome == Outcome::Survived || outcome == Outcome::Crashed) {
        return outcome == Outcome::Survived;
    }
    work();
    return true;
}

}  // namespace rubble::io
