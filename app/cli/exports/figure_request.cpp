#include "app/cli/exports/figure_request.h"

#include <QString>

#include <algorithm>
#include <cmath>
#include <iostream>

#include "app/cli/frame/option_value.h"
#include "app/cli/frame/picture_options.h"
#include "app/cli/frame/virtual_display.h"
#include "core/base/error.h"
#include "core/fe/frame_transform.h"
#include "core/fe/north.h"
#include "core/pipeline/loose_scene.h"
#include "io/exports/provenance.h"
#include "io/run/run_cautions.h"
#include "io/site/site_place.h"
#include "widgets/figures/export_record.h"
#include "widgets/figures/figure_sheet.h"
#include "widgets/figures/number_text.h"
#include "widgets/figures/view_json.h"
#include "widgets/render/basics/run_scene.h"
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

constexpr std::array<Choice<render::ColourBy>, 6> colourNames{{{"highlight", render::ColourBy::Highlight},
                                                               {"component", render::ColourBy::Component},
                                                               {"birth_time", render::ColourBy::BirthTime},
                                                               {"speed", render::ColourBy::Speed},
                                                               {"cluster", render::ColourBy::Cluster},
                                                               {"island", render::ColourBy::Island}}};
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

std::vector<Option> FigureRequest::viewOptions() {
    return {
        {"--view", "FILE", false, "a view saved in the workbench; the options below take the place of parts of it"},
        {"--pane", "PANE", false, "what a figure shows: fe, fragments, both (default), overlay or four"},
        {"--colour", "BY", false,
         "fragments by highlight (default), component, birth_time, speed or cluster; loose structure by island"},
        {"--scale", "COLOURS", false, "of birth time and speed: standard (default), viridis, cividis or grey"},
        {"--style", "STYLE", false,
         "analysis or presentation: every element in the look of its material (default: analysis; of --preset presentation)"},
        {"--look", "FROM", false, "side (default), front, back, left, right, top, bottom or corner"},
        {"--cut", "AXIS=M", false, "leaves out what lies beyond x=M, y=M or z=M; with -x, -y or -z what lies below"},
        {"--hide", "NAME", true, "leaves a component out; may be repeated"},
        {"--shadows", "on|off", false, "the sun's shadow on the ground (default: as the saved view, else on)"},
        {"--selection", "on|off", false, "the elements that the saved view has selected in their colour (default: off)"},
        {"--size", "WxH", false,
         "pixels of a figure (default: 1600 and as high as what is shown needs; of a saved view 1600x1000; of a movie 1280x720)"},
        {"--dpi", "N", false, "pixels per inch, which decide the size of text: 9 pt (default: 200; of a movie 110)"}};
}

std::vector<Option> FigureRequest::options() {
    std::vector<Option> options = viewOptions();
    options.push_back({"--time", "SECONDS", false, "instant of a figure on the file's clock, or end (default: end)"});
    options.push_back({"--state", "K", false, "instant of a figure as FE state, from 0; instead of --time"});
    options.push_back({"--preset", "NAME", false, "arrangement: fe_against_fragments, at_the_end, in_its_surroundings or stages"});
    options.push_back(
        {"--times", "A,B,C", false,
         "instants of --preset fe_against_fragments (three), at_the_end, in_its_surroundings (one) or stages (four), s"});
    return options;
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
    readTime(arguments);
    readPreset(arguments);
    m_colourBy = choiceOf(arguments, "--colour", colourNames, "highlight, component, birth_time, speed, cluster or island");
    const auto size = arguments.value("--size");
    const QSize usual = figures::usualSize({});
    // Without cameras of its own a figure is as high as what it shows.
    m_style.pixels = size ? parsePictureSize(*size) : QSize(usual.width(), m_view && !m_preset ? usual.height() : 0);
    if (const auto dpi = arguments.value("--dpi")) {
        if (!parseNumber(*dpi, m_style.dpi) || !(m_style.dpi >= 20.0 && m_style.dpi <= 2400.0)) {
            throw wrongValue("--dpi", *dpi, "pixels per inch from 20 to 2400");
        }
    }
}

