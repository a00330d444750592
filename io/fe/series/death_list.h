#pragma once

#include <cstdint>
#include <string>
#include <vector>

#include "core/base/finding.h"

namespace rubble::io {

/// One line of a list of deaths: from this time on the element is dead (or active again).
struct DeathEntry {
    std::int64_t element = 0;  ///< user's number
    double time = 0.0;         ///< s, on the file's clock
    bool active = false;       ///< true: it comes back
};

/// The list of deaths that stands beside a result which does not tell them: RESULT.deaths.csv, empty if there is none. Lines
/// "element,time" or "element,time,status" (status 0 dead, 1 active); a first line of names, empty lines and lines that begin with
/// # are passed over; semicolons and blanks part the fields as well.
std::string deathListBeside(const std::string& path);
/// Reads one. Entries come in the order of time. Throws WorldError, ParseError (line by number).
std::vector<DeathEntry> readDeathList(const std::string& path);

}  // namespace rubble::io
