#include "io/fe/exodus/exodus_material.h"

#include <algorithm>

#include "io/fe/exodus/exodus_names.h"

namespace rubble::io {

namespace {

/// Where a property of one part comes from.
std::vector<double> fromFile(const ExodusFile& file, std::size_t block, const std::vector<std::string_view>& attributes,
                             const std::vector<std::string_view>& variables) {
    const int attribute = findAny(file.blocks()[block].attributes, attributes);
    if (attribute >= 0) {
        return file.attribute(block, static_cast<std::size_t>(attribute));
    }
    const int variable = findAny(file.variables(ExodusEntity::Element), variables);
    std::vector<double> values;
    if (variable >= 0 && !file.times().empty() && file.has(block, variable)) {
        values.resize(static_cast<std::size_t>(file.blocks()[block].elements));
        file.readElement(0, variable, block, values);
    }
    return values;
}

// The format's convention: the first attribute of shells is their thickness, that of bars and beams their area.
std::vector<double> byConvention(const ExodusFile& file, std::size_t block, const std::string& part, Findings& findings) {
    const std::vector<std::string>& names = file.blocks()[block].attributes;
    const bool unnamed = !names.empty() && std::all_of(names.begin(), names.end(), [](const auto& name) { return name.empty(); });
    if (!unnamed) {
        return {};
    }
    findings.add(
        {"exodus.unnamed_attribute", "Blocks without attribute names: their first attribute was taken for thickness or area", {}},
        {"exodus.unnamed_attribute.remedy", "Check it, or set component[NAME].section.", {}}, part);
    return file.attribute(block, 0);
}

}  // namespace

void readExodusMaterial(const ExodusFile& file, std::size_t block, ElementShape shape, const std::string& part, std::size_t first,
                        MeshBuilder& builder, Findings& findings) {
    const std::vector<double> density =
        fromFile(file, block, {"density", "rho", "mass_density"}, {"density", "rho", "mass_density"});
    for (std::size_t e = 0; e < density.size(); ++e) {
        builder.setDensity(first + e, density[e]);
    }
    if (isSolid(shape)) {
        return;
    }
    std::vector<double> section =
        isShell(shape) ? fromFile(file, block, {"thickness", "shell_thickness", "thick"}, {"thickness", "shell_thickness", "thick"})
                       : fromFile(file, block, {"area", "cross_section", "section_area"}, {"area"});
    if (section.empty()) {
        section = byConvention(file, block, part, findings);
    }
    for (std::size_t e = 0; e < section.size(); ++e) {
        builder.setSection(first + e, section[e]);
    }
}

}  // namespace rubble::io
