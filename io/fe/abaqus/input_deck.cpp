#include "io/fe/abaqus/input_deck.h"

#include <algorithm>
#include <charconv>
#include <cmath>
#include <filesystem>
#include <fstream>

#include "core/base/error.h"
#include "io/base/trimmed.h"
#include "io/fe/series/byte_window.h"
#include "io/fe/series/numbered_files.h"

namespace rubble::io {

namespace {

namespace fs = std::filesystem;

constexpr int deepestInclude = 10;
constexpr std::size_t longestLine = 100'000;

std::optional<double> realOf(std::string text) {
    std::replace_if(text.begin(), text.end(), [](char c) { return c == 'D' || c == 'd'; }, 'E');
    double value = 0.0;
    const char* begin = text.data() + (text.starts_with('+') ? 1 : 0);
    const auto [end, error] = std::from_chars(begin, text.data() + text.size(), value);
    return error == std::errc{} && end == text.data() + text.size() && std::isfinite(value) ? std::optional(value) : std::nullopt;
}

std::optional<std::int64_t> integerOf(const std::string& text) {
    std::int64_t value = 0;
    const auto [end, error] = std::from_chars(text.data(), text.data() + text.size(), value);
    return error == std::errc{} && end == text.data() + text.size() ? std::optional(value) : std::nullopt;
}

/// A keyword line: "*ELEMENT, TYPE=C3D8" is ELEMENT with the option TYPE. Upper case, names without quotes, those of keywords and
/// options without blanks.
struct Keyword {
    std::string name;
    std::map<std::string, std::string> options;
    std::string file;  ///< of INPUT=, as written

    bool has(const std::string& option) const { return options.count(option) > 0; }
    std::string option(const std::string& option) const { return has(option) ? options.at(option) : ""; }
};

std::string withoutBlanks(std::string text) {
    std::erase_if(text, [](char c) { return c == ' ' || c == '\t'; });
    return text;
}

Keyword keywordOf(const std::string& line) {
    Keyword keyword;
    const std::vector<std::string> fields = fieldsOf(line);
    // "SOLID SECTION" may be written with any number of blanks, or none.
    keyword.name = withoutBlanks(upperCase(fields.front().substr(1)));
    for (std::size_t i = 1; i < fields.size(); ++i) {
        const std::size_t equals = fields[i].find('=');
        std::string value = equals == std::string::npos ? "" : std::string(trimmed(fields[i].substr(equals + 1)));
        std::erase(value, '"');
        const std::string name = withoutBlanks(upperCase(fields[i].substr(0, equals)));
        if (name == "INPUT") {
            keyword.file = value;
        }
        keyword.options[name] = upperCase(value);
    }
    return keyword;
}

class DeckReader {
public:
    explicit DeckReader(const std::string& path) {
        m_deck.path = path;
        read(path, 0);
        for (auto& [name, set] : m_deck.elementSets) {
            set.sort();
        }
        for (DeckChange& change : m_deck.changes) {
            change.elements.sort();
        }
    }
    InputDeck take() { return std::move(m_deck); }

private:
    void read(const std::string& path, int depth) {
        std::ifstream file(path);
        if (!file) {
            throw WorldError({"deck.unreadable", "Cannot read the input deck {0}", {path}},
                             {"deck.unreadable.remedy", "Copy it beside the result with all that it includes.", {}});
        }
        std::int64_t number = 0;
        for (std::string line; std::getline(file, line);) {
            ++number;
            if (line.size() > longestLine || line.find('\0') != std::string::npos) {
                throw ParseError({"deck.binary", "{0} is no input deck: line {1} is no text", {path, number}},
                                 {"deck.binary.remedy", "Give the deck as text, or take the file away.", {}});
            }
            line = std::string(trimmed(line));
            if (line.empty() || line.starts_with("**")) {
                continue;
            }
            if (line.starts_with('*')) {
                readKeyword(file, line, number, path, depth);
            } else {
                readData(fieldsOf(line));
            }
        }
    }

