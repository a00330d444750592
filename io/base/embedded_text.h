#pragma once

#include <string>

namespace rubble::io {

/// Keyword of the text chunk of a PNG that holds the provenance.
inline constexpr const char* provenanceKeyword = "Rubble-Provenance";
/// What the JSON of a provenance begins with, wherever it stands.
inline constexpr const char* provenanceStart = "{\"rubble_provenance\":";

/// The JSON object of a provenance inside a file: from the text chunks of a PNG, else the first that stands in the file as it is
/// (SVG, PDF, MP4, JSON). Empty if there is none. Throws WorldError if the file cannot be read.
std::string embeddedProvenance(const std::string& path);

}  // namespace rubble::io
