#include "core/clusters/fragment_order.h"

#include <algorithm>

namespace rubble {

std::vector<Vec3> orderingCentres(const FragmentSet& fragments) {
    std::vector<Vec3> centres;
    centres.reserve(fragments.size());
    for (std::size_t f = 0; f < fragments.size(); ++f) {
        Vec3 sum = Vec3::Zero();
        const std::span<const Vec3> corners = fragments.verticesOf(idAt<FragmentId>(f));
        for (const Vec3& corner : corners) {
            sum += corner;
        }
        centres.push_back(corners.empty() ? fragments.list[f].centre : Vec3(sum / static_cast<double>(corners.size())));
    }
    return centres;
}

AxisOrder orderFragments(const FragmentSet& fragments, const Mesh& mesh, std::span<const Vec3> centres,
                         std::span<const std::uint32_t> members, int axis) {
    std::vector<double> low;
    std::vector<double> high;
    std::vector<double> centre;
    std::vector<std::int64_t> elementId;
    for (const std::uint32_t f : members) {
        const Fragment& fragment = fragments.list[f];
        low.push_back(fragment.bounds.min()[axis]);
        high.push_back(fragment.bounds.max()[axis]);
        centre.push_back(centres[f][axis]);
        elementId.push_back(mesh.elementIds[at(fragment.element)]);
    }
    return orderAlongAxis(low, high, centre, elementId);
}

}  // namespace rubble
