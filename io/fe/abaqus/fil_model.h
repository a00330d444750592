#pragma once

#include <array>
#include <cstdint>
#include <string>
#include <vector>

#include "core/base/finding.h"
#include "core/fe/mesh.h"
#include "io/fe/abaqus/deck_parts.h"
#include "io/fe/abaqus/fil_records.h"

namespace rubble::io {

/// The model section of a results file, which comes once before the first increment.
struct FilModel {
    Mesh mesh;  ///< in units of the file, parts not yet given
    std::vector<NamedSet> sets;
    std::array<std::size_t, 3> freedoms{1, 2, 3};  ///< places of U1, U2, U3 in nodal records, from 1; 0: fixed
    Findings findings;
};

/// Reads up to the first increment, whose record is left in `record` (key 0: the file ends before). Throws ParseError.
FilModel readFilModel(const std::string& path, FilRecords& records, FilRecord& record);

}  // namespace rubble::io
