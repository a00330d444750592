#pragma once

#include <map>
#include <memory>
#include <string>
#include <vector>

#include "core/base/convex_body.h"
#include "core/base/finding.h"

namespace rubble::io {

/// Triangles that the mesh of one body may have.
inline constexpr std::size_t bodyTrianglesMax = 200'000;

/// Shapes of bodies by the meshes that a table names. Each mesh is read once.
class BodyMeshes {
public:
    /// @param table  path of the table; its folder is where names of meshes begin
    explicit BodyMeshes(std::string table) : m_table(std::move(table)) {}

    /// The hull of a mesh (STL, OBJ, PLY, in metres) about its centre of mass. A mesh that is not convex or not closed, and corners
    /// that were left out, are findings. Throws ParseError naming table, line and mesh: no such file or none of these formats, too
    /// many triangles, flat; and as readTriangleMesh().
    std::shared_ptr<const ConvexBody> shape(const std::string& name, std::size_t line);
    /// What was found in all meshes so far.
    const Findings& findings() const { return m_findings; }

private:
    std::string m_table;
    std::map<std::string, std::shared_ptr<const ConvexBody>> m_shapes;
    Findings m_findings;
};

/// Where a mesh lies that a table names.
std::string bodyMeshPath(const std::string& table, const std::string& name);

/// A table and the meshes that it names as far as they are there, in the order of their paths. Does not throw.
std::vector<std::string> filesOfBodies(const std::string& table);

}  // namespace rubble::io
