#include "core/simulation/run/acknowledgement.h"

#include <array>
#include <ctime>
#include <ranges>

#include "core/simulation/run/simulation.h"

namespace rubble {

Digest breachesDigest(const SimulationResult& result) {
    Hasher hasher;
    hasher.digest(result.trajectoryHash).value(static_cast<std::uint64_t>(result.health.breaches.size()));
    for (const HealthBreach& breach : result.health.breaches) {
        hasher.text(healthCheckName(breach.check)).value(breach.from).value(breach.to).value(breach.worst).value(breach.limit);
        hasher.value(breach.bodies).value(breach.body ? static_cast<std::int64_t>(at(*breach.body)) : std::int64_t{-1});
        for (int axis = 0; axis < 3; ++axis) {
            hasher.value(breach.place[axis]);
        }
    }
    return hasher.finish();
}

const Acknowledgement* acknowledgementOf(const SimulationResult& result, std::span<const Acknowledgement> list) {
    const Digest digest = breachesDigest(result);
    for (const Acknowledgement& entry : std::views::reverse(list)) {
        if (entry.breaches == digest) {
            return &entry;
        }
    }
    return nullptr;
}

bool isTainted(const SimulationResult& result, std::span<const Acknowledgement> list) {
    return result.health.tainted() && acknowledgementOf(result, list) == nullptr;
}

std::string utcNow() {
    const std::time_t now = std::time(nullptr);
    std::tm utc{};
    gmtime_r(&now, &utc);
    std::array<char, 32> text{};
    std::strftime(text.data(), text.size(), "%Y-%m-%dT%H:%M:%SZ", &utc);
    return text.data();
}

}  // namespace rubble
