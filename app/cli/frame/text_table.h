#pragma once

#include <cstdint>
#include <ostream>
#include <string>
#include <vector>

#include "core/base/csv_text.h"

namespace rubble::cli {

/// One entry of a table: as people read it, and as a program does.
struct Cell {
    std::string shown;
    std::string raw;
    bool number = false;  ///< set flush right
};

Cell textCell(std::string text);
Cell integerCell(std::int64_t number);
/// Shown to four significant digits, kept to the last bit; a number that is not finite is an empty cell.
Cell numberCell(double number);

/// A table for the terminal that can be written as CSV too.
class TextTable {
public:
    struct Column {
        std::string title;  ///< for people, with the unit: "mass [t]"
        std::string key;    ///< for programs, with the unit: "mass_kg"
    };

    explicit TextTable(std::vector<Column> columns) : m_columns(std::move(columns)) {}

    /// A row has one cell for each column.
    void add(std::vector<Cell> row);
    std::size_t rows() const { return m_rows.size(); }

    /// Aligned columns under their titles, ruled above and below.
    void print(std::ostream& out) const;
    /// RFC 4180 with CRLF left to LF: one heading row of keys, point as decimal sign, no comment lines.
    void writeCsv(std::ostream& out) const;

private:
    std::vector<Column> m_columns;
    std::vector<std::vector<Cell>> m_rows;
};

}  // namespace rubble::cli
