#pragma once

#include <cstdint>
#include <string>
#include <vector>

#include "core/base/finding.h"
#include "core/fe/fe_result.h"

namespace rubble::io {

/// What a copy says in words: what it was made from, and what was found then.
struct CopyAbout {
    std::string format;              ///< of the original: "LS-DYNA d3plot"
    std::string path;                ///< of the original, then
    std::vector<std::string> files;  ///< of its series
    std::uint64_t bytes = 0;         ///< of all of them
    std::string sha256;              ///< of the original, as in FeResult::Contents
    std::string activityFrom;
    std::string build;  ///< of the program that wrote it
    bool hasVelocity = false;
    FileUnits units;  ///< that the original was taken to count in
    Frame frame;      ///< that it was brought into
    std::string unitsFrom;
    std::vector<Part> parts;
    Findings findings;
};

/// As JSON text. A copy of a copy tells of the copy.
std::string aboutText(const FeResult& fe);
/// Throws ParseError. @param path  of the copy
CopyAbout aboutFromText(const std::string& text, const std::string& path);

}  // namespace rubble::io
