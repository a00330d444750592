#include "core/fragments/element_place.h"

#include "core/base/message.h"

namespace rubble {

std::string elementPlace(const Mesh& mesh, const Components& components, ElementIndex element, std::size_t state) {
    const std::string& component = components.list[at(components.of[at(element)])].name;
    return "element " + englishInteger(mesh.elementIds[at(element)]) + " (" + component + ") at state " +
           englishInteger(static_cast<std::int64_t>(state));
}

}  // namespace rubble
