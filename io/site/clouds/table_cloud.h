#pragma once

#include <memory>
#include <string>

#include "io/site/clouds/cloud_source.h"

namespace rubble::io {

/// Opens points that are text: PTX, PTS, or a table whose columns a heading or the request names. A table of neither has x, y and z
/// first, which is a finding. Throws WorldError, ParseError (no text, no such columns), UsageError (a column that is not known).
std::unique_ptr<CloudSource> openTextCloud(const std::string& path, const CloudRequest& request);

}  // namespace rubble::io
