#pragma once

#include <cstdint>
#include <map>
#include <string>

namespace rubble::io {

/// What the starter deck of a run says about a part, in the units of the deck; NaN where it does not say.
struct DeckPart {
    double density = 0.0;
    double thickness = 0.0;  ///< of shells
    double area = 0.0;       ///< of trusses
};

/// Reads parts, initial densities, thicknesses of shells and sections of trusses from a starter deck (NAME_0000.rad), by the number
/// of the part. Empty if there is no such file; what is not understood is left out.
std::map<std::int64_t, DeckPart> readStarterDeck(const std::string& path);

}  // namespace rubble::io
