#include "app/gui/exports/chart_export.h"

#include <QCoreApplication>
#include <QFileInfo>
#include <QJsonArray>
#include <QJsonDocument>
#include <QJsonObject>
#include <ostream>

#include "app/gui/exports/export_source.h"
#include "app/gui/session/save_path.h"
#include "app/gui/session/session.h"
#include "app/gui/studies/study_work.h"
#include "core/base/build.h"
#include "io/base/files.h"
#include "io/exports/ensemble_origin.h"
#include "io/exports/provenance.h"
#include "io/run/run_cautions.h"
#include "widgets/basics/wording.h"
#include "widgets/figures/figure_file.h"
#include "widgets/run/caution_words.h"

namespace rubble {

namespace {

constexpr QSize chartSize(960, 640);

class ChartWords {
    Q_DECLARE_TR_FUNCTIONS(rubble::ChartExport)
};

QStringList wordsOf(const Findings& findings) {
    QStringList parts;
    for (const Finding& finding : findings.list()) {
        parts << widgets::worded(finding.what);
    }
    return parts;
}

/// Of the file without all of its endings.
QString caseName(Session& session) {
    const QString name = QFileInfo(session.document().base()).fileName();
    return name.left(name.indexOf(u'.') > 0 ? name.indexOf(u'.') : name.size());
}

/// @param settings  of what is drawn, JSON; empty: none
std::string provenanceOf(Session& session, const std::string& name, const std::string& settings, const io::RunReader* run) {
    io::ExportRecord exported;
    exported.kind = "chart";
    exported.shown.push_back({name, 0.0, {}, run != nullptr ? "simulated" : "compared"});
    exported.settings = settings;
    exported.casePath = session.document().path().toStdString();
    return io::exportProvenance(exported, shownOrigin(session.document(), session.computation()), run);
}

}  // namespace

ChartSource ChartExport::history() const {
    ChartSource source;
    source.note.subject = caseName(m_session);
    const RunRecord* record = m_session.computation().currentRun();
    const io::RunReader* run = record != nullptr ? record->reader.get() : nullptr;
    if (run != nullptr) {
        source.note.cautions = widgets::cautionWords(runCautions(io::standingOf(*run)));
    }
    source.note.foot =
        QString::fromStdString(io::footLine(shownOrigin(m_session.document(), m_session.computation()), run != nullptr));
    source.provenance = provenanceOf(m_session, "History curves", {}, run);
    return source;
}

ChartSource ChartExport::sweep(const AccuracyReport& report, const std::string& machine) const {
    ChartSource source;
    source.note.subject = caseName(m_session);
    QStringList cautions = wordsOf(report.findings);
    if (!report.complete) {
        cautions.prepend(ChartWords::tr("Not all settings were compared"));
    }
    source.note.cautions = widgets::inOneLine(cautions);
    source.note.foot =
        QString::fromStdString(machine + "; " + io::footLine(shownOrigin(m_session.document(), m_session.computation()), false));
    QJsonArray settings;
    for (const AccuracyPoint& point : report.points) {
        settings.append(QString::fromStdString(point.setting));
    }
    QJsonObject object;
    object[QLatin1String("reference")] = QString::fromStdString(report.reference.setting);
    object[QLatin1String("settings")] = settings;
    object[QLatin1String("complete")] = report.complete;
    object[QLatin1String("machine")] = QString::fromStdString(machine);
    source.provenance = provenanceOf(m_session, "Accuracy against time",
                                     QJsonDocument(object).toJson(QJsonDocument::Compact).toStdString(), nullptr);
    return source;
}

ChartSource ChartExport::calibration(const Calibration& calibration) {
    ChartSource source;
    source.note.cautions = widgets::inOneLine(wordsOf(calibration.findings));
    source.note.foot = QString::fromStdString(
        calibration.machine + (calibration.renderer.empty() ? "" : "; " + calibration.renderer) + "; " + calibration.build);
    return source;
}

ChartSource ChartExport::causes(const MadeComparison& made) {
    ChartSource source;
    QStringList evidence;
    if (made.comparison != nullptr) {
        for (const std::string& name : made.comparison->evidence) {
            evidence << QString::fromStdString(name).section(u'/', -1);
        }
    }
    source.note.subject = evidence.join(QStringLiteral(", "));
    QStringList cautions;
    if (const QString known = widgets::cautionWords(io::separationCautions(made.hypotheses, made.basis)); !known.isEmpty()) {
        cautions << known;
    }
    if (made.comparison != nullptr) {
        cautions << wordsOf(made.comparison->findings);
    }
    source.note.cautions = widgets::inOneLine(cautions);
    source.note.foot =
        ChartWords::tr("Members of each cause: %1.")
            .arg(widgets::shownCount(made.hypotheses.empty() ? 0 : made.hypotheses.front().ensemble->done().size())) +
        u' ' + QString::fromStdString(std::string(buildText()));
    source.provenance = io::causesProvenance(made.hypotheses, made.basis);
    return source;
}

void ChartExport::save(const widgets::FileChart& chart, const QString& suffix, const ChartSource& source) {
    const QFileInfo base(m_session.document().base());
    const QString path = askSavePath(&m_window, ChartWords::tr("Chart"), base.absolutePath() + u'/' + caseName(m_session) + suffix,
                                     ChartWords::tr("Drawings (*.svg);;Images (*.png)"));
    if (!path.isEmpty()) {
        saveTo(path, chart, source);
    }
}

void ChartExport::saveTo(const QString& path, const widgets::FileChart& chart, const ChartSource& source) {
    m_session.writeNow(path, [&] { write(path, chart, source); });
}

void ChartExport::write(const QString& path, const widgets::FileChart& chart, const ChartSource& source) {
    if (QFileInfo(path).suffix().compare(QLatin1String("svg"), Qt::CaseInsensitive) == 0) {
        const QByteArray drawing = chart.svg(chartSize, source.note);
        io::writeAtomically(path.toStdString(), [&](std::ostream& out) { out.write(drawing.data(), drawing.size()); });
    } else {
        figures::writePng(path.toStdString(), chart.image(2 * chartSize, source.note));
    }
    if (!source.provenance.empty()) {
        io::writeProvenance(path.toStdString(), source.provenance);
    }
}

}  // namespace rubble
