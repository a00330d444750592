#include "core/engine/soft/box_contact.h"

#include <algorithm>
#include <cmath>
#include <limits>

namespace rubble {

namespace {

/// An edge axis must separate better than the best face axis by this share of the smallest half extent: faces give steadier
/// contacts.
constexpr double edgePreference = 0.02;
/// The same of the depth, where faces are preferred in depth: a thin body that is pressed deep would go to and fro between a face
/// of four points and an edge of one, and hand on no load.
constexpr double deepEdgePreference = 0.1;
/// Squared sine below which two edges count as parallel and give no axis of their own.
constexpr double parallelEdges = 1e-6;

/// Share of their separation by which the nearest places of two edges may lie beside each other.
constexpr double edgeReach = 0.1;

/// Feature of a corner that stands for a whole face.
constexpr std::uint32_t loneCorner = 127;

/// The axis along which two boxes are least deep in each other, or farthest apart.
struct SeparatingAxis {
    double separation = -std::numeric_limits<double>::infinity();
    int index = -1;  ///< 0-2 faces of a, 3-5 faces of b, 6-14 edges a * 3 + b
    Vec3 normal = Vec3::UnitZ();
};

/// Convex polygon of at most eight corners during clipping.
struct Polygon {
    std::array<PlanePoint, 8> points;
    int count = 0;
};

/// Clips against sign * coordinate <= limit, where coordinate is u or v.
void clip(Polygon& polygon, bool alongU, double sign, double limit, std::uint32_t plane) {
    std::array<double, 8> beyond;
    bool inside = true;
    for (int i = 0; i < polygon.count; ++i) {
        const PlanePoint& p = polygon.points[static_cast<std::size_t>(i)];
        beyond[static_cast<std::size_t>(i)] = sign * (alongU ? p.u : p.v) - limit;
        inside = inside && beyond[static_cast<std::size_t>(i)] < 0;
    }
    if (inside) {
        return;
    }
    Polygon out;
    for (int i = 0; i < polygon.count; ++i) {
        const auto from = static_cast<std::size_t>(i), to = static_cast<std::size_t>(i + 1 == polygon.count ? 0 : i + 1);
        const PlanePoint& p = polygon.points[from];
        const PlanePoint& q = polygon.points[to];
        const double dp = beyond[from], dq = beyond[to];
        if (dp <= 0 && out.count < 8) {
            out.points[static_cast<std::size_t>(out.count++)] = p;
        }
        if ((dp < 0) != (dq < 0) && dp != dq && out.count < 8) {
            const double s = dp / (dp - dq);
            // A new corner is named by the edge it lies on and the plane that cut it.
            const std::uint32_t feature = 16u + 8u * plane + std::min(p.feature, q.feature) % 8u + (dp < 0 ? 64u : 0u);
            out.points[static_cast<std::size_t>(out.count++)] = {p.u + s * (q.u - p.u), p.v + s * (q.v - p.v),
                                                                 p.height + s * (q.height - p.height), feature};
        }
    }
    polygon = out;
}

SeparatingAxis findAxis(const PlacedBox& a, const PlacedBox& b, double margin, bool faces, bool& apart) {
    const Mat3 c = a.axes.transpose() * b.axes;
    const Mat3 absC = c.cwiseAbs();
    const Vec3 d = b.centre - a.centre;
    const Vec3 ta = a.axes.transpose() * d;
    const Vec3 tb = b.axes.transpose() * d;
    apart = true;
    SeparatingAxis best;
    const Vec3 sepA = ta.cwiseAbs() - a.halfExtents - absC * b.halfExtents;
    const Vec3 sepB = tb.cwiseAbs() - b.halfExtents - absC.transpose() * a.halfExtents;
    for (int i = 0; i < 3; ++i) {
        if (sepA[i] > margin || sepB[i] > margin) {
            return best;
        }
        if (sepA[i] > best.separation) {
            best = {sepA[i], i, ta[i] < 0 ? Vec3(-a.axes.col(i)) : Vec3(a.axes.col(i))};
        }
    }
    // The second box must be clearly better, so that equal boxes keep their reference face.
    for (int i = 0; i < 3; ++i) {
        if (sepB[i] > best.separation + 1e-9 + edgePreference * 0.1 * b.halfExtents.minCoeff()) {
            best = {sepB[i], 3 + i, tb[i] < 0 ? Vec3(-b.axes.col(i)) : Vec3(b.axes.col(i))};
        }
    }
    const double preference = edgePreference * std::min(a.halfExtents.minCoeff(), b.halfExtents.minCoeff());
    double edgeBest = best.separation + preference + (faces ? deepEdgePreference * std::max(0.0, -best.separation) : 0.0);
    for (int i = 0; i < 3; ++i) {
        const int i1 = (i + 1) % 3, i2 = (i + 2) % 3;
        for (int j = 0; j < 3; ++j) {
            const int j1 = (j + 1) % 3, j2 = (j + 2) % 3;
            const double sine2 = 1.0 - c(i, j) * c(i, j);
            if (sine2 < parallelEdges) {
                continue;
            }
            const double distance = ta[i2] * c(i1, j) - ta[i1] * c(i2, j);
            const double reach = a.halfExtents[i1] * absC(i2, j) + a.halfExtents[i2] * absC(i1, j) +
                                 b.halfExtents[j1] * absC(i, j2) + b.halfExtents[j2] * absC(i, j1);
            const double separation = (std::abs(distance) - reach) / std::sqrt(sine2);
            if (separation > margin) {
                return best;
            }
            if (separation > edgeBest) {
                edgeBest = separation;
                best.separation = separation;
                best.index = 6 + 3 * i + j;
            }
        }
    }
    apart = false;
    if (best.index >= 6) {
        best.normal = a.axes.col((best.index - 6) / 3).cross(b.axes.col((best.index - 6) % 3)).normalized();
        if (best.normal.dot(d) < 0) {
            best.normal = -best.normal;
        }
    }
    return best;
}

ContactPatch edgeContact(const PlacedBox& a, const PlacedBox& b, const SeparatingAxis& axis) {
    const int i = (axis.index - 6) / 3, j = (axis.index - 6) % 3;
    // The touching edges: on each box the one farthest along the normal towards the other.
    Vec3 pa = a.centre, pb = b.centre;
    std::uint32_t feature = static_cast<std::uint32_t>(axis.index) << 8;
    for (int k = 0; k < 3; ++k) {
        if (k != i) {
            const bool positive = axis.normal.dot(a.axes.col(k)) > 0;
            pa += (positive ? a.halfExtents[k] : -a.halfExtents[k]) * a.axes.col(k);
            feature |= positive ? 1u << k : 0u;
        }
        if (k != j) {
            const bool positive = axis.normal.dot(b.axes.col(k)) < 0;
            pb += (positive ? b.halfExtents[k] : -b.halfExtents[k]) * b.axes.col(k);
            feature |= positive ? 8u << k : 0u;
        }
    }
    const Vec3 ea = a.axes.col(i), eb = b.axes.col(j);
    const Vec3 r = pb - pa;
    const double cosine = ea.dot(eb);
    const double denominator = 1.0 - cosine * cosine;
    const double s = std::clamp((ea.dot(r) - cosine * eb.dot(r)) / denominator, -a.halfExtents[i], a.halfExtents[i]);
    const double t = std::clamp((cosine * ea.dot(r) - eb.dot(r)) / denominator, -b.halfExtents[j], b.halfExtents[j]);
    const Vec3 onA = pa + s * ea;
    const Vec3 onB = pb + t * eb;
    const Vec3 across = onB - onA - axis.normal.dot(onB - onA) * axis.normal;
    ContactPatch contact;
    if (axis.separation > 0.0 && across.squaredNorm() > edgeReach * edgeReach * axis.separation * axis.separation) {
        // The nearest places of the two edges are ends that pass each other.
        return contact;
    }
    contact.normal = axis.normal;
    contact.count = 1;
    contact.points[0] = {0.5 * (onA + onB), axis.separation, feature};
    return contact;
}

/// Contact of a face of `reference` (axis, outward normal) with the face of `incident` that looks at it most.
ContactPatch faceContact(const PlacedBox& reference, const PlacedBox& incident, int axis, const Vec3& outward, double margin,
                         std::uint32_t tag) {
    const Vec3 facing = incident.axes.transpose() * outward;
    int k = 0;
    facing.cwiseAbs().maxCoeff(&k);
    const double side = facing[k] > 0 ? -1.0 : 1.0;
    const int u = (axis + 1) % 3, v = (axis + 2) % 3, ku = (k + 1) % 3, kv = (k + 2) % 3;
    const Vec3 faceCentre = reference.centre + reference.halfExtents[axis] * outward;
    const Vec3 eu = reference.axes.col(u), ev = reference.axes.col(v);
    const Vec3 centre = incident.centre + side * incident.halfExtents[k] * incident.axes.col(k);
    const Vec3 hu = incident.halfExtents[ku] * incident.axes.col(ku), hv = incident.halfExtents[kv] * incident.axes.col(kv);
    Polygon polygon;
    polygon.count = 4;
    static constexpr std::array<std::array<double, 2>, 4> signs{{{-1, -1}, {1, -1}, {1, 1}, {-1, 1}}};
    for (std::size_t n = 0; n < 4; ++n) {
        const Vec3 p = centre + signs[n][0] * hu + signs[n][1] * hv - faceCentre;
        polygon.points[n] = {eu.dot(p), ev.dot(p), outward.dot(p), static_cast<std::uint32_t>(n)};
    }
    clip(polygon, true, 1, reference.halfExtents[u], 0);
    clip(polygon, true, -1, reference.halfExtents[u], 1);
    clip(polygon, false, 1, reference.halfExtents[v], 2);
    clip(polygon, false, -1, reference.halfExtents[v], 3);
    int kept = 0;
    for (int n = 0; n < polygon.count; ++n) {
        if (polygon.points[static_cast<std::size_t>(n)].height <= margin) {
            polygon.points[static_cast<std::size_t>(kept++)] = polygon.points[static_cast<std::size_t>(n)];
        }
    }
    kept = reduceToFour(std::span(polygon.points).first(static_cast<std::size_t>(kept)));
    if (kept == 0) {
        // Faces that miss each other: the nearest corner alone, so that a pair that overlaps never loses its contact.
        const Vec3 reach = facing.cwiseSign().cwiseProduct(incident.halfExtents);
        const Vec3 corner = incident.centre - incident.axes * reach - faceCentre;
        polygon.points[0] = {std::clamp(eu.dot(corner), -reference.halfExtents[u], reference.halfExtents[u]),
                             std::clamp(ev.dot(corner), -reference.halfExtents[v], reference.halfExtents[v]), outward.dot(corner),
                             loneCorner};
        kept = polygon.points[0].height < 0.0 ? 1 : 0;
    }
    ContactPatch contact;
    contact.normal = outward;
    contact.count = kept;
    for (int n = 0; n < kept; ++n) {
        const PlanePoint& p = polygon.points[static_cast<std::size_t>(n)];
        const Vec3 onIncident = faceCentre + p.u * eu + p.v * ev + p.height * outward;
        contact.points[static_cast<std::size_t>(n)] = {
            onIncident - 0.5 * p.height * outward, p.height,
            tag | static_cast<std::uint32_t>(k) << 10 | (side > 0 ? 1u << 12 : 0u) | p.feature};
    }
    return contact;
}

}  // namespace

ContactPatch collideBoxes(const PlacedBox& a, const PlacedBox& b, double margin, bool faces) {
    bool apart = false;
    const SeparatingAxis axis = findAxis(a, b, margin, faces, apart);
    if (apart) {
        return {};
    }
    ContactPatch contact;
    const std::uint32_t tag = static_cast<std::uint32_t>(axis.index) << 13;
    if (axis.index >= 6) {
        contact = edgeContact(a, b, axis);
    } else if (axis.index < 3) {
        contact = faceContact(a, b, axis.index, axis.normal, margin, tag);
    } else {
        contact = faceContact(b, a, axis.index - 3, -axis.normal, margin, tag);
        contact.normal = axis.normal;
    }
    contact.separation = axis.separation;
    return contact;
}

}  // namespace rubble