void FigureRequest::readTime(const Arguments& arguments) {
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
}

void FigureRequest::readPreset(const Arguments& arguments) {
    if (const auto wanted = arguments.value("--preset")) {
        for (const auto& presets : {figures::figurePresets, figures::numberedPresets}) {
            for (const auto& [name, preset] : presets) {
                if (name == *wanted) {
                    m_preset = preset;
                }
            }
        }
        if (!m_preset || arguments.has("--time") || arguments.has("--state") || arguments.has("--pane")) {
            throw wrongValue(
                "--preset", *wanted,
                "fe_against_fragments, at_the_end, in_its_surroundings or stages, and no --time, --state or --pane beside it");
        }
    }
    if (const auto text = arguments.value("--times")) {
        for (const std::string& each : splitAtCommas(*text)) {
            double seconds = 0.0;
            if (!m_preset || !parseNumber(each, seconds) || !std::isfinite(seconds)) {
                throw wrongValue("--times", *text, "seconds with commas between them, beside --preset");
            }
            m_times.push_back(seconds);
        }
    }
}

void FigureRequest::readLook(const Arguments& arguments) {
    m_look = choiceOf(arguments, "--look", lookNames, "side, front, back, left, right, top, bottom or corner");
    m_map = choiceOf(arguments, "--scale", mapNames, "standard, viridis, cividis or grey");
    m_surfaces = choiceOf(arguments, "--style", styleNames, "analysis or presentation");
    m_hidden = arguments.values("--hide");
    m_selection = parseOnOff(arguments, "--selection", false);
    if (arguments.value("--shadows")) {
        m_shadows = parseOnOff(arguments, "--shadows", true);
    }
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
render::View FigureRequest::viewOf(const render::SceneData& data, QSize pixels) const {
    const int width = pixels.width();
    const int height = pixels.height();
    render::View view = m_view ? *m_view : render::defaultView(data, width, height, m_layout);
    if (!m_selection) {
        view.selection.clear();
    }
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
    view.shadows = m_shadows.value_or(view.shadows);
    if (m_cut) {
        const Vec3 origin = FrameTransform(data.fe->contents().frame).localZero();
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
    const auto [first, last] = spanOfRun(run, fe);
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

figures::Sheet FigureRequest::sheetOf(const render::SceneData& data, const io::RunReader& run) const {
    // A height that is not settled yet: the layout is chosen as for a page.
    const QSize pixels(m_style.pixels.width(),
                       m_style.pixels.height() > 0 ? m_style.pixels.height() : 5 * m_style.pixels.width() / 8);
    if (!m_preset) {
        render::View view = viewOf(data, pixels);
        view.time = timeIn(run, *data.fe);
        figures::Sheet sheet = figures::sheetOf(view);
        if (!m_view) {
            sheet.framed = true;
            sheet.look = m_look.value_or(render::Preset::Side);
            sheet.choices = sheet.panels.size() == 2 ? std::vector{1, 2} : std::vector<int>();
        }
        return sheet;
    }
    const auto [first, last] = spanOfRun(run, *data.fe);
    for (const double time : m_times) {
        if (time < first || time > last) {
            throw UsageError(
                {"cli.time_outside", "--time {0}: the run goes from {1} to {2}.", {{time, "s"}, {first, "s"}, {last, "s"}}},
                {"cli.time_outside.remedy", "Give a time within the run.", {}});
        }
    }
    figures::PresetRequest request;
    request.preset = *m_preset;
    request.times = m_times;
    request.look = m_look;
    request.camerasOfView = m_view.has_value() && !m_look;
    request.end = last;
    request.style = m_surfaces;
    if (!m_surfaces && m_view) {
        request.style = m_view->style;
    }
    return figures::presetSheet(request, viewOf(data, pixels), data);
}

/// The view of which the pictures are panes, with their cameras.
render::View FigureRequest::shownView(const render::SceneData& data, const io::RunReader& run,
                                      const figures::SheetPicture& picture) const {
    render::View view = viewOf(data, picture.pixels());
    view.time = timeIn(run, *data.fe);
    for (const figures::SheetPicture::Panel& panel : picture.panels()) {
        render::cameraOf(view, panel.shown.content) = render::cameraOf(panel.view, panel.shown.content);
    }
    return view;
}

void FigureRequest::checkFormat(const std::string& option, const std::string& path) {
    if (!figures::isFigurePath(path)) {
        throw UsageError(
            {"cli.figure_format", "{0}: {1} does not say by its ending what kind of figure it is to be.", {option, path}},
            {"cli.figure_format.remedy", "Endings: .png, .svg, .pdf.", {}});
    }
}

void FigureRequest::write(const std::string& path, const std::shared_ptr<const io::RunReader>& run, const Inputs& inputs,
                          const RunSurroundings& around, const Execution& execution) const {
    const render::SceneData data = sceneFor(run, inputs, around, execution);
    quietQt();
    figures::ensureGuiApplication();
    const VirtualDisplay display;
    const figures::Sheet sheet = sheetOf(data, *run);
    figures::FigureStyle style = m_style;
    style.provenance = io::footLine(run->origin());
    style.cautions = pictureCautions(runCautions(io::standingOf(*run)));
    style.north = northOf(io::SitePlace(run->origin().frame, run->origin().site).transform(), run->origin().frame.crs);
    figures::Studio studio(data);
    const figures::SheetPicture picture = studio.sheet(sheet, style);
    const render::View shownWhole = m_preset ? picture.panels().back().view : shownView(data, *run, picture);
    io::ExportRecord record{
        "figure",
        {},
        figures::settingsText(picture.pixels(), m_style.dpi, m_preset, picture.panels().back().place.size(), shownWhole, data),
        figures::toJson(shownWhole),
        around.casePath,
        io::shownFiles(around.shown)};
    for (const figures::SheetPicture::Panel& panel : picture.panels()) {
        const figures::ShownPanel& shown = panel.shown;
        record.shown.push_back(
            {shown.caption.toStdString(), shown.status.time, std::nullopt, figures::shownAs(shown.content, shown.status)});
    }
    figures::writeSheet(path, picture, style, io::exportProvenance(record, run->origin(), run.get()));
}

render::SceneData FigureRequest::sceneFor(const std::shared_ptr<const io::RunReader>& run, const Inputs& inputs,
                                          const RunSurroundings& around, const Execution& execution) const {
    render::SceneData data = sceneOfRun(run, inputs, around);
    if (m_colourBy.value_or(m_view ? m_view->colourBy : render::ColourBy::Highlight) == render::ColourBy::Island) {
        data.loose = std::make_shared<const LooseStructure>(looseScene(inputs, run->origin().scenario, execution));
    }
    return data;
}

render::SceneData sceneOfRun(const std::shared_ptr<const io::RunReader>& run, const Inputs& inputs, const RunSurroundings& around) {
    figures::setResultSpan(inputs.fe->times().back() - inputs.fe->times().front());
    render::SceneData data =
        render::sceneOf(inputs, {&run->origin().scenario, run, run->fragments(), run->clustering(), run->result().get()});
    data.orthophoto = around.shown.orthophoto;
    data.surroundings = around.shown.surroundings;
    return data;
}

std::pair<double, double> spanOfRun(const io::RunReader& run, const FeResult& fe) {
    const double last = run.frameCount() > 0 ? std::max(fe.times().back(), run.frameTime(run.frameCount() - 1)) : fe.times().back();
    return {fe.times().front(), last};
}

}  // namespace rubble::cli
