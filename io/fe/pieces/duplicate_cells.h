#pragma once

#include <cstddef>
#include <vector>

#include "core/base/finding.h"
#include "io/fe/series/mesh_series.h"

namespace rubble::io {

/// Leaves elements out that another piece of a mesh holds as well: those that the file marks as copies, those with an equal number,
/// and solids without numbers. A copy is known by its shape and the places of its corners, so nobody takes it for dead.
class DuplicateCells {
public:
    /// Takes them out of the mesh of a step and out of its flags; a step without a mesh has the elements of the one before.
    void leaveOut(SeriesStep& step, Findings& findings);

private:
    std::vector<bool> find(const SeriesStep& step, Findings& findings);

    std::vector<bool> m_left;  ///< of the newest mesh as it is written; empty: nothing
    bool m_noted = false;      ///< counted for the first mesh alone
};

}  // namespace rubble::io
