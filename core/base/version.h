#pragma once

/// Version of the headers. A program that compares it with versionText() notices that it was built against other ones than it runs
/// with. Before 1.0 a change of the minor version may change the interface; a change of the patch never does.
#define RUBBLE_VERSION_MAJOR 0
#define RUBBLE_VERSION_MINOR 2
#define RUBBLE_VERSION_PATCH 0

namespace rubble {

/// The same as one number, for comparisons: 200 for 0.2.0.
inline constexpr int headerVersion = RUBBLE_VERSION_MAJOR * 10000 + RUBBLE_VERSION_MINOR * 100 + RUBBLE_VERSION_PATCH;

}  // namespace rubble
