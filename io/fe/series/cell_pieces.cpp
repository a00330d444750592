#include <algorithm>
#include <array>
#include <cmath>
#include <set>

#include "core/fe/components.h"
#include "io/fe/series/cell_shapes.h"

namespace rubble::io {

namespace {

constexpr int polyline = 4, strip = 6, polygon = 7, pentagonalPrism = 15, hexagonalPrism = 16, convexPointSet = 41, polyhedron = 42;
// Single precision resolves a cell of a tenth of a metre 100 m from the origin to this share of it.
constexpr double flatness = 1e-4;

using Polygon = std::vector<std::uint32_t>;

// Quadrilaterals and at most one triangle, all from the first corner.
std::vector<Polygon> cutPolygon(const Polygon& corners) {
    std::vector<Polygon> parts;
    std::size_t at = 1;
    for (; at + 2 < corners.size(); at += 2) {
        parts.push_back({corners[0], corners[at], corners[at + 1], corners[at + 2]});
    }
    if (at + 1 < corners.size()) {
        parts.push_back({corners[0], corners[at], corners[at + 1]});
    }
    return parts;
}

Polygon countedUp(std::size_t first, std::size_t count) {
    Polygon corners;
    for (std::size_t i = 0; i < count; ++i) {
        corners.push_back(static_cast<std::uint32_t>(first + i));
    }
    return corners;
}

std::vector<CellPiece> shellsOf(const Polygon& corners) {
    std::vector<CellPiece> pieces;
    for (Polygon& part : cutPolygon(corners)) {
        pieces.push_back({part.size() == 4 ? ElementShape::Quadrilateral : ElementShape::Triangle, std::move(part)});
    }
    return pieces;
}

// The base stands first, then the same corners of the top.
std::vector<CellPiece> prismOf(std::size_t sides) {
    std::vector<CellPiece> pieces;
    for (Polygon& part : cutPolygon(countedUp(0, sides))) {
        const std::size_t corners = part.size();
        for (std::size_t c = 0; c < corners; ++c) {
            part.push_back(part[c] + static_cast<std::uint32_t>(sides));
        }
        pieces.push_back({corners == 4 ? ElementShape::Hexahedron : ElementShape::Wedge, std::move(part)});
    }
    return pieces;
}

/// The convex body of a few points: its faces as polygons, seen from outside.
class ConvexBody {
public:
    explicit ConvexBody(std::span<const Vec3> points) : m_points(points) {
        Aabb bounds;
        for (const Vec3& point : points) {
            bounds.extend(point);
        }
        m_tolerance = flatness * (bounds.isEmpty() ? 0.0 : bounds.diagonal().norm());
        for (std::uint32_t i = 0; i < points.size(); ++i) {
            for (std::uint32_t j = i + 1; j < points.size(); ++j) {
                for (std::uint32_t k = j + 1; k < points.size(); ++k) {
                    tryPlane(i, j, k);
                }
            }
        }
    }

    const std::vector<Polygon>& faces() const { return m_faces; }

private:
    void tryPlane(std::uint32_t i, std::uint32_t j, std::uint32_t k) {
        Vec3 normal = (m_points[j] - m_points[i]).cross(m_points[k] - m_points[i]);
        if (!(normal.norm() > m_tolerance * m_tolerance)) {
            return;
        }
        normal.normalize();
        Polygon flat;
        bool above = false, below = false;
        for (std::uint32_t p = 0; p < m_points.size(); ++p) {
            const double height = normal.dot(m_points[p] - m_points[i]);
            above = above || height > m_tolerance;
            below = below || height < -m_tolerance;
            if (std::abs(height) <= m_tolerance) {
                flat.push_back(p);
            }
        }
        if (above != below) {
            addFace(flat, above ? Vec3(-normal) : normal);
        }
    }

    // Of nearly flat faces the one with most points counts.
    void addFace(const Polygon& flat, const Vec3& normal) {
        for (std::size_t f = m_planes.size(); f-- > 0;) {
            if (std::includes(m_planes[f].begin(), m_planes[f].end(), flat.begin(), flat.end())) {
                return;
            }
            if (std::includes(flat.begin(), flat.end(), m_planes[f].begin(), m_planes[f].end())) {
                m_planes.erase(m_planes.begin() + static_cast<std::ptrdiff_t>(f));
                m_faces.erase(m_faces.begin() + static_cast<std::ptrdiff_t>(f));
            }
        }
        m_planes.push_back(flat);
        m_faces.push_back(around(flat, normal));
    }

    // The corners of a flat set of points, counter-clockwise about the normal.
    Polygon around(Polygon flat, const Vec3& normal) const {
        const Vec3 u = normal.unitOrthogonal(), v = normal.cross(u);
        const auto place = [&](std::uint32_t p) { return Eigen::Vector2d(u.dot(m_points[p]), v.dot(m_points[p])); };
        std::sort(flat.begin(), flat.end(), [&](std::uint32_t a, std::uint32_t b) {
            const Eigen::Vector2d left = place(a), right = place(b);
            return left.x() != right.x() ? left.x() < right.x() : left.y() < right.y();
        });
        Polygon hull;
        for (int pass = 0; pass < 2; ++pass) {
            const std::size_t begin = hull.size();
            for (const std::uint32_t p : flat) {
                while (hull.size() >= begin + 2 && !turnsLeft(place(hull[hull.size() - 2]), place(hull.back()), place(p))) {
                    hull.pop_back();
                }
                hull.push_back(p);
            }
            hull.pop_back();
            std::reverse(flat.begin(), flat.end());
        }
        return hull;
    }

