#pragma once

#include <string>
#include <string_view>

namespace rubble {

/// Path of a file of the source tree: sourcePath("resources/samples/rc-arch.exo"). Nothing: the tree itself.
std::string sourcePath(std::string_view relative = {});
/// Path of a file of the build folder.
std::string buildPath(std::string_view relative = {});

}  // namespace rubble
