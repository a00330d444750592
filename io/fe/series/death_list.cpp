#include "io/fe/series/death_list.h"

#include <algorithm>
#include <array>
#include <cctype>
#include <filesystem>
#include <initializer_list>
#include <optional>
#include <string_view>
#include <unordered_map>
#include <utility>

#include "core/base/error.h"
#include "core/base/unknown.h"
#include "io/base/delimited_table.h"
#include "io/fe/series/byte_window.h"

namespace rubble::io {

namespace {

constexpr std::uintmax_t mostBytes = std::uintmax_t{1} << 30;
constexpr std::size_t none = ~std::size_t{0};

/// Where each column stands.
struct DeathColumns {
    std::size_t element = 0, time = 1, status = 2;
};

// In seconds; nothing: no unit that is known.
std::optional<double> secondsOf(const std::string& unit) {
    constexpr std::array<std::pair<std::string_view, double>, 14> units{{{"S", 1.0},
                                                                         {"SEC", 1.0},
                                                                         {"SECS", 1.0},
                                                                         {"SECOND", 1.0},
                                                                         {"SECONDS", 1.0},
                                                                         {"MS", 1e-3},
                                                                         {"MSEC", 1e-3},
                                                                         {"MILLISECOND", 1e-3},
                                                                         {"MILLISECONDS", 1e-3},
                                                                         {"US", 1e-6},
                                                                         {"USEC", 1e-6},
                                                                         {"MICROSECOND", 1e-6},
                                                                         {"MICROSECONDS", 1e-6},
                                                                         {"MIN", 60.0}}};
    for (const auto& [name, seconds] : units) {
        if (unit == name) {
            return seconds;
        }
    }
    return std::nullopt;
}

bool isAnyOf(const std::string& word, std::initializer_list<std::string_view> known) {
    return std::find(known.begin(), known.end(), word) != known.end();
}

// A heading that names both; without one the order is element, time, status.
DeathColumns columnsOf(const std::vector<std::string>& heading) {
    DeathColumns named{none, none, none};
    for (std::size_t c = heading.size(); c-- > 0;) {
        const std::string word = upperCase(heading[c].substr(0, heading[c].find_first_of(" [(")));
        if (word.starts_with("ELEM") || isAnyOf(word, {"ID", "EID", "LABEL", "NUMBER"})) {
            named.element = c;
        } else if (word.starts_with("TIME") || word == "T" || word.starts_with("T_")) {
            named.time = c;
        } else if (isAnyOf(word, {"STATUS", "ACTIVE", "ALIVE"})) {
            named.status = c;
        }
    }
    return named.element != none && named.time != none ? named : DeathColumns{};
}

// Upper case, and a micro sign as U: it may be written in two ways.
std::string plainHeading(std::string text) {
    for (const std::string_view micro : {"\xC2\xB5", "\xCE\xBC"}) {
        for (std::size_t at = text.find(micro); at != std::string::npos; at = text.find(micro)) {
            text.replace(at, micro.size(), "u");
        }
    }
    return upperCase(text);
}

std::vector<std::string> wordsOf(const std::string& text) {
    std::vector<std::string> words(1);
    for (const char c : text) {
        if (std::isalnum(static_cast<unsigned char>(c)) != 0 || static_cast<unsigned char>(c) >= 0x80) {
            words.back() += c;
        } else if (!words.back().empty()) {
            words.emplace_back();
        }
    }
    if (words.back().empty()) {
        words.pop_back();
    }
    return words;
}

// The unit that the heading of the times ends with: "time [ms]", "t_ms", "timeMs"; empty: it names none.
std::string unitNamed(const std::string& heading) {
    const std::string text = plainHeading(heading);
    if (const std::size_t bracket = text.find_first_of("[("); bracket != std::string::npos) {
        const std::vector<std::string> inside = wordsOf(text.substr(bracket));
        return inside.size() == 1 ? inside.front() : text.substr(bracket);
    }
    std::vector<std::string> words = wordsOf(text);
    if (!words.empty() && words.front().size() > 4 && words.front().starts_with("TIME") && secondsOf(words.front().substr(4)) &&
        words.front() != "TIMES") {
        words.push_back(words.front().substr(4));
    }
    const bool names = words.size() > 1 || (words.size() == 1 && secondsOf(words.front()));
    return names && !isAnyOf(words.back(), {"TIME", "T", "DEATH", "DEATHS", "STEP", "FAILURE", "DELETION", "EROSION", "REMOVAL"})
               ? words.back()
               : std::string();
}

// s of one unit of the times of a heading; nothing where it names none: then the list counts as the result does.
std::optional<double> unitOfTimes(const std::string& path, const std::vector<std::string>& heading, const DeathColumns& columns) {
    const std::string unit = columns.time < heading.size() ? unitNamed(heading[columns.time]) : std::string();
    if (unit.empty()) {
        return std::nullopt;
    }
    const std::optional<double> seconds = secondsOf(unit);
    if (!seconds) {
        throw ParseError({"fe.death_list.unit",
                          "{0}: the heading \"{1}\" names a unit of time that is not known",
                          {path, heading[columns.time].substr(0, 80)}},
                         {"fe.death_list.unit.remedy",
                          "Write s, ms or us, as in \"time [ms]\"; without a unit the list counts as the result does.",
                          {}});
    }
    return seconds;
}

bool parseEntry(const DelimitedTable& table, const std::vector<std::string>& fields, const DeathColumns& columns,
                DeathEntry& entry) {
    if (std::max(columns.element, columns.time) >= fields.size()) {
        return false;
    }
    const auto element = wholeNumberIn(fields[columns.element]);
    const auto time = table.numberIn(fields[columns.time]);
    const bool tells = columns.status < fields.size() && !fields[columns.status].empty();
    const auto status = tells ? table.numberIn(fields[columns.status]) : std::optional(0.0);
    if (!element || !time || !status || (*status != 0.0 && *status != 1.0)) {
        return false;
    }
    entry = {*element, *time, *status == 1.0};
    return true;
}

[[noreturn]] void failLine(const std::string& path, const DelimitedRow& row) {
    std::string text;
    for (const std::string& field : row.fields) {
        text += (text.empty() ? "" : " | ") + field;
    }
    throw ParseError(
        {"fe.death_list",
         "{0}: line {1} is not \"element,time\" or \"element,time,status\": {2}",
         {path, row.line, text.substr(0, 80)}},
        {"fe.death_list.remedy",
         "Write the element's number and the time of its death on each line, and 0 (dead) or 1 (active) if there is a status.",
         {}});
}

bool beginsAsNumber(const std::string& field) {
    return field.find_first_of("0123456789") == 0 || (field.size() > 1 && field.find_first_of("+-.") == 0);
}

// A first line of names.
bool isHeading(const DelimitedTable& table, const DelimitedRow& row) {
    return &row == &table.rows.front() && std::none_of(row.fields.begin(), row.fields.end(), beginsAsNumber);
}

}  // namespace

std::string deathListBeside(const std::string& path) {
    std::error_code ignored;
    const std::string list = path + ".deaths.csv";
    return std::filesystem::is_regular_file(list, ignored) ? list : "";
}

std::vector<DeathEntry> readDeathList(const std::string& path) {
    const DelimitedTable table = readDelimitedTable(path, mostBytes);
    std::vector<DeathEntry> entries;
    DeathColumns columns;
    double unit = 1.0;
    DelimitedRow heading{0, {"element", "time", "status"}};
    for (const DelimitedRow& row : table.rows) {
        if (isHeading(table, row)) {
            if (row.fields.size() > 1) {
                heading = row;
                columns = columnsOf(row.fields);
                unit = unitOfTimes(path, row.fields, columns).value_or(1.0);
            }
            continue;
        }
        requireNoMoreFields(path, heading, row);
        DeathEntry entry;
        if (!parseEntry(table, row.fields, columns, entry)) {
            failLine(path, row);
        }
        entry.time *= unit;
        entries.push_back(entry);
    }
    std::stable_sort(entries.begin(), entries.end(), [](const auto& a, const auto& b) { return a.time < b.time; });
    return entries;
}

std::string applyDeathList(const std::string& path, const Mesh& mesh, const std::vector<double>& times, Activity& activity,
                           std::vector<double>& deathTime, Findings& findings) {
    std::unordered_map<std::int64_t, std::vector<std::uint32_t>> elements;
    for (std::size_t e = 0; e < mesh.elementCount(); ++e) {
        elements[mesh.elementIds[e]].push_back(static_cast<std::uint32_t>(e));
    }
    const std::vector<DeathEntry> entries = readDeathList(path);
    for (const DeathEntry& entry : entries) {
        const auto found = elements.find(entry.element);
        const std::string name = "element " + englishInteger(entry.element);
        if (found == elements.end()) {
            findings.add({"fe.death_list.unknown", "The list of deaths names elements that the mesh does not have", {}},
                         {"fe.death_list.unknown.remedy", "Check that list and result belong together.", {}}, name);
            continue;
        }
        if (found->second.size() > 1) {
            findings.add(
                {"fe.death_list.several", "The list of deaths names numbers that several elements share: all of them die", {}},
                {"fe.death_list.several.remedy", "Number the elements of all kinds in one row if one alone is meant.", {}}, name);
        }
        for (const std::uint32_t e : found->second) {
            for (std::size_t k = 0; k < times.size(); ++k) {
                if (times[k] >= entry.time) {
                    activity.set(k, idAt<ElementIndex>(e), entry.active);
                }
            }
            if (!entry.active) {
                deathTime.resize(mesh.elementCount(), unknown);
                deathTime[e] = entry.time;
            }
        }
    }
    return std::filesystem::path(path).filename().string() + ", a list of " +
           englishInteger(static_cast<std::int64_t>(entries.size())) + " deaths";
}

void requireClockOfDeathList(const std::string& path, const FileUnits& units) {
    const DelimitedTable table = readDelimitedStart(path, 1);
    if (units.seconds == 1.0 || table.rows.empty() || !isHeading(table, table.rows.front())) {
        return;
    }
    const std::vector<std::string>& heading = table.rows.front().fields;
    const DeathColumns columns = columnsOf(heading);
    if (heading.size() > 1 && unitOfTimes(path, heading, columns)) {
        throw ParseError(
            {"fe.death_list.clock",
             "{0}: the heading \"{1}\" names a unit of time, but the result does not count in seconds",
             {path, heading[columns.time].substr(0, 80)}},
            {"fe.death_list.clock.remedy", "Write the times as the result counts them, and no unit into the heading.", {}});
    }
}

void noteUnusedDeathList(const std::string& path, Findings& findings) {
    findings.add(
        {"fe.death_list.unused", "A list of deaths lies beside a result that says itself what is dead: it was not used", {}},
        {"fe.death_list.unused.remedy", "Take it away, or check which of the two is right.", {}}, path);
}

}  // namespace rubble::io