    bool turnsLeft(const Eigen::Vector2d& a, const Eigen::Vector2d& b, const Eigen::Vector2d& c) const {
        const Eigen::Vector2d along = b - a, on = c - a;
        return along.x() * on.y() - along.y() * on.x() > m_tolerance * on.norm();
    }

    std::span<const Vec3> m_points;
    double m_tolerance = 0.0;
    std::vector<Polygon> m_planes;  // all points of each face, ascending
    std::vector<Polygon> m_faces;
};

std::size_t facesWith(const std::vector<Polygon>& faces, std::size_t corners) {
    return static_cast<std::size_t>(
        std::count_if(faces.begin(), faces.end(), [corners](const Polygon& face) { return face.size() == corners; }));
}

bool has(const Polygon& face, std::uint32_t corner) {
    return std::find(face.begin(), face.end(), corner) != face.end();
}

// The corner outside a face that shares two faces with one of it: the other end of the edge that leaves the face there.
std::uint32_t acrossFrom(const std::vector<Polygon>& faces, const Polygon& base, std::uint32_t corner) {
    for (const Polygon& face : faces) {
        const auto at = std::find(face.begin(), face.end(), corner);
        if (at == face.end() || std::is_permutation(face.begin(), face.end(), base.begin(), base.end())) {
            continue;
        }
        const std::uint32_t before = at == face.begin() ? face.back() : *(at - 1);
        const std::uint32_t after = at + 1 == face.end() ? face.front() : *(at + 1);
        if (!has(base, before) || !has(base, after)) {
            return has(base, before) ? after : before;
        }
    }
    return corner;
}

// A hexahedron or a wedge: a base and what lies across from each of its corners.
CellPiece raised(ElementShape shape, const std::vector<Polygon>& faces, const Polygon& base) {
    CellPiece piece{shape, base};
    std::reverse(piece.corners.begin(), piece.corners.end());
    for (std::size_t c = 0; c < base.size(); ++c) {
        piece.corners.push_back(acrossFrom(faces, base, piece.corners[c]));
    }
    return piece;
}

bool isWhole(const CellPiece& piece) {
    const std::set<std::uint32_t> distinct(piece.corners.begin(), piece.corners.end());
    return distinct.size() == static_cast<std::size_t>(cornerCount(piece.shape));
}

std::optional<CellPiece> singleSolid(const std::vector<Polygon>& faces, std::size_t corners) {
    const std::size_t triangles = facesWith(faces, 3), quadrilaterals = facesWith(faces, 4);
    const auto base = [&](std::size_t count) {
        return *std::find_if(faces.begin(), faces.end(), [count](const Polygon& face) { return face.size() == count; });
    };
    CellPiece piece;
    if (corners == 8 && quadrilaterals == 6 && faces.size() == 6) {
        piece = raised(ElementShape::Hexahedron, faces, base(4));
    } else if (corners == 6 && triangles == 2 && quadrilaterals == 3 && faces.size() == 5) {
        piece = raised(ElementShape::Wedge, faces, base(3));
    } else {
        return std::nullopt;
    }
    return isWhole(piece) ? std::optional(piece) : std::nullopt;
}

// Pyramids and tetrahedra over the faces that the first corner is not on; of a pyramid or a tetrahedron, itself.
std::vector<CellPiece> solidsOf(const std::vector<Polygon>& faces) {
    std::set<std::uint32_t> corners;
    for (const Polygon& face : faces) {
        corners.insert(face.begin(), face.end());
    }
    if (faces.size() < 4 || corners.size() < 4) {
        return {};
    }
    if (const auto single = singleSolid(faces, corners.size())) {
        return {*single};
    }
    std::uint32_t apex = *corners.begin();
    if (corners.size() == 5 && facesWith(faces, 4) == 1) {
        const Polygon& base = *std::find_if(faces.begin(), faces.end(), [](const Polygon& face) { return face.size() == 4; });
        apex = *std::find_if(corners.begin(), corners.end(), [&base](std::uint32_t corner) { return !has(base, corner); });
    }
    std::vector<CellPiece> pieces;
    for (const Polygon& face : faces) {
        if (has(face, apex)) {
            continue;
        }
        for (Polygon& part : cutPolygon(face)) {
            const ElementShape shape = part.size() == 4 ? ElementShape::Pyramid : ElementShape::Tetrahedron;
            std::reverse(part.begin(), part.end());
            part.push_back(apex);
            pieces.push_back({shape, std::move(part)});
        }
    }
    return pieces;
}

}  // namespace

bool isTakenApart(int type) {
    constexpr std::array<int, 7> types{polyline, strip, polygon, pentagonalPrism, hexagonalPrism, convexPointSet, polyhedron};
    return std::find(types.begin(), types.end(), type) != types.end();
}

std::vector<CellPiece> piecesOfVtkCell(int type, std::span<const Vec3> points) {
    std::vector<CellPiece> pieces;
    switch (type) {
        case polyline:
            for (std::uint32_t i = 0; i + 1 < points.size(); ++i) {
                pieces.push_back({ElementShape::Beam, {i, i + 1}});
            }
            return pieces;
        case strip:
            for (std::uint32_t i = 0; i + 2 < points.size(); ++i) {
                pieces.push_back({ElementShape::Triangle, {i, i + 1, i + 2}});
            }
            return pieces;
        case polygon:
            return shellsOf(countedUp(0, points.size()));
        case pentagonalPrism:
            return points.size() == 10 ? prismOf(5) : pieces;
        case hexagonalPrism:
            return points.size() == 12 ? prismOf(6) : pieces;
        case convexPointSet:
        case polyhedron:
            return points.size() <= mostPolyhedronPoints ? solidsOf(ConvexBody(points).faces()) : pieces;
        default:
            return pieces;
    }
}

}  // namespace rubble::io
