#pragma once

#include <vector>

#include "core/base/archive.h"
#include "core/base/geometry.h"
#include "core/base/ids.h"

namespace rubble {

/// How hard elements of carried islands have been stopped since the engine took them, in the FE result and in the engine: the
/// largest change of an element's velocity from one FE state to the next, free fall taken off.
class IslandBlows {
public:
    /// Starts to follow an element. @param velocity  m/s, which it has in both
    void begin(ElementIndex element, const Vec3& velocity);
    /// The next FE state of one that is followed. @param fall  m/s that gravity has added since the state before
    void advance(ElementIndex element, const Vec3& inFe, const Vec3& inEngine, const Vec3& fall);
    /// The FE result has given it a blow (1 m/s and more) and the engine less than half of that.
    bool softer(ElementIndex element) const;
    void keep(Archive& archive) { archive(m_elements); }

private:
    struct Followed {
        Vec3 inFe = Vec3::Zero();      ///< m/s, at the latest state
        Vec3 inEngine = Vec3::Zero();  ///< m/s
        double feBlow = 0.0;           ///< m/s, the largest so far
        double engineBlow = 0.0;       ///< m/s

        void keep(Archive& archive) { archive(inFe, inEngine, feBlow, engineBlow); }
    };

    std::vector<Followed> m_elements;  ///< [elements], as far as one of them is followed
};

}  // namespace rubble
