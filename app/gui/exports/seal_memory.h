#pragma once

#include <exception>

#include "io/seal/signature.h"
#include "widgets/evidence/sealing/bundle_content.h"
#include "widgets/evidence/sealing/seal_dialog.h"

namespace rubble {

/// Who signed last, for this user: names and paths alone, never a passphrase.
widgets::SignerChoice rememberedSigner();
void rememberSigner(const widgets::SignerChoice& signer);

/// The certificates that this user trusts.
widgets::BundleTrust rememberedTrust();
void rememberTrust(const widgets::BundleTrust& trust);

/// Files of a signer as they are read.
io::SignerFiles signerFiles(const widgets::SignerChoice& signer);

/// What an exception says against something; nothing for null and Cancelled.
widgets::SealObjection objectionOf(const std::exception_ptr& thrown);

}  // namespace rubble
