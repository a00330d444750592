#pragma once

#include <memory>
#include <string>
#include <vector>

#include "app/cli/arguments.h"
#include "core/pipeline/pipeline.h"
#include "io/run_file.h"
#include "widgets/figures/figure_file.h"

namespace rubble::cli {

/// What a figure of a run is to show, as given by --pane, --time, --state, --colour and --size.
class FigureRequest {
public:
    /// Options that every command with figures has.
    static std::vector<Option> options();

    /// Throws UsageError for a value that is not one of those offered.
    explicit FigureRequest(const Arguments& arguments);

    /// Draws the run and writes a PNG; starts a virtual display where none answers. Throws UsageError when the instant lies outside
    /// the run, WorldError.
    void write(const std::string& path, const std::shared_ptr<const io::RunReader>& run, const Inputs& inputs) const;

private:
    double timeIn(const io::RunReader& run, const FeResult& fe) const;

    std::optional<render::Layout> m_layout;  ///< unset: both panes, as the model's proportions suggest
    std::optional<double> m_time;            ///< s; unset: the end
    std::optional<std::size_t> m_state;      ///< FE state that takes the place of the time
    render::ColourBy m_colourBy = render::ColourBy::Highlight;
    figures::FigureStyle m_style;
};

}  // namespace rubble::cli
