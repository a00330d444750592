#pragma once

#include <map>
#include <string>
#include <vector>

#include "io/seal/seal_case.h"
#include "tests/support/temporary_folder.h"

namespace rubble::io {

/// Entries of a container in their order.
using PackedFiles = std::vector<std::pair<std::string, std::string>>;
PackedFiles packedFiles(const std::string& bundle);
/// As whoever wants to alter a bundle would pack it, with the program's own hand.
void packFiles(const std::string& bundle, const PackedFiles& files);
/// The content of a place below the folder of the bag. Throws if it is not there.
std::string& contentAt(PackedFiles& files, const std::string& place);
/// Makes both lists of files anew, so that they agree with what lies in the bag.
void listAnew(PackedFiles& files);

/// Makes an Ed25519 key; returns its path.
std::string makeKey(const std::string& path);

/// Makes a certificate of a key that vouches for itself, valid from and to so many seconds from now; returns its path.
std::string makeCertificate(const std::string& key, const std::string& path, const std::string& name, long from, long to);

/// The small collapse as a case with two photographs, saved three times, run once and sealed. One for all tests of a program.
class SealedSmallCase {
public:
    static const SealedSmallCase& the();

    std::string path(const std::string& name) const { return m_folder / name; }
    std::string casePath() const { return path("small.rubble"); }
    std::string runPath() const { return path("small.run.h5"); }
    std::string bundle() const { return path("small.rubblecase"); }
    std::string key() const { return path("key.pem"); }
    SealRequest request() const;
    const SealReport& report() const { return m_report; }

private:
    SealedSmallCase();

    TemporaryFolder m_folder;
    SealReport m_report;
};

/// Runs the small case into a file, as if another build had done it where one is named.
void runSmallCase(const std::string& casePath, const std::string& runPath, const std::string& build = {});

}  // namespace rubble::io
