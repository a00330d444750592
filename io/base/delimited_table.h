#pragma once

#include <cstdint>
#include <optional>
#include <string>
#include <vector>

namespace rubble::io {

/// A line of a table in its fields, without blanks around them and without quotes;
/// empty ones at its end are left out.
struct DelimitedRow {
    std::size_t line = 0;  ///< in the file, from 1
    std::vector<std::string> fields;
};

/// A table of text as people and spreadsheets write it. One separator parts the fields of all lines: semicolons where the first
/// line has any outside quotes, else tabs, else commas, else blanks. A comma that parts no fields is a decimal sign.
struct DelimitedTable {
    std::vector<DelimitedRow> rows;  ///< the heading among them; empty lines and lines that begin with # are left out
    char separator = ',';
    bool decimalComma = false;  ///< numbers have commas as decimal signs

    /// A finite number of this table, in its decimal sign; nothing for any other text.
    std::optional<double> numberIn(const std::string& field) const;
};

/// Reads one. Quotes may enclose separators, not ends of lines. Throws WorldError (cannot be read, no regular file), ParseError
/// naming the line: too large, no text, numbers with both decimal signs.
/// @param mostBytes  a larger file is none
DelimitedTable readDelimitedTable(const std::string& path, std::uintmax_t mostBytes);

/// The same of the first lines of a file of any length, to see how it is written.
/// @param lines  that are read at most
DelimitedTable readDelimitedStart(const std::string& path, std::size_t lines);

/// Throws ParseError for a row that has more fields than the heading names: decimal commas that part fields look so.
void requireNoMoreFields(const std::string& path, const DelimitedRow& heading, const DelimitedRow& row);

/// A whole number; nothing for any other text.
std::optional<std::int64_t> wholeNumberIn(const std::string& field);

}  // namespace rubble::io
