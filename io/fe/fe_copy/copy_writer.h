#pragma once

#include <string>

#include "core/base/execution.h"
#include "core/base/geometry.h"
#include "core/fe/fe_result.h"

namespace rubble::io {

/// Writes a result as a copy that opens at once (copy_layout.h): compressed without loss, every state by itself, with digests of
/// the tables and of each state.
/// @param path    does not exist yet; what is there after an error is not whole
/// @param offset  added to all places, m
/// Throws WorldError, ParseError (a state cannot be read), Cancelled.
void writeFeCopy(const std::string& path, const FeResult& fe, const Vec3& offset, const Execution& execution);

}  // namespace rubble::io
