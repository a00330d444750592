#include "io/fe/series/death_list.h"

#include <algorithm>
#include <filesystem>
#include <initializer_list>
#include <optional>
#include <string_view>
#include <unordered_map>

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
        } else if (word.starts_with("TIME") || word == "T") {
            named.time = c;
        } else if (isAnyOf(word, {"STATUS", "ACTIVE", "ALIVE"})) {
            named.status = c;
        }
    }
    return named.element != none && named.time != none ? named : DeathColumns{};
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
    DelimitedRow heading{0, {"element", "time", "status"}};
    for (const DelimitedRow& row : table.rows) {
        const bool isHeading = &row == &table.rows.front() && std::none_of(row.fields.begin(), row.fields.end(), beginsAsNumber);
        if (isHeading) {
            if (row.fields.size() > 1) {
                heading = row;
                columns = columnsOf(row.fields);
            }
            continue;
        }
        requireNoMoreFields(path, heading, row);
        DeathEntry entry;
        if (!parseEntry(table, row.fields, columns, entry)) {
            failLine(path, row);
        }
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

void noteUnusedDeathList(const std::string& path, Findings& findings) {
    findings.add(
        {"fe.death_list.unused", "A list of deaths lies beside a result that says itself what is dead: it was not used", {}},
        {"fe.death_list.unused.remedy", "Take it away, or check which of the two is right.", {}}, path);
}

}  // namespace rubble::io
