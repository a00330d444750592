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
#include "core/fe/frame_transform.h"
#include "core/fe/regrouping.h"
#include "widgets/figures/view_json.h"
#include "widgets/render/panes.h"
#include "widgets/render/scene.h"

namespace rubble::cli {

namespace {

template <class Value>
struct Choice {
    std::string_view name;
    Value value;
};

/// The value of an option that is one of a list; nothing if it is not given. Throws UsageError naming the choices.
template <class Value, std::size_t N>
std::optional<Value> choiceOf(const Arguments& arguments, const char* option, const std::array<Choice<Value>, N>& choices,
                              const char* wanted) {
    const auto given = arguments.value(option);
    if (!given) {
        return std::nullopt;
    }
    const auto found = std::find_if(choices.begin(), choices.end(), [&](const auto& row) { return row.name == *given; });
    if (found == choices.end()) {
        throw wrongValue(option, *given, wanted);
    }
    return found->value;
}

constexpr std::array<Choice<render::ColourBy>, 5> colourNames{{{"highlight", render::ColourBy::Highlight},
                                                               {"component", render::ColourBy::Component},
                                                               {"birth_time", render::ColourBy::BirthTime},
                                                               {"speed", render::ColourBy::Speed},
                                                               {"cluster", render::ColourBy::Cluster}}};
constexpr std::array<Choice<std::optional<render::Layout>>, 5> paneNames{{{"both", std::nullopt},
                                                                          {"fe", render::Layout::FeOnly},
                                                                          {"fragments", render::Layout::FragmentsOnly},
                                                                          {"overlay", render::Layout::OverlayOnly},
                                                                          {"four", render::Layout::Four}}};
constexpr std::array<Choice<render::Preset>, 8> lookNames{{{"side", render::Preset::Side},
                                                           {"front", render::Preset::Front},
                                                           {"back", render::Preset::Back},
                                                           {"left", render::Preset::Left},
                                                           {"right", render::Preset::Right},
                                                           {"top", render::Preset::Top},
                                                           {"bottom", render::Preset::Bottom},
                                                           {"corner", render::Preset::Corner}}};
constexpr std::array<Choice<render::ColourMap>, 4> mapNames{{{"standard", render::ColourMap::Standard},
                                                             {"viridis", render::ColourMap::Viridis},
                                                             {"cividis", render::ColourMap::Cividis},
                                                             {"grey", render::ColourMap::Grey}}};
constexpr std::array<Choice<render::Style>, 2> styleNames{
    {{"analysis", render::Style::Analysis}, {"presentation", render::Style::Presentation}}};

}  // namespace

std::vector<Option> FigureRequest::options() {
    return {{"--view", "FILE", false, "a view saved in the workbench; the options below take the place of parts of it"},
            {"--pane", "PANE", false, "what a figure shows: fe, fragments, both (default), overlay or four"},
            {"--time", "SECONDS", false, "instant of a figure on the file's clock, or end (default: end)"},
            {"--state", "K", false, "instant of a figure as FE state, from 0; instead of --time"},
            {"--colour", "BY", false, "fragments by highlight (default), component, birth_time, speed or cluster"},
            {"--scale", "COLOURS", false, "of birth time and speed: standard (default), viridis, cividis or grey"},
            {"--style", "STYLE", false, "analysis (default) or presentation: every element in the look of its material"},
            {"--look", "FROM", false, "side (default), front, back, left, right, top, bottom or corner"},
            {"--cut", "AXIS=M", false, "leaves out what lies beyond x=M, y=M or z=M; with -x, -y or -z what lies below"},
            {"--hide", "NAME", true, "leaves a component out; may be repeated"},
            {"--size", "WxH", false, "pixels of a figure (default: 1600x1000)"}};
}

FigureRequest::FigureRequest(const Arguments& arguments) {
    if (const auto file = arguments.value("--view")) {
        m_view = figures::viewFromFile(*file);
    }
    if (const auto pane = choiceOf(arguments, "--pane", paneNames, "fe, fragments, both, overlay or four")) {
        m_layout = *pane;
        m_bothPanes = !*pane;
    }
    readLook(arguments);
    if (const auto time = arguments.value("--time"); time && *time == "end") {
        m_atEnd = true;
    } else if (time) {
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
    m_colourBy = choiceOf(arguments, "--colour", colourNames, "highlight, component, birth_time, speed or cluster");
    if (const auto size = arguments.value("--size")) {
        m_style.pixels = parsePictureSize(*size);
    }
}

void FigureRequest::readLook(const Arguments& arguments) {
    m_look = choiceOf(arguments, "--look", lookNames, "side, front, back, left, right, top, bottom or corner");
    m_map = choiceOf(arguments, "--scale", mapNames, "standard, viridis, cividis or grey");
    m_surfaces = choiceOf(arguments, "--style", styleNames, "analysis or presentation");
    m_hidden = arguments.values("--hide");
    if (const auto text = arguments.value("--cut")) {
        const auto [axis, place] = splitAssignment("--cut", *text);
        Cut cut;
        cut.below = axis.starts_with('-');
        const std::string name = cut.below ? axis.substr(1) : axis;
        if ((name != "x" && name != "y" && name != "z") || !parseNumber(place, cut.place) || !std::isfinite(cut.place)) {
            throw wrongValue("--cut", *text, "an axis and metres, such as x=12.5 or -z=3");
        }
        cut.axis = name[0] - 'x';
        m_cut = cut;
    }
}

/// The view that was saved, or the one that a result opens with, with what else was asked for.
render::View FigureRequest::viewOf(const render::SceneData& data) const {
    const int width = m_style.pixels.width();
    const int height = m_style.pixels.height();
    render::View view = m_view ? *m_view : render::defaultView(data, width, height, m_layout);
    if (m_view && (m_layout || m_bothPanes)) {
        view.layout = m_layout ? *m_layout : render::defaultView(data, width, height).layout;
    }
    if (m_look) {
        const double aspect = render::panesOf(view.layout, width, height).front().aspect();
        for (const render::PaneContent pane :
             {render::PaneContent::Fe, render::PaneContent::Fragments, render::PaneContent::Overlay}) {
            render::cameraOf(view, pane) = render::fitCamera(render::boundsOf(data), aspect, *m_look);
        }
    }
    view.colourBy = m_colourBy.value_or(view.colourBy);
    view.colourMap = m_map.value_or(view.colourMap);
    view.style = m_surfaces.value_or(view.style);
    if (m_cut) {
        const Vec3 origin = -FrameTransform(data.fe->contents().frame).point(Vec3::Zero());
        const Vec3 axis = Vec3::Unit(m_cut->axis);
        view.clip = render::ClipPlane{axis * (m_cut->place - origin[m_cut->axis]), m_cut->below ? Vec3(-axis) : axis};
    }
    for (const std::string& name : m_hidden) {
        std::vector<std::string> names;
        for (const Component& component : data.components->list) {
            names.push_back(component.name);
        }
        if (std::find(names.begin(), names.end(), name) == names.end()) {
            throwUnknownComponent(name, names);
        }
        view.hiddenComponents.push_back(name);
    }
    return view;
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
    if (m_atEnd || (!m_time && !m_view)) {
        return last;
    }
    const double asked = m_time.value_or(m_view ? m_view->time : last);
    if (asked < first || asked > last) {
        throw UsageError(
            {"cli.time_outside", "--time {0}: the run goes from {1} to {2}.", {{asked, "s"}, {first, "s"}, {last, "s"}}},
            {"cli.time_outside.remedy", "Give a time within the run.", {}});
    }
    return asked;
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
    render::View view = viewOf(data);
    view.time = time;
    figures::FigureStyle style = m_style;
    style.provenance = "FE " + run->origin().feSha256.substr(0, 16) + ", run " + run->origin().fingerprint.hex().substr(0, 16) +
                       ", " + run->origin().build;
    figures::writeFigure(path, view, data, style);
}

}  // namespace rubble::cli
