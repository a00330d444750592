#include "bench/results_page.h"

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <optional>
#include <sstream>
#include <utility>

namespace rubble::bench {

namespace {

std::string rowText(const std::vector<std::string>& cells, std::size_t columns) {
    std::string line = "|";
    for (std::size_t i = 0; i < columns; ++i) {
        line += ' ';
        for (const char letter : i < cells.size() ? cells[i] : std::string()) {
            if (letter == '|') {
                line += '\\';
            }
            line += letter;
        }
        line += " |";
    }
    return line + "\n";
}

std::string circumstancesText(const Circumstances& measured) {
    char numbers[96];
    std::snprintf(numbers, sizeof numbers, "Load before: %.2f. All commands: %.0f s.", measured.loadBefore, measured.seconds);
    return "Measured " + measured.date + " UTC on " + measured.machine + ". Commit " + measured.commit + "; " + measured.build +
           ". " + numbers + "\n";
}

/// A heading of the second level with all that follows it.
struct Part {
    std::string title;  ///< empty for what stands before the first heading
    std::string text;
};

std::vector<Part> partsOf(const std::string& page) {
    std::vector<Part> parts(1);
    std::istringstream lines(page);
    bool inCode = false;
    for (std::string line; std::getline(lines, line);) {
        if (line.starts_with("```")) {
            inCode = !inCode;
        }
        if (!inCode && line.starts_with("## ")) {
            parts.push_back({line.substr(3), {}});
        }
        parts.back().text += line + "\n";
    }
    return parts;
}

/// Where a title stands in the order; nothing for one that does not occur in it.
std::optional<std::size_t> rankOf(const std::vector<std::string>& titles, const std::string& title) {
    const auto found = std::find(titles.begin(), titles.end(), title);
    if (found == titles.end()) {
        return std::nullopt;
    }
    return static_cast<std::size_t>(found - titles.begin());
}

/// After the last part that comes before this title in the order; at the end if none does.
std::vector<Part>::iterator placeOf(std::vector<Part>& parts, const std::vector<std::string>& titles, const std::string& title) {
    const std::optional<std::size_t> rank = rankOf(titles, title);
    auto place = parts.begin() + 1;
    for (auto part = parts.begin() + 1; part != parts.end(); ++part) {
        const std::optional<std::size_t> other = rankOf(titles, part->title);
        if (!rank || (other && *other < *rank)) {
            place = part + 1;
        }
    }
    return place;
}

/// The text with one empty line at its end.
std::string closed(std::string text) {
    while (text.ends_with('\n')) {
        text.pop_back();
    }
    return text + "\n\n";
}

}  // namespace

std::string tableText(const Table& table) {
    std::string text = rowText(table.head, table.head.size()) + "|";
    for (std::size_t i = 0; i < table.head.size(); ++i) {
        text += "---|";
    }
    text += "\n";
    for (const std::vector<std::string>& row : table.rows) {
        text += rowText(row, table.head.size());
    }
    return text;
}

std::string sectionText(const Section& section) {
    std::string text = "## " + section.title + "\n\n";
    if (!section.about.empty()) {
        text += section.about + "\n\n";
    }
    text += circumstancesText(section.circumstances);
    for (const MeasuredTable& measured : section.tables) {
        text += "\n```\n";
        for (const std::string& command : measured.commands) {
            text += command + "\n";
        }
        text += "```\n\n" + tableText(measured.table);
    }
    return text;
}

std::string pageWith(const std::string& page, const std::string& opening, const std::vector<Section>& sections,
                     const std::vector<std::string>& titles) {
    std::vector<Part> parts = partsOf(page);
    parts.front().text = opening;
    for (const Section& section : sections) {
        const auto same =
            std::find_if(parts.begin() + 1, parts.end(), [&](const Part& part) { return part.title == section.title; });
        if (same != parts.end()) {
            same->text = sectionText(section);
        } else {
            parts.insert(placeOf(parts, titles, section.title), {section.title, sectionText(section)});
        }
    }
    std::string text;
    for (const Part& part : parts) {
        text += closed(part.text);
    }
    text.pop_back();
    return text;
}

}  // namespace rubble::bench
