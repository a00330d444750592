#pragma once

#include <ctime>
#include <string>

#include "core/base/message.h"

namespace rubble::io {

/// Asks a service to say when it saw a content (RFC 3161, DER): its SHA-256, a number that is used once, and that the answer brings
/// the certificate of the service. Throws WorldError.
std::string timeStampRequest(const std::string& content);

/// Whether a request (DER) is for this content.
bool isRequestFor(const std::string& request, const std::string& content);

/// What is known of a time stamp.
struct StampCheck {
    bool matches = false;  ///< it is of this content, answers this request, and its signature holds
    std::time_t time = 0;  ///< s since 1970, when the service saw the content
    std::string service;   ///< subject of its certificate
    Message fault;         ///< why it proves nothing; empty: it does
    Message doubt;         ///< nobody vouches for the service; empty: somebody does
};

/// Throws ParseError unless an answer is of this content and request, and its signature holds.
void requireStamp(const std::string& answer, const std::string& request, const std::string& content);

/// Verifies an answer offline.
/// @param answer   DER as the service gave it
/// @param request  DER that it answers; empty: not known
/// @param roots    file with certificates in PEM that vouch for the service; empty: none
/// Throws WorldError, ParseError for the roots; never for what is verified.
StampCheck checkTimeStamp(const std::string& answer, const std::string& request, const std::string& content,
                          const std::string& roots);

}  // namespace rubble::io
