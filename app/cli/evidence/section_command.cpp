#include <QFont>
#include <QFontMetrics>
#include <QImage>
#include <QPainter>
#include <algorithm>
#include <array>
#include <cmath>
#include <utility>

#include "app/cli/evidence/placed_survey.h"
#include "app/cli/evidence/scanned_site.h"
#include "app/cli/exports/map_subject.h"
#include "app/cli/exports/run_surroundings.h"
#include "app/cli/frame/commands.h"
#include "app/cli/frame/option_value.h"
#include "app/cli/frame/output_file.h"
#include "app/cli/frame/picture_options.h"
#include "app/cli/frame/text_output.h"
#include "core/base/error.h"
#include "core/evidence/site_section.h"
#include "core/evidence/surveys/stated_survey.h"
#include "io/base/files.h"
#include "io/case/case_file.h"
#include "io/exports/exports.h"
#include "io/site/cause_evidence.h"
#include "io/site/clouds/run_distance.h"
#include "io/site/site_place.h"
#include "io/site/surveys/measured_points.h"
#include "widgets/figures/figure_file.h"
#include "widgets/figures/palette.h"
#include "widgets/figures/report/report_chart.h"

namespace rubble::cli {

namespace {

constexpr std::array<const char*, 5> sectionThings{"nothing", "debris", "fallen_structure", "structure", "ground"};
/// Points that a picture shows at most, evenly along the line.
constexpr std::size_t pointsDrawn = 1500;

/// The line of --line, m, local.
SectionLine lineFrom(const Arguments& arguments, const io::SitePlace& place) {
    const std::string text = arguments.value("--line").value_or("");
    const std::vector<std::string> parts = splitAtCommas(text);
    std::array<double, 4> numbers{};
    bool sound = parts.size() == numbers.size();
    for (std::size_t k = 0; sound && k < numbers.size(); ++k) {
        sound = parseNumber(parts[k], numbers[k]) && std::isfinite(numbers[k]);
    }
    if (!sound) {
        throw wrongValue("--line", text, "easting and northing of both ends in metres, such as 10,-5,10,25");
    }
    SectionLine line;
    line.from = place.planToLocal({numbers[0], numbers[1]});
    line.to = place.planToLocal({numbers[2], numbers[3]});
    line.width = parseLength(arguments, "--width", line.width);
    line.step = parseLength(arguments, "--step", line.step);
    return line;
}

/// A section and how it came to be.
struct MadeSection {
    SiteSection section;
    double time = 0.0;
    Findings findings;
    double zero = 0.0;  ///< m, height of the local zero in the system of the case
};

std::vector<Vec3> measuredFrom(const Arguments& arguments, const MapSubject& subject, const Site& site, MadeSection& made,
                               const Execution& execution) {
    std::vector<Vec3> all;
    const std::string casePath = caseOfEvidence(arguments);
    const Case theCase = casePath.empty()                      ? Case()
                         : io::isCaseFile(arguments.operand()) ? io::loadCase(casePath)
                                                               : loadCaseOfRun(casePath, subject.run->origin());
    for (const std::string& path : arguments.values("--points")) {
        io::MeasuredRequest request{path, {}, subject.inputs.frame, site};
        if (const CaseInput* stated = casePath.empty() ? nullptr : io::surveyOfFile(theCase, casePath, path)) {
            checkShowsDebris(*stated);
            request.placed = stated->registration;
        }
        const std::vector<Vec3> places = io::readMeasuredPoints(request, made.findings, execution);
        all.insert(all.end(), places.begin(), places.end());
    }
    return all;
}

MadeSection makeSection(const Arguments& arguments, const MapSubject& subject, const Execution& execution) {
    MadeSection made;
    const Site& at = subject.run->origin().site;
    const io::SitePlace place(subject.inputs.frame, at);
    const SectionLine line = lineFrom(arguments, place);
    const std::vector<Vec3> measured = measuredFrom(arguments, subject, at, made, execution);
    ScannedSite site = scannedSite(*subject.run, subject.inputs, instantFrom(arguments),
                                   parseLength(arguments, "--live-threshold", 1.0, true), execution);
    Aabb around;
    for (const Eigen::Vector2d& end : {line.from, line.to}) {
        around.extend(Vec3(end.x() - line.width, end.y() - line.width, 0.0));
        around.extend(Vec3(end.x() + line.width, end.y() + line.width, 0.0));
    }
    io::addCoarseGround(made.findings, addGround(site.shape, site.ground, around, io::scannedTriangles));
    const SurfaceTree tree(site.shape.points, site.shape.triangles);
    made.section = siteSection(site.shape, tree, site.ground, line, measured, execution);
    made.time = site.shape.time;
    made.zero = place.transform().height;
    const auto missing = static_cast<std::int64_t>(made.section.points.size()) - made.section.compared;
    if (missing > 0) {
        made.findings.add({"section.no_surface", "points lie where the simulated site has no surface; they were not compared", {}},
                          {"section.no_surface.remedy", "check where the terrain ends", {}}, {}, missing);
    }
    if (arguments.has("--points") && made.section.points.empty()) {
        made.findings.add({"section.no_points", "none of {0} points lies within the width of the line", {measured.size()}},
                          {"section.no_points.remedy", "check the ends of the line, or give a greater width", {}});
    }
    return made;
}

TextTable stepTable(const MadeSection& made) {
    TextTable table({{"along [m]", "along_m"},
                     {"ground [m]", "ground_m"},
                     {"simulated [m]", "simulated_m"},
                     {"of", "of"},
                     {"points", "points"},
                     {"measured [m]", "measured_m"},
                     {"difference [m]", "difference_m"}});
    for (const SectionStep& step : made.section.steps) {
        table.add({numberCell(step.along), numberCell(step.ground + made.zero), numberCell(step.simulated + made.zero),
                   textCell(sectionThings[static_cast<std::size_t>(step.thing)]), integerCell(step.points),
                   numberCell(step.measured + made.zero), numberCell(step.simulatedAtPoints - step.measured)});
    }
    return table;
}

/// A line for the heights that are there; where there are none it ends and begins anew.
void addProfile(std::vector<figures::ChartSeries>& series, const QColor& colour, bool dashed, const MadeSection& made,
                double SectionStep::* height) {
    figures::ChartSeries line;
    line.colour = colour;
    line.dashed = dashed;
    for (const SectionStep& step : made.section.steps) {
        if (std::isfinite(step.*height)) {
            line.points.push_back({step.along, step.*height + made.zero, {}});
        } else if (!line.points.empty()) {
            series.push_back(line);
            line.points.clear();
        }
    }
    if (!line.points.empty()) {
        series.push_back(std::move(line));
    }
}

void drawSection(const std::string& path, const MadeSection& made, const Arguments& arguments, const std::string& metadata) {
    quietQt();
    figures::ensureGuiApplication();
    QSize pixels(1600, 900);
    if (const auto size = arguments.value("--size")) {
        pixels = parsePictureSize(*size);
    }
    const figures::Palette& colours = figures::palette(render::Theme::Print);
    figures::ReportChart chart;
    chart.xTitle = QStringLiteral("along the section [m]");
    chart.yTitle = QStringLiteral("height [m]");
    chart.fromZero = false;
    // What was measured lies below the lines, which it would hide.
    figures::ChartSeries measured;
    measured.colour = colours.muted;
    measured.line = false;
    const std::size_t stride = made.section.points.size() / pointsDrawn + 1;
    for (std::size_t p = 0; p < made.section.points.size(); p += stride) {
        measured.points.push_back({made.section.points[p].along, made.section.points[p].place.z() + made.zero, {}});
    }
    if (!measured.points.empty()) {
        chart.series.push_back(std::move(measured));
    }
    addProfile(chart.series, colours.text, true, made, &SectionStep::ground);
    addProfile(chart.series, colours.fragment, false, made, &SectionStep::simulated);
    QImage image(pixels, QImage::Format_RGB32);
    image.fill(Qt::white);
    QPainter painter(&image);
    painter.setRenderHint(QPainter::Antialiasing);
    const double text = 0.028 * pixels.height();
    chart.paint(painter, QRectF(text, 2.5 * text, pixels.width() - 2.0 * text, pixels.height() - 3.5 * text), text);
    QFont font = painter.font();
    font.setPixelSize(static_cast<int>(text));
    painter.setFont(font);
    double at = 6.0 * text;
    for (const auto& [name, colour] :
         {std::pair(QStringLiteral("simulated"), colours.fragment), std::pair(QStringLiteral("measured"), colours.muted),
          std::pair(QStringLiteral("ground (dashed)"), colours.text)}) {
        painter.setPen(colour);
        painter.drawText(QPointF(at, 2.0 * text), name);
        at += painter.fontMetrics().horizontalAdvance(name) + 2.0 * text;
    }
    painter.end();
    figures::writePng(path, image, metadata);
}

Json sectionNumber(double number) {
    return std::isfinite(number) ? Json(number) : Json();
}

Json sectionJson(const MadeSection& made, const io::SitePlace& place) {
    const SiteSection& section = made.section;
    const Eigen::Vector2d from = place.planToWorld(section.line.from);
    const Eigen::Vector2d to = place.planToWorld(section.line.to);
    return {{"time_s", made.time},
            {"line_m", {from.x(), from.y(), to.x(), to.y()}},
            {"length_m", section.line.length()},
            {"width_m", section.line.width},
            {"step_m", section.line.step},
            {"points", section.points.size()},
            {"points_compared", section.compared},
            {"difference_mean_m", sectionNumber(section.mean)},
            {"difference_rms_m", sectionNumber(section.rms)},
            {"covered_m", section.covered},
            {"measured_area_m2", section.measuredArea},
            {"simulated_area_m2", section.simulatedArea}};
}

void printSection(std::ostream& out, const MadeSection& made) {
    const SiteSection& section = made.section;
    FactList facts;
    facts.add("time", englishNumber(made.time) + " s");
    facts.add("section", englishNumber(section.line.length()) + " m long, " + englishNumber(section.line.width) +
                             " m wide, steps of " + englishNumber(section.line.step) + " m");
    facts.add("measured points", englishInteger(static_cast<std::int64_t>(section.points.size())) + ", " +
                                     englishInteger(section.compared) + " of them where the simulation has a surface");
    if (section.compared > 0) {
        facts.add("simulated less measured",
                  englishNumber(section.mean) + " m in the mean, " + englishNumber(section.rms) + " m RMS");
        facts.add("area above ground", englishNumber(section.measuredArea) + " measured, " + englishNumber(section.simulatedArea) +
                                           " simulated m2, over " + englishNumber(section.covered) + " m with points");
    }
    printHeading(out, "Section through the simulated site and what was measured");
    facts.print(out);
}

ExitCode section(const Arguments& arguments, Session& session) {
    const std::vector<std::string> files = arguments.values("--out");
    std::vector<std::string> inputs = arguments.values("--points");
    inputs.push_back(arguments.operand());
    for (const std::string& path : files) {
        if (!io::hasEnding(path, ".png")) {
            throw wrongValue("--out", path, "a path that ends in .png");
        }
        checkOutputPath(path, inputs);
    }
    checkCsvPath(arguments, inputs);
    lineFrom(arguments, io::SitePlace(Frame(), Site()));
    instantFrom(arguments);
    const MapSubject subject = openMapSubject(arguments, session);
    const MadeSection made = makeSection(arguments, subject, session.execution());
    for (const std::string& path : files) {
        const std::string provenance = io::provenanceText(*subject.run);
        drawSection(path, made, arguments, provenance);
        io::writeProvenance(path, provenance);
    }
    writeCsv(arguments, stepTable(made));
    Findings findings = subject.findings;
    findings.append(made.findings);
    conclude(
        arguments, session, subject, findings,
        [&] { return sectionJson(made, io::SitePlace(subject.inputs.frame, subject.run->origin().site)); },
        [&](std::ostream& out) { printSection(out, made); });
    return ExitCode::Ok;
}

}  // namespace

Command sectionCommand() {
    return {
        "section",
        "RUN|FE|CASE",
        "a section through the simulated site and what was measured of the real one",
        "Cuts what a recorded run, or a case or FE file that is simulated first, leaves on the site along a line, and holds points "
        "of a total station, a drawing or a cloud beside the line against it: heights, differences and areas.",
        {{"--line", "E,N,E,N", false, "easting and northing of both ends, m"},
         {"--points", "FILE", true, "measured points: table of a total station, DXF or point cloud"},
         {"--width", "M", false, "points within half of it to either side count (default: 1)"},
         {"--step", "M", false, "along the line, what is drawn and summed (default: 0.25)"},
         {"--time", "SECONDS", false, "instant on the file's clock, or end (default: end)"},
         {"--live-threshold", "M", false, "live structure has fallen if it moved farther than this, m (default: 1)"},
         {"--out", "FILE", true, "a picture to write: .png"},
         {"--size", "WxH", false, "pixels of a picture (default: 1600x900)"},
         evidenceCaseOption(),
         setOption(),
         scenarioOption(),
         meshOffsetOption(),
         feOption(),
         {"--terrain", "FILE", false, "of a run where its terrain is now; of a case the terrain to take"},
         groundClassOption(),
         csvOption("write a row for each step")},
        section};
}

}  // namespace rubble::cli
