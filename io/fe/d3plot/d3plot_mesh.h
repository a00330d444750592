#pragma once

#include <map>
#include <vector>

#include "core/fe/mesh.h"
#include "io/fe/d3plot/d3plot_activity.h"
#include "io/fe/d3plot/keyword_deck.h"
#include "io/fe/particles.h"

namespace rubble::io {

struct D3plotMesh {
    Mesh mesh;  ///< elements in the order of D3plotActivity; corners of particles stand behind the nodes of the file
    Particles particles;
    Findings findings;
};

/// Makes the mesh. Density is the mass of a part at the first state over the volume of its active elements at rest, where the
/// family has both; volumes of solids by one point, as the solver's own, so that the density is that of its input. Thickness of
/// shells comes from the first state. Sections of beams are not in the file; the deck has them, and what else the family lacks.
D3plotMesh makeD3plotMesh(const D3plotFamily& family, const D3plotHeader& header, const D3plotGeometry& geometry,
                          const D3plotStateLayout& layout, const D3plotStates& states, const Activity& activity,
                          const std::map<std::int64_t, KeywordPart>& deck);

/// Masses of the parts at a state, in the file's unit; empty if the globals do not hold them.
std::vector<double> d3plotPartMasses(const D3plotFamily& family, const D3plotHeader& header, std::int64_t stateBegin);

}  // namespace rubble::io
