#pragma once

#include <cstdint>
#include <map>
#include <optional>
#include <string>
#include <vector>

#include "core/base/finding.h"

namespace rubble::io {

/// Numbers of a set, as single ones and as ranges first, last, step.
class NumberSet {
public:
    void add(std::int64_t number) { m_single.push_back(number); }
    void addRange(std::int64_t first, std::int64_t last, std::int64_t step) { m_ranges.push_back({first, last, step}); }
    /// To be called after the last add().
    void sort();
    bool contains(std::int64_t number) const;
    bool empty() const { return m_single.empty() && m_ranges.empty(); }
    void append(const NumberSet& other);

private:
    struct Range {
        std::int64_t first, last, step;
    };
    std::vector<std::int64_t> m_single;
    std::vector<Range> m_ranges;
};

/// A layer of a composite shell.
struct DeckLayer {
    double thickness = 0.0;
    std::string material;  ///< upper case
};

/// A section of an input deck: which elements are of which material, and how thick.
struct DeckSection {
    std::string set;       ///< upper case
    std::string material;  ///< upper case; empty where it has layers
    std::optional<double> thickness;
    std::optional<double> area;
    std::vector<DeckLayer> layers;  ///< empty: one material all through
};

/// Elements that a step takes out or puts back.
struct DeckChange {
    int step = 1;  ///< from 1
    bool remove = true;
    NumberSet elements;
};

/// What a result file leaves out and the input deck of Abaqus or CalculiX (.inp) has. Names are upper case; lengths in the deck's
/// unit.
struct InputDeck {
    std::string path;
    std::map<std::string, NumberSet> elementSets;
    std::vector<DeckSection> sections;
    std::map<std::string, double> densities;  ///< of materials
    std::vector<DeckChange> changes;
    bool hasInstances = false;  ///< numbers are those of parts, not those of a result
    Findings findings;

    /// The section of an element by number, nullptr if none has it; of several the last counts.
    const DeckSection* sectionOf(std::int64_t element) const;
    /// Density of a section's material, of layers the mean over the thickness; nothing where one is unknown.
    std::optional<double> densityOf(const DeckSection& section) const;
};

/// Reads a deck with what it includes. Throws WorldError, ParseError (line) for what cannot be one.
InputDeck readInputDeck(const std::string& path);

/// The deck of a result: the file of the same name, else the only .inp in its folder; empty if there is none. Never throws.
std::string inputDeckBeside(const std::string& path);

}  // namespace rubble::io
