#pragma once

#include <string_view>
#include <vector>

#include "core/fe/components.h"

namespace rubble::cli {

/// Who says what a component is made of.
struct ComponentOrigin {
    std::string_view density;   ///< stable: "settings", "file", "assumed", "mixed" (file and assumption)
    std::string_view material;  ///< stable: "settings", "density" (guessed from it)
};

/// Of every component, in their order.
std::vector<ComponentOrigin> originsOf(const Components& components, const Mesh& mesh,
                                       const std::map<std::string, ComponentSettings>& settings);

}  // namespace rubble::cli
