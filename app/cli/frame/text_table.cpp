#include "app/cli/frame/text_table.h"

#include <algorithm>
#include <cassert>
#include <cmath>

#include "core/base/message.h"

namespace rubble::cli {

namespace {

/// Characters on the screen, not bytes: continuation bytes of UTF-8 take no room.
std::size_t width(const std::string& text) {
    return static_cast<std::size_t>(std::count_if(text.begin(), text.end(), [](char c) { return (c & 0xC0) != 0x80; }));
}

}  // namespace

Cell textCell(std::string text) {
    return {text, text, false};
}

Cell integerCell(std::int64_t number) {
    return {englishInteger(number), std::to_string(number), true};
}

Cell numberCell(double number) {
    return {std::isfinite(number) ? englishNumber(number) : "-", exactNumber(number), true};
}

void TextTable::add(std::vector<Cell> row) {
    assert(row.size() == m_columns.size());
    m_rows.push_back(std::move(row));
}

void TextTable::print(std::ostream& out) const {
    std::vector<std::size_t> widths;
    for (std::size_t c = 0; c < m_columns.size(); ++c) {
        std::size_t widest = width(m_columns[c].title);
        for (const auto& row : m_rows) {
            widest = std::max(widest, width(row[c].shown));
        }
        widths.push_back(widest);
    }
    const auto line = [&](const auto& textOf, const auto& flushRight) {
        std::string text = " ";
        for (std::size_t c = 0; c < m_columns.size(); ++c) {
            const std::string padding(widths[c] - width(textOf(c)), ' ');
            text += ' ' + (flushRight(c) ? padding + textOf(c) : textOf(c) + padding) + ' ';
        }
        text.erase(text.find_last_not_of(' ') + 1);
        out << text << '\n';
    };
    std::size_t total = 1;
    for (const std::size_t w : widths) {
        total += w + 2;
    }
    const std::string rule = "  " + std::string(total - 3, '-') + '\n';
    // A column of numbers has its title flush right as well.
    const auto numeric = [&](std::size_t c) { return !m_rows.empty() && m_rows.front()[c].number; };
    line([&](std::size_t c) -> const std::string& { return m_columns[c].title; }, numeric);
    out << rule;
    for (const auto& row : m_rows) {
        line([&](std::size_t c) -> const std::string& { return row[c].shown; }, [&](std::size_t c) { return row[c].number; });
    }
    out << rule;
}

void TextTable::writeCsv(std::ostream& out) const {
    for (std::size_t c = 0; c < m_columns.size(); ++c) {
        out << (c == 0 ? "" : ",") << csvField(m_columns[c].key);
    }
    out << '\n';
    for (const auto& row : m_rows) {
        for (std::size_t c = 0; c < row.size(); ++c) {
            out << (c == 0 ? "" : ",") << csvField(row[c].raw);
        }
        out << '\n';
    }
}

}  // namespace rubble::cli
