#pragma once

#include <cstddef>
#include <string>
#include <string_view>

#include "core/base/finding.h"

namespace rubble::io {

/// Fingerprint, in hex, of the run that a file was made from by this program: by the provenance beside it (NAME.provenance.json).
/// Empty: there is none, it names no run, or it cannot be read.
std::string runBehind(const std::string& path);

/// The same by the provenance inside a figure or a picture.
std::string runWithin(const std::string& path);

/// Digits of a fingerprint in hex.
inline constexpr std::size_t fingerprintDigits = 32;
/// A fingerprint that stands in a file, if it is one; else empty.
std::string fingerprintOf(std::string_view text);

/// Adds that a file taken as evidence shows a simulated run. Nothing where it does not.
/// @param behind  fingerprint of the run that the file shows, hex; empty: it shows none
/// @param held    that of the run that it is held against, hex; empty: not known, or none
void noteRunBehind(Findings& findings, const std::string& path, const std::string& behind, const std::string& held);

}  // namespace rubble::io
