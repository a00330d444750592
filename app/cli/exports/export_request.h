#pragma once

#include <functional>
#include <memory>
#include <span>
#include <string>
#include <vector>

#include "app/cli/exports/figure_request.h"
#include "app/cli/exports/map_request.h"
#include "app/cli/frame/arguments.h"
#include "app/cli/frame/session.h"
#include "io/run/run_file.h"

namespace rubble::cli {

/// One kind of file that a run can be written as.
struct ExportKind {
    std::string_view name;     ///< "series"
    std::string_view endings;  ///< "*.pvd"
    std::string_view content;  ///< what it holds, one line
    std::string_view readers;  ///< programs that open it
};
/// Every kind, in the order in which they are listed.
std::span<const ExportKind> exportKinds();

/// The files asked for by --export KIND=PATH.
class ExportRequest {
public:
    /// The option itself, for the command table.
    static Option option();

    /// Throws UsageError for an unknown kind, WorldError for a path that cannot be written.
    ExportRequest(const Arguments& arguments, std::span<const std::string> inputs);

    bool empty() const { return m_rows.empty(); }
    /// The FE file is needed for everything that shows structure or ground; for glTF where bodies carried live structure.
    bool needsFe(const io::RunReader& run) const;
    /// Throws UsageError if a kind refers to the run file, which is not going to be kept.
    void checkKept() const;
    /// Writes the files in the order given; throws what the exporters throw, and Cancelled.
    /// @param inputs  of the run; without FE result unless needsFe()
    void perform(const std::shared_ptr<const io::RunReader>& run, const Inputs& inputs, const RunSurroundings& around,
                 Session& session) const;
    /// Paths in the order given.
    std::vector<std::string> paths() const;

private:
    struct Row {
        std::string kind;
        std::string path;
    };
    static bool readsFe(const Row& row);

    std::vector<Row> m_rows;
    FigureRequest m_figure;
    MapRequest m_map;
};

}  // namespace rubble::cli
