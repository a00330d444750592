#pragma once

#include <cstdint>
#include <map>
#include <optional>
#include <string>

#include "core/fe/units.h"

namespace rubble::io {

/// What the starter deck of a run says about a part, in the units of the deck; NaN where it does not say.
struct DeckPart {
    double density = 0.0;
    double thickness = 0.0;  ///< of shells
    double area = 0.0;       ///< of trusses
};

/// What a starter deck says.
struct StarterDeck {
    std::map<std::int64_t, DeckPart> parts;  ///< by the number of the part
    std::string mass, length, time;          ///< units as the deck names them: "Mg", "mm", "s"; empty where it does not
};

/// The units that a deck names; nothing if it names none or one that is not known.
std::optional<FileUnits> unitsOf(const StarterDeck& deck);

/// Reads units, parts, initial densities, thicknesses of shells and sections of trusses from a starter deck (NAME_0000.rad), empty
/// if there is no such file; what is not understood is left out.
StarterDeck readStarterDeck(const std::string& path);

}  // namespace rubble::io
