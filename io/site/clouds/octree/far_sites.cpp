#include "io/site/clouds/octree/far_sites.h"

#include <algorithm>
#include <limits>
#include <tuple>

#include "io/site/clouds/octree/cloud_bulk.h"

namespace rubble::io {

namespace {

constexpr std::uint64_t farRead = 1'000'000;

}  // namespace

FarSites::FarSites(const PlacedOctree& placed, const Execution& execution) {
    const CloudOctree& octree = placed.octree();
    const std::vector<OctreeNode>& nodes = octree.nodes();
    m_bulk = placed.boxes().front();
    const auto dense = [&](double farPlaces) {
        return std::max(denseLeast, denseShare * (static_cast<double>(octree.head().points - octree.head().farPoints) + farPlaces));
    };
    // Their places are no more than their points.
    if (static_cast<double>(octree.head().farPoints) < dense(0.0)) {
        return;
    }
    std::vector<Vec3> places;
    std::uint64_t read = 0;
    for (std::size_t n = 0; n < nodes.size(); ++n) {
        const OctreeNode& node = nodes[n];
        // A node has a second part if most of its points are at one place.
        const bool second =
            n > 0 && nodes[n - 1].far == node.far && nodes[n - 1].level == node.level && nodes[n - 1].box.min() == node.box.min();
        if (!node.far || second) {
            continue;
        }
        execution.check();
        if (read + node.points <= farRead) {
            read += node.points;
            const CloudBlock block = placed.read(n);
            places.insert(places.end(), block.places.begin(), block.places.end());
        } else if (!placed.boxes()[n].isEmpty()) {
            m_heaps.push_back({placed.boxes()[n], static_cast<double>(node.points)});
        }
    }
    const auto order = [](const Vec3& one, const Vec3& other) {
        return std::tuple(one.x(), one.y(), one.z()) < std::tuple(other.x(), other.y(), other.z());
    };
    std::sort(places.begin(), places.end(), order);
    places.erase(std::unique(places.begin(), places.end()), places.end());
    for (const Vec3& place : places) {
        m_heaps.push_back({Aabb(place), 1.0});
    }
    double all = 0.0;
    for (const Heap& heap : m_heaps) {
        all += heap.places;
    }
    m_dense = dense(all);
}

bool FarSites::nearer(const Vec3& place) const {
    const double bulk = m_bulk.isEmpty() ? std::numeric_limits<double>::infinity() : m_bulk.exteriorDistance(place);
    if (bulk <= 0.0 || m_heaps.empty()) {
        return false;
    }
    double places = 0.0;
    for (const Heap& heap : m_heaps) {
        places += heap.box.exteriorDistance(place) < bulk ? heap.places : 0.0;
    }
    return places >= m_dense;
}

}  // namespace rubble::io
