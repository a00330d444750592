#include "core/fe/units.h"

#include <array>
#include <cmath>

#include "core/base/standard_gravity.h"

namespace rubble {

namespace {

// International avoirdupois pound and inch; standard gravity.
constexpr double inch = 0.0254;
constexpr double foot = 0.3048;
constexpr double poundForce = 0.45359237 * standardGravity;  // N

constexpr std::array systems{
    UnitSystem{"kg-m-s", "kilograms, metres, seconds (stress in Pa)", {1.0, 1.0, 1.0}},
    UnitSystem{"t-mm-s", "tonnes, millimetres, seconds (stress in MPa)", {1e-3, 1e3, 1.0}},
    UnitSystem{"kg-mm-ms", "kilograms, millimetres, milliseconds (stress in GPa)", {1e-3, 1.0, 1e-3}},
    UnitSystem{"g-mm-ms", "grams, millimetres, milliseconds (stress in MPa)", {1e-3, 1e-3, 1e-3}},
    UnitSystem{"t-m-s", "tonnes, metres, seconds (stress in kPa)", {1.0, 1e3, 1.0}},
    UnitSystem{"kg-mm-s", "kilograms, millimetres, seconds (stress in kPa)", {1e-3, 1.0, 1.0}},
    UnitSystem{"g-mm-s", "grams, millimetres, seconds (stress in Pa)", {1e-3, 1e-3, 1.0}},
    UnitSystem{"g-cm-us", "grams, centimetres, microseconds (stress in Mbar)", {1e-2, 1e-3, 1e-6}},
    UnitSystem{"g-cm-s", "grams, centimetres, seconds (stress in dyn/cm2)", {1e-2, 1e-3, 1.0}},
    UnitSystem{"lbf-in-s", "lbf s2/in, inches, seconds (stress in psi)", {inch, poundForce / inch, 1.0}},
    UnitSystem{"kip-in-s", "kip s2/in, inches, seconds (stress in ksi)", {inch, 1000.0 * poundForce / inch, 1.0}},
    UnitSystem{"lbf-ft-s", "slugs, feet, seconds (stress in psf)", {foot, poundForce / foot, 1.0}},
};

constexpr std::array<std::string_view, 8> upAxes{"frame", "auto", "x", "y", "z", "-x", "-y", "-z"};

bool alike(double a, double b) {
    return std::abs(a / b - 1.0) < 1e-6;
}

}  // namespace

std::span<const UnitSystem> unitSystems() {
    return systems;
}

const UnitSystem* systemOf(const FileUnits& units) {
    for (const UnitSystem& system : systems) {
        if (alike(units.metres, system.units.metres) && alike(units.kilograms, system.units.kilograms) &&
            alike(units.seconds, system.units.seconds)) {
            return &system;
        }
    }
    return nullptr;
}

std::vector<std::string_view> unitChoices() {
    std::vector<std::string_view> choices{"frame", "auto"};
    for (const UnitSystem& system : systems) {
        choices.push_back(system.id);
    }
    return choices;
}

std::vector<std::string_view> upAxisChoices() {
    return {upAxes.begin(), upAxes.end()};
}

}  // namespace rubble
