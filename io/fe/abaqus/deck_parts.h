#pragma once

#include <cstdint>
#include <string>
#include <vector>

#include "core/base/finding.h"
#include "core/fe/mesh.h"
#include "io/fe/abaqus/input_deck.h"

namespace rubble::io {

/// A set of elements as a result file has it.
struct NamedSet {
    std::string name;
    std::vector<std::int64_t> members;
};

/// Gives the elements of a mesh in file units their parts, densities and sections: by the sections of the deck where there is one,
/// else by the sets of the result, of which an element belongs to the smallest that holds it; what is in none goes by its shape.
/// @param deck  nullptr if there is none  @param mesh  with elementIds and shapes; parts are made anew
void assignParts(const InputDeck* deck, const std::vector<NamedSet>& sets, Mesh& mesh, Findings& findings);

}  // namespace rubble::io
