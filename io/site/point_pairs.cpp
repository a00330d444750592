#include "io/site/point_pairs.h"

#include <algorithm>
#include <array>
#include <optional>
#include <string_view>

#include "core/base/csv_text.h"
#include "core/base/error.h"
#include "core/base/nearest_names.h"
#include "io/base/delimited_table.h"
#include "io/base/files.h"
#include "io/site/site_place.h"

namespace rubble::io {

namespace {

constexpr std::size_t pairsMax = 10000;
constexpr std::uintmax_t pairBytesMax = 10 << 20;
constexpr std::array<std::string_view, 5> pictureColumns{"picture_x_px", "picture_y_px", "x_m", "y_m", "z_m"};
constexpr std::array<std::string_view, 6> surveyColumns{"survey_x", "survey_y", "survey_z", "x_m", "y_m", "z_m"};
constexpr std::array<std::string_view, 6> metreColumns{"survey_x_m", "survey_y_m", "survey_z_m", "x_m", "y_m", "z_m"};

constexpr std::string_view deviationColumn = "deviation_m";

/// A row of numbers and its name; without one it is called by its number.
template <std::size_t Count>
struct NamedNumbers {
    std::string name;
    std::array<double, Count> values{};
    std::optional<double> deviation{};  ///< m, of the place, where the table states it
};

/// Where each column stands.
template <std::size_t Count>
struct Columns {
    std::array<std::size_t, Count> numbers{};
    std::size_t name = ~std::size_t{0};
    std::size_t deviation = ~std::size_t{0};

