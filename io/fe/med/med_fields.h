#pragma once

#include <array>
#include <optional>
#include <string>
#include <vector>

#include "core/base/finding.h"
#include "core/scenario/scenario.h"
#include "io/fe/med/med_file.h"

namespace rubble::io {

/// A vector on nodes and which components of its field are its axes; -1: the model has no such axis.
struct MedVector {
    MedField field;
    std::array<int, 3> axis{-1, -1, -1};
};

/// One component of a field on cells, and what its name says.
struct MedFlag {
    MedField field;
    MedPlace place = MedPlace::Cells;
    std::size_t component = 0;
    std::string name;
    std::optional<int> activeByName;
};

/// The fields of one result of a file: what moves the nodes, what the elements carry, what tells which of them are active.
struct MedResult {
    std::optional<MedVector> displacement, velocity;
    std::vector<std::pair<MedField, MedPlace>> onCells;
    std::optional<MedFlag> flag;
    std::vector<std::string> choices;  ///< what else could be the flag
    std::string mesh;
    std::vector<MedStep> steps;  ///< the states
};

/// Chooses them. code_aster names a field by its result and what it is: RESU____DEPL; of several results the one with most steps is
/// taken and the others counted. Throws ParseError without a displacement, UsageError for names that the file does not have.
MedResult chooseMedResult(const MedFile& file, const ImportSettings& settings, Findings& findings);

}  // namespace rubble::io
