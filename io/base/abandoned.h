#pragma once

#include <string>

namespace rubble::io {

/// Takes away what processes that were killed while they wrote a file left beside it: what is called as unfinishedName() says and
/// was not written to for ten minutes. What cannot be removed stays.
void removeAbandoned(const std::string& path);

}  // namespace rubble::io
