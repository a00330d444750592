#pragma once

#include <ctime>
#include <memory>
#include <optional>
#include <string>
#include <string_view>

#include "core/base/message.h"

struct evp_pkey_st;

namespace rubble::io {

/// Where the key of a signer lies.
struct SignerFiles {
    std::string key;          ///< private key in PEM: Ed25519, RSA of 2048 bits or more, or an elliptic curve
    std::string certificate;  ///< X.509 in PEM, the signer's own first and those above it after it; empty: the key alone
    std::string passphrase;   ///< of the key; empty: it has none
};

/// What a signature says of its signer.
struct SignerFacts {
    std::string fingerprint;  ///< SHA-256 of the public key (DER of SubjectPublicKeyInfo), hex
    std::string algorithm;    ///< "Ed25519", "RSA with SHA-256", "ECDSA with SHA-256"
    std::string subject;      ///< of the certificate; empty: there is none
    std::string validFrom;    ///< UTC, of the certificate
    std::string validTo;
};

/// A private key, and the certificate of it if there is one.
class Signer {
public:
    /// Throws WorldError (cannot be read), ParseError (no key, wrong passphrase), UsageError (a weak key, a certificate of another
    /// key, or one that is not valid now), each with the remedy.
    explicit Signer(const SignerFiles& files);

    const SignerFacts& facts() const { return m_facts; }
    /// Of a text, in the form that openssl pkeyutl -rawin verifies.
    std::string sign(std::string_view text) const;
    std::string publicKey() const;  ///< PEM
    /// PEM, with those above it; empty: the key alone.
    const std::string& certificates() const { return m_certificates; }

private:
    std::shared_ptr<evp_pkey_st> m_key;
    std::string m_certificates;
    SignerFacts m_facts;
};

/// What is known of a signature.
struct SignatureCheck {
    bool matches = false;  ///< the text is what was signed by the key that lies beside it
    SignerFacts signer;
    Message fault;             ///< why it does not hold; empty: it does
    Message doubt;             ///< nobody vouches for the signer; empty: somebody does
    bool keyExpected = false;  ///< the key is the one that was asked for
};

/// Who is trusted, in files.
struct TrustedSigners {
    std::string roots;     ///< certificates in PEM that vouch for the signer's; empty: none
    std::string expected;  ///< public key or certificate in PEM, or its fingerprint; empty: any
};

/// @param publicKey     PEM as it lies beside the signature
/// @param certificates  PEM as it lies there; empty: none
/// @param at            when the certificate must have been valid
/// Throws WorldError, ParseError for what is trusted; never for what is verified.
SignatureCheck verifySignature(std::string_view text, std::string_view signature, const std::string& publicKey,
                               const std::string& certificates, const TrustedSigners& trusted, std::time_t at);

/// UTC as utcNow() writes it in seconds since 1970; nothing if it is none.
std::optional<std::time_t> secondsOfUtc(const std::string& utc);
std::string utcOfSeconds(std::time_t seconds);

}  // namespace rubble::io
