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
constexpr std::array<std::string_view, 5> columnNames{"picture_x_px", "picture_y_px", "x_m", "y_m", "z_m"};

/// Where each column stands.
struct Columns {
    std::array<std::size_t, 5> numbers{};
    std::size_t name = ~std::size_t{0};

    Columns(const std::vector<std::string>& heading, const std::string& path) {
        for (std::size_t c = 0; c < columnNames.size(); ++c) {
            const auto found = std::find(heading.begin(), heading.end(), columnNames[c]);
            if (found == heading.end()) {
                throw ParseError(
                    {"pairs.no_column", "{0}, line 1: there is no column {1}", {path, columnNames[c]}},
                    {"pairs.no_column.remedy", "Begin the table with the line name,picture_x_px,picture_y_px,x_m,y_m,z_m.", {}});
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

}  // namespace

std::vector<PointPair> readPointPairs(const std::string& path) {
    const DelimitedTable table = readDelimitedTable(path, pairBytesMax);
    const DelimitedRow heading = table.rows.empty() ? DelimitedRow{} : table.rows.front();
    const Columns columns(heading.fields, path);
    std::vector<PointPair> pairs;
    for (std::size_t r = 1; r < table.rows.size(); ++r) {
        const DelimitedRow& row = table.rows[r];
        if (pairs.size() == pairsMax) {
            throw ParseError({"pairs.too_many", "{0}, line {1}: there are more than {2} pairs", {path, row.line, pairsMax}},
                             {"pairs.too_many.remedy", "A few dozen pairs are enough.", {}});
        }
        requireNoMoreFields(path, heading, row);
        std::array<double, 5> values{};
        for (std::size_t c = 0; c < values.size(); ++c) {
            values[c] = numberIn(table, row, columns.numbers[c], columnNames[c], path);
        }
        PointPair& pair = pairs.emplace_back();
        const bool named = columns.name < row.fields.size() && !row.fields[columns.name].empty();
        pair.name = named ? row.fields[columns.name] : std::to_string(row.line - 1);
        pair.picture = {values[0], values[1]};
        pair.model = {values[2], values[3], values[4]};
    }
    return pairs;
}

}  // namespace rubble::io
