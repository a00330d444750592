#include "app/gui/window/options.h"

#include <QCommandLineParser>
#include <QCoreApplication>
#include <QRegularExpression>
#include <algorithm>
#include <cmath>
#include <iterator>
#include <map>

#include "core/base/build.h"
#include "core/base/help/bash_completion.h"
#include "core/base/help/man_page.h"
#include "widgets/basics/language.h"

namespace rubble {

namespace {

/// Values of the options that offer some, in the order in which other parts of the window count them.
const std::map<QString, QStringList>& choices() {
    static const std::map<QString, QStringList> table{
        {QStringLiteral("theme"), {QStringLiteral("light"), QStringLiteral("dark"), QStringLiteral("system")}},
        {QStringLiteral("language"), widgets::languageCodes() + QStringList(QStringLiteral("system"))},
        {QStringLiteral("panel"),
         {QStringLiteral("case"), QStringLiteral("fragments"), QStringLiteral("grid"), QStringLiteral("effects"),
          QStringLiteral("run"), QStringLiteral("accuracy"), QStringLiteral("evidence"), QStringLiteral("report"),
          QStringLiteral("ensemble"), QStringLiteral("causes")}},
        {QStringLiteral("new-case"),
         {QStringLiteral("units"), QStringLiteral("ground"), QStringLiteral("components"), QStringLiteral("deaths"),
          QStringLiteral("case")}},
        {QStringLiteral("photo"),
         {QStringLiteral("alone"), QStringLiteral("swipe"), QStringLiteral("blend"), QStringLiteral("blink"),
          QStringLiteral("outline")}}};
    return table;
}

/// Reads the values of options that have a form of their own; false and a complaint if one is wrong.
bool readValues(const QCommandLineParser& parser, Options& options) {
    if (parser.isSet(QStringLiteral("time"))) {
        bool ok = false;
        options.time = parser.value(QStringLiteral("time")).toDouble(&ok);
        if (!ok || !std::isfinite(*options.time)) {
            options.text = QCoreApplication::translate("options", "--time needs a number of seconds, not “%1”.")
                               .arg(parser.value(QStringLiteral("time")));
            return false;
        }
    }
    if (parser.isSet(QStringLiteral("size"))) {
        static const QRegularExpression form(QStringLiteral("^(\\d{3,5})x(\\d{3,5})$"));
        const auto match = form.match(parser.value(QStringLiteral("size")));
        if (!match.hasMatch()) {
            options.text = QCoreApplication::translate("options", "--size needs WIDTHxHEIGHT, such as 1280x800, not “%1”.")
                               .arg(parser.value(QStringLiteral("size")));
            return false;
        }
        options.size = QSize(match.captured(1).toInt(), match.captured(2).toInt());
    }
    const QString theme = parser.value(QStringLiteral("theme"));
    if (!theme.isEmpty() && !choices().at(QStringLiteral("theme")).contains(theme)) {
        options.text = QCoreApplication::translate("options", "--theme is light, dark or system, not “%1”.").arg(theme);
        return false;
    }
    options.theme = theme;
    options.language = parser.value(QStringLiteral("language"));
    const QStringList& languages = choices().at(QStringLiteral("language"));
    if (parser.isSet(QStringLiteral("language")) && !languages.contains(options.language)) {
        options.text = QCoreApplication::translate("options", "--language is one of %1, not “%2”.")
                           .arg(languages.join(QStringLiteral(", ")), options.language);
        return false;
    }
    if (parser.isSet(QStringLiteral("panel"))) {
        const QStringList& names = choices().at(QStringLiteral("panel"));
        const auto place = names.indexOf(parser.value(QStringLiteral("panel")));
        if (place < 0) {
            options.text = QCoreApplication::translate("options", "--panel is one of %1, not “%2”.")
                               .arg(names.join(QStringLiteral(", ")), parser.value(QStringLiteral("panel")));
            return false;
        }
        options.panel = static_cast<int>(place);
    }
    options.view = parser.value(QStringLiteral("view"));
    if (parser.isSet(QStringLiteral("new-case"))) {
        const QStringList& names = choices().at(QStringLiteral("new-case"));
        const auto place = names.indexOf(parser.value(QStringLiteral("new-case")));
        if (place < 0) {
            options.text = QCoreApplication::translate("options", "--new-case is one of %1, not “%2”.")
                               .arg(names.join(QStringLiteral(", ")), parser.value(QStringLiteral("new-case")));
            return false;
        }
        options.newCaseStep = static_cast<int>(place);
    }
    if (parser.isSet(QStringLiteral("photo"))) {
        const QStringList& names = choices().at(QStringLiteral("photo"));
        const auto place = names.indexOf(parser.value(QStringLiteral("photo")));
        if (place < 0) {
            options.text = QCoreApplication::translate("options", "--photo is one of %1, not “%2”.")
                               .arg(names.join(QStringLiteral(", ")), parser.value(QStringLiteral("photo")));
            return false;
        }
        options.photo = static_cast<int>(place);
    }
    return true;
}

/// Reads the actions that are to be triggered; a complaint about the first name that none has.
void readActions(const QCommandLineParser& parser, Options& options) {
    for (const QString& name : parser.value(QStringLiteral("action")).split(u',', Qt::SkipEmptyParts)) {
        if (const auto id = actionNamed(name)) {
            options.actions.push_back(*id);
        } else if (!options.wrong) {
            options.text = QCoreApplication::translate(
                               "options", "--action knows no “%1”; the manual lists the actions in the order of the menus.")
                               .arg(name);
            options.wrong = true;
        }
    }
}

/// Reads what causes are to be compared with; a complaint if evidence has no kind.
void readCauses(const QCommandLineParser& parser, Options& options) {
    options.causes = parser.values(QStringLiteral("cause"));
    options.against = parser.values(QStringLiteral("against"));
    static const QRegularExpression found(QStringLiteral("^(footprint|height|surface)=.+$"));
    for (const QString& each : std::as_const(options.against)) {
        if (!options.wrong && !found.match(each).hasMatch()) {
            options.text =
                QCoreApplication::translate("options", "--against needs footprint, height or surface and a file, not “%1”.")
                    .arg(each);
            options.wrong = true;
        }
    }
}

/// Every option but help and version.
QList<QCommandLineOption> optionTable() {
    return {
        {QStringLiteral("sample"), QCoreApplication::translate("options", "Open the embedded sample and simulate it.")},
        {QStringLiteral("simulate"), QCoreApplication::translate("options", "Simulate as soon as the file is open.")},
        {QStringLiteral("accuracy"), QCoreApplication::translate("options", "Compare settings as soon as the file is open.")},
        {QStringLiteral("chart"),
         QCoreApplication::translate("options", "Compare settings, save the chart of what accuracy costs and leave."),
         QStringLiteral("svg|png")},
        {QStringLiteral("measure"),
         QCoreApplication::translate("options", "Open the file, measure how fast window and scrubbing are, print JSON and leave.")},
        {QStringLiteral("screenshot"), QCoreApplication::translate("options", "Save a picture of the window and leave."),
         QStringLiteral("png")},
        {QStringLiteral("time"), QCoreApplication::translate("options", "Show this instant, in seconds."), QStringLiteral("s")},
        {QStringLiteral("size"), QCoreApplication::translate("options", "Size of the window."), QStringLiteral("WxH")},
        {QStringLiteral("panel"),
         QCoreApplication::translate(
             "options", "Show this panel: case, fragments, grid, effects, run, accuracy, evidence, report, ensemble or causes."),
         QStringLiteral("panel")},
        {QStringLiteral("new-case"),
         QCoreApplication::translate(
             "options", "Make a new case from the file, from this step on: units, ground, components, deaths or case."),
         QStringLiteral("step")},
        {QStringLiteral("photo"),
         QCoreApplication::translate("options",
                                     "How the simulation lies over the photograph: alone, swipe, blend, blink or outline."),
         QStringLiteral("mode")},
        {QStringLiteral("cause"),
         QCoreApplication::translate("options", "Another case or FE result to compare causes with; may be repeated."),
         QStringLiteral("file")},
        {QStringLiteral("against"),
         QCoreApplication::translate("options",
                                     "What was found, to compare causes with: footprint, height or surface; may be repeated."),
         QStringLiteral("kind=file")},
        {QStringLiteral("action"),
         QCoreApplication::translate("options", "Trigger these actions before the picture is taken, by their ids."),
         QStringLiteral("id,id")},
        {QStringLiteral("view"), QCoreApplication::translate("options", "Look as a saved view does."), QStringLiteral("json")},
        {QStringLiteral("language"), QCoreApplication::translate("options", "Language: en, zh_CN or system."),
         QStringLiteral("language")},
        {QStringLiteral("theme"), QCoreApplication::translate("options", "Colours: light, dark or system."),
         QStringLiteral("theme")},
        {QStringLiteral("man-page"), QCoreApplication::translate("options", "Print the page for man and leave.")},
        {QStringLiteral("completion"), QCoreApplication::translate("options", "Print the completion for bash and leave.")}};
}

QString description() {
    return QCoreApplication::translate("options", "Workbench for the debris of structural collapses.");
}

QString manPage() {
    ManPage page("rubble", "workbench for the debris of structural collapses");
    page.section("SYNOPSIS").paragraph("rubble [options] [file]");
    page.section("DESCRIPTION")
        .paragraph(
            "Opens a case (*.rubble) or a finite-element result and shows the conventional FE view and the fragments that its "
            "deactivated elements become side by side on one timeline. F1 opens the manual. rubble-cli(1) does the same without a "
            "window.");
    page.section("OPTIONS");
    for (const QCommandLineOption& option : optionTable()) {
        const QString value = option.valueName().isEmpty() ? QString() : u' ' + option.valueName();
        page.item("--" + option.names().front().toStdString() + value.toStdString(), option.description().toStdString());
    }
    page.item("--help", "Print the options.").item("--version", "Print the version.");
    page.section("SEE ALSO").paragraph("rubble-cli(1)");
    return QString::fromStdString(page.text()).chopped(1);
}

QString completion() {
    CompletedCommand program;
    for (const QCommandLineOption& option : optionTable()) {
        CompletedOption row{"--" + option.names().front().toStdString(), !option.valueName().isEmpty(), {}, {}};
        if (const auto known = choices().find(option.names().front()); known != choices().end()) {
            std::transform(known->second.begin(), known->second.end(), std::back_inserter(row.values),
                           [](const QString& word) { return word.toStdString(); });
        }
        program.options.push_back(std::move(row));
    }
    return QString::fromStdString(bashCompletion("rubble", {program}, {"--help", "--version"})).chopped(1);
}

}  // namespace

bool Options::asksForNothing() const {
    return path.isEmpty() && !sample && !simulate && !accuracy && !measure && screenshot.isEmpty() && chart.isEmpty() && !time &&
           !panel && actions.empty() && view.isEmpty() && !newCaseStep && !photo && causes.isEmpty() && against.isEmpty();
}

Options parseOptions(const QStringList& arguments) {
    QCommandLineParser parser;
    parser.setApplicationDescription(description());
    const QCommandLineOption help = parser.addHelpOption();
    const QCommandLineOption version = parser.addVersionOption();
    parser.addPositionalArgument(QStringLiteral("file"),
                                 QCoreApplication::translate("options", "A case (*.rubble) or an FE result."),
                                 QStringLiteral("[file]"));
    parser.addOptions(optionTable());
    Options options;
    if (!parser.parse(arguments)) {
        options.text = parser.errorText();
        options.wrong = true;
        return options;
    }
    if (parser.isSet(help)) {
        // Without an application Qt does not know its name.
        options.text = parser.helpText().replace(QStringLiteral("<executable_name>"), QStringLiteral("rubble"));
        return options;
    }
    if (parser.isSet(version)) {
        options.text =
            QStringLiteral("rubble %1").arg(QString::fromUtf8(versionText().data(), static_cast<qsizetype>(versionText().size())));
        return options;
    }
    if (parser.isSet(QStringLiteral("man-page")) || parser.isSet(QStringLiteral("completion"))) {
        options.text = parser.isSet(QStringLiteral("man-page")) ? manPage() : completion();
        return options;
    }
    options.wrong = !readValues(parser, options) || parser.positionalArguments().size() > 1;
    if (parser.positionalArguments().size() > 1) {
        options.text = QCoreApplication::translate("options", "One file at a time, please.");
    }
    options.sample = parser.isSet(QStringLiteral("sample"));
    options.simulate = parser.isSet(QStringLiteral("simulate"));
    options.chart = parser.value(QStringLiteral("chart"));
    options.accuracy = parser.isSet(QStringLiteral("accuracy")) || !options.chart.isEmpty();
    readActions(parser, options);
    options.measure = parser.isSet(QStringLiteral("measure"));
    if (!options.wrong && options.measure && parser.positionalArguments().isEmpty()) {
        options.text = QCoreApplication::translate("options", "--measure needs a file to open.");
        options.wrong = true;
    }
    readCauses(parser, options);
    options.screenshot = parser.value(QStringLiteral("screenshot"));
    options.path = parser.positionalArguments().value(0);
    return options;
}

}  // namespace rubble
