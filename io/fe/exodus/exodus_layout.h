#pragma once

#include <cstddef>
#include <string>

namespace rubble::io {

/// Checks that a file is whole and that everything in it which the Exodus library will be asked for has the shape that it should
/// have. The library trusts the file: without this a damaged one would give zeros, or write past its buffers.
/// @return  how many of the last states are not whole: of a classic file that is cut off behind its first state
/// Throws WorldError (cannot be read), ParseError (cut off, no Exodus II, two-dimensional is not judged here).
std::size_t checkExodusLayout(const std::string& path);

}  // namespace rubble::io
