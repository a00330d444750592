#pragma once

#include <optional>
#include <string>
#include <vector>

#include "app/cli/frame/json_output.h"
#include "app/cli/frame/subject.h"
#include "app/cli/frame/text_table.h"
#include "app/cli/run/run_sinks.h"
#include "core/evidence/cautions.h"
#include "core/pipeline/pipeline.h"
#include "core/trajectory/trajectory.h"
#include "io/run/acknowledgements.h"

namespace rubble::cli {

/// A finished run, as its summary, its tables and its JSON object report it.
struct RunReport {
    const io::OpenedCase& subject;
    const Results& results;
    const std::vector<LedgerRow>& ledger;
    const IslandRows& islands;
    Findings findings;
    std::string runPath;             ///< empty if the run was not kept
    std::vector<std::string> files;  ///< exported
    io::Taint taint;

    Json json() const;
    /// Tables for people: fragments, Basic Grid, clusters, run, health, ledger, findings, files.
    void print(std::ostream& out) const;

private:
    std::vector<Caution> cautions() const;
    /// What the bodies and the frame rate of its sizing leave out.
    std::optional<Finding> beside() const;
};

/// One row for each row of the ledger.
TextTable ledgerTable(const std::vector<LedgerRow>& ledger);

}  // namespace rubble::cli
