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
constexpr std::uint32_t firstOf(ColliderPair pair) {
    return static_cast<std::uint32_t>(pair >> 32);
}
constexpr std::uint32_t secondOf(ColliderPair pair) {
    return static_cast<std::uint32_t>(pair);
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
    /// Has the piece of this pair given way? One that overlapped at birth has: a newborn does not fight what it was part of.
    bool yielded(ColliderPair pair) const;
    /// Makes the present depth the offset, because a piece that has given way goes on into the body.
    void follow(ColliderPair pair, double depth);
    /// A piece carried a body and left much of the closing speed; true when it gives way after so many in a row.
    bool pushedInVain(ColliderPair pair, double depth);
    /// m/s that a pressing piece may still change the speed of its body by.
    double pressLeft(ColliderPair pair) const;
    /// A piece pressed by so much; true when it gives way for that.
    bool pressed(ColliderPair pair, double depth, double speed);
    /// Takes off what was bled in this step.
    void bleed(ColliderPair pair, double distance);
    void endStep();

    bool empty() const { return m_entries.empty(); }
    std::size_t size() const { return m_entries.size(); }

private:
    struct Entry {
        double offset = 0.0;
        std::uint64_t seen = 0;
        std::uint64_t pushed = 0;  ///< latest step of a push in vain
        int pushes = 0;            ///< in a row
        double pressed = 0.0;      ///< m/s
        bool yielded = false;
    };
    std::unordered_map<ColliderPair, Entry> m_entries;
    std::uint64_t m_step = 1;
};

}  // namespace rubble
