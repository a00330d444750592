#pragma once

#include <string>

#include "core/base/execution.h"
#include "core/fe/activity.h"
#include "io/fe/d3plot/d3plot_states.h"

namespace rubble::io {

struct D3plotActivity {
    Activity activity;  ///< elements in the order solids, thick shells, beams, shells, particles
    std::string from;   ///< for people
    Findings findings;
};

/// Reads which elements are active at which state, by the table of deletions that the family has, or by stress where it has none;
/// reads the table alone, never the rest of a state.
D3plotActivity readD3plotActivity(const D3plotFamily& family, const D3plotHeader& header, const D3plotGeometry& geometry,
                                  const D3plotStateLayout& layout, const D3plotStates& states, const Execution& execution);

}  // namespace rubble::io
