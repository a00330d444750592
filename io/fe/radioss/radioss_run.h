#pragma once

#include <string>
#include <vector>

#include "core/base/execution.h"
#include "core/fe/fe_result.h"
#include "io/fe/radioss/anim_file.h"

namespace rubble::io {

/// Files of the run that a file belongs to, by their numbers; see FeFormat::members.
/// @param marks  what stands between the name of the run and the number: "A" for animation files
/// @param ending  after the number, beside an optional ".gz"
std::vector<std::string> numberedMembers(const std::string& path, const std::string& marks, const std::string& ending);

/// A run as a row of files, one a state, and how one of them is read.
struct RadiossRun {
    std::vector<std::string> files;
    AnimState (*read)(const std::string& path, AnimWanted wanted);
    std::string deck;        ///< path of the starter deck, which need not exist
    std::string activeFrom;  ///< how the file says which elements are active, for people
};

/// Reads a run: mesh from the first file, status and exact times of death from all. Files that are cut off, repeat a
/// time or belong to an abandoned branch are left out and counted. Links of rigid bodies (beams without a number) are no elements;
/// rigid elements are active. Throws as FeFormat::read.
FeResult::Contents readRadiossRun(const RadiossRun& run, const Execution& execution);

}  // namespace rubble::io
