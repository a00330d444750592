#pragma once

#include <string_view>

namespace rubble {

/// Version of the program, as in the changelog: "0.2.0".
std::string_view versionText();

/// Names what can change a result bit for bit: program version, the sources of core and io that make results (without comments),
/// compiler, word size and flags of this build.
/// Part of every fingerprint.
std::string_view buildText();

/// What people need of such a text: program and sources, "Rubble 0.2.0, sources 1a2b3c4d".
std::string_view shortBuild(std::string_view build);

}  // namespace rubble
