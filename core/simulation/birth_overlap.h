#pragma once

#include <cstdint>
#include <unordered_map>
#include <utility>

namespace rubble {

/// Two colliders, in the order of their numbers.
using ColliderPair = std::uint64_t;
constexpr ColliderPair colliderPair(std::uint32_t a, std::uint32_t b) {
    return a < b ? (std::uint64_t{a} << 32) | b : (std::uint64_t{b} << 32) | a;
}

/// Rest offsets of pairs that overlapped when one of them was born, and of pieces that gave way: as long as a pair is no deeper
/// than its offset the solver sees it as just touching. An offset never grows by itself, follows the pair when it comes apart, and
/// is bled off by position only. Looked up by pair only, so that no order reaches a result.
class BirthOverlaps {
public:
    /// Begins a step; pairs not seen during it are forgotten at the end.
    void beginStep() { ++m_step; }
    /// The offset [m] of a pair that is `depth` deep now.
    /// @param newborn  one of the two has just entered: the depth becomes the offset
    double offset(ColliderPair pair, double depth, bool newborn);
    /// Makes the present depth the offset because a piece gave way; true if it did not do so in the step before.
    bool yield(ColliderPair pair, double depth);
    /// Did the piece of this pair give way in the step before?
    bool yielded(ColliderPair pair) const;
    /// Takes off what was bled in this step.
    void bleed(ColliderPair pair, double distance);
    void endStep();

    bool empty() const { return m_entries.empty(); }
    std::size_t size() const { return m_entries.size(); }

private:
    struct Entry {
        double offset = 0.0;
        std::uint64_t seen = 0;
        std::uint64_t yielded = 0;
    };
    std::unordered_map<ColliderPair, Entry> m_entries;
    std::uint64_t m_step = 1;
};

}  // namespace rubble
