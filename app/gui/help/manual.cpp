#include "app/gui/help/manual.h"

#include <QCoreApplication>
#include <QDir>
#include <QFile>
#include <QLocale>
#include <cmath>

#include "app/gui/stage/actions.h"
#include "core/scenario/parameters.h"
#include "widgets/basics/language.h"

namespace rubble {

namespace {

QString qt(std::string_view text) {
    return QString::fromUtf8(text.data(), static_cast<qsizetype>(text.size()));
}

QString contentOf(const QString& path) {
    QFile file(path);
    return file.open(QIODevice::ReadOnly) ? QString::fromUtf8(file.readAll()) : QString();
}

QString rangeText(const Parameter& row) {
    if (row.kind == ParameterKind::Choice) {
        QStringList choices;
        for (const std::string_view choice : row.choices) {
            choices << qt(choice);
        }
        return choices.join(QStringLiteral(", "));
    }
    if (row.kind == ParameterKind::Switch) {
        return QStringLiteral("on, off");
    }
    if (row.kind == ParameterKind::Text) {
        return QStringLiteral("text");
    }
    const auto limit = [](double value) {
        return std::isfinite(value) ? QLocale::c().toString(value, 'g', 6) : QStringLiteral("any");
    };
    return QStringLiteral("%1 to %2%3").arg(limit(row.low), limit(row.high), row.automatic ? QStringLiteral(", auto") : QString());
}

}  // namespace

QString parameterReference() {
    const Scenario defaults;
    QString page =
        QStringLiteral("# ") + QCoreApplication::translate("manual", "Parameters") + QStringLiteral("\n\n") +
        QCoreApplication::translate(
            "manual", "Every setting of a scenario, as the panels, `rubble-cli --set key=value` and the case file know it.") +
        QStringLiteral("\n\n|") +
        QCoreApplication::translate("manual", "Key|Meaning|Unit|Default|Values|What it does and what it costs") +
        QStringLiteral("|\n|---|---|---|---|---|---|\n");
    for (const Parameter& row : parameterTable()) {
        const QString byDefault = row.subject() == ParameterSubject::Pair
                                      ? QStringLiteral("auto")
                                      : QString::fromStdString(valueText(row.get(defaults, {})));
        page += QStringLiteral("|`%1`|%2|%3|%4|%5|%6|\n")
                    .arg(qt(row.key), widgets::said("parameters", row.label), qt(row.unit), byDefault, rangeText(row),
                         widgets::said("parameters", row.help).replace(u'|', u'/'));
    }
    return page;
}

QStringList headingsOf(const QString& text) {
    QStringList headings;
    for (const QString& line : text.split(u'\n')) {
        if (line.startsWith(u'#')) {
            headings << QString(line).remove(u'#').trimmed();
        }
    }
    return headings;
}

std::vector<ManualPage> manualPages() {
    std::vector<ManualPage> pages;
    const QString language = widgets::currentLanguage();
    const QDir folder(QStringLiteral(":/manual"));
    for (const QString& name : folder.entryList({QStringLiteral("*.md")}, QDir::Files, QDir::Name)) {
        const QString english = contentOf(folder.filePath(name));
        const QString own = contentOf(folder.filePath(language + u'/' + name));
        const QString& text = own.isEmpty() ? english : own;
        const QStringList headings = headingsOf(english);
        pages.push_back({headingsOf(text).value(0), text, headings.value(0), headings,
                         language == QLatin1String("en") || !own.isEmpty(), name});
    }
    for (const auto& [text, name] :
         {std::pair(parameterReference(), "Parameters"), std::pair(actionReference(), "Actions and keys")}) {
        pages.push_back({headingsOf(text).value(0), text, QLatin1String(name), {QLatin1String(name)}, true});
    }
    return pages;
}

}  // namespace rubble
