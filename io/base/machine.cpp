#include "io/base/machine.h"

#include <unistd.h>

#include <array>
#include <charconv>
#include <cmath>
#include <cstdlib>
#include <cstring>
#include <filesystem>
#include <fstream>
#include <thread>

#include "core/base/error.h"
#include "core/simulation/run/checkpoint.h"

namespace rubble::io {

namespace fs = std::filesystem;

namespace {

std::string processorName() {
    std::ifstream stream("/proc/cpuinfo");
    for (std::string line; std::getline(stream, line);) {
        const std::size_t colon = line.find(':');
        if (line.starts_with("model name") && colon != std::string::npos && colon + 2 < line.size()) {
            return line.substr(colon + 2);
        }
    }
    return "unknown processor";
}

/// An absolute path from the environment; relative ones are to be ignored, says the standard.
fs::path folderFrom(const char* variable) {
    const char* value = std::getenv(variable);
    const fs::path path = value ? value : "";
    return path.is_absolute() ? path : fs::path();
}

/// The first of: its own variable, "rubble" in the shared folder, "rubble" in that folder of the home.
std::string folderOr(const char* own, const char* shared, const char* inHome, Message what, Message remedy) {
    if (const fs::path folder = folderFrom(own); !folder.empty()) {
        return folder.string();
    }
    if (const fs::path folder = folderFrom(shared); !folder.empty()) {
        return (folder / "rubble").string();
    }
    if (const fs::path home = folderFrom("HOME"); !home.empty()) {
        return (home / inHome / "rubble").string();
    }
    throw WorldError(std::move(what), std::move(remedy));
}

}  // namespace

std::string machineText() {
    const double bytes = static_cast<double>(sysconf(_SC_PHYS_PAGES)) * static_cast<double>(sysconf(_SC_PAGE_SIZE));
    std::array<char, 32> memory{};
    std::snprintf(memory.data(), memory.size(), "%.1f", bytes / (1024.0 * 1024.0 * 1024.0));
    return processorName() + ", " + std::to_string(std::thread::hardware_concurrency()) + " threads, " + memory.data() + " GiB";
}

std::string cacheFolder() {
    return folderOr("RUBBLE_CACHE", "XDG_CACHE_HOME", ".cache",
                    {"io.no_cache",
                     "There is no folder for what can be made again: neither RUBBLE_CACHE, XDG_CACHE_HOME nor HOME is an "
                     "absolute path.",
                     {}},
                    {"io.no_cache.remedy", "Set RUBBLE_CACHE to a folder with room.", {}});
}

double checkpointSeconds() {
    const char* const text = std::getenv("RUBBLE_CHECKPOINT_SECONDS");
    if (text == nullptr || *text == '\0') {
        return checkpointInterval;
    }
    double seconds = 0.0;
    const char* const end = text + std::strlen(text);
    const auto [rest, error] = std::from_chars(text, end, seconds);
    if (error != std::errc{} || rest != end || !(seconds > 0.0) || !std::isfinite(seconds)) {
        throw UsageError(
            {"io.checkpoint_seconds", "RUBBLE_CHECKPOINT_SECONDS is {0}, which is no number of seconds above zero.", {text}},
            {"io.checkpoint_seconds.remedy", "Set it to a number such as 60, or take it away.", {}});
    }
    return seconds;
}

std::string stateFolder() {
    return folderOr("RUBBLE_STATE", "XDG_STATE_HOME", ".local/state",
                    {"io.no_state",
                     "There is no folder for unsaved work: neither RUBBLE_STATE, XDG_STATE_HOME nor HOME is an absolute path.",
                     {}},
                    {"io.no_state.remedy", "Set RUBBLE_STATE to a folder with room.", {}});
}

}  // namespace rubble::io
