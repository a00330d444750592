#pragma once

#include <QSize>
#include <string>

namespace rubble::cli {

/// The pixels that --size asks for. Throws UsageError for text that is not WIDTHxHEIGHT, each from 100 to 8000.
QSize parsePictureSize(const std::string& text);

/// Lets Qt speak on stderr, but for its remark on a variable that a program without windows does not need.
void quietQt();

}  // namespace rubble::cli
