#pragma once

#include <map>
#include <string>
#include <utility>
#include <vector>

#include "core/base/finding.h"
#include "core/fe/mesh.h"
#include "io/fe/particles.h"
#include "io/fe/radioss/anim_file.h"
#include "io/fe/radioss/starter_deck.h"

namespace rubble::io {

/// The mesh of a run and where its elements stand in the files.
struct RadiossMesh {
    Mesh mesh;
    std::vector<std::pair<AnimKind, std::size_t>> places;  ///< [elements of the mesh]
    std::size_t fileNodes = 0;
    Particles particles;
    Findings findings;
};

/// Makes the mesh from the first state. Densities: the masses of elements over their volume at that state, part by part, else the
/// values of the element function "Density", else the deck. Sections: thickness from the file, from mass and density, or from the
/// deck. Parts are known by kind and place, since their numbers repeat.
RadiossMesh makeRadiossMesh(const std::string& path, const AnimState& first, const std::map<std::int64_t, DeckPart>& deck);

}  // namespace rubble::io
