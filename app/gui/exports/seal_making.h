#pragma once

#include <string>
#include <vector>

#include "app/gui/exports/run_orders.h"
#include "io/case/open_case.h"
#include "io/seal/seal_offer.h"

namespace rubble {

/// Makes the reports and pages that are sealed with runs, by the orders of *Report* and *Share as a page*, as they were asked for.
struct SealMaking {
    io::OpenedCase opened;  ///< what the window has open: not read again for runs that were made from it
    Case theCase;           ///< as it is saved
    std::string casePath;
    ReportOrder report;  ///< what the panel asks of a report
    std::vector<io::OfferedPart> parts;

    bool empty() const { return parts.empty(); }
    /// Makes each of them in a folder, on the worker. @param runs  that are sealed; their order numbers what is made
    /// Returns what was made. Throws what the orders throw, originInCase(), openRunInputs(), and Cancelled.
    std::vector<io::SealedExtra> make(const std::vector<std::string>& runs, const std::string& folder,
                                      const Execution& execution) const;
};

}  // namespace rubble
