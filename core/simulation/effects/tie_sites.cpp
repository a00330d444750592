#include "core/simulation/effects/tie_sites.h"

#include <algorithm>
#include <cmath>
#include <tuple>

namespace rubble {

namespace {

/// m. No tie is shorter: clusters may lie around each other.
constexpr double leastLength = 0.01;

/// One side of a joint.
struct Side {
    std::array<std::uint32_t, 4> key{TieSite::Joint::none, TieSite::Joint::none, TieSite::Joint::none, TieSite::Joint::none};
    TieSite::Joint joint;
    ClusterId cluster{};
    ElementIndex element{};
};

std::vector<ClusterId> clusterOfElements(const RunDescription& description) {
    const Components& components = *description.components;
    std::vector<ClusterId> of(description.fe->mesh().elementCount(), noCluster);
    for (std::size_t f = 0; f < description.fragments->size(); ++f) {
        const Fragment& fragment = description.fragments->list[f];
        if (components.list[at(fragment.component)].reinforced) {
            of[at(fragment.element)] = description.clustering->of[f];
        }
    }
    return of;
}

double faceArea(const Mesh& mesh, const std::array<std::uint32_t, 4>& nodes) {
    const Vec3& a = mesh.nodes[nodes[0]];
    const Vec3 ac = mesh.nodes[nodes[2]] - a;
    Vec3 twice = (mesh.nodes[nodes[1]] - a).cross(ac);
    if (nodes[3] != TieSite::Joint::none) {
        twice += ac.cross(mesh.nodes[nodes[3]] - a);
    }
    return 0.5 * twice.norm();
}

void addSides(const RunDescription& description, ElementIndex e, ClusterId cluster, std::vector<Side>& sides) {
    const Mesh& mesh = description.fe->mesh();
    const auto corners = mesh.cornersOf(e);
    const double section = description.components->section[at(e)];
    const auto add = [&](TieSite::Joint joint) {
        Side side{joint.nodes, joint, cluster, e};
        std::sort(side.key.begin(), side.key.end());
        if (joint.area > 0.0 && std::isfinite(joint.area)) {
            sides.push_back(side);
        }
    };
    const ElementShape shape = mesh.shapes[at(e)];
    if (isSolid(shape)) {
        for (const auto& face : facesOf(shape)) {
            TieSite::Joint joint;
            for (std::size_t i = 0; i < 4 && face[i] >= 0; ++i) {
                joint.nodes[i] = corners[static_cast<std::size_t>(face[i])];
            }
            joint.area = faceArea(mesh, joint.nodes);
            add(joint);
        }
        return;
    }
    for (std::size_t i = 0; i < corners.size(); ++i) {
        TieSite::Joint joint;
        joint.nodes[0] = corners[i];
        joint.area = section;
        if (isShell(shape)) {
            joint.nodes[1] = corners[(i + 1) % corners.size()];
            joint.area *= (mesh.nodes[joint.nodes[1]] - mesh.nodes[joint.nodes[0]]).norm();
        }
        add(joint);
    }
}

/// Centres at rest of the clusters, by the volume of their elements.
std::vector<Vec3> restCentres(const RunDescription& description) {
    const Mesh& mesh = description.fe->mesh();
    std::vector<Vec3> centres;
    for (std::size_t c = 0; c < description.clustering->list.size(); ++c) {
        Vec3 sum = Vec3::Zero();
        double weight = 0.0;
        for (const FragmentId f : description.clustering->membersOf(idAt<ClusterId>(c))) {
            const Fragment& fragment = description.fragments->list[at(f)];
            const auto corners = mesh.cornersOf(fragment.element);
            for (const std::uint32_t node : corners) {
                sum += fragment.mass / static_cast<double>(corners.size()) * mesh.nodes[node];
            }
            weight += fragment.mass;
        }
        centres.push_back(weight > 0.0 ? Vec3(sum / weight) : sum);
    }
    return centres;
}

}  // namespace

Vec3 TieSite::centre(std::span<const Vec3> positions) const {
    Vec3 sum = Vec3::Zero();
    for (const Joint& joint : joints) {
        Vec3 mean = Vec3::Zero();
        double nodes = 0.0;
        for (const std::uint32_t node : joint.nodes) {
            if (node != Joint::none) {
                mean += positions[node];
                nodes += 1.0;
            }
        }
        sum += joint.area / nodes * mean;
    }
    return sum / area;
}

std::vector<TieSite> findTieSites(const RunDescription& description) {
    std::vector<TieSite> sites;
    const std::vector<ClusterId> clusterOf = clusterOfElements(description);
    std::vector<Side> sides;
    for (std::size_t e = 0; e < clusterOf.size(); ++e) {
        if (clusterOf[e] != noCluster) {
            addSides(description, idAt<ElementIndex>(e), clusterOf[e], sides);
        }
    }
    std::sort(sides.begin(), sides.end(),
              [](const Side& x, const Side& y) { return std::tie(x.key, x.element) < std::tie(y.key, y.element); });

    struct Shared {
        ClusterId first, second;
        TieSite::Joint joint;
    };
    std::vector<Shared> shared;
    for (std::size_t i = 0; i + 1 < sides.size(); ++i) {
        if (sides[i].key == sides[i + 1].key && sides[i].cluster != sides[i + 1].cluster) {
            const auto [low, high] = std::minmax(sides[i].cluster, sides[i + 1].cluster);
            TieSite::Joint joint = sides[i].joint;
            joint.area = std::min(joint.area, sides[i + 1].joint.area);
            shared.push_back({low, high, joint});
        }
    }
    std::stable_sort(shared.begin(), shared.end(),
                     [](const Shared& x, const Shared& y) { return std::tie(x.first, x.second) < std::tie(y.first, y.second); });
    if (shared.empty()) {
        return sites;
    }
    const std::vector<Vec3> centres = restCentres(description);
    for (const Shared& joint : shared) {
        if (sites.empty() || sites.back().first != joint.first || sites.back().second != joint.second) {
            const double length = (centres[at(joint.first)] - centres[at(joint.second)]).norm();
            sites.push_back({joint.first, joint.second, 0.0, std::max(leastLength, length), {}});
        }
        sites.back().area += joint.joint.area;
        sites.back().joints.push_back(joint.joint);
    }
    return sites;
}

}  // namespace rubble
