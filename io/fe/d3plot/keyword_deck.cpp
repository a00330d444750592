#include "io/fe/d3plot/keyword_deck.h"

#include <algorithm>
#include <cctype>
#include <cmath>
#include <cstdlib>
#include <filesystem>
#include <fstream>
#include <numbers>
#include <vector>

#include "core/base/unknown.h"

namespace rubble::io {

namespace fs = std::filesystem;

namespace {

constexpr std::size_t fieldWidth = 10;
constexpr std::size_t longestLine = 1000;
constexpr int deepestInclude = 4;

std::string upper(std::string text) {
    std::transform(text.begin(), text.end(), text.begin(), [](unsigned char c) { return static_cast<char>(std::toupper(c)); });
    text.erase(text.find_last_not_of(" \t\r") + 1);
    return text;
}

// Field i of a card, of ten columns or between commas.
std::string fieldOf(const std::string& card, std::size_t i) {
    if (card.find(',') == std::string::npos) {
        return card.size() > i * fieldWidth ? card.substr(i * fieldWidth, fieldWidth) : std::string();
    }
    std::size_t begin = 0;
    for (; i > 0 && begin != std::string::npos; --i) {
        begin = card.find(',', begin);
        begin += begin == std::string::npos ? 0 : 1;
    }
    return begin == std::string::npos ? std::string() : card.substr(begin, card.find(',', begin) - begin);
}

std::int64_t integerOf(const std::string& card, std::size_t i) {
    return std::strtoll(fieldOf(card, i).c_str(), nullptr, 10);
}

double realOf(const std::string& card, std::size_t i) {
    const std::string field = fieldOf(card, i);
    char* end = nullptr;
    const double value = std::strtod(field.c_str(), &end);
    return end != field.c_str() && std::isfinite(value) ? value : 0.0;
}

double positiveOrNothing(double value) {
    return value > 0.0 ? value : unknown;
}

/// Takes blocks of cards and joins them in the end.
class DeckReader {
public:
    void readFile(const std::string& path, int depth) {
        std::ifstream file(path);
        std::string keyword;
        std::vector<std::string> cards;
        for (std::string line; std::getline(file, line) && !m_longFormat;) {
            if (line.size() > longestLine || line.starts_with("$")) {
                continue;
            }
            if (line.starts_with("*")) {
                take(keyword, cards, path, depth);
                keyword = upper(line);
                cards.clear();
                m_longFormat |= keyword.starts_with("*KEYWORD") && keyword.find("LONG") != std::string::npos;
            } else if (wanted(keyword)) {
                cards.push_back(line);
            }
        }
        take(keyword, cards, path, depth);
    }

    std::map<std::int64_t, KeywordPart> finish() const {
        std::map<std::int64_t, KeywordPart> result;
        const auto find = [](const std::map<std::int64_t, double>& values, std::int64_t id) {
            const auto found = values.find(id);
            return found == values.end() ? unknown : found->second;
        };
        for (const auto& [id, links] : m_parts) {
            result[id] = {find(m_density, links.material), find(m_thickness, links.section), find(m_area, links.section)};
        }
        return m_longFormat ? std::map<std::int64_t, KeywordPart>{} : result;
    }

private:
    struct Links {
        std::int64_t section = 0, material = 0;
    };

    static bool wanted(const std::string& keyword) {
        return keyword == "*PART" || keyword.starts_with("*MAT_") || keyword.starts_with("*SECTION_SHELL") ||
               keyword.starts_with("*SECTION_BEAM") || keyword == "*INCLUDE";
    }

    void take(const std::string& keyword, const std::vector<std::string>& cards, const std::string& path, int depth) {
        const bool titled = keyword.ends_with("_TITLE");
        const std::size_t title = titled ? 1 : 0;
        if (keyword == "*PART") {
            for (std::size_t i = 1; i < cards.size(); i += 2) {
                m_parts[integerOf(cards[i], 0)] = {integerOf(cards[i], 1), integerOf(cards[i], 2)};
            }
        } else if (keyword.starts_with("*MAT_") && cards.size() > title) {
            m_density[integerOf(cards[title], 0)] = positiveOrNothing(realOf(cards[title], 1));
        } else if (keyword.starts_with("*SECTION_")) {
            for (std::size_t i = title; i + 1 < cards.size(); i += 2 + title) {
                takeSection(keyword.starts_with("*SECTION_BEAM"), cards[i], cards[i + 1]);
            }
        } else if (keyword == "*INCLUDE" && depth < deepestInclude) {
            for (const std::string& name : cards) {
                const std::string trimmed = name.substr(0, name.find_last_not_of(" \t\r") + 1);
                readFile((fs::path(path).parent_path() / trimmed).string(), depth + 1);
            }
        }
    }

    void takeSection(bool beam, const std::string& first, const std::string& second) {
        const std::int64_t id = integerOf(first, 0);
        if (!beam) {
            m_thickness[id] = positiveOrNothing(realOf(second, 0));
            return;
        }
        const std::int64_t form = integerOf(first, 1);
        if (form == 2 || form == 3 || form == 12 || form == 13) {
            m_area[id] = positiveOrNothing(realOf(second, 0));
        } else if (form <= 1 || form == 11) {
            // Sides of a rectangle, or outer and inner diameter of a tube.
            const double outer = realOf(second, 0), other = realOf(second, 2);
            const bool tube = realOf(first, 4) == 1.0;
            m_area[id] = positiveOrNothing(tube ? 0.25 * std::numbers::pi * (outer * outer - other * other) : outer * other);
        }
    }

    std::map<std::int64_t, Links> m_parts;
    std::map<std::int64_t, double> m_density, m_thickness, m_area;
    bool m_longFormat = false;
};

bool beginsAsDeck(const std::string& path) {
    std::ifstream file(path);
    for (std::string line; std::getline(file, line) && line.size() < longestLine;) {
        if (!line.starts_with("$")) {
            return upper(line).starts_with("*KEYWORD");
        }
    }
    return false;
}

}  // namespace

std::string keywordDeckBeside(const std::string& root) {
    const fs::path folder = fs::path(root).parent_path();
    std::vector<std::string> decks;
    std::error_code error;
    for (fs::directory_iterator entry(folder.empty() ? "." : folder, error); !error && entry != fs::directory_iterator();
         entry.increment(error)) {
        const fs::path name = entry->path().filename();
        std::error_code ignored;
        if ((name.extension() == ".k" || name.extension() == ".key" || name.extension() == ".dyn") &&
            entry->is_regular_file(ignored) && beginsAsDeck(entry->path().string())) {
            decks.push_back((folder / name).string());
        }
    }
    return decks.size() == 1 ? decks.front() : std::string();
}

std::map<std::int64_t, KeywordPart> readKeywordDeck(const std::string& path) {
    DeckReader reader;
    if (!path.empty()) {
        reader.readFile(path, 0);
    }
    return reader.finish();
}

}  // namespace rubble::io
