#pragma once

#include <functional>
#include <memory>
#include <vector>

#include "core/fe/fe_result.h"

namespace rubble::io {

/// A result in memory with all that a file can say: every shape, parts of several shapes, numbers with gaps, velocities, death
/// times, densities and sections of which some are not known, an element that comes back. Five states.
class MixedResult {
public:
    /// @param extraNodes  nodes of no element besides, to make the states larger  @param atRead  called before a state is read
    explicit MixedResult(std::size_t extraNodes = 0, std::function<void(std::size_t)> atRead = {});

    const FeResult& operator*() const { return *m_fe; }
    const FeResult* operator->() const { return m_fe.get(); }
    /// States in the order in which they were read.
    const std::vector<std::size_t>& reads() const { return *m_reads; }

private:
    std::shared_ptr<std::vector<std::size_t>> m_reads;
    std::shared_ptr<const FeResult> m_fe;
};

/// Compares all that a copy must keep bit by bit, and what all formats keep. Failures name what differs.
void expectSameResult(const FeResult& expected, const FeResult& found);

}  // namespace rubble::io
