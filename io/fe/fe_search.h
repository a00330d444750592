#pragma once

#include <cstdint>
#include <string>
#include <vector>

#include "io/fe/fe_format.h"

namespace rubble::io {

/// A result that was found: its format and its files.
struct FoundFe {
    const FeFormat* format = nullptr;  ///< null: no FE result
    std::vector<std::string> files;
    std::vector<std::string> others;  ///< further results in the folder, by their first file
};

/// The result that a path means: a file, any file of a series, or a folder that holds one. Throws WorldError (cannot be read, a
/// folder with none or several), ParseError (no FE result).
/// @param alone  a file by itself, without the others of its series
FoundFe findFe(const std::string& path, bool alone);
/// The same result with one file of its series.
FoundFe onlyFile(FoundFe found, const std::string& path);
/// The result that a file belongs to: by its own content, else as a member of a series whose first file is recognised. Without
/// format where it belongs to none.
FoundFe findFeAt(const std::string& path, const FileHead& head);

/// Counts that the file which was given is a piece of the result that was found.
void notePiece(const FoundFe& found, const std::string& path, Findings& findings);

/// Names the content of a result as it is opened: files, settings, and the frame and units that were decided on, so that it is
/// known again once the decision is recorded.
Digest feFingerprint(const FeFormat& format, const std::string& sha256, const ImportSettings& settings, const Frame& frame,
                     const FileUnits& units);

}  // namespace rubble::io
