#pragma once

#include <string>
#include <vector>

#include "core/base/execution.h"
#include "core/validation/validation_set.h"

namespace rubble::io {

/// Where the sets lie that come with the program: beside it, wherever that was installed.
std::string shippedSets();

/// A set that can be read: the folder of its tables, and the file that says what they mean.
struct SetPlace {
    std::string id;
    std::string folder;
    std::string definition;  ///< set.json of the folder, or of the shipped set whose tables lie there
};

/// The sets in a folder: itself, if it holds one, else those in its folders, by name. A folder without set.json whose tables are
/// named as those of a shipped set is such a set. Throws WorldError (no folder), UsageError (no set in it).
std::vector<SetPlace> setsIn(const std::string& folder);

/// Reads a set: what set.json says (the manual has its keys), its tables, its terrain. A set without README, orientations that were
/// not measured and places that lie far from the terrain are counted findings.
/// Throws WorldError (a file that cannot be read), ParseError (no licence; set.json is not what it should be; as bodyTableOf();
/// bodies outside the terrain or, unless the set lifts them, below it), Cancelled.
ValidationSet readSet(const SetPlace& place, const Execution& execution);

}  // namespace rubble::io
