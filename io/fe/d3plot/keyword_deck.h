#pragma once

#include <cstdint>
#include <map>
#include <string>

namespace rubble::io {

/// What the keyword deck of an analysis says about a part, in the units of the deck; NaN where it does not say.
struct KeywordPart {
    double density = 0.0;
    double thickness = 0.0;  ///< of shells
    double area = 0.0;       ///< of beams
};

/// The keyword deck beside a d3plot: the one file in its folder that ends in .k, .key or .dyn and begins as a deck does; empty if
/// there is none, or more than one.
std::string keywordDeckBeside(const std::string& root);

/// Reads *PART, *MAT_..., *SECTION_SHELL and *SECTION_BEAM in cards of fixed or comma-separated fields, and follows *INCLUDE; by
/// the number of the part. Decks in the long format, and what is not understood, are left out.
std::map<std::int64_t, KeywordPart> readKeywordDeck(const std::string& path);

}  // namespace rubble::io
