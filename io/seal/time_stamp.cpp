#include "io/seal/time_stamp.h"

#include <openssl/err.h>
#include <openssl/pkcs7.h>
#include <openssl/rand.h>
#include <openssl/ts.h>

#include <array>

#include "core/base/error.h"
#include "io/base/sha256.h"
#include "io/seal/openssl_handles.h"
#include "io/seal/signature.h"

namespace rubble::io {

namespace {

using StampRequest = std::unique_ptr<TS_REQ, OpensslRelease<&TS_REQ_free>>;
using StampAnswer = std::unique_ptr<TS_RESP, OpensslRelease<&TS_RESP_free>>;

std::string sha256Bytes(const std::string& content) {
    std::array<unsigned char, EVP_MAX_MD_SIZE> digest{};
    unsigned size = 0;
    EVP_Digest(content.data(), content.size(), digest.data(), &size, EVP_sha256(), nullptr);
    return {reinterpret_cast<const char*>(digest.data()), size};
}

template <class Value, class Read>
Value* readDer(const std::string& der, Read read) {
    const auto* at = reinterpret_cast<const unsigned char*>(der.data());
    Value* const value = read(nullptr, &at, static_cast<long>(der.size()));
    ERR_clear_error();
    // Bytes behind the end belong to nothing that was signed.
    const bool whole = value != nullptr && at == reinterpret_cast<const unsigned char*>(der.data()) + der.size();
    return whole ? value : nullptr;
}

[[noreturn]] void failRequest() {
    throw WorldError(Message{"io.seal.stamp_request", "OpenSSL makes no request for a time stamp: {0}", {opensslReason()}},
                     Message{"io.seal.stamp_request.remedy", "Seal without a time stamp.", {}});
}

/// SHA-256 that a stamp or a request is about; empty: of another kind.
std::string imprintOf(TS_MSG_IMPRINT* imprint) {
    ASN1_OBJECT* const algorithm = TS_MSG_IMPRINT_get_algo(imprint)->algorithm;
    if (OBJ_obj2nid(algorithm) != NID_sha256) {
        return {};
    }
    const ASN1_OCTET_STRING* digest = TS_MSG_IMPRINT_get_msg(imprint);
    return {reinterpret_cast<const char*>(ASN1_STRING_get0_data(digest)), static_cast<std::size_t>(ASN1_STRING_length(digest))};
}

std::time_t timeOf(const TS_TST_INFO* info) {
    std::tm parts{};
    ASN1_TIME_to_tm(TS_TST_INFO_get_time(info), &parts);
    return timegm(&parts);
}

std::string serviceOf(PKCS7* token) {
    STACK_OF(X509)* const signers = PKCS7_get0_signers(token, nullptr, 0);
    std::string name;
    if (signers != nullptr && sk_X509_num(signers) > 0) {
        const Bio bio(BIO_new(BIO_s_mem()));
        X509_NAME_print_ex(bio.get(), X509_get_subject_name(sk_X509_value(signers, 0)), 0, XN_FLAG_ONELINE & ~ASN1_STRFLGS_ESC_MSB);
        name = textOf(bio.get());
    }
    sk_X509_free(signers);
    ERR_clear_error();
    return name;
}

/// The signature of the answer, by the certificates that it brings.
bool signatureHolds(PKCS7* token) {
    const bool good = PKCS7_verify(token, nullptr, nullptr, nullptr, nullptr, PKCS7_NOVERIFY) == 1;
    ERR_clear_error();
    return good;
}

/// Why those who are trusted do not vouch for the service; empty: they do.
std::string vouchingFault(PKCS7* token, const std::string& roots, std::time_t at) {
    const CertificateStore store = trustedStore(roots, at);
    X509_STORE_set_purpose(store.get(), X509_PURPOSE_TIMESTAMP_SIGN);
    const bool good = TS_RESP_verify_signature(token, nullptr, store.get(), nullptr) == 1;
    return good ? std::string() : opensslReason();
}

Message faultOfRequest(TS_TST_INFO* info, const std::string& request) {
    if (request.empty()) {
        return {};
    }
    const StampRequest asked(readDer<TS_REQ>(request, &d2i_TS_REQ));
    if (asked == nullptr) {
        return {"io.seal.request_damaged", "the request for the time stamp is damaged", {}};
    }
    const ASN1_INTEGER* wanted = TS_REQ_get_nonce(asked.get());
    const ASN1_INTEGER* given = TS_TST_INFO_get_nonce(info);
    if (wanted != nullptr && (given == nullptr || ASN1_INTEGER_cmp(wanted, given) != 0)) {
        return {"io.seal.stamp_unasked", "the time stamp answers another request than the one that lies beside it", {}};
    }
    return {};
}

}  // namespace

std::string timeStampRequest(const std::string& content) {
    const StampRequest request(TS_REQ_new());
    const std::unique_ptr<TS_MSG_IMPRINT, OpensslRelease<&TS_MSG_IMPRINT_free>> imprint(TS_MSG_IMPRINT_new());
    const std::unique_ptr<X509_ALGOR, OpensslRelease<&X509_ALGOR_free>> algorithm(X509_ALGOR_new());
    const std::unique_ptr<ASN1_INTEGER, OpensslRelease<&ASN1_INTEGER_free>> once(ASN1_INTEGER_new());
    std::string digest = sha256Bytes(content);
    std::uint64_t number = 0;
    if (RAND_bytes(reinterpret_cast<unsigned char*>(&number), sizeof number) != 1) {
        failRequest();
    }
    X509_ALGOR_set0(algorithm.get(), OBJ_nid2obj(NID_sha256), V_ASN1_NULL, nullptr);
    ASN1_INTEGER_set_uint64(once.get(), number >> 1);
    if (TS_REQ_set_version(request.get(), 1) != 1 || TS_MSG_IMPRINT_set_algo(imprint.get(), algorithm.get()) != 1 ||
        TS_MSG_IMPRINT_set_msg(imprint.get(), reinterpret_cast<unsigned char*>(digest.data()), static_cast<int>(digest.size())) !=
            1 ||
        TS_REQ_set_msg_imprint(request.get(), imprint.get()) != 1 || TS_REQ_set_nonce(request.get(), once.get()) != 1 ||
        TS_REQ_set_cert_req(request.get(), 1) != 1) {
        failRequest();
    }
    unsigned char* der = nullptr;
    const int size = i2d_TS_REQ(request.get(), &der);
    if (size <= 0) {
        failRequest();
    }
    std::string bytes(reinterpret_cast<char*>(der), static_cast<std::size_t>(size));
    OPENSSL_free(der);
    return bytes;
}

bool isRequestFor(const std::string& request, const std::string& content) {
    const StampRequest asked(readDer<TS_REQ>(request, &d2i_TS_REQ));
    return asked != nullptr && imprintOf(TS_REQ_get_msg_imprint(asked.get())) == sha256Bytes(content);
}

StampCheck checkTimeStamp(const std::string& answer, const std::string& request, const std::string& content,
                          const std::string& roots) {
    StampCheck check;
    const StampAnswer stamp(readDer<TS_RESP>(answer, &d2i_TS_RESP));
    if (stamp == nullptr) {
        check.fault = {
            "io.seal.stamp_damaged", "the time stamp is damaged, or no answer of a time-stamping service (RFC 3161)", {}};
        return check;
    }
    PKCS7* const token = TS_RESP_get_token(stamp.get());
    TS_TST_INFO* const info = TS_RESP_get_tst_info(stamp.get());
    if (token == nullptr || info == nullptr) {
        check.fault = {"io.seal.stamp_refused", "the service granted no time stamp", {}};
        return check;
    }
    if (imprintOf(TS_TST_INFO_get_msg_imprint(info)) != sha256Bytes(content)) {
        check.fault = {"io.seal.stamp_of_another", "the time stamp is of another file", {}};
        return check;
    }
    check.fault = faultOfRequest(info, request);
    if (check.fault.empty() && !signatureHolds(token)) {
        check.fault = {"io.seal.stamp_signature", "the signature of the time stamp does not hold", {}};
    }
    if (!check.fault.empty()) {
        return check;
    }
    check.matches = true;
    check.time = timeOf(info);
    check.service = serviceOf(token);
    if (roots.empty()) {
        check.doubt = {"io.seal.stamp_no_roots",
                       "the time-stamping service {0} was not held against any that are trusted: none were given",
                       {check.service}};
    } else if (const std::string reason = vouchingFault(token, roots, check.time); !reason.empty()) {
        check.fault = {"io.seal.stamp_not_vouched",
                       "those who are trusted do not vouch for the time-stamping service {0}: {1}",
                       {check.service, reason}};
    }
    return check;
}

void requireStamp(const std::string& answer, const std::string& request, const std::string& content) {
    const StampCheck check = checkTimeStamp(answer, request, content, {});
    if (!check.fault.empty()) {
        throw ParseError(
            check.fault,
            Message{"io.seal.stamp.remedy", "Send the request that was written for this bundle, and give the answer to that.", {}});
    }
}

}  // namespace rubble::io