    void readKeyword(std::ifstream& file, std::string line, std::int64_t& number, const std::string& path, int depth) {
        // A comma at the end goes on with the next line.
        for (std::string more; line.ends_with(',') && std::getline(file, more);) {
            ++number;
            line += trimmed(more);
        }
        m_keyword = keywordOf(line);
        m_line = 0;
        m_inChange = false;
        if (m_keyword.name == "INCLUDE" && !m_keyword.file.empty()) {
            if (depth >= deepestInclude) {
                throw ParseError({"deck.include", "{0}: line {1} includes files in a circle", {path, number}},
                                 {"deck.include.remedy", "Remove the include.", {}});
            }
            const std::string included = namedFile(path, m_keyword.file);
            std::error_code ignored;
            if (fs::is_regular_file(included, ignored)) {
                read(included, depth + 1);
            } else {
                m_deck.findings.add(
                    {"deck.include_missing", "Files that the input deck includes are not there", {}},
                    {"deck.include_missing.remedy", "Copy them beside the deck if they hold densities or sections.", {}}, included);
            }
            m_keyword = {};
        } else if (m_keyword.name == "INSTANCE") {
            m_deck.hasInstances = true;
        } else if (m_keyword.name == "STEP") {
            ++m_step;
        } else if (m_keyword.name == "MATERIAL") {
            m_material = m_keyword.option("NAME");
        } else if (m_keyword.name.ends_with("SECTION") && m_keyword.has("ELSET")) {
            m_deck.sections.push_back({m_keyword.option("ELSET"), m_keyword.option("MATERIAL"), {}, {}, {}});
        } else if (m_keyword.name == "MODELCHANGE") {
            beginChange();
        }
    }

    // It changes elements unless it names another type. What neither adds nor removes, such as strains turned into residual
    // ones, leaves all elements where they are.
    void beginChange() {
        const bool ofElements = !m_keyword.has("TYPE") || m_keyword.option("TYPE") == "ELEMENT";
        m_inChange = ofElements && m_keyword.has("REMOVE") != m_keyword.has("ADD");
        if (m_inChange) {
            m_deck.changes.push_back({std::max(m_step, 1), m_keyword.has("REMOVE"), {}});
        }
    }

    void readData(const std::vector<std::string>& fields) {
        ++m_line;
        if (m_keyword.name == "ELEMENT") {
            readElement(fields);
        } else if (m_keyword.name == "ELSET") {
            readSet(fields);
        } else if (m_keyword.name == "DENSITY" && m_line == 1) {
            if (const auto density = realOf(fields.front()); density && !m_material.empty()) {
                m_deck.densities[m_material] = *density;
            }
        } else if (m_keyword.name == "SHELLSECTION" && m_keyword.has("ELSET")) {
            readShell(fields);
        } else if (m_keyword.name == "SOLIDSECTION" && m_line == 1 && m_keyword.has("ELSET")) {
            m_deck.sections.back().area = realOf(fields.front());  // of trusses
        } else if (m_keyword.name == "BEAMSECTION" && m_line == 1 && m_keyword.has("ELSET")) {
            readBeam(fields);
        } else if (m_inChange) {
            readChange(fields);
        }
    }

    // A line for each layer: thickness, points, material. Thicknesses that stand at the nodes are not read.
    void readShell(const std::vector<std::string>& fields) {
        DeckSection& section = m_deck.sections.back();
        const std::optional<double> thickness = realOf(fields.front());
        if (m_keyword.has("NODALTHICKNESS")) {
            return;
        }
        if (!m_keyword.has("COMPOSITE")) {
            if (m_line == 1) {
                section.thickness = thickness;
            }
        } else if (thickness) {
            section.thickness = section.thickness.value_or(0.0) + *thickness;
            section.layers.push_back({*thickness, fields.size() > 2 ? upperCase(fields[2]) : std::string()});
        }
    }

    // Continuation lines hold nodes alone: a line that follows one with a comma at its end.
    void readElement(const std::vector<std::string>& fields) {
        const bool continues = m_line > 1 && m_continued;
        m_continued = fields.back().empty();
        const std::string set = m_keyword.option("ELSET");
        const auto number = integerOf(fields.front());
        if (!continues && number && !set.empty()) {
            m_deck.elementSets[set].add(*number);
        }
    }

    void readSet(const std::vector<std::string>& fields) {
        NumberSet& set = m_deck.elementSets[m_keyword.option("ELSET")];
        if (m_keyword.has("GENERATE") && fields.size() >= 2) {
            const auto first = integerOf(fields[0]), last = integerOf(fields[1]);
            const auto step = fields.size() > 2 && !fields[2].empty() ? integerOf(fields[2]) : std::optional<std::int64_t>(1);
            if (first && last && step && *step > 0 && *last >= *first) {
                set.addRange(*first, *last, *step);
            }
            return;
        }
        addMembers(fields, set);
    }

