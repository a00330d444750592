#pragma once

#include <memory>
#include <span>
#include <vector>

#include "core/fe/frame.h"
#include "io/run/run_file.h"

namespace rubble::io {

/// Where the fragments of a run are at any instant, by the bodies that carry them.
class FragmentPlaces {
public:
    /// @param run  must outlive this object; what it has committed by now is what counts
    explicit FragmentPlaces(const RunReader& run);

    struct Place {
        FragmentId fragment{};
        BodyId body{};
        Pose fromHandOver;  ///< takes points of the fragment at hand-over to where they are now
        float speed = 0.0f;
    };

    /// The fragments that are born and carried at an instant, in their order.
    std::vector<Place> at(double time) const;
    /// Those that a body carries at an instant, born or not.
    std::vector<Place> carriedAt(double time) const;
    const FragmentSet& fragments() const { return *m_fragments; }

private:
    const RunReader& m_run;
    std::shared_ptr<const FragmentSet> m_fragments;
    std::vector<Carrier> m_carriers;  ///< by fragment, then by time
};

}  // namespace rubble::io
