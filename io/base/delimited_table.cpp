#include "io/base/delimited_table.h"

#include <algorithm>
#include <charconv>
#include <cmath>
#include <filesystem>
#include <fstream>
#include <limits>
#include <string_view>

#include "core/base/error.h"
#include "io/base/files.h"
#include "io/base/trimmed.h"

namespace rubble::io {

namespace {

constexpr char blankSeparator = ' ';

/// A line as it stands in the file.
struct Line {
    std::size_t number = 0;
    std::string text;
};

bool hasOutsideQuotes(const std::string& text, char wanted) {
    bool inside = false;
    for (const char c : text) {
        if (c == '"') {
            inside = !inside;
        } else if (c == wanted && !inside) {
            return true;
        }
    }
    return false;
}

// The first line tells, unless it has one field alone.
char separatorOf(const std::vector<Line>& lines) {
    for (const std::size_t seen : {std::min<std::size_t>(lines.size(), 1), lines.size()}) {
        for (const char separator : {';', '\t', ','}) {
            for (std::size_t l = 0; l < seen; ++l) {
                if (hasOutsideQuotes(lines[l].text, separator)) {
                    return separator;
                }
            }
        }
        if (seen > 0 && lines.front().text.find(blankSeparator) != std::string::npos) {
            break;
        }
    }
    return blankSeparator;
}

std::vector<std::string> partsOf(const std::string& text, char separator) {
    std::vector<std::string> fields(1);
    bool inside = false;
    for (std::size_t i = 0; i < text.size(); ++i) {
        const char c = text[i];
        if (c == '"' && inside && i + 1 < text.size() && text[i + 1] == '"') {
            fields.back() += text[++i];
        } else if (c == '"') {
            inside = !inside;
        } else if (c == separator && !inside) {
            fields.emplace_back();
        } else {
            fields.back() += c;
        }
    }
    for (std::string& field : fields) {
        field = std::string(trimmed(field));
    }
    if (separator == blankSeparator) {
        std::erase(fields, "");
    }
    while (fields.size() > 1 && fields.back().empty()) {
        fields.pop_back();
    }
    return fields;
}

std::optional<double> plainNumber(std::string_view text) {
    double value = 0.0;
    if (text.starts_with('+')) {
        text.remove_prefix(1);
    }
    const auto [end, error] = std::from_chars(text.data(), text.data() + text.size(), value);
    const bool whole = error == std::errc{} && end == text.data() + text.size() && std::isfinite(value);
    return whole ? std::optional(value) : std::nullopt;
}

std::optional<double> numberWithComma(std::string text) {
    if (std::count(text.begin(), text.end(), ',') != 1 || text.find('.') != std::string::npos) {
        return std::nullopt;
    }
    std::replace(text.begin(), text.end(), ',', '.');
    return plainNumber(text);
}

// "sep=;" is what a spreadsheet reads as the separator of the lines below.
std::optional<char> declaredSeparator(const std::vector<Line>& lines) {
    const bool declared = !lines.empty() && lines.front().text.size() == 5 && lines.front().text.starts_with("sep=");
    return declared ? std::optional(lines.front().text.back()) : std::nullopt;
}

std::vector<Line> linesOf(const std::string& path, std::uintmax_t mostBytes, std::size_t mostLines) {
    std::error_code error;
    std::ifstream file;
    if (std::filesystem::is_regular_file(path, error)) {
        file.open(path, std::ios::binary);
    }
    if (!file.is_open()) {
        failToRead(path);
    }
    if (std::filesystem::file_size(path, error) > mostBytes && !error) {
        throw ParseError({"table.too_large", "{0} is too large for such a table", {path}},
                         {"table.too_large.remedy", "Give a table of at most {0} bytes.", {static_cast<std::int64_t>(mostBytes)}});
    }
    std::vector<Line> lines;
    std::string text;
    for (std::size_t number = 1; number <= mostLines && std::getline(file, text); ++number) {
        if (number == 1 && text.starts_with("\xef\xbb\xbf")) {
            text.erase(0, 3);
        }
        if (text.find('\0') != std::string::npos) {
            throw ParseError({"table.no_text", "{0}: line {1} is no text", {path, number}},
                             {"table.no_text.remedy", "Save the table as CSV in UTF-8.", {}});
        }
        text = std::string(trimmed(text));
        if (!text.empty() && !text.starts_with('#')) {
            lines.push_back({number, text});
        }
    }
    return lines;
}

void decideDecimalSign(DelimitedTable& table, const std::string& path) {
    const DelimitedRow* withPoint = nullptr;
    for (const DelimitedRow& row : table.rows) {
        for (const std::string& field : row.fields) {
            if (field.find('.') != std::string::npos && plainNumber(field)) {
                withPoint = &row;
            }
            table.decimalComma = table.decimalComma || numberWithComma(field).has_value();
        }
    }
    if (table.decimalComma && withPoint != nullptr) {
        throw ParseError({"table.two_signs", "{0}: numbers have commas and, in line {1}, points", {path, withPoint->line}},
                         {"table.two_signs.remedy", "Write all numbers with one decimal sign and without marks of thousands.", {}});
    }
}

DelimitedTable tableOf(const std::string& path, std::vector<Line> lines) {
    const std::optional<char> declared = declaredSeparator(lines);
    if (declared) {
        lines.erase(lines.begin());
    }
    DelimitedTable table;
    table.separator = declared ? *declared : separatorOf(lines);
    for (const Line& line : lines) {
        table.rows.push_back({line.number, partsOf(line.text, table.separator)});
    }
    decideDecimalSign(table, path);
    return table;
}

}  // namespace

std::optional<double> DelimitedTable::numberIn(const std::string& field) const {
    if (decimalComma && field.find(',') != std::string::npos) {
        return numberWithComma(field);
    }
    return plainNumber(field);
}

DelimitedTable readDelimitedTable(const std::string& path, std::uintmax_t mostBytes) {
    return tableOf(path, linesOf(path, mostBytes, std::numeric_limits<std::size_t>::max()));
}

DelimitedTable readDelimitedStart(const std::string& path, std::size_t lines) {
    return tableOf(path, linesOf(path, std::numeric_limits<std::uintmax_t>::max(), lines));
}

void requireNoMoreFields(const std::string& path, const DelimitedRow& heading, const DelimitedRow& row) {
    if (row.fields.size() > heading.fields.size()) {
        throw ParseError({"table.more_fields",
                          "{0}: line {1} has {2} fields, but the heading names {3}",
                          {path, row.line, row.fields.size(), heading.fields.size()}},
                         {"table.more_fields.remedy",
                          "Name every column in the heading, and write numbers with points, or part the fields by semicolons.",
                          {}});
    }
}

std::optional<std::int64_t> wholeNumberIn(const std::string& field) {
    std::int64_t value = 0;
    const char* const begin = field.data() + (field.starts_with('+') ? 1 : 0);
    const auto [end, error] = std::from_chars(begin, field.data() + field.size(), value);
    return error == std::errc{} && end == field.data() + field.size() ? std::optional(value) : std::nullopt;
}

}  // namespace rubble::io
