#include "app/cli/fe/component_origin.h"

#include <algorithm>

namespace rubble::cli {

namespace {

std::string_view densityOrigin(const Component& component, const Mesh& mesh) {
    const auto inFile = [&](ElementIndex e) { return mesh.density[at(e)] > 0.0; };
    const auto known = std::count_if(component.elements.begin(), component.elements.end(), inFile);
    if (known == 0) {
        return "assumed";
    }
    return static_cast<std::size_t>(known) == component.elements.size() ? "file" : "mixed";
}

}  // namespace

std::vector<ComponentOrigin> originsOf(const Components& components, const Mesh& mesh,
                                       const std::map<std::string, ComponentSettings>& settings) {
    std::vector<ComponentOrigin> origins;
    for (const Component& component : components.list) {
        const auto own = settings.find(component.name);
        const bool said = own != settings.end();
        origins.push_back({said && own->second.density ? "settings" : densityOrigin(component, mesh),
                           said && own->second.material ? "settings" : "density"});
    }
    return origins;
}

}  // namespace rubble::cli