    void addMembers(const std::vector<std::string>& fields, NumberSet& set) {
        for (const std::string& field : fields) {
            if (const auto number = integerOf(field)) {
                set.add(*number);
            } else if (const auto other = m_deck.elementSets.find(upperCase(field)); other != m_deck.elementSets.end()) {
                if (&other->second != &set) {
                    set.append(other->second);
                }
            }
        }
    }

    // The area of the sections that have one in closed form.
    void readBeam(const std::vector<std::string>& fields) {
        const std::string kind = m_keyword.option("SECTION");
        std::vector<double> values;
        for (const std::string& field : fields) {
            values.push_back(realOf(field).value_or(0.0));
        }
        values.resize(std::max<std::size_t>(values.size(), 2), 0.0);
        constexpr double pi = 3.14159265358979323846;
        std::optional<double>& area = m_deck.sections.back().area;
        if (kind == "RECT") {
            area = values[0] * values[1];
        } else if (kind == "CIRC") {
            area = pi * values[0] * values[0];
        } else if (kind == "PIPE") {
            area = pi * (2.0 * values[0] - values[1]) * values[1];
        } else if (kind == "GENERAL") {
            area = values[0];
        }
    }

    void readChange(const std::vector<std::string>& fields) {
        addMembers(fields, m_deck.changes.back().elements);
        for (const std::string& field : fields) {
            if (!field.empty() && !integerOf(field) && !m_deck.elementSets.contains(upperCase(field))) {
                m_deck.findings.add({"deck.change_unknown", "MODEL CHANGE names sets of elements that the deck does not have", {}},
                                    {"deck.change_unknown.remedy",
                                     "Their elements keep what they were: copy the files that the deck includes beside it.",
                                     {}},
                                    field);
            }
        }
    }

    InputDeck m_deck;
    Keyword m_keyword;
    std::string m_material;
    int m_step = 0;
    std::int64_t m_line = 0;  // of data, under the keyword
    bool m_continued = false;
    bool m_inChange = false;  // under a MODEL CHANGE that adds or removes elements
};

}  // namespace

void NumberSet::sort() {
    std::sort(m_single.begin(), m_single.end());
}

bool NumberSet::contains(std::int64_t number) const {
    return std::binary_search(m_single.begin(), m_single.end(), number) ||
           std::any_of(m_ranges.begin(), m_ranges.end(), [number](const Range& range) {
               return number >= range.first && number <= range.last && (number - range.first) % range.step == 0;
           });
}

void NumberSet::append(const NumberSet& other) {
    m_single.insert(m_single.end(), other.m_single.begin(), other.m_single.end());
    m_ranges.insert(m_ranges.end(), other.m_ranges.begin(), other.m_ranges.end());
}

const DeckSection* InputDeck::sectionOf(std::int64_t element) const {
    for (std::size_t s = sections.size(); s-- > 0;) {
        const auto set = elementSets.find(sections[s].set);
        if (set != elementSets.end() && set->second.contains(element)) {
            return &sections[s];
        }
    }
    return nullptr;
}

std::optional<double> InputDeck::densityOf(const DeckSection& section) const {
    const std::vector<DeckLayer> whole{{1.0, section.material}};
    double thickness = 0.0, mass = 0.0;
    for (const DeckLayer& layer : section.layers.empty() ? whole : section.layers) {
        const auto density = densities.find(layer.material);
        if (density == densities.end()) {
            return std::nullopt;
        }
        thickness += layer.thickness;
        mass += layer.thickness * density->second;
    }
    return thickness > 0.0 ? std::optional(mass / thickness) : std::nullopt;
}

InputDeck readInputDeck(const std::string& path) {
    return DeckReader(path).take();
}

std::string inputDeckBeside(const std::string& path) {
    std::error_code ignored;
    const std::string own = fs::path(path).replace_extension(".inp").string();
    if (fs::is_regular_file(own, ignored)) {
        return own;
    }
    std::vector<std::string> decks;
    for (const std::string& other : filesBeside(path)) {
        if (upperCase(fs::path(other).extension().string()) == ".INP") {
            decks.push_back(other);
        }
    }
    return decks.size() == 1 ? decks.front() : "";
}

}  // namespace rubble::io
