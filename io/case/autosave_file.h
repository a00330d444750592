#pragma once

#include <string>

#include "core/scenario/case.h"

namespace rubble::io {

/// A case with changes that were not saved, as it is kept until they are.
struct AutosavedCase {
    std::string path;     ///< of the case file, absolute; empty for one that was never saved
    std::string base;     ///< what its inputs are relative to, absolute
    std::string savedAt;  ///< UTC, "2024-05-31T08:15:30Z"
    Case theCase;
    friend bool operator==(const AutosavedCase&, const AutosavedCase&) = default;
};

/// Writes it atomically, and the folder if it is not there. Throws WorldError, UsageError; an older file is then unchanged.
void writeAutosave(const std::string& file, const AutosavedCase& autosaved);

/// Throws WorldError, ParseError naming the file and the place.
AutosavedCase readAutosave(const std::string& file);

}  // namespace rubble::io
