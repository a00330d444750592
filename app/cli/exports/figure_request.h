#pragma once

#include <memory>
#include <string>
#include <vector>

#include "app/cli/exports/run_surroundings.h"
#include "app/cli/frame/arguments.h"
#include "core/pipeline/pipeline.h"
#include "io/run/run_file.h"
#include "widgets/figures/figure_file.h"
#include "widgets/figures/figure_sheet.h"
#include "widgets/render/basics/camera.h"

namespace rubble::cli {

/// What a figure of a run is to show, as given by --view, --pane, --time, --state, --preset, --times, --colour, --scale, --style,
/// --look, --cut, --hide, --size and --dpi.
class FigureRequest {
public:
    /// Options that every command with figures has.
    static std::vector<Option> options();
    /// Of these, those that say what is shown and how, whatever the instant.
    static std::vector<Option> viewOptions();

    /// Throws UsageError for a value that is not one of those offered.
    explicit FigureRequest(const Arguments& arguments);

    /// Throws UsageError unless the path ends in .png, .svg or .pdf.
    static void checkFormat(const std::string& option, const std::string& path);

    /// Draws the run and writes the figure; starts a virtual display where none answers. Throws UsageError when the instant lies
    /// outside the run, WorldError.
    void write(const std::string& path, const std::shared_ptr<const io::RunReader>& run, const Inputs& inputs,
               const RunSurroundings& around, const Execution& execution) const;
    /// sceneOfRun() with what the colours that were asked for need. Throws Cancelled.
    render::SceneData sceneFor(const std::shared_ptr<const io::RunReader>& run, const Inputs& inputs, const RunSurroundings& around,
                               const Execution& execution) const;
    /// The view that was asked for, at its own time. @param pixels  of the picture
    render::View viewOf(const render::SceneData& data, QSize pixels) const;
    const figures::FigureStyle& style() const { return m_style; }

private:
    void readLook(const Arguments& arguments);
    void readTime(const Arguments& arguments);
    void readPreset(const Arguments& arguments);
    figures::Sheet sheetOf(const render::SceneData& data, const io::RunReader& run) const;
    double timeIn(const io::RunReader& run, const FeResult& fe) const;
    render::View shownView(const render::SceneData& data, const io::RunReader& run, const figures::SheetPicture& picture) const;

    /// One half of the model that is left out.
    struct Cut {
        int axis = 0;
        double place = 0.0;  ///< m, as exported tables give it
        bool below = false;  ///< what lies below is cut away, else what lies beyond
    };

    std::optional<render::View> m_view;      ///< that everything not said otherwise comes from
    std::optional<render::Layout> m_layout;  ///< unset: both panes, as the model's proportions suggest
    bool m_bothPanes = false;                ///< said in so many words
    std::optional<render::Preset> m_look;
    std::optional<render::ColourMap> m_map;
    std::optional<render::Style> m_surfaces;
    std::optional<bool> m_shadows;
    std::optional<Cut> m_cut;
    std::vector<std::string> m_hidden;
    bool m_selection = false;
    std::optional<double> m_time;  ///< s; unset: the end
    bool m_atEnd = false;
    std::optional<std::size_t> m_state;  ///< FE state that takes the place of the time
    std::optional<render::ColourBy> m_colourBy;
    std::optional<figures::FigurePreset> m_preset;
    std::vector<double> m_times;  ///< s, of a preset; empty: those of the published figure
    figures::FigureStyle m_style;
};

/// What the pictures of a run show.
render::SceneData sceneOfRun(const std::shared_ptr<const io::RunReader>& run, const Inputs& inputs, const RunSurroundings& around);
/// First and last instant of a run that can be shown, s.
std::pair<double, double> spanOfRun(const io::RunReader& run, const FeResult& fe);

}  // namespace rubble::cli
