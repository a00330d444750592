#include "io/base/drawing_unit.h"

#include <algorithm>
#include <array>
#include <charconv>
#include <fstream>
#include <optional>
#include <system_error>
#include <utility>

#include "io/base/file_words.h"

namespace rubble::io {

namespace {

constexpr double foot = 0.3048;
constexpr double surveyFoot = 1200.0 / 3937.0;

/// Metres of the units that sites are drawn in, by their number (AutoCAD DXF Reference, section HEADER, $INSUNITS).
constexpr std::array<std::pair<int, double>, 14> units{{{1, foot / 12.0},
                                                        {2, foot},
                                                        {3, 5280.0 * foot},
                                                        {4, 1e-3},
                                                        {5, 1e-2},
                                                        {6, 1.0},
                                                        {7, 1e3},
                                                        {10, 3.0 * foot},
                                                        {14, 0.1},
                                                        {15, 10.0},
                                                        {16, 100.0},
                                                        {21, surveyFoot},
                                                        {22, surveyFoot / 12.0},
                                                        {23, 3.0 * surveyFoot}}};

std::string withoutSpace(const std::string& line) {
    const std::size_t from = line.find_first_not_of(" \t\r");
    return from == std::string::npos ? std::string() : line.substr(from, line.find_last_not_of(" \t\r") - from + 1);
}

/// The number of $INSUNITS in the header; unset: there is none.
std::optional<int> unitNumber(const std::string& path) {
    std::ifstream in(path, std::ios::binary);
    std::string line;
    bool meant = false;
    constexpr int mostLines = 20'000;  // of a header
    for (int k = 0; k < mostLines && std::getline(in, line); ++k) {
        const std::string word = withoutSpace(line);
        if (word == "ENDSEC") {
            return std::nullopt;
        }
        if (meant && word != "70") {
            int number = 0;
            const auto [end, failure] = std::from_chars(word.data(), word.data() + word.size(), number);
            return failure == std::errc() && end == word.data() + word.size() ? std::optional(number) : std::nullopt;
        }
        meant = meant || word == "$INSUNITS";
    }
    return std::nullopt;
}

}  // namespace

double drawingUnit(const std::string& path, Findings& findings) {
    const std::optional<int> number = unitNumber(path);
    const auto unit = std::find_if(units.begin(), units.end(), [&](const auto& each) { return each.first == number; });
    if (unit == units.end()) {
        addFinding(findings, path,
                   {"drawing.unit_unsaid", "the drawing does not say its unit; its coordinates are taken as metres", {}},
                   "set the unit of the drawing ($INSUNITS) if it is another one");
        return 1.0;
    }
    if (unit->second != 1.0) {
        addFinding(findings, path,
                   {"drawing.unit",
                    "the drawing says that it counts in units of {0}, from which its coordinates were brought to metres",
                    {{unit->second, "m"}}},
                   "set the unit of the drawing ($INSUNITS) to metres if its numbers are metres");
    }
    return unit->second;
}

}  // namespace rubble::io
