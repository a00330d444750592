#pragma once

#include <functional>
#include <memory>
#include <string>
#include <vector>

#include "core/fe/components.h"
#include "core/fe/fe_result.h"

namespace rubble::selftest {

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
    /// Takes every node of the mesh to another place.
    void transformNodes(const std::function<Vec3(const Vec3&)>& transform);
    /// The same elements with their numbers, parts and deaths, in another order in the file: the i-th of the copy is order[i].
    ElementScene reordered(const std::vector<std::size_t>& order) const;

    /// Every element belongs to this part from now on; the first part is "rubble".
    ElementScene& part(const std::string& name);

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

}  // namespace rubble::selftest
