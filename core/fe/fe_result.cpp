#include "core/fe/fe_result.h"

#include <algorithm>
#include <cassert>
#include <exception>
#include <future>
#include <list>
#include <map>

namespace rubble {

namespace {

using StatePointer = std::shared_ptr<const FeState>;

constexpr std::size_t statesAlwaysKept = 2;

std::size_t bytesOf(const FeState& state) {
    return sizeof(FeState) + (state.positions.capacity() + state.velocities.capacity()) * sizeof(Vec3);
}

}  // namespace

/// States most recently used first. A state being read is a future, so that threads that want the same one read it once, and
/// the lock is never held while a file is read.
struct FeResult::Cache {
    struct Entry {
        std::size_t index;
        std::size_t bytes;
        StatePointer state;
    };

    explicit Cache(std::size_t budget) : byteBudget(budget) {}

    StatePointer find(std::size_t k) {
        const auto found = std::find_if(recent.begin(), recent.end(), [&](const Entry& entry) { return entry.index == k; });
        if (found == recent.end()) {
            return nullptr;
        }
        recent.splice(recent.begin(), recent, found);
        return found->state;
    }

    void keep(std::size_t k, const StatePointer& state) {
        recent.push_front({k, bytesOf(*state), state});
        bytes += recent.front().bytes;
        while (bytes > byteBudget && recent.size() > statesAlwaysKept) {
            bytes -= recent.back().bytes;
            recent.pop_back();
        }
    }

    const std::size_t byteBudget;
    std::mutex mutex;
    std::list<Entry> recent;
    std::size_t bytes = 0;
    std::map<std::size_t, std::shared_future<StatePointer>> reading;
};

FeResult::FeResult(Contents contents, std::size_t byteBudget)
    : m_contents(std::move(contents)), m_cache(std::make_unique<Cache>(byteBudget)) {
    assert(m_contents.mesh && m_contents.source);
    assert(m_contents.activity.states() == m_contents.times.size());
    assert(m_contents.activity.elements() == m_contents.mesh->elementCount());
    assert(m_contents.deathTime.empty() || m_contents.deathTime.size() == m_contents.mesh->elementCount());
    assert(std::adjacent_find(m_contents.times.begin(), m_contents.times.end(), std::greater_equal<>()) == m_contents.times.end());
}

FeResult::~FeResult() = default;

std::shared_ptr<const FeState> FeResult::state(std::size_t k) const {
    assert(k < stateCount());
    std::promise<StatePointer> promise;
    std::shared_future<StatePointer> other;
    {
        const std::lock_guard lock(m_cache->mutex);
        if (StatePointer kept = m_cache->find(k)) {
            return kept;
        }
        const auto found = m_cache->reading.find(k);
        if (found != m_cache->reading.end()) {
            other = found->second;
        } else {
            m_cache->reading.emplace(k, promise.get_future().share());
        }
    }
    if (other.valid()) {
        return other.get();
    }
    try {
        auto state = std::make_shared<const FeState>(m_contents.source->read(k));
        assert(state->positions.size() == mesh().nodeCount());
        const std::lock_guard lock(m_cache->mutex);
        m_cache->keep(k, state);
        m_cache->reading.erase(k);
        promise.set_value(state);
        return state;
    } catch (...) {
        const std::lock_guard lock(m_cache->mutex);
        m_cache->reading.erase(k);
        promise.set_exception(std::current_exception());
        throw;
    }
}

}  // namespace rubble
