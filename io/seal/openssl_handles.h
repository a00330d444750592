#pragma once

#include <openssl/bio.h>
#include <openssl/evp.h>
#include <openssl/x509.h>

#include <memory>
#include <string>
#include <vector>

namespace rubble::io {

template <auto release>
struct OpensslRelease {
    template <class Handle>
    void operator()(Handle* handle) const {
        release(handle);
    }
};

using Bio = std::unique_ptr<BIO, OpensslRelease<&BIO_free_all>>;
using PublicKey = std::unique_ptr<EVP_PKEY, OpensslRelease<&EVP_PKEY_free>>;
using Certificate = std::unique_ptr<X509, OpensslRelease<&X509_free>>;
using CertificateStore = std::unique_ptr<X509_STORE, OpensslRelease<&X509_STORE_free>>;

/// A text to be read; it must outlive the handle.
Bio bioOf(const std::string& text);
/// What was written to a handle in memory.
std::string textOf(BIO* bio);
/// The certificates of a PEM text in their order; empty if there are none.
std::vector<Certificate> certificatesOf(const std::string& pem);
/// Trusted certificates of a file. Throws WorldError, ParseError (none in it).
CertificateStore trustedStore(const std::string& path, std::time_t at);
/// Why OpenSSL refused the last request, in its own words; clears them.
std::string opensslReason();

}  // namespace rubble::io
