#include "app/cli/figure_request.h"

#include <QString>

#include <algorithm>
#include <cmath>
#include <iostream>

#include "app/cli/option_value.h"
#include "app/cli/picture_options.h"
#include "app/cli/virtual_display.h"
#include "core/base/error.h"
#include "core/fe/components.h"
#include "widgets/render/scene.h"

namespace rubble::cli {

namespace {

struct ColourName {
    std::string_view name;
    render::ColourBy colour;
};
constexpr std::array<ColourName, 5> colourNames{{{"highlight", render::ColourBy::Highlight},
                                                 {"component", render::ColourBy::Component},
                                                 {"birth_time", render::ColourBy::BirthTime},
                                                 {"speed", render::ColourBy::Speed},
                                                 {"cluster", render::ColourBy::Cluster}}};

}  // namespace

std::vector<Option> FigureRequest::options() {
    return {{"--pane", "PANE", false, "what a figure shows: fe, fragments or both (default: both)"},
            {"--time", "SECONDS", false, "instant of a figure on the file's clock, or end (default: end)"},
            {"--state", "K", false, "instant of a figure as FE state, from 0; instead of --time"},
            {"--colour", "BY", false, "fragments by highlight (default), component, birth_time, speed or cluster"},
            {"--size", "WxH", false, "pixels of a figure (default: 1600x1000)"}};
}

FigureRequest::FigureRequest(const Arguments& arguments) {
    const std::string pane = arguments.value("--pane").value_or("both");
    if (pane == "fe") {
        m_layout = render::Layout::FeOnly;
    } else if (pane == "fragments") {
        m_layout = render::Layout::FragmentsOnly;
    } else if (pane != "both") {
        throw wrongValue("--pane", pane, "fe, fragments or both");
    }
    if (const auto time = arguments.value("--time"); time && *time != "end") {
        double seconds = 0.0;
        if (!parseNumber(*time, seconds) || !std::isfinite(seconds)) {
            throw wrongValue("--time", *time, "seconds with a point as decimal sign, or end");
        }
        m_time = seconds;
    }
    if (const auto state = arguments.value("--state")) {
        std::size_t number = 0;
        if (!parseNumber(*state, number) || arguments.has("--time")) {
            throw wrongValue("--state", *state, "the number of an FE state, from 0, and no --time beside it");
        }
        m_state = number;
    }
    if (const auto colour = arguments.value("--colour")) {
        const auto found =
            std::find_if(colourNames.begin(), colourNames.end(), [&](const ColourName& row) { return row.name == *colour; });
        if (found == colourNames.end()) {
            throw wrongValue("--colour", *colour, "highlight, component, birth_time, speed or cluster");
        }
        m_colourBy = found->colour;
    }
    if (const auto size = arguments.value("--size")) {
        m_style.pixels = parsePictureSize(*size);
    }
}

double FigureRequest::timeIn(const io::RunReader& run, const FeResult& fe) const {
    const double first = fe.times().front();
    const double last = run.frameCount() > 0 ? std::max(fe.times().back(), run.frameTime(run.frameCount() - 1)) : fe.times().back();
    if (m_state) {
        if (*m_state >= fe.stateCount()) {
            throw UsageError(
                {"cli.state_outside", "--state {0}: the FE result has the states 0 to {1}.", {*m_state, fe.stateCount() - 1}},
                {"cli.state_outside.remedy", "Give one of these.", {}});
        }
        return fe.times()[*m_state];
    }
    if (!m_time) {
        return last;
    }
    if (*m_time < first || *m_time > last) {
        throw UsageError(
            {"cli.time_outside", "--time {0}: the run goes from {1} to {2}.", {{*m_time, "s"}, {first, "s"}, {last, "s"}}},
            {"cli.time_outside.remedy", "Give a time within the run.", {}});
    }
    return *m_time;
}

void FigureRequest::write(const std::string& path, const std::shared_ptr<const io::RunReader>& run, const Inputs& inputs) const {
    const std::shared_ptr<const FeResult>& fe = inputs.fe;
    const Scenario& scenario = run->origin().scenario;
    const double time = timeIn(*run, *fe);
    render::SceneData data;
    data.fe = fe;
    data.components = std::make_shared<const Components>(
        groupComponents(fe->mesh(), scenario.regrouping, scenario.components, scenario.assumptions));
    data.fragments = run->fragments();
    data.clustering = run->clustering();
    data.trajectory = run;
    data.setSurroundings(scenario, inputs.terrain, run->result().get());

    quietQt();
    figures::ensureGuiApplication();
    const VirtualDisplay display;
    render::View view = render::defaultView(data, m_style.pixels.width(), m_style.pixels.height(), m_layout);
    view.time = time;
    view.colourBy = m_colourBy;
    figures::FigureStyle style = m_style;
    style.provenance = "FE " + run->origin().feSha256.substr(0, 16) + ", run " + run->origin().fingerprint.hex().substr(0, 16) +
                       ", " + run->origin().build;
    figures::writeFigure(path, view, data, style);
}

}  // namespace rubble::cli
