#include "io/fe/meshes/polygon_cut.h"

#include <algorithm>
#include <cmath>

namespace rubble::io {

namespace {

using Triangles = std::vector<std::array<std::uint32_t, 3>>;

/// Share of the square of a polygon's extent below which an area is rounding.
constexpr double areaRounding = 1e-13;

double turn(const Eigen::Vector2d& a, const Eigen::Vector2d& b, const Eigen::Vector2d& c) {
    return (b.x() - a.x()) * (c.y() - a.y()) - (b.y() - a.y()) * (c.x() - a.x());
}

/// The outline in its plane, counter-clockwise, from which ears are taken.
class EarCut {
public:
    EarCut(const std::vector<Vec3>& points, std::vector<std::uint32_t> corners, const Vec3& normal, Triangles& triangles)
        : m_corners(std::move(corners)), m_triangles(triangles), m_left(m_corners.size()) {
        const Vec3 up = normal.normalized();
        const Vec3 east = up.unitOrthogonal();
        const Vec3 north = up.cross(east);
        const Vec3 first = points[m_corners.front()];
        double extent = 0.0;
        for (std::size_t k = 0; k < m_left; ++k) {
            const Vec3 from = points[m_corners[k]] - first;
            m_places.emplace_back(from.dot(east), from.dot(north));
            extent = std::max(extent, from.norm());
            m_next.push_back((k + 1) % m_left);
            m_before.push_back((k + m_left - 1) % m_left);
        }
        m_rounding = areaRounding * extent * extent;
        m_area = 0.5 * normal.norm();
    }

    /// @return whether the triangles cover the outline
    bool cut() {
        std::size_t at = 0;
        std::size_t tried = 0;
        bool mayTouch = false;
        while (m_left > 3) {
            const double corner = turnAt(at);
            const bool flat = std::abs(corner) <= m_rounding;
            if (flat || (corner > 0.0 && isEar(at, mayTouch))) {
                at = take(at, flat);
                tried = 0;
            } else if (++tried <= m_left) {
                at = m_next[at];
            } else if (!mayTouch) {
                mayTouch = true;
                tried = 0;
            } else {
                takeRest(at);
                return false;
            }
        }
        take(at, turnAt(at) <= m_rounding);
        return std::abs(m_covered - m_area) <= 1e-9 * m_area + static_cast<double>(m_corners.size()) * m_rounding;
    }

private:
    double turnAt(std::size_t k) const { return turn(m_places[m_before[k]], m_places[k], m_places[m_next[k]]); }

    /// Takes a corner off, with its triangle or, where it has no area, without. @return the one after it
    std::size_t take(std::size_t k, bool flat) {
        const std::size_t a = m_before[k];
        const std::size_t c = m_next[k];
        if (!flat) {
            m_triangles.push_back({m_corners[a], m_corners[k], m_corners[c]});
            m_covered += 0.5 * std::abs(turnAt(k));
        }
        m_next[a] = c;
        m_before[c] = a;
        --m_left;
        return c;
    }

    /// An outline that crosses itself has no ears in the end; what is left of it is cut as a fan.
    void takeRest(std::size_t at) {
        while (m_left >= 3) {
            at = m_before[take(at, false)];
        }
    }

    /// Nothing of the outline may lie in the triangle. Corners may share a place: a slit to a hole passes its ends twice.
    bool isEar(std::size_t k, bool mayTouch) const {
        const Eigen::Vector2d& a = m_places[m_before[k]];
        const Eigen::Vector2d& b = m_places[k];
        const Eigen::Vector2d& c = m_places[m_next[k]];
        const double least = mayTouch ? m_rounding : -m_rounding;
        for (std::size_t p = m_next[m_next[k]]; p != m_before[k]; p = m_next[p]) {
            const Eigen::Vector2d& place = m_places[p];
            if (place == b) {
                if (leavesAcross(m_places[m_next[p]], a, b, c) || leavesAcross(m_places[m_before[p]], a, b, c)) {
                    return false;
                }
            } else if (place != a && place != c && turn(a, b, place) > least && turn(b, c, place) > least &&
                       turn(c, a, place) > least) {
                return false;
            }
        }
        return true;
    }

