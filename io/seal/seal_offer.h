#pragma once

#include <cstdint>
#include <string>
#include <vector>

#include "core/base/execution.h"
#include "core/base/message.h"
#include "io/seal/seal_case.h"

namespace rubble::io {

/// Something of a case that can be sealed with it.
struct OfferedPart {
    enum class Kind { Input, Run, Export, Report, Page };
    Kind kind = Kind::Input;
    std::string id;                ///< of an input; of a run the name of its scenario
    std::string path;              ///< absolute
    std::uint64_t bytes = 0;       ///< with the files that go with it
    bool chosen = true;            ///< it is sealed; of an input: it travels
    Message remark = {};           ///< what speaks against it, or for making it; empty: nothing
    std::string fingerprint = {};  ///< of a run, or of the run that it was made of, hex; empty: not known
    std::string run = {};          ///< of a report or a page that is not there but can be made: the file of its run, absolute
};

/// The newest complete run of each scenario of a case whose file was kept. Throws WorldError, ParseError.
std::vector<std::string> newestRuns(const std::string& casePath);

/// What a case has: its inputs, the runs that were kept or lie beside it, and the exports, reports and pages beside it that were
/// made of it, as their provenance says, and the reports and pages that its runs lack. Chosen is what there is, of the runs the
/// newest of each scenario. Throws WorldError, ParseError, Cancelled.
std::vector<OfferedPart> sealOffer(const std::string& casePath, const Execution& execution);

/// A file or a folder that somebody adds: a report is a folder, a page ends in .html, a run in .run.h5.
OfferedPart addedPart(const std::string& path);

/// Report and page that can be made of a run: those of which the parts hold none that was made of it or of one equal to it. Not
/// chosen.
std::vector<OfferedPart> missingOf(const OfferedPart& run, const std::vector<OfferedPart>& parts);

/// Where a report (a folder) or a page of a run is made, and where it goes in the bag.
/// @param number  of the run, from 1, for runs of one name
/// @param folder  to be made in
SealedExtra placeOfMade(OfferedPart::Kind kind, const std::string& run, std::size_t number, const std::string& folder);

/// Where it lies in the bag then.
std::string placeInBag(const SealedExtra& made);

/// Puts what is chosen and there into a request, and inputs that are not chosen among those that stay home.
void choose(SealRequest& request, const std::vector<OfferedPart>& parts);

/// A service that is asked by a command of the user, in which {request} and {answer} stand for files. What it returns throws
/// WorldError.
StampService stampServiceBy(const std::string& command);

}  // namespace rubble::io
