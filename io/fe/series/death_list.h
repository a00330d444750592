#pragma once

#include <cstdint>
#include <string>
#include <vector>

#include "core/base/finding.h"
#include "core/fe/activity.h"
#include "core/fe/mesh.h"
#include "core/fe/units.h"

namespace rubble::io {

/// One line of a list of deaths: from this time on the element is dead (or active again).
struct DeathEntry {
    std::int64_t element = 0;  ///< user's number
    double time = 0.0;         ///< s, on the file's clock
    bool active = false;       ///< true: it comes back
};

/// The list of deaths that stands beside a result which does not tell them: RESULT.deaths.csv, empty if there is none. A table (see
/// DelimitedTable) of "element,time" or "element,time,status" (status 0 dead, 1 active). A first line of names is passed over;
/// where it names element and time, columns may come in any order and there may be others. A unit in its heading of the times, as
/// in "time [ms]", is obeyed.
std::string deathListBeside(const std::string& path);
/// Reads one. Entries come in the order of time. Throws WorldError, ParseError (line by number, unit that is not known).
std::vector<DeathEntry> readDeathList(const std::string& path);

/// Applies a list to elements that are all active, and says so. Numbers that no element has, and those that several have, are
/// counted.
/// @param times      s, of the states  @param activity  [states x elements]
/// @param deathTime  exact times by the list [elements]; made where it is empty
/// Throws as readDeathList(). @return how activity was decided: "wall.rst.deaths.csv, a list of 2 deaths"
std::string applyDeathList(const std::string& path, const Mesh& mesh, const std::vector<double>& times, Activity& activity,
                           std::vector<double>& deathTime, Findings& findings);
/// Throws ParseError for a list whose heading names a unit, beside a result that does not count in seconds: they were compared.
void requireClockOfDeathList(const std::string& path, const FileUnits& units);
/// Counts a list beside a result that says itself which elements are dead.
void noteUnusedDeathList(const std::string& path, Findings& findings);

}  // namespace rubble::io