    /// Whether an edge from b leaves the triangle through its side from c to a.
    static bool leavesAcross(const Eigen::Vector2d& to, const Eigen::Vector2d& a, const Eigen::Vector2d& b,
                             const Eigen::Vector2d& c) {
        return turn(a, b, to) > 0.0 && turn(b, c, to) > 0.0 && turn(c, a, to) <= 0.0;
    }

    std::vector<std::uint32_t> m_corners;
    Triangles& m_triangles;
    std::size_t m_left;
    std::vector<Eigen::Vector2d> m_places;
    std::vector<std::size_t> m_next, m_before;
    double m_rounding = 0.0;
    double m_area = 0.0;
    double m_covered = 0.0;
};

/// Twice the area of the outline, as a vector along its normal (Newell's method).
Vec3 areaVector(const std::vector<Vec3>& points, const std::vector<std::uint32_t>& corners) {
    Vec3 sum = Vec3::Zero();
    const Vec3 first = points[corners.front()];
    for (std::size_t k = 1; k + 1 < corners.size(); ++k) {
        sum += (points[corners[k]] - first).cross(points[corners[k + 1]] - first);
    }
    return sum;
}

/// A fan from the first corner. @return whether it has any area
bool addFan(const std::vector<Vec3>& points, const std::vector<std::uint32_t>& corners, double rounding, Triangles& triangles) {
    bool any = false;
    for (std::size_t k = 1; k + 1 < corners.size(); ++k) {
        const Vec3 first = points[corners.front()];
        if ((points[corners[k]] - first).cross(points[corners[k + 1]] - first).norm() > rounding) {
            triangles.push_back({corners.front(), corners[k], corners[k + 1]});
            any = true;
        }
    }
    return any;
}

/// A convex outline of four corners by its shorter diagonal. @return false if it is not convex
bool cutQuad(const std::vector<Vec3>& points, const std::vector<std::uint32_t>& corners, const Vec3& normal, Triangles& triangles) {
    for (std::size_t k = 0; k < 4; ++k) {
        const Vec3& at = points[corners[k]];
        if (!((at - points[corners[(k + 3) % 4]]).cross(points[corners[(k + 1) % 4]] - at).dot(normal) > 0.0)) {
            return false;
        }
    }
    const double even = (points[corners[2]] - points[corners[0]]).squaredNorm();
    const double odd = (points[corners[3]] - points[corners[1]]).squaredNorm();
    const std::size_t from = even <= odd ? 0 : 1;
    triangles.push_back({corners[from], corners[from + 1], corners[from + 2]});
    triangles.push_back({corners[from], corners[from + 2], corners[(from + 3) % 4]});
    return true;
}

}  // namespace

bool cutPolygon(const std::vector<Vec3>& points, std::span<const std::uint32_t> corners, Triangles& triangles) {
    std::vector<std::uint32_t> outline;
    double extent = 0.0;
    for (const std::uint32_t corner : corners) {
        if (outline.empty() || points[corner] != points[outline.back()]) {
            outline.push_back(corner);
            extent = std::max(extent, (points[corner] - points[outline.front()]).norm());
        }
    }
    while (outline.size() > 1 && points[outline.front()] == points[outline.back()]) {
        outline.pop_back();
    }
    if (outline.size() < 3) {
        return true;
    }
    if (outline.size() == 3) {
        triangles.push_back({outline[0], outline[1], outline[2]});
        return true;
    }
    const Vec3 normal = areaVector(points, outline);
    const double rounding = areaRounding * extent * extent;
    if (!(normal.norm() > rounding)) {
        // A line, or an outline whose parts take each other's area away.
        return !addFan(points, outline, rounding, triangles);
    }
    if (outline.size() == 4 && cutQuad(points, outline, normal, triangles)) {
        return true;
    }
    return EarCut(points, std::move(outline), normal, triangles).cut();
}

}  // namespace rubble::io
