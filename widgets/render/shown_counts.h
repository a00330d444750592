#pragma once

#include <cstdint>
#include <vector>

#include "core/clusters/clustering.h"
#include "core/fragments/fragment_set.h"
#include "widgets/render/shapes/structure_faces.h"

namespace rubble::render {

/// How many elements are shown as active structure at any time, counted once.
class ElementCounts {
public:
    explicit ElementCounts(const ShowTimes& times);

    std::size_t at(double time) const;

private:
    std::vector<double> m_times;         ///< s, ascending, at which the number changes
    std::vector<std::int64_t> m_counts;  ///< from each of them on
    std::int64_t m_before = 0;           ///< before the first
};

/// When fragments are drawn and born, and how many of them. Time is cut at their hand-overs, births and ends into slots, within
/// which nothing changes.
class FragmentSlots {
public:
    struct Counts {
        std::size_t onTheWay = 0;  ///< drawn, not yet born: they still count as structure
        std::size_t born = 0;
        std::vector<std::size_t> bornByComponent;  ///< [components]
        std::size_t clusters = 0;                  ///< with at least one fragment born

        friend bool operator==(const Counts&, const Counts&) = default;
    };

    /// @param clusters    may be null
    /// @param components  how many there are; 0: not known
    /// @param carried     bodies carry fragments from their hand-over, else they are drawn from their birth
    FragmentSlots(const FragmentSet& fragments, const Clustering* clusters, std::size_t components, bool carried);

    std::size_t slotAt(double time) const;
    bool drawn(std::size_t fragment, std::size_t slot) const {
        return m_spans[fragment].drawn <= slot && slot < m_spans[fragment].end;
    }
    bool born(std::size_t fragment, std::size_t slot) const {
        return m_spans[fragment].birth <= slot && slot < m_spans[fragment].end;
    }
    /// Counted on from the slot of the last call by what changes between the two. Valid until the next call.
    const Counts& countsAt(std::size_t slot);

private:
    /// First slots of a fragment's stages.
    struct Span {
        std::uint32_t drawn = 0;
        std::uint32_t birth = 0;
        std::uint32_t end = 0;
    };
    void count(std::uint32_t fragment, std::size_t slot, bool in);

    const FragmentSet& m_fragments;
    const Clustering* m_clusters;
    std::vector<double> m_events;           ///< s, ascending
    std::vector<Span> m_spans;              ///< by fragment
    std::vector<std::uint32_t> m_offsets;   ///< first of m_changing of each slot [slots + 1]
    std::vector<std::uint32_t> m_changing;  ///< fragments that begin a stage with a slot
    std::size_t m_slot = 0;                 ///< that m_counts belongs to
    Counts m_counts;
    std::vector<std::uint32_t> m_bornInCluster;
};

}  // namespace rubble::render
