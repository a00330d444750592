#pragma once

#include <cstdint>
#include <map>
#include <string>
#include <vector>

#include "core/base/hash.h"
#include "core/fe/fe_result.h"

namespace rubble::io {

/// What must be the same of one collapse in every format, whatever the order of its elements, the names of its parts and the rest
/// of its states.
class CollapseDigest {
public:
    /// @param left  elements that do not count, by number
    explicit CollapseDigest(const FeResult& fe, const std::vector<std::int64_t>& left = {});

    /// Numbers and components of the elements: components are told by which elements share one.
    Digest elements() const;
    /// Numbers of the dead at a state.
    Digest dead(std::size_t state) const;
    std::size_t deadCount(std::size_t state) const;
    /// The state at a time, to six digits; states() where there is none.
    std::size_t stateAt(double time) const;
    /// Largest distance of the centres of active elements at a state of each [length unit].
    double distance(std::size_t state, const CollapseDigest& other, std::size_t otherState) const;
    /// Initial volume times density by element number, NaN where the density is not known.
    std::map<std::int64_t, double> masses() const;
    std::map<std::int64_t, double> volumes() const;

private:
    std::map<std::int64_t, Vec3> centres(std::size_t state) const;

    const FeResult& m_fe;
    std::map<std::int64_t, std::size_t> m_places;  // by number
};

}  // namespace rubble::io
