#include "widgets/render/basics/fragment_filter.h"

#include "core/evidence/maps/motion_history.h"

namespace rubble::render {

double longestSide(const Fragment& fragment) {
    return 2.0 * fragment.box.halfExtents.maxCoeff();
}

std::vector<double> speedsShown(const SceneData& data, const TrajectoryFrame* frame) {
    if (frame != nullptr) {
        return fragmentSpeeds(*data.fragments, data.trajectory->carriers(), *frame);
    }
    std::vector<double> speeds;
    speeds.reserve(data.fragments->size());
    for (const Fragment& fragment : data.fragments->list) {
        speeds.push_back(fragment.velocity.norm());
    }
    return speeds;
}

std::vector<std::uint8_t> meeting(const FragmentFilter& filter, const FragmentSet& fragments, const Components* components,
                                  const std::vector<double>& speeds) {
    std::vector<std::uint8_t> wanted;
    if (components != nullptr) {
        for (const Component& component : components->list) {
            wanted.push_back(filter.component.empty() || component.name == filter.component ? 1 : 0);
        }
    }
    std::vector<std::uint8_t> meets(fragments.size(), 0);
    for (std::size_t f = 0; f < meets.size(); ++f) {
        const Fragment& fragment = fragments.list[f];
        const bool named =
            filter.component.empty() || (at(fragment.component) < wanted.size() && wanted[at(fragment.component)] != 0);
        const bool moves = filter.speed.empty() || (f < speeds.size() && filter.speed.holds(speeds[f]));
        meets[f] = named && moves && filter.mass.holds(fragment.mass) && filter.size.holds(longestSide(fragment)) &&
                           filter.birth.holds(fragment.birthTime)
                       ? 1
                       : 0;
    }
    return meets;
}

}  // namespace rubble::render
