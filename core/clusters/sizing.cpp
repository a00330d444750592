#include "core/clusters/sizing.h"

#include <cassert>

#include "core/clusters/grid_sizer.h"

namespace rubble {

std::string_view clampedByName(ClampedBy by) {
    switch (by) {
        case ClampedBy::None:
            return "none";
        case ClampedBy::Spacing:
            return "spacing";
        case ClampedBy::FragmentSize:
            return "fragment_size";
        case ClampedBy::ComponentSize:
            return "component_size";
    }
    assert(false);
    return "";
}

std::string_view stoppedByName(StoppedBy by) {
    switch (by) {
        case StoppedBy::Efficiency:
            return "efficiency";
        case StoppedBy::FpsUnreachable:
            return "fps_unreachable";
        case StoppedBy::User:
            return "user";
    }
    assert(false);
    return "";
}

Sizing sizeBasicGrid(const FragmentSet& fragments, const Mesh& mesh, const Components& components, const GridSettings& settings,
                     const Execution& execution) {
    return GridSizer(fragments, mesh, components).size(settings, execution);
}

}  // namespace rubble
