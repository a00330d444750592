#include "app/gui/exports/figure_return.h"

#include <QFileInfo>
#include <cmath>
#include <memory>
#include <utility>

#include "app/gui/case/recent_cases.h"
#include "app/gui/session/session.h"
#include "core/base/error.h"
#include "widgets/figures/view_json.h"

namespace rubble {

FigureReturn::FigureReturn(Session& session)
    : m_session(session), m_document(session.document()), m_computation(session.computation()) {
    // Queued: the window shows a case or a run first, then what the figure shows of it.
    connect(&m_computation, &Computation::prepared, this, &FigureReturn::prepared, Qt::QueuedConnection);
    const auto reopened = [this] {
        if (m_going && m_going->runAsked) {
            show();
        }
    };
    connect(&m_computation, &Computation::runReopened, this, reopened, Qt::QueuedConnection);
    connect(&m_computation, &Computation::failed, this, [this] { m_going.reset(); });
}

bool FigureReturn::carriesSource(const QString& path) {
    const QString ending = QFileInfo(path).suffix().toLower();
    if (ending != QLatin1String("png") && ending != QLatin1String("svg") && ending != QLatin1String("pdf") &&
        ending != QLatin1String("mp4")) {
        return false;
    }
    try {
        return io::readProvenance(path.toStdString()).has_value();
    } catch (const Error&) {
        // It does, but is damaged: that is told when it is read again.
        return QFileInfo::exists(path);
    }
}

void FigureReturn::begin(const QString& path) {
    auto going = std::make_shared<Going>();
    going->figure = path;
    std::vector<std::string> known;
    if (!m_document.path().isEmpty()) {
        known.push_back(m_document.path().toStdString());
    }
    for (const RecentCase& recent : RecentCases({}).list()) {
        known.push_back(recent.path.toStdString());
    }
    m_computation.write(
        [going, known](const Execution& execution) {
            execution.report({"gui.finding_case", "Finding the case of the figure", {}}, 0.0);
            const auto provenance = io::readProvenance(going->figure.toStdString());
            if (!provenance) {
                throw UsageError({"gui.no_provenance", "{0} does not say what it was made from", {going->figure.toStdString()}},
                                 {"gui.no_provenance.remedy", "Open the case itself.", {}});
            }
            going->provenance = *provenance;
            going->source = io::findSource(*provenance, going->figure.toStdString(), known, execution);
        },
        [this, going](const std::exception_ptr& thrown) {
            if (const auto failure = failureOf(thrown)) {
                m_session.report(*failure);
            } else if (thrown == nullptr) {
                m_going = *going;
                found();
            }
        });
}

void FigureReturn::found() {
    const QString path = QString::fromStdString(m_going->source.path);
    const auto& fe = m_computation.inputs().fe;
    const bool here = fe != nullptr && fe->contents().sha256 == m_going->provenance.feSha256 &&
                      (!m_going->source.isCase || QFileInfo(m_document.path()) == QFileInfo(path));
    m_going->opened = true;
    if (here) {
        prepared();
    } else {
        emit openRequested(path);
    }
}

void FigureReturn::prepared() {
    const auto& fe = m_computation.inputs().fe;
    if (!m_going || !m_going->opened || m_going->runAsked || fe == nullptr ||
        fe->contents().sha256 != m_going->provenance.feSha256) {
        return;
    }
    const std::string& scenario = m_going->source.scenarioId;
    if (!scenario.empty() && m_document.active() != nullptr && m_document.active()->id != scenario) {
        m_document.activateScenario(scenario);
        return;  // comes back when that is prepared
    }
    const RunRecord* record = m_computation.currentRun();
    const bool shown = record != nullptr && record->reader != nullptr &&
                       record->reader->origin().fingerprint.hex() == m_going->provenance.fingerprint;
    if (!shown && !m_going->source.runPath.empty()) {
        m_going->runAsked = true;
        m_computation.showRun(QString::fromStdString(m_going->source.runPath), std::nan(""));
        return;
    }
    show();
}

void FigureReturn::show() {
    const Going going = *std::exchange(m_going, std::nullopt);
    try {
        if (!going.provenance.view.empty()) {
            emit viewRequested(figures::viewFromJson(going.provenance.view, going.figure.toStdString()), going.provenance.aspect);
        }
        const RunRecord* record = m_computation.currentRun();
        const bool same = record != nullptr && record->reader != nullptr &&
                          record->reader->origin().fingerprint.hex() == going.provenance.fingerprint;
        const QString name = QFileInfo(going.figure).fileName();
        m_session.tell(going.provenance.fingerprint.empty() || same
                           ? tr("Shown as in %1").arg(name)
                           : tr("The view of %1; its run is not kept here, so simulate to see its fragments").arg(name));
    } catch (...) {
        const auto failure = failureOf(std::current_exception());
        m_session.report(*failure);
    }
}

}  // namespace rubble
