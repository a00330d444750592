#include "io/fe/radioss/starter_deck.h"

#include <cstdlib>
#include <fstream>
#include <sstream>
#include <utility>
#include <vector>

#include "core/base/unknown.h"

namespace rubble::io {

namespace {

constexpr std::size_t deckLineMax = 1000;

/// A block of the deck: its keyword split at the slashes, and its lines without comments.
struct Block {
    std::vector<std::string> keyword;
    std::vector<std::string> lines;

    bool is(const char* first, const char* second) const {
        return keyword.size() >= 3 && keyword[0] == first && keyword[1] == second;
    }
};

// Fields have fixed columns, counted from 0.
double realAt(const Block& block, std::size_t line, std::size_t column) {
    if (line >= block.lines.size() || column >= block.lines[line].size()) {
        return unknown;
    }
    const std::string field = block.lines[line].substr(column, 20);
    char* end = nullptr;
    const double value = std::strtod(field.c_str(), &end);
    return end != field.c_str() && value > 0.0 ? value : unknown;
}

std::int64_t integerAt(const Block& block, std::size_t line, std::size_t column) {
    if (line >= block.lines.size() || column >= block.lines[line].size()) {
        return 0;
    }
    return std::strtoll(block.lines[line].substr(column, 10).c_str(), nullptr, 10);
}

std::vector<std::string> splitKeyword(const std::string& line) {
    std::vector<std::string> words;
    std::istringstream stream(line.substr(1));
    for (std::string word; std::getline(stream, word, '/');) {
        words.push_back(word);
    }
    return words;
}

/// Collects what blocks say and joins it in the end.
class DeckReader {
public:
    // The title is line 0 of every block.
    void take(const Block& block) {
        if (block.keyword.empty()) {
            return;
        }
        const std::int64_t id = std::strtoll(block.keyword.back().c_str(), nullptr, 10);
        if (block.keyword[0] == "BEGIN" && block.lines.size() > 2) {
            // Run, version, units of the deck.
            std::istringstream(block.lines[2]) >> m_deck.mass >> m_deck.length >> m_deck.time;
        } else if (block.keyword[0] == "PART") {
            m_parts[id] = {integerAt(block, 1, 0), integerAt(block, 1, 10)};
        } else if (block.keyword[0] == "MAT") {
            m_density[id] = realAt(block, 1, 0);
        } else if (block.is("PROP", "SHELL") || block.is("PROP", "TYPE1")) {
            m_thickness[id] = realAt(block, 3, 20);
        } else if (block.is("PROP", "TRUSS") || block.is("PROP", "TYPE2")) {
            m_area[id] = realAt(block, 1, 0);
        }
    }

    StarterDeck finish() {
        const auto find = [](const std::map<std::int64_t, double>& values, std::int64_t id) {
            const auto found = values.find(id);
            return found == values.end() ? unknown : found->second;
        };
        for (const auto& [id, links] : m_parts) {
            m_deck.parts[id] = {find(m_density, links.material), find(m_thickness, links.property), find(m_area, links.property)};
        }
        return std::move(m_deck);
    }

private:
    struct Links {
        std::int64_t property = 0, material = 0;
    };

    StarterDeck m_deck;
    std::map<std::int64_t, Links> m_parts;
    std::map<std::int64_t, double> m_density, m_thickness, m_area;
};

}  // namespace

std::optional<FileUnits> unitsOf(const StarterDeck& deck) {
    const std::map<std::string, double> metres{{"mm", 0.001},  {"cm", 0.01},   {"dm", 0.1},   {"m", 1.0},
                                               {"km", 1000.0}, {"in", 0.0254}, {"ft", 0.3048}};
    const std::map<std::string, double> kilograms{{"mg", 1e-6},  {"g", 0.001},    {"kg", 1.0},       {"Mg", 1000.0},
                                                  {"t", 1000.0}, {"ton", 1000.0}, {"lb", 0.45359237}};
    const std::map<std::string, double> seconds{{"us", 1e-6}, {"ms", 0.001}, {"s", 1.0}};
    const auto length = metres.find(deck.length);
    const auto mass = kilograms.find(deck.mass);
    const auto time = seconds.find(deck.time);
    if (length == metres.end() || mass == kilograms.end() || time == seconds.end()) {
        return std::nullopt;
    }
    return FileUnits{length->second, mass->second, time->second};
}

StarterDeck readStarterDeck(const std::string& path) {
    std::ifstream file(path);
    DeckReader reader;
    Block block;
    for (std::string line; std::getline(file, line);) {
        if (line.size() > deckLineMax || line.starts_with("#")) {
            continue;
        }
        if (line.starts_with("/")) {
            reader.take(block);
            block = {splitKeyword(line), {}};
        } else if (block.lines.size() < 8) {
            block.lines.push_back(line);
        }
    }
    reader.take(block);
    return reader.finish();
}

}  // namespace rubble::io
