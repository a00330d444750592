#include "core/clusters/velocity_split.h"

#include <algorithm>

namespace rubble {

namespace {

/// Moves the members that stay to the front and returns how many there are; all of them if the set holds together.
std::size_t oneRound(std::span<const MovingMass> all, double tolerance, std::span<std::uint32_t> members) {
    if (members.size() == 1) {
        return 1;
    }
    const MovingMass body = joinRigidly(all, members);
    double worst = 0.0;
    double least = std::numeric_limits<double>::infinity();
    std::uint32_t calmest = members.front();
    for (const std::uint32_t i : members) {
        const double misfit = velocityMisfit(body, all[i]);
        worst = std::max(worst, misfit);
        if (misfit < least) {
            least = misfit;
            calmest = i;
        }
    }
    if (worst <= tolerance) {
        return members.size();
    }
    const double limit = std::max(tolerance, 0.5 * worst);
    auto last = std::stable_partition(members.begin(), members.end(),
                                      [&](std::uint32_t i) { return velocityMisfit(body, all[i]) <= limit; });
    if (last == members.begin()) {
        const Vec3 velocity = all[calmest].velocity;
        last = std::stable_partition(members.begin(), members.end(), [&](std::uint32_t i) {
            return i == calmest || (all[i].velocity - velocity).norm() <= tolerance;
        });
    }
    return static_cast<std::size_t>(last - members.begin());
}

}  // namespace

void splitByVelocity(std::span<const MovingMass> all, double tolerance, std::span<std::uint32_t> members,
                     std::vector<std::uint32_t>& sizes) {
    while (!members.empty()) {
        std::size_t kept = members.size();
        for (std::size_t before = kept + 1; kept < before;) {
            before = kept;
            kept = oneRound(all, tolerance, members.first(kept));
        }
        sizes.push_back(static_cast<std::uint32_t>(kept));
        members = members.subspan(kept);
        std::ranges::sort(members);
    }
}

}  // namespace rubble
