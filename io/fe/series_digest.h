#pragma once

#include <string>
#include <vector>

#include "core/base/execution.h"

namespace rubble::io {

/// What names the content of a series: the SHA-256 of its file, or of a list of all its files as sha256sum writes it (digest, two
/// blanks, name without folder, newline), hex. Files are read side by side on the threads of the execution; the digest does not
/// depend on their number. Throws WorldError, Cancelled.
std::string sha256OfSeries(const std::vector<std::string>& files, const Execution& execution);
/// The same of files whose digests are known. @param digests  [files]
std::string sha256OfList(const std::vector<std::string>& files, const std::vector<std::string>& digests);

}  // namespace rubble::io
