#pragma once

#include <limits>
#include <random>
#include <string>

#include "core/clusters/clustering.h"
#include "core/fe/components.h"

namespace rubble {

/// Fragments that are plain boxes, with mesh and components to match as far as clustering reads them.
class FragmentBlocks {
public:
    FragmentSet set;
    Mesh mesh;
    Components components;

    /// A component of the given bounds.
    ComponentId component(const std::string& name, const Vec3& low, const Vec3& high) {
        Component c;
        c.name = name;
        c.bounds = Aabb(low, high);
        components.list.push_back(c);
        return idAt<ComponentId>(components.list.size() - 1);
    }

    Fragment& add(const Vec3& low, const Vec3& size, ComponentId component = ComponentId{}, std::uint32_t state = 0) {
        Fragment f;
        f.element = idAt<ElementIndex>(mesh.elementIds.size());
        mesh.elementIds.push_back(static_cast<std::int64_t>(mesh.elementIds.size()) + 1001);
        f.component = component;
        f.handOverState = state;
        f.birthState = state + 1;
        f.handOverTime = 0.1 * state;
        f.birthTime = 0.1 * (state + 1);
        f.endTime = std::numeric_limits<double>::infinity();
        f.mass = 2000.0 * size.prod();
        f.bounds = Aabb(low, low + size);
        f.centre = f.bounds.center();
        const Vec3 squares = size.cwiseAbs2();
        f.inertia =
            f.mass / 12.0 * Vec3(squares.y() + squares.z(), squares.x() + squares.z(), squares.x() + squares.y()).asDiagonal();
        if (set.vertexOffsets.empty()) {
            set.vertexOffsets.push_back(0);
        }
        for (int corner = 0; corner < 8; ++corner) {
            set.vertices.push_back(low + Vec3(corner & 1, (corner >> 1) & 1, corner >> 2).cwiseProduct(size));
        }
        set.vertexOffsets.push_back(static_cast<std::uint32_t>(set.vertices.size()));
        set.solid.push_back(ElementShape::Hexahedron);
        set.list.push_back(f);
        return set.list.back();
    }
};

inline double uniform(std::mt19937& random, double low, double high) {
    return std::uniform_real_distribution<double>(low, high)(random);
}

inline Vec3 uniformVector(std::mt19937& random, double low, double high) {
    const double x = uniform(random, low, high);
    const double y = uniform(random, low, high);
    return {x, y, uniform(random, low, high)};
}

/// Blocks of unequal size at random places, in two components, born at several states in that order.
inline FragmentBlocks randomBlocks(std::mt19937& random, int states, int perState, double span) {
    FragmentBlocks blocks;
    const ComponentId left = blocks.component("left", Vec3::Constant(-span), Vec3(0.0, span, span));
    const ComponentId right = blocks.component("right", Vec3(0.0, -span, -span), Vec3::Constant(span));
    for (int state = 0; state < states; ++state) {
        for (int i = 0; i < perState; ++i) {
            const Vec3 low = uniformVector(random, -span, span);
            Fragment& f =
                blocks.add(low, uniformVector(random, 0.3, 1.2), low.x() < 0.0 ? left : right, static_cast<std::uint32_t>(state));
            f.velocity = Vec3(0.0, 0.0, -9.0) + uniformVector(random, -1.0, 1.0);
            f.angularVelocity = uniformVector(random, -2.0, 2.0);
        }
    }
    return blocks;
}

}  // namespace rubble
