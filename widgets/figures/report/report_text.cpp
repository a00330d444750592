#include "widgets/figures/report/report_text.h"

#include <QCoreApplication>
#include <QFileInfo>
#include <QLocale>

#include <algorithm>
#include <cmath>

#include "widgets/figures/report/report_sections.h"
#include "widgets/figures/shown_units.h"

namespace rubble::figures {
namespace {

QLocale numbers() {
    const QLocale locale;
    return locale.language() == QLocale::C ? QLocale(QLocale::English) : locale;
}

QString code(const std::string& text) {
    return QStringLiteral("<code>") + QString::fromStdString(text).toHtmlEscaped() + QStringLiteral("</code>");
}

}  // namespace

QString reportNumber(double value, int digits) {
    if (!std::isfinite(value)) {
        return QStringLiteral("–");
    }
    if (value == 0.0) {
        return QStringLiteral("0");
    }
    const int power = static_cast<int>(std::floor(std::log10(std::abs(value)) + 1e-12));
    if (power < -4 || power > 7) {
        const double mantissa = value / std::pow(10.0, power);
        return QStringLiteral("%1 × 10<sup>%2</sup>").arg(numbers().toString(mantissa, 'f', std::max(0, digits - 1))).arg(power);
    }
    const double step = std::pow(10.0, power - digits + 1);
    const double rounded = step > 1.0 ? std::round(value / step) * step : value;
    return numbers().toString(rounded, 'f', std::max(0, digits - 1 - power)).replace(u'-', QStringLiteral("−"));
}

QString reportSeconds(double seconds) {
    if (seconds != 0.0 && std::abs(seconds) < 0.1) {
        return reportNumber(seconds);
    }
    return std::isfinite(seconds) ? numbers().toString(seconds, 'f', 2).replace(u'-', QStringLiteral("−")) : QStringLiteral("–");
}

QString unitShown(QString unit) {
    unit = raisedUnits(unit);
    return unit.startsWith(QLatin1String("x ")) ? QStringLiteral("× ") + unit.mid(2) : unit;
}

QString escaped(const std::string& text) {
    return QString::fromStdString(text).toHtmlEscaped();
}

QString rangedNumber(double value, const FigureRange& range) {
    const double width = range.high - range.low;
    if (!std::isfinite(width) || width <= 0.0) {
        return reportNumber(value);
    }
    // Down to the first two figures of the range, of the value at least two and no more than four.
    const double digits = std::floor(std::log10(std::max(std::abs(value), 1e-300))) - std::floor(std::log10(width)) + 2.0;
    const int shown = static_cast<int>(std::clamp(digits, 2.0, 4.0));
    return QCoreApplication::translate("rubble::figures::ReportSections", "%1 (%2 to %3)")
        .arg(reportNumber(value, shown), reportNumber(range.low, shown), reportNumber(range.high, shown));
}

QString shortDigest(const std::string& digest) {
    return code(digest.substr(0, 16) + (digest.size() > 16 ? "…" : ""));
}

ReportDocument composeReport(const ReportFacts& facts, const ReportPictures& pictures) {
    ReportDocument document;
    document.title = QString::fromStdString(facts.title);
    document.subtitle = ReportSections::tr("Where the debris of the collapse went: simulation report");
    document.language = QLocale().language() == QLocale::Chinese ? QStringLiteral("zh-CN") : QStringLiteral("en");
    document.contents = ReportSections::tr("Contents");
    document.page = ReportSections::tr("page %1 of %2");
    document.figure = ReportSections::tr("Figure %1");
    document.table = ReportSections::tr("Table %1");
    document.header =
        ReportSections::tr("%1 · run %2").arg(document.title, QString::fromStdString(facts.fingerprint.substr(0, 16)));
    const auto fact = [&](const QString& name, const QString& value) {
        if (!value.isEmpty()) {
            document.facts.emplace_back(name, value);
        }
    };
    fact(ReportSections::tr("Made by"), QString::fromStdString(facts.author).toHtmlEscaped());
    // ISO 8601, as a reader has it.
    fact(ReportSections::tr("Made on (UTC)"),
         QString::fromStdString(facts.when).replace(QLatin1Char('T'), QLatin1Char(' ')).remove(QLatin1Char('Z')));
    fact(ReportSections::tr("Scenario"), QString::fromStdString(facts.scenarioName).toHtmlEscaped());
    fact(ReportSections::tr("FE result"), QFileInfo(QString::fromStdString(facts.fe->contents().path)).fileName().toHtmlEscaped());
    fact(ReportSections::tr("SHA-256 of the FE result"), code(facts.fe->contents().sha256));
    fact(ReportSections::tr("Fingerprint of the run"), code(facts.fingerprint));
    fact(ReportSections::tr("Trajectory hash"), code(facts.result->trajectoryHash.hex()));
    fact(ReportSections::tr("Program"), QString::fromStdString(facts.build).toHtmlEscaped());
    fact(ReportSections::tr("Machine"), QString::fromStdString(facts.machine).toHtmlEscaped());

    ReportSections sections(facts, pictures);
    sections.addPlainSummary();
    sections.addSummary();
    sections.addEvidence();
    sections.addMethod();
    sections.addInputs();
    sections.addResults();
    sections.addEnsemble();
    sections.addAccuracy();
    sections.addValidation();
    sections.addAlternatives();
    sections.addEffects();
    sections.addHealth();
    sections.addSelfTest();
    sections.addLimits();
    sections.addChange();
    sections.addSignature();
    sections.addParameters();
    sections.addJournal();
    document.blocks = sections.take();
    return document;
}

}  // namespace rubble::figures
