#pragma once

#include <map>
#include <optional>
#include <span>
#include <string>
#include <vector>

#include "core/base/finding.h"
#include "core/base/geometry.h"
#include "core/base/ids.h"
#include "core/fe/material.h"
#include "core/fe/mesh.h"
#include "core/fe/regrouping.h"

namespace rubble {

/// What the user says about one component; unset means: from the file or the assumption.
struct ComponentSettings {
    std::optional<double> density;     ///< kg/m3
    std::optional<double> section;     ///< m (shells) or m2 (beams)
    std::optional<bool> structural;    ///< its size limits the Basic Grid (default yes)
    std::optional<Material> material;  ///< unset: guessed from its density
    bool reinforced = false;           ///< its neighbouring clusters are tied by steel
    friend bool operator==(const ComponentSettings&, const ComponentSettings&) = default;
};

/// What is assumed where neither the file nor the user knows; each use is counted.
struct MaterialAssumptions {
    double density = 2400.0;  ///< kg/m3
    double thickness = 0.2;   ///< m, shells
    double area = 0.01;       ///< m2, beams
    friend bool operator==(const MaterialAssumptions&, const MaterialAssumptions&) = default;
};

/// A structural component: one part of the file unless regrouped.
struct Component {
    std::string name;
    std::vector<ElementIndex> elements;  ///< ascending
    std::string kind;                    ///< "solid", "shell", "beam" or "mixed"
    bool structural = true;              ///< its size limits the Basic Grid
    double mass = 0.0;                   ///< kg, over all elements at rest
    double density = 0.0;                ///< kg/m3, mass over volume
    Material material = Material::Concrete;
    bool reinforced = false;
    Aabb bounds;  ///< m, at rest; shells with their thickness, beams with their section
};

/// The components of a scenario, with the material of every element settled.
struct Components {
    std::vector<Component> list;
    std::vector<ComponentId> of;  ///< component of each element [elements]
    std::vector<double> density;  ///< kg/m3 of each element, assumption applied [elements]
    std::vector<double> section;  ///< thickness m or area m2 of each element, assumption applied; 0 for solids [elements]
    std::vector<double> volume;   ///< m3 of each element at rest, never negative [elements]
    Findings findings;            ///< assumed densities and thicknesses, counted; steps that named unknown components

    double mass(ElementIndex e) const { return density[at(e)] * volume[at(e)]; }
};

/// Applies the regrouping steps to the parts of the file in order, then settles density and section of every element: the user's
/// word over the file over the assumption (counted). Throws UsageError if a step or a setting names a component that does not
/// exist.
Components groupComponents(const Mesh& mesh, const std::vector<RegroupStep>& regrouping,
                           const std::map<std::string, ComponentSettings>& settings, const MaterialAssumptions& assumptions);

/// Volume of an element at the given corner positions [m3]: solids by Gauss quadrature of det J (signed), shells area x section,
/// beams length x section.
double elementVolume(ElementShape shape, std::span<const Vec3> corners, double section);

}  // namespace rubble
