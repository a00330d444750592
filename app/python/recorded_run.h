#pragma once

#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "core/evidence/maps/run_map.h"
#include "core/pipeline/pipeline.h"
#include "io/run/run_file.h"

namespace rubble::python {

/// A debris map with what its files need.
struct RecordedMap {
    RunMap made;
    std::shared_ptr<const io::RunReader> run;
};

/// A run file that is open, with the FE result that it was made from where somebody had it open or asked for it.
class RecordedRun {
public:
    /// @param inputs  of the run, where they are open already; else found by path and SHA-256 when first needed
    RecordedRun(std::shared_ptr<io::RunReader> reader, std::optional<Inputs> inputs);

    io::RunReader& reader() const { return *m_reader; }
    const std::shared_ptr<io::RunReader>& shared() const { return m_reader; }
    /// Throws ParseError where the run was stopped before there were any.
    std::shared_ptr<const FragmentSet> fragments() const;
    /// Throws UsageError where the run is not complete.
    std::shared_ptr<const SimulationResult> result() const;
    /// @param fe  where the FE file is now; unset: where it was
    const Inputs& inputs(const std::optional<std::string>& fe, const Execution& execution);

    /// Writes a file as rubble-cli export does. Throws UsageError for an unknown kind, and what the exporters throw.
    void write(const std::string& kind, const std::string& path, const std::optional<std::string>& fe, const Execution& execution);
    std::shared_ptr<const RecordedMap> map(std::optional<double> cell, std::optional<double> time, bool live,
                                           const std::optional<std::string>& fe, const Execution& execution);

private:
    std::shared_ptr<io::RunReader> m_reader;
    std::optional<Inputs> m_inputs;
};

/// Writes a map by the ending of its name: .tif, .csv or .gpkg. Throws UsageError for another one, and what the writers throw.
void saveMap(const RecordedMap& map, const std::string& path, const Execution& execution);

}  // namespace rubble::python
