#pragma once

#include <array>
#include <cstdint>
#include <span>
#include <vector>

#include "core/base/ids.h"
#include "core/fe/fe_result.h"
#include "core/fragments/fragment_set.h"

namespace rubble::render {

/// Half-open interval of time [from, to), s; ends may be infinite.
struct TimeSpan {
    double from = 0.0;
    double to = 0.0;

    friend bool operator==(const TimeSpan&, const TimeSpan&) = default;
};

/// When each element is drawn as active structure: disjoint ascending spans.
struct ShowTimes {
    std::vector<std::uint32_t> offsets;  ///< first span of each element [elements + 1]
    std::vector<TimeSpan> spans;

    std::span<const TimeSpan> of(ElementIndex e) const {
        return {spans.data() + offsets[at(e)], offsets[at(e) + 1] - offsets[at(e)]};
    }
};

/// As the file says: active at state k means shown from t_k to t_(k+1), without end at the last state and without beginning at
/// the first.
ShowTimes showTimes(const FeResult& fe);
/// As showTimes(), less the time in which an element is a fragment: from its hand-over if bodies carry it there already, else from
/// its birth, to the fragment's end.
ShowTimes showTimes(const FeResult& fe, const FragmentSet& fragments, bool carriedFromHandOver);

/// The faces of the structure with the times in which each can be seen, found once: a face between two shown elements never is.
/// Times are cut at events into slots; within a slot the set of faces does not change.
class StructureFaces {
public:
    static constexpr std::uint32_t none = 0xffffffffu;

    /// A triangle (fourth node `none`) or quadrilateral seen from outside, or a beam (third and fourth `none`).
    struct Face {
        std::array<std::uint32_t, 4> nodes{};
        ElementIndex element{};
        std::uint32_t fromSlot = 0;
        std::uint32_t toSlot = 0;  ///< exclusive
    };

    /// @param hideInner  false keeps every face of every element while it is shown
    StructureFaces(const Mesh& mesh, const ShowTimes& times, bool hideInner = true);

    std::span<const Face> faces() const { return m_faces; }
    std::size_t slotAt(double time) const;
    std::size_t slotCount() const { return m_events.size() + 1; }
    /// Indices into faces() of what can be seen in a slot, ascending.
    std::vector<std::uint32_t> visible(std::size_t slot) const;
    /// Brings what visible() gave in one slot to what it gives in another.
    void follow(std::vector<std::uint32_t>& visible, std::size_t from, std::size_t to) const;

private:
    std::uint32_t slotFrom(double time) const;

    /// Faces by the slot with which they begin or end, ascending in each.
    struct BySlot {
        std::vector<std::uint32_t> offsets;  ///< first of each slot [slots + 2]
        std::vector<std::uint32_t> faces;
    };
    template <class SlotOf>
    BySlot sorted(SlotOf slotOf) const;

    std::vector<double> m_events;
    std::vector<Face> m_faces;
    BySlot m_beginning;
    BySlot m_ending;
};

}  // namespace rubble::render
