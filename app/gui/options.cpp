#include "app/gui/options.h"

#include <QCommandLineParser>
#include <QCoreApplication>
#include <QRegularExpression>
#include <algorithm>
#include <cmath>

#include "app/gui/actions.h"
#include "core/base/build.h"
#include "widgets/language.h"

namespace rubble {

namespace {

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
    if (!theme.isEmpty() && theme != QLatin1String("light") && theme != QLatin1String("dark") && theme != QLatin1String("system")) {
        options.text = QCoreApplication::translate("options", "--theme is light, dark or system, not “%1”.").arg(theme);
        return false;
    }
    options.theme = theme;
    options.language = parser.value(QStringLiteral("language"));
    const QStringList languages = widgets::languageCodes() + QStringList(QStringLiteral("system"));
    if (parser.isSet(QStringLiteral("language")) && !languages.contains(options.language)) {
        options.text = QCoreApplication::translate("options", "--language is one of %1, not “%2”.")
                           .arg(languages.join(QStringLiteral(", ")), options.language);
        return false;
    }
    if (parser.isSet(QStringLiteral("panel"))) {
        static const QStringList names{QStringLiteral("case"),    QStringLiteral("fragments"), QStringLiteral("grid"),
                                       QStringLiteral("effects"), QStringLiteral("run"),       QStringLiteral("accuracy"),
                                       QStringLiteral("evidence")};
        const auto place = names.indexOf(parser.value(QStringLiteral("panel")));
        if (place < 0) {
            options.text = QCoreApplication::translate("options", "--panel is one of %1, not “%2”.")
                               .arg(names.join(QStringLiteral(", ")), parser.value(QStringLiteral("panel")));
            return false;
        }
        options.panel = static_cast<int>(place);
    }
    options.view = parser.value(QStringLiteral("view"));
    if (parser.isSet(QStringLiteral("photo"))) {
        static const QStringList names{QStringLiteral("alone"), QStringLiteral("swipe"), QStringLiteral("blend"),
                                       QStringLiteral("blink"), QStringLiteral("outline")};
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

}  // namespace

Options parseOptions(const QStringList& arguments) {
    QCommandLineParser parser;
    parser.setApplicationDescription(QCoreApplication::translate("options", "Workbench for the debris of structural collapses."));
    const QCommandLineOption help = parser.addHelpOption();
    const QCommandLineOption version = parser.addVersionOption();
    parser.addPositionalArgument(QStringLiteral("file"),
                                 QCoreApplication::translate("options", "A case (*.rubble) or an FE result."),
                                 QStringLiteral("[file]"));
    parser.addOptions(
        {{QStringLiteral("sample"), QCoreApplication::translate("options", "Open the embedded sample and simulate it.")},
         {QStringLiteral("simulate"), QCoreApplication::translate("options", "Simulate as soon as the file is open.")},
         {QStringLiteral("accuracy"), QCoreApplication::translate("options", "Compare settings as soon as the file is open.")},
         {QStringLiteral("screenshot"), QCoreApplication::translate("options", "Save a picture of the window and leave."),
          QStringLiteral("png")},
         {QStringLiteral("time"), QCoreApplication::translate("options", "Show this instant, in seconds."), QStringLiteral("s")},
         {QStringLiteral("size"), QCoreApplication::translate("options", "Size of the window."), QStringLiteral("WxH")},
         {QStringLiteral("panel"),
          QCoreApplication::translate("options", "Show this panel: case, fragments, grid, effects, run, accuracy or evidence."),
          QStringLiteral("panel")},
         {QStringLiteral("photo"),
          QCoreApplication::translate("options",
                                      "How the simulation lies over the photograph: alone, swipe, blend, blink or outline."),
          QStringLiteral("mode")},
         {QStringLiteral("action"),
          QCoreApplication::translate("options", "Trigger these actions before the picture is taken, by their ids."),
          QStringLiteral("id,id")},
         {QStringLiteral("view"), QCoreApplication::translate("options", "Look as a saved view does."), QStringLiteral("json")},
         {QStringLiteral("language"), QCoreApplication::translate("options", "Language: en, zh_CN or system."),
          QStringLiteral("language")},
         {QStringLiteral("theme"), QCoreApplication::translate("options", "Colours: light, dark or system."),
          QStringLiteral("theme")}});
    Options options;
    if (!parser.parse(arguments)) {
        options.text = parser.errorText();
        options.wrong = true;
        return options;
    }
    if (parser.isSet(help)) {
        options.text = parser.helpText();
        return options;
    }
    if (parser.isSet(version)) {
        options.text =
            QStringLiteral("rubble %1").arg(QString::fromUtf8(versionText().data(), static_cast<qsizetype>(versionText().size())));
        return options;
    }
    options.wrong = !readValues(parser, options) || parser.positionalArguments().size() > 1;
    if (parser.positionalArguments().size() > 1) {
        options.text = QCoreApplication::translate("options", "One file at a time, please.");
    }
    options.sample = parser.isSet(QStringLiteral("sample"));
    options.simulate = parser.isSet(QStringLiteral("simulate"));
    options.accuracy = parser.isSet(QStringLiteral("accuracy"));
    options.actions = parser.value(QStringLiteral("action")).split(u',', Qt::SkipEmptyParts);
    for (const QString& id : std::as_const(options.actions)) {
        const auto table = actionTable();
        if (!options.wrong &&
            std::none_of(table.begin(), table.end(), [&](const ActionRow& row) { return row.id == id.toStdString(); })) {
            options.text = QCoreApplication::translate(
                               "options", "--action knows no “%1”; the manual lists the actions in the order of the menus.")
                               .arg(id);
            options.wrong = true;
        }
    }
    options.screenshot = parser.value(QStringLiteral("screenshot"));
    options.path = parser.positionalArguments().value(0);
    return options;
}

}  // namespace rubble
