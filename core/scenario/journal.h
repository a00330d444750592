#pragma once

#include <string>
#include <vector>

namespace rubble {

/// One thing in a case that became another.
struct JournalChange {
    std::string place;   ///< "scenarios/scenario-1/settings/friction"
    std::string before;  ///< JSON; empty: it was not there
    std::string after;   ///< JSON; empty: it is not there any more
    friend bool operator==(const JournalChange&, const JournalChange&) = default;
};

/// What was changed in a case when it was saved.
struct JournalEntry {
    std::string when;      ///< UTC, "2024-05-31T08:15:30Z"; empty: not known
    std::string who;       ///< user of the machine; empty: not known
    std::string program;   ///< version that wrote it; empty: none
    bool outside = false;  ///< found when the case was opened: somebody changed the file without Rubble
    std::vector<JournalChange> changes;
    std::string digest;  ///< SHA-256 of the entry and of the digest before it, hex
};

/// Who changed what in a case and when, from its first saving on. The digests make a chain: no entry can be altered without all
/// later ones.
struct Journal {
    std::vector<JournalEntry> entries;
    /// Two cases are equal if they say the same, whatever way they came to it.
    friend bool operator==(const Journal&, const Journal&) { return true; }
};

}  // namespace rubble
