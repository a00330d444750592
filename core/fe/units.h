#pragma once

#include <span>
#include <string>
#include <string_view>
#include <vector>

namespace rubble {

/// What one unit of a file is in SI. Forces, pressures and energies of a consistent system follow from these three.
struct FileUnits {
    double metres = 1.0;
    double kilograms = 1.0;  ///< 0: judged by the densities alone
    double seconds = 1.0;

    /// kg/m3 in one unit of density.
    double density() const { return kilograms / (metres * metres * metres); }
    /// m/s2 in one unit of acceleration.
    double acceleration() const { return metres / (seconds * seconds); }
    friend bool operator==(const FileUnits&, const FileUnits&) = default;
};

/// A consistent system that analyses are made in.
struct UnitSystem {
    std::string_view id;     ///< "t-mm-s": mass, length, time
    std::string_view words;  ///< "tonnes, millimetres, seconds (stress in MPa)"
    FileUnits units;
};

/// All systems that are known, the most usual first.
std::span<const UnitSystem> unitSystems();

/// The system with these units, to a millionth; nullptr if it is none of the known.
const UnitSystem* systemOf(const FileUnits& units);

/// "frame", "auto", then the ids of all systems: what the setting `units` can be.
std::vector<std::string_view> unitChoices();
/// "frame", "auto", "x", "y", "z", "-x", "-y", "-z": what the setting `up_axis` can be.
std::vector<std::string_view> upAxisChoices();

/// Who decides: the frame of the case, what the file fits, or the user by name.
enum class Decided : std::size_t { ByFrame, ByEvidence, ByName };

/// How a choice of unitChoices() or upAxisChoices() is decided.
constexpr Decided decidedBy(std::size_t choice) {
    return choice < 2 ? static_cast<Decided>(choice) : Decided::ByName;
}

}  // namespace rubble
