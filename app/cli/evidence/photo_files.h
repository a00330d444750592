#pragma once

#include "app/cli/frame/arguments.h"
#include "app/cli/frame/json_output.h"
#include "app/cli/frame/session.h"
#include "core/scenario/photograph.h"

namespace rubble::cli {

/// What the file of a photograph says, with the keys of the manual.
Json photoFactsJson(const PhotoFacts& facts);

/// rubble-cli photo add CASE PHOTO...: all of them, or none and an error.
ExitCode addPhotos(const Arguments& arguments, Session& session);
/// rubble-cli photo facts PHOTO...
ExitCode tellPhotoFacts(const Arguments& arguments, Session& session);

}  // namespace rubble::cli