    Columns(const std::vector<std::string>& heading, const std::array<std::string_view, Count>& names, const std::string& path) {
        std::string whole = "name";
        for (const std::string_view each : names) {
            whole += "," + std::string(each);
        }
        for (std::size_t c = 0; c < Count; ++c) {
            const auto found = std::find(heading.begin(), heading.end(), names[c]);
            if (found == heading.end()) {
                throw ParseError({"pairs.no_column", "{0}, line 1: there is no column {1}", {path, names[c]}},
                                 {"pairs.no_column.remedy", "Begin the table with the line {0}.", {whole}});
            }
            numbers[c] = static_cast<std::size_t>(found - heading.begin());
        }
        for (const auto& [column, at] : {std::pair{std::string_view("name"), &name}, std::pair{deviationColumn, &deviation}}) {
            const auto found = std::find(heading.begin(), heading.end(), column);
            *at = found == heading.end() ? *at : static_cast<std::size_t>(found - heading.begin());
        }
    }
};

double numberIn(const DelimitedTable& table, const DelimitedRow& row, std::size_t column, std::string_view name,
                const std::string& path) {
    const std::string text = column < row.fields.size() ? row.fields[column] : std::string();
    const std::optional<double> number = table.numberIn(text);
    if (!number) {
        throw ParseError({"pairs.no_number", "{0}, line {1}: {2} is \"{3}\", which is no number", {path, row.line, name, text}},
                         {"pairs.no_number.remedy", "Write it with a point as decimal sign, or leave the line out.", {}});
    }
    return *number;
}

template <std::size_t Count>
std::vector<NamedNumbers<Count>> numbersOf(const DelimitedTable& table, const std::string& path,
                                           const std::array<std::string_view, Count>& names) {
    const DelimitedRow heading = table.rows.empty() ? DelimitedRow{} : table.rows.front();
    const Columns<Count> columns(heading.fields, names, path);
    std::vector<NamedNumbers<Count>> all;
    for (std::size_t r = 1; r < table.rows.size(); ++r) {
        const DelimitedRow& row = table.rows[r];
        if (all.size() == pairsMax) {
            throw ParseError({"pairs.too_many", "{0}, line {1}: there are more than {2} pairs", {path, row.line, pairsMax}},
                             {"pairs.too_many.remedy", "A few dozen pairs are enough.", {}});
        }
        requireNoMoreFields(path, heading, row);
        NamedNumbers<Count>& each = all.emplace_back();
        for (std::size_t c = 0; c < Count; ++c) {
            each.values[c] = numberIn(table, row, columns.numbers[c], names[c], path);
        }
        if (columns.deviation < row.fields.size() && !row.fields[columns.deviation].empty()) {
            each.deviation = numberIn(table, row, columns.deviation, deviationColumn, path);
            if (*each.deviation < 0.0) {
                throw ParseError({"pairs.deviation", "{0}, line {1}: {2} is below zero", {path, row.line, deviationColumn}},
                                 {"pairs.deviation.remedy", "Give the standard deviation of the place in m.", {}});
            }
        }
        const bool named = columns.name < row.fields.size() && !row.fields[columns.name].empty();
        each.name = named ? row.fields[columns.name] : std::to_string(row.line - 1);
    }
    return all;
}

}  // namespace

std::vector<PointPair> readPointPairs(const std::string& path) {
    std::vector<PointPair> pairs;
    for (const auto& [name, values, deviation] : numbersOf(readDelimitedTable(path, pairBytesMax), path, pictureColumns)) {
        pairs.push_back({name, {values[0], values[1]}, {values[2], values[3], values[4]}});
    }
    return pairs;
}

bool needsNamedPoints(const std::string& path) {
    const DelimitedTable start = readDelimitedStart(path, 1);
    return !start.rows.empty() && std::ranges::count(start.rows.front().fields, pictureColumns[0]) > 0 &&
           std::ranges::count(start.rows.front().fields, pictureColumns[2]) == 0;
}

std::vector<PointPair> readPointPairs(const std::string& path, std::span<const NamedPoint> measured,
                                      const std::function<Vec3(const Vec3&)>& to) {
    constexpr std::array<std::string_view, 2> columns{pictureColumns[0], pictureColumns[1]};
    std::vector<PointPair> pairs;
    std::vector<std::string> missing;
    for (const auto& [name, values, deviation] : numbersOf(readDelimitedTable(path, pairBytesMax), path, columns)) {
        const auto found = std::ranges::find(measured, name, &NamedPoint::name);
        if (found == measured.end()) {
            missing.push_back(name);
        } else {
            pairs.push_back({name, {values[0], values[1]}, to(found->place)});
        }
    }
    if (!missing.empty()) {
        throw ParseError({"pairs.not_measured", "{0}: no measured point is called {1}", {path, quotedList(missing)}},
                         {"pairs.not_measured.remedy", "Give points of the picture the names that they have in the survey.", {}});
    }
    return pairs;
}

PlacePairTable readPlacePairs(const std::string& path) {
    const DelimitedTable table = readDelimitedTable(path, pairBytesMax);
    PlacePairTable read;
    read.metres = !table.rows.empty() && std::ranges::count(table.rows.front().fields, metreColumns[0]) > 0;
    for (const auto& [name, values, deviation] : numbersOf(table, path, read.metres ? metreColumns : surveyColumns)) {
        read.pairs.push_back({name, {values[0], values[1], values[2]}, {values[3], values[4], values[5]}, deviation});
    }
    return read;
}

void writePlacePairs(const std::string& path, const std::vector<PlacePair>& pairs, const Frame& frame, const Site& site) {
    const SitePlace place(frame, site);
    const Vec3 lift(0.0, 0.0, site.heightShift);
    writeAtomically(path, [&](std::ostream& out) {
        out << "name";
        for (const std::string_view column : metreColumns) {
            out << ',' << column;
        }
        const bool stated = std::ranges::any_of(pairs, [](const PlacePair& pair) { return pair.deviation.has_value(); });
        out << (stated ? "," + std::string(deviationColumn) : "") << '\n';
        for (const PlacePair& pair : pairs) {
            out << csvField(pair.name);
            for (const Vec3& at : {Vec3(place.toWorld(pair.surveyed) - lift), place.toWorld(pair.placed)}) {
                for (const double number : at) {
                    out << ',' << exactNumber(number);
                }
            }
            out << (stated ? "," : "") << (pair.deviation ? exactNumber(*pair.deviation) : "") << '\n';
        }
    });
}

}  // namespace rubble::io
