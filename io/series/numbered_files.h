#pragma once

#include <string>
#include <vector>

namespace rubble::io {

/// The files that differ from this one only in a number, by that number; the file alone if there is none. The number may stand
/// before the ending (s001.vtu) or be the ending (out.vtk.1).
std::vector<std::string> numberedSiblings(const std::string& path);

/// The regular files of the folder that a path lies in, each as it would be given beside that path, sorted. Never throws.
std::vector<std::string> filesBeside(const std::string& path);

}  // namespace rubble::io
