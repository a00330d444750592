#include "io/site/point_pairs.h"

#include <algorithm>
#include <array>
#include <charconv>
#include <cmath>
#include <filesystem>
#include <fstream>

#include "core/base/error.h"

namespace rubble::io {

namespace {

constexpr std::size_t pairsMax = 10000;
constexpr std::uintmax_t pairBytesMax = 10 << 20;
constexpr std::array<std::string_view, 5> columnNames{"picture_x_px", "picture_y_px", "x_m", "y_m", "z_m"};

/// One line of a table in its fields. Quotes may enclose separators, not ends of lines.
std::vector<std::string> fieldsOfRow(const std::string& line) {
    std::vector<std::string> fields(1);
    bool inside = false;
    for (std::size_t i = 0; i < line.size(); ++i) {
        const char c = line[i];
        if (c == '"' && inside && i + 1 < line.size() && line[i + 1] == '"') {
            fields.back() += line[++i];
        } else if (c == '"') {
            inside = !inside;
        } else if (c == ',' && !inside) {
            fields.emplace_back();
        } else if (c != '\r') {
            fields.back() += c;
        }
    }
    return fields;
}

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

double numberIn(const std::vector<std::string>& fields, std::size_t column, std::string_view name, const std::string& path,
                std::size_t line) {
    const std::string text = column < fields.size() ? fields[column] : std::string();
    double number = 0.0;
    const auto end = std::from_chars(text.data(), text.data() + text.size(), number);
    if (end.ec != std::errc{} || end.ptr != text.data() + text.size() || !std::isfinite(number)) {
        throw ParseError({"pairs.no_number", "{0}, line {1}: {2} is \"{3}\", which is no number", {path, line, name, text}},
                         {"pairs.no_number.remedy", "Write it with a point as decimal sign, or leave the line out.", {}});
    }
    return number;
}

}  // namespace

std::vector<PointPair> readPointPairs(const std::string& path) {
    std::error_code ignored;
    std::ifstream in(path, std::ios::binary);
    if (!in || std::filesystem::is_directory(path, ignored)) {
        throw WorldError({"pairs.unreadable", "Cannot read {0}", {path}},
                         {"pairs.unreadable.remedy", "Check that the file exists and that you may read it.", {}});
    }
    if (std::filesystem::file_size(path, ignored) > pairBytesMax && !ignored) {
        throw ParseError({"pairs.too_large", "{0} is too large for a table of point pairs", {path}},
                         {"pairs.too_large.remedy", "Give the table of pairs, with a few dozen lines.", {}});
    }
    std::string line;
    std::getline(in, line);
    if (line.starts_with("\xef\xbb\xbf")) {
        line.erase(0, 3);
    }
    const Columns columns(fieldsOfRow(line), path);
    std::vector<PointPair> pairs;
    for (std::size_t number = 2; std::getline(in, line); ++number) {
        if (line.find_first_not_of(" \t\r") == std::string::npos) {
            continue;
        }
        if (pairs.size() == pairsMax) {
            throw ParseError({"pairs.too_many", "{0}, line {1}: there are more than {2} pairs", {path, number, pairsMax}},
                             {"pairs.too_many.remedy", "A few dozen pairs are enough.", {}});
        }
        const std::vector<std::string> fields = fieldsOfRow(line);
        std::array<double, 5> values{};
        for (std::size_t c = 0; c < values.size(); ++c) {
            values[c] = numberIn(fields, columns.numbers[c], columnNames[c], path, number);
        }
        PointPair& pair = pairs.emplace_back();
        pair.name =
            columns.name < fields.size() && !fields[columns.name].empty() ? fields[columns.name] : std::to_string(number - 1);
        pair.picture = {values[0], values[1]};
        pair.model = {values[2], values[3], values[4]};
    }
    return pairs;
}

}  // namespace rubble::io
