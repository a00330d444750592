#include "app/gui/evidence/surveys/cloud_tools.h"

#include <QCoreApplication>
#include <QFileDialog>
#include <QFileInfo>
#include <QPointer>
#include <algorithm>
#include <utility>

#include "app/gui/evidence/evidence_work.h"
#include "app/gui/evidence/surveys/distance_words.h"
#include "app/gui/session/file_kinds.h"
#include "app/gui/session/save_path.h"
#include "app/gui/session/session.h"
#include "app/gui/stage/actions.h"
#include "core/evidence/evidence_list.h"
#include "core/evidence/scanned_site.h"
#include "io/base/files.h"
#include "io/case/case_file.h"
#include "io/exports/survey_files.h"
#include "io/run/run_cautions.h"
#include "io/site/clouds/distance_files.h"
#include "io/site/clouds/run_scan.h"
#include "io/site/site_place.h"
#include "io/site/surveys/measured_points.h"
#include "widgets/basics/wording.h"
#include "widgets/evidence/surveys/scan_dialog.h"
#include "widgets/evidence/surveys/scanner_dialog.h"
#include "widgets/evidence/surveys/scanner_field.h"
#include "widgets/figures/number_text.h"
#include "widgets/views/view_widget.h"

namespace rubble {

namespace {

QString scanText(const io::RunScan& made, const QString& path) {
    const auto count = [&](SiteThing thing) {
        return figures::countText(static_cast<std::size_t>(made.counts[static_cast<std::size_t>(thing)]));
    };
    const QString when = made.instant ? CloudTools::tr("Scanned at %1.").arg(widgets::shownWith(made.shape.time, "s"))
                                      : CloudTools::tr("Scanned at the end of the run.");
    const QString moving =
        made.moving.moving > 0
            ? QLatin1Char(' ') + CloudTools::tr("Not all lies at rest: %1 of %2 bodies still moved then.")
                                     .arg(widgets::shownCount(made.moving.moving), widgets::shownCount(made.moving.bodies))
            : QString();
    return when + moving + QLatin1Char(' ') +
           CloudTools::tr(
               "%1: %2 points; debris %3, fallen structure %4, standing structure %5, ground %6. Fragments seen: %7 of %8.")
               .arg(QFileInfo(path).fileName(), figures::countText(made.scan.places.size()), count(SiteThing::Debris),
                    count(SiteThing::FallenStructure), count(SiteThing::Structure), count(SiteThing::Ground),
                    figures::countText(static_cast<std::size_t>(made.debris.seen)),
                    figures::countText(static_cast<std::size_t>(made.debris.seen + made.debris.unseen)));
}

}  // namespace

std::vector<Vec3> scannersOfTable(QWidget* window, Session& session) {
    const QString path = QFileDialog::getOpenFileName(window, CloudTools::tr("Places of the scanners"),
                                                      QFileInfo(session.document().base()).absolutePath(), cloudFileKinds());
    std::vector<Vec3> places;
    if (path.isEmpty()) {
        return places;
    }
    try {
        const Frame frame = session.computation().inputs().frame;
        const Site& site = session.document().theCase().site;
        Findings found;
        places = io::readMeasuredPoints({path.toStdString(), {}, frame, site}, found, Execution());
        const io::SitePlace place(frame, site);
        std::transform(places.begin(), places.end(), places.begin(), [&](const Vec3& at) { return place.toWorld(at); });
        if (!found.empty()) {
            session.tell(widgets::worded(found.list().front().what));
        }
    } catch (...) {
        session.tell(failureOf(std::current_exception())->inOneLine());
    }
    return places;
}

void pickScanners(QWidget* window, Session& session, const widgets::ViewWidget& views, widgets::ScannerField& field) {
    const std::optional<std::vector<Vec3>> now = field.places();
    if (!now) {
        return;  // the field says what is wrong
    }
    const Inputs& inputs = session.computation().inputs();
    if (inputs.fe == nullptr) {
        session.tell(CloudTools::tr("Places are picked in the model: open the FE result first."));
        return;
    }
    const io::SitePlace place(inputs.frame, session.document().theCase().site);
    widgets::ScannerDialog dialog(
        *now, {[&](const Vec3& at) { return place.toWorld(at); }, [&](const Vec3& at) { return place.toLocal(at); }}, window);
    dialog.resize(window->window()->size().expandedTo({900, 640}).boundedTo({1400, 1000}));
    render::View view = views.view();
    view.layout = session.computation().currentRun() != nullptr ? render::Layout::FragmentsOnly : render::Layout::FeOnly;
    dialog.setModel(views.data(), view);
    if (dialog.exec() == QDialog::Accepted) {
        field.takePlaces(dialog.places());
    }
}

CloudTools::CloudTools(Session& session, Actions& actions, const widgets::ViewWidget& views, QWidget& window, QObject* parent)
    : QObject(parent),
      m_session(session),
      m_document(session.document()),
      m_computation(session.computation()),
      m_actions(actions),
      m_views(views),
      m_window(window) {
    connect(&actions[ActionId::ScanRun], &QAction::triggered, this, &CloudTools::scanRun);
    connect(&actions[ActionId::CompareClouds], &QAction::triggered, this, &CloudTools::compareClouds);
    connect(&m_document, &Document::replaced, this, [this] { m_worker.cancel(); });
}

QString CloudTools::wrongEnding() {
    return tr("Points are saved as LAS, PLY or CSV: end the name with .las, .ply or .csv.");
}

void CloudTools::refresh() {
    m_actions.enable(ActionId::ScanRun, EvidenceWork::whyNoDebris(m_computation.currentRun()).isEmpty());
    m_actions.enable(ActionId::CompareClouds, !m_document.empty());
}

void CloudTools::scanRun() {
    widgets::ScanDialog dialog(&m_window);
    if (const RunRecord* record = m_computation.currentRun(); record != nullptr && record->reader != nullptr) {
        const RunStanding standing = io::standingOf(*record->reader);
        dialog.setMoving(standing.moving, standing.bodies);
    }
    connect(&dialog, &widgets::ScanDialog::scanRequested, this, [&] { chooseScanFile(dialog); });
    connect(&dialog, &widgets::ScanDialog::cancelRequested, this, [&] { m_worker.cancel(); });
    connect(&dialog.scanners(), &widgets::ScannerField::tableRequested, this, [&] {
        if (const std::vector<Vec3> places = scannersOfTable(&dialog, m_session); !places.empty()) {
            dialog.scanners().takePlaces(places);
        }
    });
    connect(&dialog.scanners(), &widgets::ScannerField::pickRequested, this,
            [&] { pickScanners(&dialog, m_session, m_views, dialog.scanners()); });
    dialog.exec();
    m_worker.cancel();
}

void CloudTools::chooseScanFile(widgets::ScanDialog& dialog) {
    if (!dialog.scanners().places()) {
        return;  // the field says what is wrong
    }
    const QString path =
        askSavePath(&dialog, tr("Scan of the run"), QFileInfo(m_document.base()).absolutePath() + QStringLiteral("/scan.las"),
                    writtenCloudKinds());
    if (!path.isEmpty()) {
        scanTo(dialog, path);
    }
}

void CloudTools::scanTo(widgets::ScanDialog& dialog, const QString& path) {
    const RunRecord* record = m_computation.currentRun();
    if (!EvidenceWork::whyNoDebris(record).isEmpty()) {
        return;
    }
    if (!io::namesScan(path.toStdString())) {
        dialog.setContent({false, {}, wrongEnding(), {}});
        return;
    }
    const Inputs& inputs = m_computation.inputs();
    // Points lie where the run says that its site does.
    const io::SitePlace place(inputs.frame, record->reader->origin().site);
    ScanSettings settings = dialog.settings();
    std::transform(settings.scanners.begin(), settings.scanners.end(), settings.scanners.begin(),
                   [&](const Vec3& at) { return place.toLocal(at); });
    auto made = std::make_shared<io::RunScan>();
    dialog.setContent({true, {}, {}, {}});
    const QPointer<widgets::ScanDialog> shown(&dialog);
    m_worker.start({Worker::Kind::Study,
                    [made, settings, place, path = path.toStdString(), run = EvidenceRun(inputs, record), reader = record->reader,
                     instant = dialog.instant()](const Execution& execution) {
                        *made = io::scanRun(scannedSite(run.mapped(), instant, fallenFrom, execution), settings, execution);
                        made->instant = instant;
                        made->run = reader->origin().fingerprint.hex();
                        io::writeScan(path, *made, place);
                        io::writeProvenance(path, io::scanProvenance(*reader, *made, place));
                        io::tellUnsaidInstant(path, *made, made->findings);
                    },
                    [made, shown, path](const std::exception_ptr& thrown) {
                        if (shown == nullptr) {
                            return;
                        }
                        widgets::ScanDialog::Content content;
                        if (const auto failure = failureOf(thrown)) {
                            content.complaint = failure->inOneLine();
                        } else if (thrown == nullptr) {
                            content.said = scanText(*made, path);
                            content.findings = made->findings;
                        }
                        shown->setContent(content);
                    }});
}

std::vector<widgets::CloudPairDialog::Cloud> CloudTools::clouds() const {
    std::vector<widgets::CloudPairDialog::Cloud> found;
    for (const CaseInput& input : m_document.theCase().inputs) {
        if (input.role == InputRole::Survey && evidenceFormOf(input) == EvidenceForm::Cloud) {
            found.push_back({io::inputPath(m_document.base().toStdString(), input), input.taken, input.read});
        }
    }
    // Epochs in their order; those that are not known stay where they are.
    std::stable_sort(found.begin(), found.end(),
                     [](const auto& a, const auto& b) { return !a.taken.empty() && !b.taken.empty() && a.taken < b.taken; });
    return found;
}

void CloudTools::compareClouds() {
    widgets::CloudPairDialog dialog(clouds(), &m_window);
    m_made = nullptr;
    connect(&dialog, &widgets::CloudPairDialog::fileRequested, this, [&](bool second) {
        const QString path =
            QFileDialog::getOpenFileName(&dialog, tr("Point cloud"), QFileInfo(m_document.base()).absolutePath(), cloudFileKinds());
        if (!path.isEmpty()) {
            dialog.addCloud({path.toStdString()}, second);
        }
    });
    connect(&dialog, &widgets::CloudPairDialog::measureRequested, this, [&] { measure(dialog); });
    connect(&dialog, &widgets::CloudPairDialog::cancelRequested, this, [&] { m_worker.cancel(); });
    connect(&dialog, &widgets::CloudPairDialog::outdated, this, [this] {
        m_worker.cancel();
        m_made = nullptr;
    });
    connect(&dialog, &widgets::CloudPairDialog::saveRequested, this, [&] {
        const QString path =
            askSavePath(&dialog, tr("Distances"), QFileInfo(m_document.base()).absolutePath() + QStringLiteral("/distances.las"),
                        writtenCloudKinds());
        if (!path.isEmpty()) {
            saveTo(path);
        }
    });
    dialog.exec();
    m_worker.cancel();
    m_made = nullptr;
}

void CloudTools::measure(widgets::CloudPairDialog& dialog) {
    const auto first = dialog.first();
    const auto second = dialog.second();
    if (!first || !second) {
        return;
    }
    io::CloudComparisonRequest request;
    request.first = first->path;
    request.second = second->path;
    request.read = first->read.empty() ? second->read : first->read;
    request.metres = true;
    request.settings = dialog.settings();
    request.cell = dialog.cell();
    auto made = std::make_shared<io::CloudComparison>();
    m_made = nullptr;
    dialog.setContent({true, {}, {}, {}, false});
    const QPointer<widgets::CloudPairDialog> shown(&dialog);
    m_worker.start({Worker::Kind::Study,
                    [made, request](const Execution& execution) { *made = io::compareClouds(request, execution); },
                    [this, made, shown](const std::exception_ptr& thrown) {
                        if (shown == nullptr) {
                            return;
                        }
                        widgets::CloudPairDialog::Content content;
                        if (const auto failure = failureOf(thrown)) {
                            content.complaint = failure->inOneLine();
                        } else if (thrown == nullptr) {
                            m_made = made;
                            content.said = pairWords(*made);
                            content.findings = made->findings;
                            content.savable = true;
                        }
                        shown->setContent(content);
                    }});
}

void CloudTools::saveTo(const QString& path) {
    if (m_made == nullptr) {
        return;
    }
    if (!io::namesDistances(path.toStdString())) {
        m_session.tell(wrongEnding());
        return;
    }
    m_session.writeNow(path, [&] { io::writeDistanceFile(path.toStdString(), *m_made); });
}

}  // namespace rubble
