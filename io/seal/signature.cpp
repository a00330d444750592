#include "io/seal/signature.h"

#include <openssl/err.h>
#include <openssl/pem.h>
#include <openssl/x509v3.h>

#include <algorithm>
#include <cctype>
#include <filesystem>

#include "core/base/error.h"
#include "core/base/small_letters.h"
#include "io/base/files.h"
#include "io/base/sha256.h"
#include "io/seal/openssl_handles.h"

namespace rubble::io {

Bio bioOf(const std::string& text) {
    return Bio(BIO_new_mem_buf(text.data(), static_cast<int>(text.size())));
}

std::string textOf(BIO* bio) {
    char* data = nullptr;
    const long size = BIO_get_mem_data(bio, &data);
    return size > 0 ? std::string(data, static_cast<std::size_t>(size)) : std::string();
}

std::vector<Certificate> certificatesOf(const std::string& pem) {
    std::vector<Certificate> list;
    const Bio bio = bioOf(pem);
    while (X509* next = PEM_read_bio_X509(bio.get(), nullptr, nullptr, nullptr)) {
        list.emplace_back(next);
    }
    ERR_clear_error();
    return list;
}

std::string opensslReason() {
    const unsigned long error = ERR_get_error();
    const char* reason = error != 0 ? ERR_reason_error_string(error) : nullptr;
    ERR_clear_error();
    return reason != nullptr ? reason : "unknown reason";
}

namespace {

constexpr int weakestRsa = 2048;

std::string fileText(const std::string& path) {
    if (std::error_code ignored; std::filesystem::is_regular_file(path, ignored)) {
        if (std::optional<std::string> content = contentOf(path)) {
            return *content;
        }
    }
    throw WorldError(Message{"io.seal.key_unreadable", "The key or certificate {0} cannot be read", {path}},
                     Message{"io.seal.key_unreadable.remedy", "Check that the file exists and that you may read it.", {}});
}

struct Passphrase {
    std::string text;
    bool asked = false;
};

int givePassphrase(char* buffer, int size, int, void* given) {
    Passphrase& passphrase = *static_cast<Passphrase*>(given);
    passphrase.asked = true;
    const int length = std::min(size, static_cast<int>(passphrase.text.size()));
    std::copy_n(passphrase.text.data(), length, buffer);
    return length > 0 ? length : -1;
}

std::shared_ptr<EVP_PKEY> readPrivateKey(const SignerFiles& files) {
    const std::string pem = fileText(files.key);
    Passphrase passphrase{files.passphrase};
    const Bio bio = bioOf(pem);
    std::shared_ptr<EVP_PKEY> key(PEM_read_bio_PrivateKey(bio.get(), nullptr, &givePassphrase, &passphrase), &EVP_PKEY_free);
    ERR_clear_error();
    if (key == nullptr && passphrase.asked) {
        throw ParseError(Message{"io.seal.passphrase", "{0} is protected by another passphrase than the one given", {files.key}},
                         Message{"io.seal.passphrase.remedy", "Give the passphrase of the key.", {}});
    }
    if (key == nullptr) {
        throw ParseError(
            Message{"io.seal.no_key", "{0} holds no private key in PEM", {files.key}},
            Message{"io.seal.no_key.remedy",
                    "Make one with: openssl genpkey -algorithm ed25519 -out KEY.pem; keep it where only you can read it.",
                    {}});
    }
    return key;
}

std::string derOf(EVP_PKEY* key) {
    unsigned char* der = nullptr;
    const int size = i2d_PUBKEY(key, &der);
    const std::string bytes = size > 0 ? std::string(reinterpret_cast<char*>(der), static_cast<std::size_t>(size)) : std::string();
    OPENSSL_free(der);
    return bytes;
}

/// The algorithm in words; empty: none that is taken.
std::string algorithmOf(EVP_PKEY* key) {
    switch (EVP_PKEY_get_base_id(key)) {
        case EVP_PKEY_ED25519:
            return "Ed25519";
        case EVP_PKEY_RSA:
            return EVP_PKEY_get_bits(key) >= weakestRsa ? "RSA with SHA-256" : "";
        case EVP_PKEY_EC:
            return EVP_PKEY_get_bits(key) >= 256 ? "ECDSA with SHA-256" : "";
        default:
            return "";
    }
}

const EVP_MD* digestOfKey(EVP_PKEY* key) {
    return EVP_PKEY_get_base_id(key) == EVP_PKEY_ED25519 ? nullptr : EVP_sha256();
}

std::time_t secondsOf(const ASN1_TIME* time) {
    std::tm parts{};
    ASN1_TIME_to_tm(time, &parts);
    return timegm(&parts);
}

std::string subjectOf(X509* certificate) {
    const Bio bio(BIO_new(BIO_s_mem()));
    X509_NAME_print_ex(bio.get(), X509_get_subject_name(certificate), 0, XN_FLAG_ONELINE & ~ASN1_STRFLGS_ESC_MSB);
    return textOf(bio.get());
}

SignerFacts factsOf(EVP_PKEY* key, X509* certificate) {
    SignerFacts facts{sha256OfText(derOf(key)), algorithmOf(key), {}, {}, {}};
    if (certificate != nullptr) {
        facts.subject = subjectOf(certificate);
        facts.validFrom = utcOfSeconds(secondsOf(X509_get0_notBefore(certificate)));
        facts.validTo = utcOfSeconds(secondsOf(X509_get0_notAfter(certificate)));
    }
    return facts;
}

/// A certificate that was not valid at an instant; empty: it was.
Message outsideValidity(const SignerFacts& facts, std::time_t at) {
    const std::optional<std::time_t> from = secondsOfUtc(facts.validFrom), to = secondsOfUtc(facts.validTo);
    if (from && at < *from) {
        return {"io.seal.certificate_early",
                "the certificate of {0} is valid from {1} only, and the time is {2}",
                {facts.subject, facts.validFrom, utcOfSeconds(at)}};
    }
    if (to && at > *to) {
        return {"io.seal.certificate_expired",
                "the certificate of {0} ended on {1}, and the time is {2}",
                {facts.subject, facts.validTo, utcOfSeconds(at)}};
    }
    return {};
}

PublicKey publicKeyOf(const std::string& pem) {
    const Bio bio = bioOf(pem);
    PublicKey key(PEM_read_bio_PUBKEY(bio.get(), nullptr, nullptr, nullptr));
    ERR_clear_error();
    return key;
}

/// Fingerprint of whom somebody expects, given as such or in a file.
std::string expectedFingerprint(const std::string& given) {
    const bool hex = given.size() == 64 && std::all_of(given.begin(), given.end(), [](char c) { return std::isxdigit(c) != 0; });
    if (hex) {
        return inSmallLetters(given);
    }
    const std::string pem = fileText(given);
    if (const PublicKey key = publicKeyOf(pem)) {
        return sha256OfText(derOf(key.get()));
    }
    if (const std::vector<Certificate> list = certificatesOf(pem); !list.empty()) {
        return sha256OfText(derOf(X509_get0_pubkey(list.front().get())));
    }
    throw ParseError(Message{"io.seal.no_public_key", "{0} holds neither a public key nor a certificate in PEM", {given}},
                     Message{"io.seal.no_public_key.remedy",
                             "Name the signer's public key, certificate, or the 64 figures of its fingerprint.",
                             {}});
}

bool holds(EVP_PKEY* key, std::string_view text, std::string_view signature) {
    const std::unique_ptr<EVP_MD_CTX, OpensslRelease<&EVP_MD_CTX_free>> context(EVP_MD_CTX_new());
    const bool good = EVP_DigestVerifyInit(context.get(), nullptr, digestOfKey(key), nullptr, key) == 1 &&
                      EVP_DigestVerify(context.get(), reinterpret_cast<const unsigned char*>(signature.data()), signature.size(),
                                       reinterpret_cast<const unsigned char*>(text.data()), text.size()) == 1;
    ERR_clear_error();
    return good;
}

/// Why nobody who is trusted vouches for a certificate; empty: somebody does.
std::string vouchingFault(const std::vector<Certificate>& list, const std::string& roots, std::time_t at) {
    const CertificateStore store = trustedStore(roots, at);
    STACK_OF(X509)* above = sk_X509_new_null();
    for (std::size_t i = 1; i < list.size(); ++i) {
        sk_X509_push(above, list[i].get());
    }
    const std::unique_ptr<X509_STORE_CTX, OpensslRelease<&X509_STORE_CTX_free>> context(X509_STORE_CTX_new());
    X509_STORE_CTX_init(context.get(), store.get(), list.front().get(), above);
    const bool good = X509_verify_cert(context.get()) == 1;
    const std::string reason = good ? "" : X509_verify_cert_error_string(X509_STORE_CTX_get_error(context.get()));
    sk_X509_free(above);
    ERR_clear_error();
    return reason;
}

void judgeCertificate(SignatureCheck& check, const std::vector<Certificate>& list, const TrustedSigners& trusted, std::time_t at) {
    if (list.empty()) {
        if (!check.keyExpected) {
            check.doubt = {"io.seal.key_alone",
                           "nobody vouches that the key {0} is the signer's: compare its fingerprint with one got another way",
                           {check.signer.fingerprint}};
        }
        return;
    }
    if (const Message outside = outsideValidity(check.signer, at); !outside.empty()) {
        check.fault = outside;
        return;
    }
    if (trusted.roots.empty()) {
        if (!check.keyExpected) {
            check.doubt = {"io.seal.no_roots",
                           "the certificate of {0} was not held against any that are trusted: none were given",
                           {check.signer.subject}};
        }
        return;
    }
    if (const std::string reason = vouchingFault(list, trusted.roots, at); !reason.empty()) {
        check.fault = {"io.seal.not_vouched",
                       "those who are trusted do not vouch for the certificate of {0}: {1}",
                       {check.signer.subject, reason}};
    }
}

}  // namespace

CertificateStore trustedStore(const std::string& path, std::time_t at) {
    const std::vector<Certificate> list = certificatesOf(fileText(path));
    if (list.empty()) {
        throw ParseError(Message{"io.seal.no_certificates", "{0} holds no certificate in PEM", {path}},
                         Message{"io.seal.no_certificates.remedy", "Name a file with the certificates that you trust.", {}});
    }
    CertificateStore store(X509_STORE_new());
    for (const Certificate& each : list) {
        X509_STORE_add_cert(store.get(), each.get());
    }
    // What was signed while a certificate was valid stays so after its end.
    X509_VERIFY_PARAM_set_time(X509_STORE_get0_param(store.get()), at);
    X509_STORE_set_purpose(store.get(), X509_PURPOSE_ANY);
    return store;
}

std::optional<std::time_t> secondsOfUtc(const std::string& utc) {
    std::tm parts{};
    const char* end = strptime(utc.c_str(), "%Y-%m-%dT%H:%M:%SZ", &parts);
    if (end == nullptr || *end != '\0') {
        return {};
    }
    return timegm(&parts);
}

std::string utcOfSeconds(std::time_t seconds) {
    std::tm parts{};
    gmtime_r(&seconds, &parts);
    char text[32];
    std::strftime(text, sizeof text, "%Y-%m-%dT%H:%M:%SZ", &parts);
    return text;
}

Signer::Signer(const SignerFiles& files) : m_key(readPrivateKey(files)) {
    if (algorithmOf(m_key.get()).empty()) {
        throw UsageError(Message{"io.seal.weak_key", "The key {0} is of a kind or size that is not taken", {files.key}},
                         Message{"io.seal.weak_key.remedy",
                                 "Take an Ed25519 key, RSA of 2048 bits or more, or an elliptic curve of 256 bits or more.",
                                 {}});
    }
    std::vector<Certificate> list;
    if (!files.certificate.empty()) {
        m_certificates = fileText(files.certificate);
        list = certificatesOf(m_certificates);
        if (list.empty()) {
            throw ParseError(Message{"io.seal.no_certificates", "{0} holds no certificate in PEM", {files.certificate}},
                             Message{"io.seal.no_certificate.remedy", "Name the signer's certificate, or leave it out.", {}});
        }
        if (X509_check_private_key(list.front().get(), m_key.get()) != 1) {
            ERR_clear_error();
            throw UsageError(
                Message{"io.seal.other_key", "The first certificate of {0} is not of the key {1}", {files.certificate, files.key}},
                Message{"io.seal.other_key.remedy", "Name the key and the certificate of one signer.", {}});
        }
    }
    m_facts = factsOf(m_key.get(), list.empty() ? nullptr : list.front().get());
    if (list.empty()) {
        return;
    }
    if (const Message outside = outsideValidity(m_facts, std::time(nullptr)); !outside.empty()) {
        throw UsageError(outside, Message{"io.seal.certificate_expired.remedy",
                                          "Use a certificate that is valid now, or set the clock of this machine.",
                                          {}});
    }
}

std::string Signer::sign(std::string_view text) const {
    const std::unique_ptr<EVP_MD_CTX, OpensslRelease<&EVP_MD_CTX_free>> context(EVP_MD_CTX_new());
    std::size_t size = 0;
    const auto* bytes = reinterpret_cast<const unsigned char*>(text.data());
    std::string signature;
    if (EVP_DigestSignInit(context.get(), nullptr, digestOfKey(m_key.get()), nullptr, m_key.get()) == 1 &&
        EVP_DigestSign(context.get(), nullptr, &size, bytes, text.size()) == 1) {
        signature.resize(size);
        if (EVP_DigestSign(context.get(), reinterpret_cast<unsigned char*>(signature.data()), &size, bytes, text.size()) == 1) {
            signature.resize(size);
            return signature;
        }
    }
    throw WorldError(Message{"io.seal.not_signed", "OpenSSL does not sign with this key: {0}", {opensslReason()}},
                     Message{"io.seal.not_signed.remedy", "Use another key.", {}});
}

std::string Signer::publicKey() const {
    const Bio bio(BIO_new(BIO_s_mem()));
    PEM_write_bio_PUBKEY(bio.get(), m_key.get());
    return textOf(bio.get());
}

SignatureCheck verifySignature(std::string_view text, std::string_view signature, const std::string& publicKey,
                               const std::string& certificates, const TrustedSigners& trusted, std::time_t at) {
    SignatureCheck check;
    const std::string expected = trusted.expected.empty() ? std::string() : expectedFingerprint(trusted.expected);
    const PublicKey key = publicKeyOf(publicKey);
    const std::vector<Certificate> list = certificatesOf(certificates);
    if (key == nullptr || algorithmOf(key.get()).empty() || (list.empty() && !certificates.empty())) {
        check.fault = {"io.seal.key_damaged", "the public key or the certificate beside the signature is damaged", {}};
        return check;
    }
    check.signer = factsOf(key.get(), list.empty() ? nullptr : list.front().get());
    if (!list.empty() && EVP_PKEY_eq(X509_get0_pubkey(list.front().get()), key.get()) != 1) {
        check.fault = {"io.seal.certificate_other", "the certificate beside the signature is of another key", {}};
        return check;
    }
    if (!holds(key.get(), text, signature)) {
        check.fault = {"io.seal.signature_broken",
                       "the signature does not hold: the text is not what the key {0} signed",
                       {check.signer.fingerprint}};
        return check;
    }
    check.matches = true;
    check.keyExpected = !expected.empty() && expected == check.signer.fingerprint;
    if (!expected.empty() && !check.keyExpected) {
        check.fault = {
            "io.seal.other_signer", "signed by the key {0}, not by the one expected, {1}", {check.signer.fingerprint, expected}};
        return check;
    }
    judgeCertificate(check, list, trusted, at);
    return check;
}

}  // namespace rubble::io
