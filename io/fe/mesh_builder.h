#pragma once

#include <cstdint>
#include <set>
#include <span>
#include <string>
#include <vector>

#include "core/base/finding.h"
#include "core/fe/mesh.h"

namespace rubble::io {

/// Builds a mesh from what a file says, element by element, and checks and mends it once all is known. Elements keep the order in
/// which they were added. Everything given is in units and axes of the file.
class MeshBuilder {
public:
    /// @param path  named in errors
    explicit MeshBuilder(std::string path);

    /// Nodes with their user's numbers, both [nodes]. Called once, before any element.
    void setNodes(std::vector<std::int64_t> ids, std::vector<Vec3> places);
    /// A part; gives its index. An empty name becomes "part ID"; a name met before gets the number added, counted.
    std::uint32_t addPart(std::string name, std::int64_t fileId);

    /// A solid of eight corners in the order of Exodus II and VTK; repeated corners make wedges, pyramids and tetrahedra.
    /// @param corners  0-based nodes, checked: ParseError if one does not exist
    void addSolid(std::int64_t id, std::uint32_t part, std::span<const std::int64_t> corners);
    /// A shell of four corners, of which one may be repeated. @param thickness  NaN where unknown
    void addShell(std::int64_t id, std::uint32_t part, std::span<const std::int64_t> corners, double thickness);
    /// @param area  of its section, NaN where unknown
    void addBeam(std::int64_t id, std::uint32_t part, std::span<const std::int64_t> corners, double area);
    /// An element of a shape that is known, its corners alone.
    void add(ElementShape shape, std::int64_t id, std::uint32_t part, std::span<const std::int64_t> corners, double section);
    /// Density of an element; see densityInSi() for its unit.
    void setDensity(std::size_t element, double density);
    /// Thickness or area of an element, where it becomes known later.
    void setSection(std::size_t element, double section);

    std::size_t elementCount() const { return m_mesh.shapes.size(); }
    std::size_t nodeCount() const { return m_mesh.nodes.size(); }
    ElementShape shape(std::size_t element) const { return m_mesh.shapes[element]; }
    std::uint32_t part(std::size_t element) const { return m_mesh.part[element]; }
    /// Thickness or area in the file's unit; NaN where unknown and for solids.
    double section(std::size_t element) const { return m_mesh.section[element]; }
    /// Places of an element's corners, in the file's unit.
    std::vector<Vec3> cornersOf(std::size_t element) const;

    /// Turns solids that are numbered inside out and counts them, and leaves out parts without
    /// elements. Throws ParseError for a mesh without elements and for elements at nodes without a finite place.
    Mesh finish(Findings& findings);

private:
    void requirePlaces(Findings& findings);
    void turnReversed(Findings& findings);
    void dropEmptyParts();

    std::string m_path;
    Mesh m_mesh;
    std::set<std::string> m_names;
    Findings m_findings;
    bool m_places = false;
};

/// True for a length [file unit] that can be a place or a displacement: finite and below 1e9.
bool usableLength(double value);
inline bool usablePlace(const Vec3& value) {
    return usableLength(value.x()) && usableLength(value.y()) && usableLength(value.z());
}

/// A density of a file whose unit of mass nobody says, in kg/m3: as it stands where that is a building material or the lengths are
/// metres, else with the unit of mass (kg, t, g) that gives 1 to 25,000 kg/m3; counted.
/// @param value  mass per cubed length unit of the file  @param part  named in the finding
double densityInSi(double value, double metresPerUnit, Findings& findings, const std::string& part);

}  // namespace rubble::io
