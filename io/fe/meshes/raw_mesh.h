#pragma once

#include <array>
#include <cstdint>
#include <limits>
#include <optional>
#include <span>
#include <string>
#include <vector>

#include "core/base/execution.h"
#include "core/base/finding.h"
#include "core/base/geometry.h"

namespace rubble::io {

/// Triangles that a mesh may have, and points, so that a file of gigabytes takes no more memory than there is.
inline constexpr std::size_t meshTrianglesMax = 5'000'000;
inline constexpr std::size_t meshPointsMax = 15'000'000;

/// A mesh in the coordinates of its file, z up.
struct RawMesh {
    std::vector<Vec3> points;
    std::vector<std::array<std::uint32_t, 3>> triangles;  ///< of points
    /// Distance of neighbouring numbers that the file can tell apart, at its largest coordinate; 0: it keeps enough digits.
    double step = 0.0;
    Findings findings;  ///< what of the file was left out
};

/// Gathers the points and faces of a file, in any order, and makes a mesh of them.
class MeshGathering {
public:
    /// An index of a point that is none.
    static constexpr std::uint32_t noPoint = std::numeric_limits<std::uint32_t>::max();

    /// @param path  named in errors; must outlive this object
    explicit MeshGathering(const std::string& path) : m_path(path) {}

    /// Throws ParseError for a coordinate that is no number, naming line or point, and for too many points.
    /// @param line  of a text; 0: there are no lines, and the number of the point is named
    void addPoint(const Vec3& point, std::uint64_t line = 0);
    std::size_t points() const { return m_mesh.points.size(); }
    /// A face with its corners in order around. One with fewer than three is left out as points and lines are.
    /// Throws ParseError if there are too many faces or corners.
    /// @param corners  counted from 0; of points that may come later in the file; below zero: there is no such point
    void addFace(std::span<const std::int64_t> corners, std::uint64_t line = 0);
    /// Shapes that are no surface: points and lines.
    void leaveOut(std::int64_t count) { m_others += count; }
    /// Curved shapes of a text, which are no polygons.
    void leaveOutCurved() { ++m_curved; }
    /// The file tells coordinates apart no finer than this.
    void noteStep(double step) { m_mesh.step = std::max(m_mesh.step, step); }

    /// The mesh, its polygons cut into triangles. Faces that name points which are not there, that cross themselves, and shapes
    /// that are left out are counted findings. Throws ParseError if there is no face, Cancelled.
    RawMesh finish(const Execution& execution) &&;

private:
    void find(Message what, std::string_view remedy, std::int64_t count);
    void cut(const Execution& execution);

    struct Face {
        std::uint32_t end;  ///< of its corners
        std::uint32_t line;
    };
    const std::string& m_path;
    RawMesh m_mesh;
    std::vector<std::uint32_t> m_corners;
    std::vector<Face> m_faces;
    std::size_t m_triangles = 0;  ///< that the faces make
    std::int64_t m_others = 0;
    std::int64_t m_curved = 0;
};

/// Step of the last digit of a number as it stands in a text with an exponent; 0 for one without, which is taken as exact.
double stepOfText(std::string_view text, double value);
/// Step of a number in single precision.
double stepOfFloat(double value);

}  // namespace rubble::io
