#include "tests/support/time_stamp_service.h"

#include <gtest/gtest.h>

#include <filesystem>

#include "io/base/files.h"
#include "tests/support/command_run.h"

namespace rubble::io {

namespace {

void openssl(const std::string& folder, const std::string& words) {
    const cli::Outcome outcome = cli::CommandRun().in(folder).run({"sh", "-c", "openssl " + words});
    EXPECT_EQ(outcome.exitCode, 0) << words << ": " << outcome.out << outcome.err;
}

}  // namespace

void TimeStampService::found() {
    openssl(m_folder,
            "req -x509 -newkey rsa:2048 -nodes -keyout tsa.key -out tsa.pem -days 30 -subj '/CN=Service of the test' "
            "-addext extendedKeyUsage=critical,timeStamping");
    writeIn(m_folder + "/serial", "01\n");
    writeIn(m_folder + "/tsa.cnf",
            "[t]\nserial = serial\ncrypto_device = builtin\nsigner_cert = tsa.pem\ncerts = tsa.pem\nsigner_key = tsa.key\n"
            "signer_digest = sha256\ndefault_policy = 1.2.3.4.1\ndigests = sha256\ness_cert_id_alg = sha256\n");
}

std::string TimeStampService::answerTo(const std::string& request) {
    if (!std::filesystem::exists(roots())) {
        found();
    }
    writeIn(m_folder + "/request.tsq", request);
    openssl(m_folder, "ts -reply -queryfile request.tsq -config tsa.cnf -section t -out answer.tsr");
    return contentOf(answer()).value_or("");
}

}  // namespace rubble::io
