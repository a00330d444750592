#pragma once

#include <map>
#include <nlohmann/json_fwd.hpp>
#include <string>
#include <vector>

#include "core/scenario/journal.h"
#include "io/json/json_cursor.h"

namespace rubble::io {

/// Everything that a case document says, by place: JSON of each value. Lists whose members have an id are kept by it, so that a
/// member keeps its place when another goes.
std::map<std::string, std::string> casePlaces(const nlohmann::json& document);
/// What a journal says that the case is: all its changes in their order.
std::map<std::string, std::string> journalPlaces(const Journal& journal);
/// In the order of the places.
std::vector<JournalChange> placeChanges(const std::map<std::string, std::string>& before,
                                        const std::map<std::string, std::string>& after);

/// Adds what has changed since the last entry, by whoever runs this program, now. Nothing if nothing has.
void continueJournal(Journal& journal, const nlohmann::json& document);
/// Adds what was changed in the file without Rubble, if anything was; a journal without entries stays so.
void noteOutsideChanges(Journal& journal, const nlohmann::json& document);

nlohmann::json journalJson(const Journal& journal);
/// Throws ParseError with the place.
Journal journalFromJson(const JsonCursor& list);

}  // namespace rubble::io
