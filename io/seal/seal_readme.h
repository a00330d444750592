#pragma once

#include <string>
#include <string_view>

#include "io/seal/seal_statement.h"

namespace rubble::io {

/// What a reader without the program needs to check a bundle: its layout, and commands of sha256sum and openssl, in English and
/// Chinese.
std::string sealReadme(const SealStatement& statement);
/// Which program made it, and how another gets the same.
std::string buildReadme(const SealStatement& statement);

/// Commit of the sources of this program; empty in builds for development and of sources without history.
std::string_view commitText();

/// The same as resources/sealed has them: places for what is put in are {{name}}.
std::string_view sealReadmeFrame();
std::string_view buildReadmeFrame();

}  // namespace rubble::io
