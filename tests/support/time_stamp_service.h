#pragma once

#include <string>

namespace rubble::io {

/// A time-stamping service in a folder: that of openssl, with a certificate made for it.
class TimeStampService {
public:
    explicit TimeStampService(std::string folder) : m_folder(std::move(folder)) {}

    /// Answers a request, both in DER; the answer lies in answer() as well.
    std::string answerTo(const std::string& request);
    std::string answer() const { return m_folder + "/answer.tsr"; }
    /// Certificate that vouches for it.
    std::string roots() const { return m_folder + "/tsa.pem"; }

private:
    void found();

    std::string m_folder;
};

}  // namespace rubble::io
