#include "io/base/length_unit.h"

#include <algorithm>
#include <array>
#include <string>
#include <vector>

#include "core/base/small_letters.h"

namespace rubble::io {

std::optional<double> metresInUnit(std::string_view name) {
    struct Unit {
        double metres;
        std::vector<std::string_view> names;
    };
    static const std::array<Unit, 6> units{{
        {1.0, {"m", "metre", "metres", "meter", "meters"}},
        {0.3048, {"ft", "foot", "feet", "ift", "ftint", "internationalfoot", "internationalfeet"}},
        {1200.0 / 3937.0,
         {"ftus", "usft", "sft", "footus", "usfoot", "usfeet", "ussft", "surveyfoot", "surveyfeet", "ussurveyfoot",
          "ussurveyfeet"}},
        {0.01, {"cm", "centimetre", "centimetres", "centimeter", "centimeters"}},
        {0.001, {"mm", "millimetre", "millimetres", "millimeter", "millimeters"}},
        {1000.0, {"km", "kilometre", "kilometres", "kilometer", "kilometers"}},
    }};
    std::string plain = inSmallLetters(name);
    std::erase_if(plain, [](char c) { return c == ' ' || c == '_' || c == '-' || c == '.'; });
    for (const Unit& unit : units) {
        if (std::find(unit.names.begin(), unit.names.end(), plain) != unit.names.end()) {
            return unit.metres;
        }
    }
    return std::nullopt;
}

}  // namespace rubble::io
