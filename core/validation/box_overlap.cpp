#include "core/validation/box_overlap.h"

#include <algorithm>
#include <cmath>
#include <limits>

namespace rubble {

namespace {

/// Axes shorter than this are of two parallel edges and part nothing.
constexpr double parallel = 1e-9;

double reach(const Mat3& axes, const Vec3& halfExtents, const Vec3& along) {
    return (axes.transpose() * along).cwiseAbs().dot(halfExtents);
}

/// Half the sides of the box along the axes around a box.
Vec3 halfBounds(const OrientedBox& box) {
    return box.orientation.toRotationMatrix().cwiseAbs() * box.halfExtents;
}

}  // namespace

double overlapOf(const OrientedBox& a, const OrientedBox& b) {
    const Mat3 axesA = a.orientation.toRotationMatrix();
    const Mat3 axesB = b.orientation.toRotationMatrix();
    const Vec3 between = b.centre - a.centre;
    double least = std::numeric_limits<double>::infinity();
    const auto look = [&](const Vec3& axis) {
        const double length = axis.norm();
        if (length > parallel) {
            const Vec3 along = axis / length;
            least = std::min(
                least, reach(axesA, a.halfExtents, along) + reach(axesB, b.halfExtents, along) - std::abs(between.dot(along)));
        }
    };
    for (int i = 0; i < 3; ++i) {
        look(axesA.col(i));
        look(axesB.col(i));
        for (int j = 0; j < 3; ++j) {
            look(axesA.col(i).cross(axesB.col(j)));
        }
    }
    return least;
}

OverlapMeasure measureOverlap(const std::vector<OrientedBox>& boxes, const std::vector<std::size_t>& owners) {
    const auto ownerOf = [&](std::size_t i) { return owners.empty() ? i : owners[i]; };
    const std::size_t bodies = owners.empty() ? boxes.size() : std::ranges::max(owners) + 1;
    std::vector<Vec3> bounds;
    bounds.reserve(boxes.size());
    for (const OrientedBox& box : boxes) {
        bounds.push_back(halfBounds(box));
    }
    std::vector<std::size_t> order(boxes.size());
    for (std::size_t i = 0; i < order.size(); ++i) {
        order[i] = i;
    }
    const auto low = [&](std::size_t i) { return boxes[i].centre.x() - bounds[i].x(); };
    std::sort(order.begin(), order.end(), [&](std::size_t i, std::size_t j) { return low(i) < low(j); });
    // Negative: the body has no box.
    std::vector<double> deepest(bodies, -1.0), share(bodies, 0.0);
    for (std::size_t i = 0; i < boxes.size(); ++i) {
        deepest[ownerOf(i)] = 0.0;
    }
    for (std::size_t m = 0; m < order.size(); ++m) {
        const std::size_t i = order[m];
        for (std::size_t n = m + 1; n < order.size() && low(order[n]) < boxes[i].centre.x() + bounds[i].x(); ++n) {
            const std::size_t j = order[n];
            const Vec3 apart = (boxes[i].centre - boxes[j].centre).cwiseAbs() - bounds[i] - bounds[j];
            if (apart.maxCoeff() >= 0.0 || ownerOf(i) == ownerOf(j)) {
                continue;
            }
            const double depth = overlapOf(boxes[i], boxes[j]);
            const double side = 2.0 * std::min(boxes[i].halfExtents.minCoeff(), boxes[j].halfExtents.minCoeff());
            for (const std::size_t k : {ownerOf(i), ownerOf(j)}) {
                deepest[k] = std::max(deepest[k], depth);
                share[k] = std::max(share[k], depth / side);
            }
        }
    }
    OverlapMeasure measure;
    if (boxes.empty()) {
        return measure;
    }
    std::erase(deepest, -1.0);
    measure.deepest = *std::max_element(deepest.begin(), deepest.end());
    measure.deepestShare = *std::max_element(share.begin(), share.end());
    measure.beyondFive = std::count_if(share.begin(), share.end(), [](double s) { return s > 0.05; });
    std::sort(deepest.begin(), deepest.end());
    measure.p99 = deepest[static_cast<std::size_t>(0.99 * static_cast<double>(deepest.size() - 1))];
    return measure;
}

std::vector<OrientedBox> placedBoxes(const RigidWorld& world, const std::vector<Vec3>& sizes) {
    std::vector<OrientedBox> boxes;
    for (std::size_t i = 0; i < sizes.size(); ++i) {
        const BodyId id = idAt<BodyId>(i);
        if (world.state(id) != BodyState::Removed) {
            const Pose pose = world.motion(id).pose;
            boxes.push_back({pose.position, pose.orientation, 0.5 * sizes[i]});
        }
    }
    return boxes;
}

}  // namespace rubble
