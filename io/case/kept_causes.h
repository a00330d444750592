#pragma once

#include <set>
#include <string>
#include <vector>

#include "core/evidence/ensembles/cause_comparison.h"
#include "io/site/cause_evidence.h"

namespace rubble::io {

/// Which supposed causes somebody holds against which evidence, beside what the case itself has of either.
struct KeptCauses {
    struct Cause {
        std::string path;  ///< of a case or an FE result, absolute
        bool used = true;
    };
    struct File {
        EvidenceFile file;  ///< its path is absolute
        bool used = true;
    };
    struct Time {
        TimeEvidence time;
        bool used = true;
    };
    std::vector<Cause> causes;
    std::vector<File> files;
    std::vector<Time> times;
    std::set<std::string> leftOutScenarios;  ///< ids of scenarios of the case that are no cause
    std::set<std::string> leftOutEvidence;   ///< ids of inputs of the case that do not count
    bool blind = false;

    bool empty() const;
};

/// The choice of a file; an empty one if there is none. Throws WorldError, ParseError naming file and place.
KeptCauses readKeptCauses(const std::string& file);

/// Writes it atomically, with paths relative to the file; an empty one removes the file. Throws WorldError; the old file is then
/// unchanged.
void writeKeptCauses(const std::string& file, const KeptCauses& kept);

}  // namespace rubble::io
