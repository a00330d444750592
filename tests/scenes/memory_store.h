#pragma once

#include <map>
#include <mutex>
#include <optional>
#include <vector>

#include "core/analysis/accuracy/accuracy_study.h"

namespace rubble {

/// Keeps worlds and costs of a study in memory.
class MemoryStore : public StudyStore {
public:
    std::optional<SimulatedWorld> world(const WorldOrigin& origin, Findings&) override {
        const std::scoped_lock lock(m_mutex);
        return foundIn(worlds, origin);
    }
    void keep(const WorldOrigin& origin, const SimulatedWorld& world) override {
        const std::scoped_lock lock(m_mutex);
        admit(origin);
        worlds.insert_or_assign(origin.key, world);
        order.push_back(origin);
        kept();
    }
    std::optional<SettingCost> cost(const WorldOrigin& origin, int) override { return foundIn(costs, origin); }
    void keep(const WorldOrigin& origin, const SettingCost& cost) override { costs[origin.key] = cost; }

    std::map<Digest, SimulatedWorld> worlds;
    std::map<Digest, SettingCost> costs;
    std::vector<WorldOrigin> order;  ///< in which worlds were kept

protected:
    /// Before a world is kept: may throw.
    virtual void admit(const WorldOrigin&) {}
    /// After it.
    virtual void kept() {}

private:
    template <class Kept>
    static std::optional<Kept> foundIn(const std::map<Digest, Kept>& all, const WorldOrigin& origin) {
        const auto found = all.find(origin.key);
        return found == all.end() ? std::nullopt : std::optional(found->second);
    }

    std::mutex m_mutex;
};

}  // namespace rubble
