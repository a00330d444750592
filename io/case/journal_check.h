#pragma once

#include <cstddef>
#include <string>
#include <vector>

#include "core/scenario/journal.h"

namespace rubble::io {

/// What comes of holding a case file against its journal.
struct JournalCheck {
    std::size_t entries = 0;
    std::vector<std::size_t> broken;     ///< entries, from 1, that are not what was written, or miss the one before
    std::vector<JournalChange> altered;  ///< places where the file says something else than the journal: `after` is the file
    std::vector<JournalEntry> outside;   ///< earlier alterations, taken over when the case was saved again
    std::vector<std::size_t> backward;   ///< entries, from 1, of a time before that of an earlier one: a clock was set back
    std::string head;                    ///< digest of the last entry, hex; empty: there is none
    std::string last;                    ///< UTC, the latest time of all entries; empty: there is none

    bool sound() const { return broken.empty() && altered.empty(); }
};
/// Throws WorldError, ParseError as loadCase().
JournalCheck checkJournal(const std::string& casePath);
/// The same of the text of a case file. @param name  what to call it in errors
JournalCheck checkJournalText(const std::string& text, const std::string& name);

}  // namespace rubble::io
