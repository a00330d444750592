#pragma once

#include <string>
#include <vector>

#include "app/cli/frame/arguments.h"
#include "app/cli/frame/json_output.h"
#include "io/seal/seal_check.h"
#include "io/seal/signature.h"

namespace rubble::cli {

/// --key, --certificate and --passphrase-file.
std::vector<Option> signerOptions();
/// What they say. Throws WorldError if the passphrase cannot be read.
io::SignerFiles signerOf(const Arguments& arguments);

/// Where a longer bundle goes: --out, else in place of the bundle.
std::string longerBundle(const Arguments& arguments);
Option longerBundleOption();

/// [{place, what}]
Json faultsJson(const std::vector<io::SealFault>& faults);
/// One object for each entry after the sealing.
Json recordsJson(const io::SealCheck& check);
/// The entries in words, one row each.
void printRecords(std::ostream& out, const io::SealCheck& check);

}  // namespace rubble::cli
