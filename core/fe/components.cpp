#include "core/fe/components.h"

#include <algorithm>
#include <cassert>
#include <cmath>

#include "core/base/error.h"
#include "core/fe/material.h"

namespace rubble {

namespace {

bool usable(double value) {
    return std::isfinite(value) && value > 0.0;
}

std::string place(const Mesh& mesh, std::size_t e, const std::string& component) {
    return "element " + englishInteger(mesh.elementIds[e]) + " (" + component + ")";
}

std::vector<Vec3> cornersAtRest(const Mesh& mesh, ElementIndex e) {
    std::vector<Vec3> corners;
    for (const std::uint32_t node : mesh.cornersOf(e)) {
        corners.push_back(mesh.nodes[node]);
    }
    return corners;
}

std::string kindOf(const Mesh& mesh, const std::vector<ElementIndex>& elements) {
    bool solid = false, shell = false, beam = false;
    for (const ElementIndex e : elements) {
        const ElementShape shape = mesh.shapes[at(e)];
        solid |= isSolid(shape);
        shell |= isShell(shape);
        beam |= shape == ElementShape::Beam;
    }
    if (solid + shell + beam > 1) {
        return "mixed";
    }
    return beam ? "beam" : shell ? "shell" : "solid";
}

// Half the extent that thickness or section adds along each axis.
Vec3 addedHalfExtent(ElementShape shape, const std::vector<Vec3>& x, double section) {
    if (shape == ElementShape::Beam) {
        const Vec3 axis = (x[1] - x[0]).stableNormalized();
        return 0.5 * std::sqrt(section) * (Vec3::Ones() - axis.cwiseProduct(axis)).cwiseMax(0.0).cwiseSqrt();
    }
    if (!isShell(shape)) {
        return Vec3::Zero();
    }
    const Vec3 across = shape == ElementShape::Quadrilateral ? (x[2] - x[0]).cross(x[3] - x[1]) : (x[1] - x[0]).cross(x[2] - x[0]);
    return 0.5 * section * across.stableNormalized().cwiseAbs();
}

/// Settles the material of single elements: the user's word over the file over the assumption.
class ElementMaterial {
public:
    ElementMaterial(const Mesh& mesh, const MaterialAssumptions& assumptions, Findings& findings)
        : m_mesh(mesh), m_assumptions(assumptions), m_findings(findings) {}

    double density(std::size_t e, const std::string& component, const ComponentSettings& settings) {
        const double inFile = m_mesh.density[e];
        const double value = settings.density.value_or(usable(inFile) ? inFile : m_assumptions.density);
        if (!settings.density && !usable(inFile)) {
            m_findings.add(
                {"components.assumed_density", "No density is known: {0} is assumed", {{m_assumptions.density, "kg/m3"}}},
                {"components.assumed_density.remedy", "Set component[NAME].density.", {}}, place(m_mesh, e, component));
        } else if (!isMaterialDensity(value)) {
            m_findings.add({"components.implausible_density",
                            "No material has this density: they have {0} to {1}",
                            {{leastMaterialDensity, "kg/m3"}, {greatestMaterialDensity, "kg/m3"}}},
                           {"components.implausible_density.remedy",
                            "Check the units of the file and set component[NAME].density in kg/m3.",
                            {}},
                           place(m_mesh, e, component) + ": " + englishNumber(value) + " kg/m3");
        }
        return value;
    }

    double section(std::size_t e, const std::string& component, const ComponentSettings& settings) {
        const ElementShape shape = m_mesh.shapes[e];
        if (isSolid(shape)) {
            return 0.0;
        }
        if (settings.section) {
            return *settings.section;
        }
        if (usable(m_mesh.section[e])) {
            return m_mesh.section[e];
        }
        const Message remedy{"components.assumed_section.remedy", "Set component[NAME].section.", {}};
        if (isShell(shape)) {
            m_findings.add(
                {"components.assumed_thickness", "No thickness is known: {0} is assumed", {{m_assumptions.thickness, "m"}}}, remedy,
                place(m_mesh, e, component));
            return m_assumptions.thickness;
        }
        m_findings.add({"components.assumed_area", "No section is known: {0} is assumed", {{m_assumptions.area, "m2"}}}, remedy,
                       place(m_mesh, e, component));
        return m_assumptions.area;
    }

private:
    const Mesh& m_mesh;
    const MaterialAssumptions& m_assumptions;
    Findings& m_findings;
};

void requireKnownNames(const std::vector<ElementGroup>& groups, const std::map<std::string, ComponentSettings>& settings) {
    std::vector<std::string> names;
    for (const ElementGroup& group : groups) {
        names.push_back(group.name);
    }
    for (const auto& [name, unused] : settings) {
        if (std::find(names.begin(), names.end(), name) == names.end()) {
            throwUnknownComponent(name, names);
        }
    }
}

}  // namespace

Components groupComponents(const Mesh& mesh, const std::vector<RegroupStep>& regrouping,
                           const std::map<std::string, ComponentSettings>& settings, const MaterialAssumptions& assumptions) {
    Components result;
    std::vector<ElementGroup> groups = regroup(mesh, regrouping, result.findings);
    requireKnownNames(groups, settings);

    result.of.resize(mesh.elementCount());
    result.density.resize(mesh.elementCount());
    result.section.resize(mesh.elementCount());
    result.volume.resize(mesh.elementCount());
    ElementMaterial material(mesh, assumptions, result.findings);
    for (ElementGroup& group : groups) {
        const auto found = settings.find(group.name);
        const ComponentSettings own = found == settings.end() ? ComponentSettings{} : found->second;
        Component component;
        component.structural = own.structural.value_or(true);
        component.kind = kindOf(mesh, group.elements);
        double volume = 0.0;
        for (const ElementIndex id : group.elements) {
            const std::size_t e = at(id);
            const std::vector<Vec3> corners = cornersAtRest(mesh, id);
            result.of[e] = idAt<ComponentId>(result.list.size());
            result.density[e] = material.density(e, group.name, own);
            result.section[e] = material.section(e, group.name, own);
            result.volume[e] = std::abs(elementVolume(mesh.shapes[e], corners, result.section[e]));
            volume += result.volume[e];
            component.mass += result.mass(id);
            const Vec3 added = addedHalfExtent(mesh.shapes[e], corners, result.section[e]);
            for (const Vec3& corner : corners) {
                component.bounds.extend(corner - added);
                component.bounds.extend(corner + added);
            }
        }
        component.density = volume > 0.0 ? component.mass / volume : result.density[at(group.elements.front())];
        component.material = own.material.value_or(materialOfDensity(component.density));
        component.reinforced = own.reinforced;
        component.name = std::move(group.name);
        component.elements = std::move(group.elements);
        result.list.push_back(std::move(component));
    }
    return result;
}

}  // namespace rubble
