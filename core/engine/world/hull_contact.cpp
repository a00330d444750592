#include "core/engine/world/hull_contact.h"

#include <algorithm>
#include <cmath>
#include <limits>

#include "core/base/same_bits.h"

namespace rubble {

namespace {

/// As for boxes: an edge axis must separate better than the best face by this share of the smallest half extent, and the faces of
/// the second better than those of the first by a tenth of that.
constexpr double edgePreference = 0.02;
/// Squared sine below which two edges count as parallel and give no axis of their own.
constexpr double parallelEdges = 1e-6;
/// Share of their separation by which the nearest places of two edges may lie beside each other.
constexpr double edgeReach = 0.1;

/// Corners and face normals in the world, about the middle between the two bodies: differences of large numbers lose digits.
struct Turned {
    Turned(const PlacedHull& placed, const Vec3& middle) : hull(*placed.hull) {
        corners.reserve(hull.corners.size());
        for (const Vec3& p : hull.corners) {
            corners.emplace_back(placed.axes * p + (placed.position - middle));
        }
        normals.reserve(hull.faces.size());
        for (const HullFace& face : hull.faces) {
            normals.emplace_back(placed.axes * face.normal);
        }
    }
    Vec3 edge(const HullEdge& e) const { return corners[e.to] - corners[e.from]; }
    double least(const Vec3& normal) const {
        double least = std::numeric_limits<double>::infinity();
        for (const Vec3& p : corners) {
            least = std::min(least, normal.dot(p));
        }
        return least;
    }
    const ConvexHull& hull;
    std::vector<Vec3> corners;
    std::vector<Vec3> normals;
};

/// The face of one body that is farthest from all of the other.
struct FaceAxis {
    double separation = -std::numeric_limits<double>::infinity();
    std::size_t face = 0;
};

FaceAxis bestFace(const Turned& of, const Turned& other, double margin) {
    FaceAxis best;
    for (std::size_t f = 0; f < of.normals.size() && best.separation <= margin; ++f) {
        const double plane = of.normals[f].dot(of.corners[of.hull.faces[f].corners.front()]);
        const double separation = other.least(of.normals[f]) - plane;
        if (separation > best.separation) {
            best = {separation, f};
        }
    }
    return best;
}

/// Two edges that cross, and the axis across both.
struct EdgeAxis {
    double separation = -std::numeric_limits<double>::infinity();
    Vec3 normal = Vec3::UnitZ();  ///< from a to b
    std::size_t a = 0, b = 0;
};

/// Two edges make a face of the difference of the bodies where their arcs on the Gauss map cross.
/// @param a1, a2  normals beside one edge, acrossA their product a2 x a1. @param b1, b2  negative normals beside the other
bool makeFace(const Vec3& a1, const Vec3& a2, const Vec3& acrossA, const Vec3& b1, const Vec3& b2, const Vec3& acrossB) {
    const double c = b1.dot(acrossA), d = b2.dot(acrossA);
    const double e = a1.dot(acrossB), f = a2.dot(acrossB);
    // The last: on one half of the sphere.
    return c * d < 0.0 && e * f < 0.0 && c * f > 0.0;
}

EdgeAxis bestEdges(const Turned& a, const Turned& b, double margin) {
    EdgeAxis best;
    std::vector<Vec3> acrossB;
    for (const HullEdge& eb : b.hull.edges) {
        acrossB.push_back(b.normals[eb.right].cross(b.normals[eb.left]));
    }
    for (std::size_t i = 0; i < a.hull.edges.size(); ++i) {
        const HullEdge& ea = a.hull.edges[i];
        const Vec3 alongA = a.edge(ea);
        const Vec3& left = a.normals[ea.left];
        const Vec3& right = a.normals[ea.right];
        const Vec3 acrossA = right.cross(left);
        for (std::size_t j = 0; j < b.hull.edges.size(); ++j) {
            const HullEdge& eb = b.hull.edges[j];
            if (!makeFace(left, right, acrossA, -b.normals[eb.left], -b.normals[eb.right], acrossB[j])) {
                continue;
            }
            const Vec3 alongB = b.edge(eb);
            Vec3 normal = alongA.cross(alongB);
            const double length2 = normal.squaredNorm();
            if (length2 < parallelEdges * alongA.squaredNorm() * alongB.squaredNorm()) {
                continue;
            }
            normal /= std::sqrt(length2);
            if (normal.dot(left + right) < 0.0) {
                normal = -normal;
            }
            const double separation = normal.dot(b.corners[eb.from] - a.corners[ea.from]);
            if (separation > best.separation) {
                best = {separation, normal, i, j};
                if (separation > margin) {
                    return best;
                }
            }
        }
    }
    return best;
}

ContactPatch edgeContact(const Turned& a, const Turned& b, const EdgeAxis& axis) {
    const HullEdge& ea = a.hull.edges[axis.a];
    const HullEdge& eb = b.hull.edges[axis.b];
    const Vec3 alongA = a.edge(ea), alongB = b.edge(eb);
    const Vec3 r = b.corners[eb.from] - a.corners[ea.from];
    const double aa = alongA.squaredNorm(), bb = alongB.squaredNorm(), ab = alongA.dot(alongB);
    const double denominator = aa * bb - ab * ab;
    const double s = std::clamp((bb * alongA.dot(r) - ab * alongB.dot(r)) / denominator, 0.0, 1.0);
    const double t = std::clamp((ab * alongA.dot(r) - aa * alongB.dot(r)) / denominator, 0.0, 1.0);
    const Vec3 onA = a.corners[ea.from] + s * alongA;
    const Vec3 onB = b.corners[eb.from] + t * alongB;
    const Vec3 across = onB - onA - axis.normal.dot(onB - onA) * axis.normal;
    ContactPatch contact;
    if (axis.separation > 0.0 && across.squaredNorm() > edgeReach * edgeReach * axis.separation * axis.separation) {
        // The nearest places of the two edges are ends that pass each other.
        return contact;
    }
    contact.normal = axis.normal;
    contact.count = 1;
    contact.points[0] = {0.5 * (onA + onB), axis.separation,
                         1u << 31 | static_cast<std::uint32_t>(axis.a) << 12 | static_cast<std::uint32_t>(axis.b)};
    return contact;
}

/// Cuts a convex polygon where it lies beyond a side of the reference face.
/// @param outward  in the plane, away from the face. @param side  number of it, names what is new
void clip(std::vector<PlanePoint>& polygon, double outU, double outV, double limit, std::uint32_t side) {
    std::vector<PlanePoint> kept;
    for (std::size_t i = 0; i < polygon.size(); ++i) {
        const PlanePoint& p = polygon[i];
        const PlanePoint& q = polygon[(i + 1) % polygon.size()];
        const double dp = outU * p.u + outV * p.v - limit, dq = outU * q.u + outV * q.v - limit;
        if (dp <= 0.0) {
            kept.push_back(p);
        }
        if ((dp < 0.0) != (dq < 0.0) && dp != dq) {
            const double share = dp / (dp - dq);
            const std::uint32_t feature = 64u + 64u * side + std::min(p.feature, q.feature) % 32u + (dp < 0.0 ? 32u : 0u);
            kept.push_back(
                {p.u + share * (q.u - p.u), p.v + share * (q.v - p.v), p.height + share * (q.height - p.height), feature});
        }
    }
    polygon = std::move(kept);
}

/// The face of a body that looks most against a direction.
std::size_t facing(const Turned& of, const Vec3& direction) {
    std::size_t best = 0;
    for (std::size_t f = 1; f < of.normals.size(); ++f) {
        if (of.normals[f].dot(direction) < of.normals[best].dot(direction)) {
            best = f;
        }
    }
    return best;
}

/// Contact of a face of one body with the face of the other that looks at it most; the normal leads from the first to the second.
ContactPatch faceContact(const Turned& reference, const Turned& incident, std::size_t face, double margin, std::uint32_t tag) {
    const Vec3 outward = reference.normals[face];
    const std::size_t other = facing(incident, outward);
    const auto& around = reference.hull.faces[face].corners;
    const Vec3& origin = reference.corners[around.front()];
    const Vec3 eu = (reference.corners[around[1]] - origin).normalized();
    const Vec3 ev = outward.cross(eu);
    const auto place = [&](const Vec3& p, std::uint32_t feature) {
        return PlanePoint{eu.dot(p - origin), ev.dot(p - origin), outward.dot(p - origin), feature};
    };
    std::vector<PlanePoint> polygon;
    for (const std::uint32_t corner : incident.hull.faces[other].corners) {
        polygon.push_back(place(incident.corners[corner], corner));
    }
    for (std::size_t k = 0; k < around.size(); ++k) {
        const PlanePoint from = place(reference.corners[around[k]], 0);
        const PlanePoint to = place(reference.corners[around[(k + 1) % around.size()]], 0);
        const double length = lengthOf(to.u - from.u, to.v - from.v);
        const double outU = (to.v - from.v) / length, outV = -(to.u - from.u) / length;
        clip(polygon, outU, outV, outU * from.u + outV * from.v, static_cast<std::uint32_t>(k));
    }
    std::erase_if(polygon, [margin](const PlanePoint& p) { return p.height > margin; });
    int kept = reduceToFour(polygon);
    if (kept == 0) {
        // Faces that miss each other: the deepest corner alone, so that a pair that overlaps never loses its contact.
        std::uint32_t deepest = 0;
        for (std::uint32_t i = 1; i < incident.corners.size(); ++i) {
            if (outward.dot(incident.corners[i]) < outward.dot(incident.corners[deepest])) {
                deepest = i;
            }
        }
        polygon.assign(1, place(incident.corners[deepest], deepest));
        kept = polygon.front().height < 0.0 ? 1 : 0;
    }
    ContactPatch contact;
    contact.normal = outward;
    contact.count = kept;
    for (std::size_t n = 0; n < static_cast<std::size_t>(kept); ++n) {
        const PlanePoint& p = polygon[n];
        const Vec3 onIncident = origin + p.u * eu + p.v * ev + p.height * outward;
        contact.points[n] = {onIncident - 0.5 * p.height * outward, p.height,
                             tag | static_cast<std::uint32_t>(face) << 20 | static_cast<std::uint32_t>(other) << 13 | p.feature};
    }
    return contact;
}

}  // namespace

ContactPatch collideHulls(const PlacedHull& placedA, const PlacedHull& placedB, double margin) {
    const Vec3 middle = 0.5 * (placedA.position + placedB.position);
    const Turned a(placedA, middle), b(placedB, middle);
    const FaceAxis ofA = bestFace(a, b, margin);
    if (ofA.separation > margin) {
        return {};
    }
    const FaceAxis ofB = bestFace(b, a, margin);
    if (ofB.separation > margin) {
        return {};
    }
    const EdgeAxis edges = bestEdges(a, b, margin);
    if (edges.separation > margin) {
        return {};
    }
    const bool faceOfB = ofB.separation > ofA.separation + 1e-9 + 0.1 * edgePreference * placedB.leastHalf;
    const double face = faceOfB ? ofB.separation : ofA.separation;
    ContactPatch contact;
    if (edges.separation > face + edgePreference * std::min(placedA.leastHalf, placedB.leastHalf)) {
        contact = edgeContact(a, b, edges);
        contact.separation = edges.separation;
    } else if (faceOfB) {
        contact = faceContact(b, a, ofB.face, margin, 1u << 30);
        contact.normal = -contact.normal;
        contact.separation = face;
    } else {
        contact = faceContact(a, b, ofA.face, margin, 0);
        contact.separation = face;
    }
    for (int i = 0; i < contact.count; ++i) {
        contact.points[static_cast<std::size_t>(i)].position += middle;
    }
    return contact;
}

}  // namespace rubble
