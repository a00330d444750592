#pragma once

#include <string>

namespace rubble {

/// A number so that it reads back to the same bits, with a point as decimal sign; empty if it is not finite.
std::string exactNumber(double number);

/// A field of a table as RFC 4180 has it: quoted where it must be.
std::string csvField(const std::string& text);

}  // namespace rubble
