#pragma once

#include <functional>
#include <memory>
#include <random>
#include <string>
#include <vector>

#include "core/fe/components.h"
#include "core/fe/fe_result.h"

namespace rubble::test {

/// An FE result in memory, element by element: any shapes, any activity, any motion.
class ElementScene {
public:
    /// Place of a node at a time, from where it is at rest.
    using Motion = std::function<Vec3(const Vec3& atRest, double time)>;

    ElementScene();

    /// @param activity  one character a state, '1' active
    ElementScene& element(ElementShape shape, const std::vector<Vec3>& corners, const std::string& activity, double section = 0.0,
                          double density = 2000.0);
    /// The same between nodes that exist already.
    ElementScene& between(ElementShape shape, const std::vector<std::uint32_t>& nodes, const std::string& activity,
                          double section = 0.0, double density = 2000.0);

    std::vector<double> times;
    Motion position = [](const Vec3& x, double) { return x; };
    Motion velocity;                 ///< unset: the result has no velocities
    std::vector<double> deathTimes;  ///< empty: none known
    /// Last word on a state as it is read: to damage it.
    std::function<void(std::size_t state, FeState&)> damage;

    /// The result; times are 0, 1, 2, ... s unless set.
    std::shared_ptr<const FeResult> result() const;
    /// Every part its own component, as the file says.
    static Components components(const FeResult& fe);
    /// The states read so far from the results of this scene, in order.
    const std::vector<std::size_t>& reads() const { return *m_reads; }

private:
    Mesh m_mesh;
    std::vector<std::string> m_activity;
    std::shared_ptr<std::vector<std::size_t>> m_reads;
};

/// Corners of an element of about the given size, distorted at random but sound; beams along some direction.
std::vector<Vec3> randomElement(ElementShape shape, std::mt19937& random, double size = 1.0, double distortion = 0.2);
Vec3 randomVector(std::mt19937& random, double length);
Mat3 randomRotation(std::mt19937& random);

inline constexpr ElementShape allShapes[]{ElementShape::Hexahedron,  ElementShape::Wedge,         ElementShape::Pyramid,
                                          ElementShape::Tetrahedron, ElementShape::Quadrilateral, ElementShape::Triangle,
                                          ElementShape::Beam};

}  // namespace rubble::test
