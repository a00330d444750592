#include "io/site/point_pairs.h"

#include <algorithm>
#include <array>
#include <optional>
#include <string_view>

#include "core/base/error.h"
#include "io/base/delimited_table.h"

namespace rubble::io {

namespace {

constexpr std::size_t pairsMax = 10000;
constexpr std::uintmax_t pairBytesMax = 10 << 20;
constexpr std::array<std::string_view, 5> pictureColumns{"picture_x_px", "picture_y_px", "x_m", "y_m", "z_m"};
constexpr std::array<std::string_view, 6> surveyColumns{"survey_x", "survey_y", "survey_z", "x_m", "y_m", "z_m"};

/// A row of numbers and its name; without one it is called by its number.
template <std::size_t Count>
struct NamedNumbers {
    std::string name;
    std::array<double, Count> values{};
};

/// Where each column stands.
template <std::size_t Count>
struct Columns {
    std::array<std::size_t, Count> numbers{};
    std::size_t name = ~std::size_t{0};

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
        const auto named = std::find(heading.begin(), heading.end(), "name");
        name = named == heading.end() ? name : static_cast<std::size_t>(named - heading.begin());
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
std::vector<NamedNumbers<Count>> readNumbers(const std::string& path, const std::array<std::string_view, Count>& names) {
    const DelimitedTable table = readDelimitedTable(path, pairBytesMax);
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
        const bool named = columns.name < row.fields.size() && !row.fields[columns.name].empty();
        each.name = named ? row.fields[columns.name] : std::to_string(row.line - 1);
    }
    return all;
}

}  // namespace

std::vector<PointPair> readPointPairs(const std::string& path) {
    std::vector<PointPair> pairs;
    for (const auto& [name, values] : readNumbers(path, pictureColumns)) {
        pairs.push_back({name, {values[0], values[1]}, {values[2], values[3], values[4]}});
    }
    return pairs;
}

std::vector<PlacePair> readPlacePairs(const std::string& path) {
    std::vector<PlacePair> pairs;
    for (const auto& [name, values] : readNumbers(path, surveyColumns)) {
        pairs.push_back({name, {values[0], values[1], values[2]}, {values[3], values[4], values[5]}});
    }
    return pairs;
}

}  // namespace rubble::io
