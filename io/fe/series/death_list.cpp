#include "io/fe/series/death_list.h"

#include <algorithm>
#include <charconv>
#include <cmath>
#include <filesystem>
#include <fstream>

#include "core/base/error.h"

namespace rubble::io {

namespace {

std::vector<std::string> fieldsOfRow(const std::string& line) {
    std::vector<std::string> fields;
    std::string field;
    for (const char c : line + ",") {
        if (std::string_view(",; \t\r").find(c) == std::string_view::npos) {
            field += c;
        } else if (!field.empty()) {
            fields.push_back(field);
            field.clear();
        }
    }
    return fields;
}

template <class T>
bool parse(const std::string& text, T& value) {
    const auto [end, error] = std::from_chars(text.data(), text.data() + text.size(), value);
    return error == std::errc{} && end == text.data() + text.size();
}

bool parseEntry(const std::vector<std::string>& fields, DeathEntry& entry) {
    double status = 0.0;
    if (fields.size() < 2 || fields.size() > 3 || !parse(fields[0], entry.element) || !parse(fields[1], entry.time) ||
        !std::isfinite(entry.time) || (fields.size() == 3 && !parse(fields[2], status))) {
        return false;
    }
    entry.active = status != 0.0;
    return true;
}

}  // namespace

std::string deathListBeside(const std::string& path) {
    std::error_code ignored;
    const std::string list = path + ".deaths.csv";
    return std::filesystem::is_regular_file(list, ignored) ? list : "";
}

std::vector<DeathEntry> readDeathList(const std::string& path) {
    std::ifstream file(path);
    if (!file) {
        throw WorldError({"io.file.unreadable", "Cannot read {0}", {path}},
                         {"io.file.unreadable.remedy", "Check that the file exists and that you may read it.", {}});
    }
    std::vector<DeathEntry> entries;
    std::int64_t number = 0;
    bool names = false;
    for (std::string line; std::getline(file, line);) {
        ++number;
        const std::vector<std::string> fields = fieldsOfRow(line);
        if (fields.empty() || fields[0].starts_with("#")) {
            continue;
        }
        DeathEntry entry;
        if (parseEntry(fields, entry)) {
            entries.push_back(entry);
            continue;
        }
        if (!entries.empty() || names) {
            throw ParseError({"fe.death_list", "{0}: line {1} is not \"element,time\": {2}", {path, number, line.substr(0, 80)}},
                             {"fe.death_list.remedy", "Write the element's number and the time of its death on each line.", {}});
        }
        names = true;
    }
    std::stable_sort(entries.begin(), entries.end(), [](const auto& a, const auto& b) { return a.time < b.time; });
    return entries;
}

}  // namespace rubble::io
