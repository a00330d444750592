#include "app/gui/evidence/cloud_points.h"

#include <QFileInfo>
#include <algorithm>
#include <cmath>
#include <utility>

#include "app/gui/evidence/evidence_work.h"
#include "app/gui/evidence/survey_display.h"
#include "app/gui/evidence/surveys/cloud_tools.h"
#include "app/gui/evidence/surveys/distance_words.h"
#include "app/gui/session/file_kinds.h"
#include "app/gui/session/save_path.h"
#include "app/gui/session/session.h"
#include "app/gui/stage/actions.h"
#include "app/gui/stage/panel_deck.h"
#include "app/gui/stage/scene_display.h"
#include "app/gui/stage/view_area.h"
#include "core/base/error.h"
#include "core/evidence/evidence_list.h"
#include "core/evidence/scanned_site.h"
#include "core/evidence/surveys/stated_survey.h"
#include "io/base/files.h"
#include "io/case/case_file.h"
#include "io/case/case_photographs.h"
#include "io/exports/survey_files.h"
#include "io/site/clouds/distance_files.h"
#include "io/site/clouds/e57/placed_photographs.h"
#include "io/site/site_place.h"
#include "widgets/basics/wording.h"
#include "widgets/evidence/evidence_panel.h"
#include "widgets/evidence/survey_box.h"
#include "widgets/evidence/surveys/distance_fields.h"
#include "widgets/evidence/surveys/point_box.h"
#include "widgets/evidence/surveys/scanner_field.h"
#include "widgets/figures/number_text.h"

namespace rubble {

CloudPoints::CloudPoints(Session& session, PanelDeck& deck, SceneDisplay& scene, SurveyDisplay& surveys, ViewArea& area,
                         Actions& actions, QObject* parent)
    : QObject(parent),
      m_session(session),
      m_document(session.document()),
      m_computation(session.computation()),
      m_deck(deck),
      m_scene(scene),
      m_surveys(surveys),
      m_area(area),
      m_actions(actions),
      m_work(session.part<PointsWork>()) {
    m_pause.setSingleShot(true);
    m_pause.setInterval(120);
    connect(&m_pause, &QTimer::timeout, this, &CloudPoints::ask);
    widgets::PointBox& box = deck.evidence().survey().points();
    if (m_work.asked) {
        box.distances().setSettings(*m_work.asked);
        box.distances().setCell(m_work.cell);
    }
    connect(&box, &widgets::PointBox::shownChosen, this, &CloudPoints::setShown);
    connect(&box, &widgets::PointBox::colourChosen, this, &CloudPoints::setColour);
    connect(&box, &widgets::PointBox::photographsRequested, this, &CloudPoints::addPhotographs);
    connect(&box, &widgets::PointBox::photographsCancelled, this, &CloudPoints::stopPhotographs);
    connect(&box, &widgets::PointBox::measureRequested, this, &CloudPoints::measure);
    connect(&box, &widgets::PointBox::cancelRequested, this, &CloudPoints::stopMeasuring);
    connect(&box, &widgets::PointBox::saveRequested, this, &CloudPoints::saveDistances);
    const auto scanners = [this](const std::vector<Vec3>& places) {
        m_surveys.edit([&](CaseInput& input) { input.scanners = places; }, [] { return tr("where the scanners stood"); });
    };
    connect(&box.scanners(), &widgets::ScannerField::edited, this, scanners);
    connect(&box.scanners(), &widgets::ScannerField::tableRequested, this, [this, scanners] {
        if (const std::vector<Vec3> places = scannersOfTable(m_area.window(), m_session); !places.empty()) {
            scanners(places);
        }
    });
    connect(&box.scanners(), &widgets::ScannerField::pickRequested, this,
            [this, &box] { pickScanners(m_area.window(), m_session, m_area.views(), box.scanners()); });
    connect(&actions[ActionId::CloudPoints], &QAction::triggered, this, &CloudPoints::setShown);
    connect(&actions[ActionId::MeasureCloud], &QAction::triggered, this, &CloudPoints::measure);
    connect(&m_work, &PointsWork::changed, this, &CloudPoints::refresh);
    connect(&surveys, &SurveyDisplay::changed, this, &CloudPoints::refresh);
    connect(&scene, &SceneDisplay::viewSet, this, &CloudPoints::refresh);
    connect(&scene, &SceneDisplay::changed, this, &CloudPoints::refresh);
    connect(&area.views(), &widgets::ViewWidget::shown, this, &CloudPoints::follow);
    connect(&m_document, &Document::replaced, this, [this] {
        stopMeasuring();
        stopPhotographs();
        m_work.distances.drop();
        m_work.close();
        // Ids of surveys are alike in all cases: its own first cloud is another one.
        render::View view = m_area.views().view();
        view.cloud.clear();
        m_scene.setView(view);
        refresh();
    });
    refresh();
}

CloudPoints::~CloudPoints() {
    const widgets::PointBox& box = m_deck.evidence().survey().points();
    m_work.asked = box.distances().settings();
    m_work.cell = box.distances().cell();
}

void CloudPoints::stopMeasuring() {
    m_work.making = nullptr;
    m_work.measuring.cancel();
    if (!m_work.measuring.busy()) {
        m_work.distances.end();  // one that had not begun never ends by itself
    }
}

bool CloudPoints::busy() const {
    return m_pause.isActive() || m_work.worker.busy() || m_work.pictures.busy() || m_work.distances.running();
}

std::optional<PointsWork::Cloud> CloudPoints::cloudOf(const std::string& id) const {
    const Inputs& inputs = m_computation.inputs();
    for (const CaseInput& input : m_document.theCase().inputs) {
        if (input.id == id && inputs.fe != nullptr && input.role == InputRole::Survey &&
            evidenceFormOf(input) == EvidenceForm::Cloud) {
            return PointsWork::Cloud{id,
                                     io::inputPath(m_document.base().toStdString(), input),
                                     inputs.frame,
                                     m_document.theCase().site,
                                     input.registration,
                                     input.read};
        }
    }
    return std::nullopt;
}

void CloudPoints::setShown(bool shown) {
    const CaseInput* survey = m_surveys.current();
    render::View view = m_area.views().view();
    view.cloud = shown && survey != nullptr ? survey->id : std::string();
    m_scene.setView(view);
    if (!view.cloud.empty()) {
        emit viewsRequested();
    }
}

void CloudPoints::setColour(render::PointColour colour) {
    render::View view = m_area.views().view();
    view.pointColour = colour;
    m_scene.setView(view);
}

void CloudPoints::refresh() {
    takePhotographs();
    const render::View& view = m_area.views().view();
    const std::optional<PointsWork::Cloud> wanted = view.cloud.empty() ? std::nullopt : cloudOf(view.cloud);
    if (!wanted && m_work.cloud) {
        m_work.close();
        m_asked.reset();
    } else if (wanted && !(m_work.cloud && *m_work.cloud == *wanted)) {
        m_asked.reset();
        m_work.open(*wanted);  // comes back here
        return;
    }
    publish();
    follow();
    showBox();
}

void CloudPoints::follow() {
    const render::View& view = m_area.views().view();
    const bool other = !m_asked || m_asked->second != m_area.views().size() || m_asked->first.layout != view.layout ||
                       m_asked->first.cameras != view.cameras || m_asked->first.camerasLinked != view.camerasLinked ||
                       m_asked->first.pointColour != view.pointColour;
    if (m_work.opened != nullptr && !m_work.failure && other && !m_pause.isActive()) {
        m_pause.start();
    }
}

void CloudPoints::ask() {
    if (m_work.opened == nullptr) {
        return;
    }
    const render::View& view = m_area.views().view();
    m_asked = {view, m_area.views().size()};
    const QSize size = m_area.views().size() * m_area.views().devicePixelRatioF();
    PointsWork::Look look;
    look.colour = view.pointColour;
    for (const render::Pane& pane : render::panesOf(view.layout, size.width(), size.height())) {
        look.panes.emplace_back(pane, render::cameraOf(view, pane.content));
    }
    m_work.look(look);
}

bool CloudPoints::distancesShown() const {
    const RunRecord* record = m_computation.currentRun();
    const PointsWork::Measured& of = m_work.distances.answered();
    return m_area.views().view().pointColour == render::PointColour::Distance && m_work.distances.result() != nullptr &&
           m_work.cloud && of.cloud == *m_work.cloud && record != nullptr && of.run == record->reader;
}

void CloudPoints::publish() {
    const auto measured = m_work.distances.result();
    if (measured != nullptr && distancesShown()) {
        m_scene.setPoints(measured->points);
    } else {
        m_scene.setPoints(m_work.points);
    }
}

std::optional<PointsWork::Measured> CloudPoints::measuredNow() const {
    const CaseInput* survey = m_surveys.current();
    const RunRecord* record = m_computation.currentRun();
    if (survey == nullptr || record == nullptr) {
        return std::nullopt;
    }
    const std::optional<PointsWork::Cloud> cloud = cloudOf(survey->id);
    if (!cloud) {
        return std::nullopt;
    }
    PointsWork::Measured now{*cloud,
                             *survey,
                             record->reader,
                             m_deck.evidence().survey().points().distances().settings(),
                             m_deck.evidence().survey().points().distances().cell().value_or(0.0),
                             {}};
    now.survey.scope = scopeWhenTaken(m_document.theCase(), *survey, now.said);
    return now;
}

void CloudPoints::measure() {
    const std::optional<PointsWork::Measured> order = measuredNow();
    if (!order || !EvidenceWork::whyNoDebris(m_computation.currentRun()).isEmpty() || m_work.distances.running()) {
        return;
    }
    m_work.distances.ask(*order);
    auto made = std::make_shared<PointsWork::Distances>();
    m_work.making = made;
    const std::string name = QFileInfo(QString::fromStdString(order->cloud.path)).fileName().toStdString();
    m_work.measuring.start(
        {Worker::Kind::Study,
         [made, order = *order, name, fingerprint = m_computation.currentRun()->reader->origin().fingerprint.hex(),
          run = EvidenceRun(m_computation.inputs(), m_computation.currentRun())](const Execution& execution) {
             checkShowsDebris(order.survey);
             made->source = sourceOf(order.cloud);
             ScannedSite site = scannedSite(run.mapped(), order.survey.instant, fallenFrom, execution);
             made->time = site.shape.time;
             io::RunDistanceRequest request;
             request.cloud = order.cloud.path;
             request.fingerprint = fingerprint;
             request.read = order.cloud.read;
             request.frame = order.cloud.frame;
             request.site = order.cloud.site;
             request.placed = order.cloud.placed;
             request.scope = order.survey.scope;
             request.settings = order.settings;
             request.cell = order.cell;
             request.scanners = order.survey.scanners;
             if (!request.settings.registrationError) {
                 request.settings.registrationError = order.survey.offsetError;
             }
             made->made = io::compareCloudWithSite(request, std::move(site.shape), site.ground, site.volumes, execution);
             made->made.compared.findings.append(order.said);
             const io::SitePlace place(order.cloud.frame, order.cloud.site);
             for (const Vec3& core : made->made.compared.cores) {
                 made->cores.push_back(place.toLocal(core));
             }
             made->points = distancePoints(*made, name);
         },
         [work = &m_work, made](const std::exception_ptr& thrown) {
             if (thrown == nullptr && made == work->making) {
                 work->distances.take(made);
             }
             const auto failure = failureOf(thrown);
             work->distances.end(failure ? &*failure : nullptr);
             emit work->changed();
         }});
    render::View view = m_area.views().view();
    view.cloud = order->survey.id;
    view.pointColour = render::PointColour::Distance;
    m_scene.setView(view);
    emit viewsRequested();
    refresh();
}

int CloudPoints::photographsOf(const CaseInput& survey) {
    const std::string path = io::inputPath(m_document.base().toStdString(), survey);
    if (m_pictures.first != path) {
        m_pictures = {path, 0};
        try {
            // Only an E57 holds any; its head is read in no time.
            if (io::hasEnding(path, ".e57")) {
                const std::vector<io::CloudPhotograph> all = io::openCloud(path)->head().photographs;
                m_pictures.second = static_cast<int>(std::count_if(all.begin(), all.end(), io::hasPlace));
            }
        } catch (const Error&) {
            m_pictures.second = 0;  // what is wrong with it is said where its points are shown or compared
        }
    }
    const std::string folder = QFileInfo(QString::fromStdString(path)).fileName().toStdString() + "-photographs/";
    const std::vector<CaseInput>& inputs = m_document.theCase().inputs;
    const auto known = std::count_if(inputs.begin(), inputs.end(), [&](const CaseInput& input) {
        return input.role == InputRole::Photograph && input.path.find(folder) != std::string::npos;
    });
    return std::max(0, m_pictures.second - static_cast<int>(known));
}

void CloudPoints::addPhotographs() {
    const CaseInput* survey = m_surveys.current();
    const Inputs& inputs = m_computation.inputs();
    if (survey == nullptr || inputs.fe == nullptr) {
        return;
    }
    if (m_work.pictures.busy() || m_work.adding != nullptr) {
        return;
    }
    auto made = std::make_shared<PointsWork::Pictures>();
    made->before = made->after = m_document.theCase();
    made->base = m_document.base();
    made->frame = inputs.frame;
    m_work.picturesFraction = 0.0;
    m_work.adding = made;
    m_work.pictures.start({Worker::Kind::Study,
                           [made, cloud = io::inputPath(made->base.toStdString(), *survey)](const Execution& execution) {
                               made->added = io::addPhotographsOfCloud(made->after, made->base.toStdString(), cloud, made->frame,
                                                                       made->findings, execution);
                           },
                           [work = &m_work, made](const std::exception_ptr& thrown) {
                               made->failure = failureOf(thrown);
                               if (thrown != nullptr && !made->failure && made == work->adding) {
                                   work->adding = nullptr;
                               }
                               made->done = true;
                               emit work->changed();
                           }});
    refresh();
}

/// Takes photographs that are ready, whichever window asked for them.
void CloudPoints::takePhotographs() {
    if (m_work.adding == nullptr || !m_work.adding->done) {
        return;
    }
    const std::shared_ptr<PointsWork::Pictures> made = std::exchange(m_work.adding, nullptr);
    const Case& now = m_document.theCase();
    if (made->failure) {
        m_session.tell(made->failure->inOneLine());
    } else if (now.inputs != made->before.inputs || now.photographs != made->before.photographs || now.site != made->before.site ||
               m_document.base() != made->base || m_computation.inputs().frame != made->frame) {
        m_session.tell(tr("The case changed meanwhile: add the photographs once more."));
    } else {
        made->added.written->kept = true;
        showAdded(made->added, std::move(made->after), made->findings);
    }
}

void CloudPoints::showAdded(const io::AddedPhotographs& added, Case&& theCase, const Findings& findings) {
    if (!added.ids.empty()) {
        m_document.setPhotographs(std::move(theCase.photographs), std::move(theCase.inputs),
                                  [count = added.ids.size()] { return tr("%1 photographs of the cloud added").arg(count); });
    }
    QString told = tr("Photographs added with the camera that the cloud states: %1").arg(added.ids.size());
    if (!findings.empty()) {
        told += QStringLiteral(" · ") + widgets::worded(findings.list().front().what);
    }
    m_session.tell(told);
}

void CloudPoints::stopPhotographs() {
    m_work.adding = nullptr;
    m_work.pictures.cancel();
    refresh();
}

QString CloudPoints::statusText() const {
    if (m_work.opened == nullptr) {
        return m_work.failure ? QString() : tr("The octree is made or opened, %1 %").arg(std::lround(100.0 * m_work.fraction));
    }
    const io::PlacedOctree& placed = *m_work.opened->octree;
    const io::CloudOctree& octree = placed.octree();
    QString text;
    if (distancesShown()) {
        text = tr("Places of which the distance was measured are drawn.");
    } else if (m_work.points != nullptr) {
        text = tr("%1 of %2 points are drawn.")
                   .arg(figures::countText(m_work.points->shown), figures::countText(octree.head().points));
    }
    if (!distancesShown() && m_area.views().view().pointColour == render::PointColour::Distance) {
        text += u' ' + tr("No distances to this run were measured: colours say the height.");
    }
    if (!distancesShown() && !m_work.whole) {
        text += u' ' + tr("Finer ones were left out: no more than %1 are.").arg(figures::countText(pointsBudget));
    }
    if (const std::uint64_t far = m_work.points != nullptr ? m_work.points->source.far : 0; far > 0 && !distancesShown()) {
        text += u' ' + tr("%1 points lie far from the others and are not drawn.").arg(figures::countText(far));
    }
    const QString megabytes = figures::countText((octree.bytes() + 999'999) / 1'000'000);
    const QString path = QString::fromStdString(octree.path());
    return text + u' ' +
           (placed.made() ? tr("The octree was made: %1, %2 MB.") : tr("The octree: %1, %2 MB.")).arg(path, megabytes);
}

QString CloudPoints::measuredText() const {
    if (m_work.distances.running()) {
        return tr("Distances are being measured.");
    }
    const std::shared_ptr<const PointsWork::Distances>& made = m_work.distances.result();
    const CaseInput* survey = m_surveys.current();
    if (m_work.distances.failure() && survey != nullptr && m_work.distances.asked().survey.id == survey->id) {
        return m_work.distances.failure()->inOneLine();
    }
    if (made == nullptr || survey == nullptr || m_work.distances.answered().survey.id != survey->id) {
        return {};
    }
    const render::SitePoints& points = *made->points;
    const QString text = tr("%1 of %2 distances differ by more than the level of detection.")
                             .arg(figures::countText(points.significant), figures::countText(points.shown));
    const io::SightedDebris& debris = made->made.debris;
    const QString seen = debris.unseen == 0
                             ? QString()
                             : u' ' + tr("Fragments that no point looks at: %1 of %2.")
                                          .arg(figures::countText(static_cast<std::size_t>(debris.unseen)),
                                               figures::countText(static_cast<std::size_t>(debris.unseen + debris.seen)));
    QStringList words{text + u' ' + detectionWords(points.detection, points.registered) + seen};
    words << sightWords(made->made);
    if (made->made.compared.volumes) {
        words << volumeWords(*made->made.compared.volumes, made->made.compared.cubicMetres) + u' ' +
                     tr("Fill is where the run lies above the cloud.");
    }
    if (!distancesKept()) {
        words << tr("They are of another run or other settings.");
    }
    return words.join(QLatin1Char(' '));
}

/// Distances were measured of what is chosen now.
bool CloudPoints::distancesKept() const {
    const auto now = measuredNow();
    return now && m_work.distances.result() != nullptr && !m_work.distances.running() && !m_work.distances.stale(*now);
}

void CloudPoints::saveDistances() {
    const QString path =
        askSavePath(m_area.window(), tr("Distances"),
                    QFileInfo(m_document.base()).absolutePath() + QStringLiteral("/distances.las"), writtenCloudKinds());
    if (!path.isEmpty()) {
        saveDistancesTo(path);
    }
}

void CloudPoints::saveDistancesTo(const QString& path) {
    const RunRecord* record = m_computation.currentRun();
    if (!distancesKept() || record == nullptr || record->reader == nullptr) {
        return;
    }
    if (!io::namesDistances(path.toStdString())) {
        m_session.tell(CloudTools::wrongEnding());
        return;
    }
    m_session.writeNow(path, [&, made = m_work.distances.result(), cloud = measuredNow()->survey.sha256] {
        io::writeDistanceFile(path.toStdString(), made->made.compared);
        io::writeProvenance(path.toStdString(), io::distanceProvenance(*record->reader, made->made, cloud));
    });
}

void CloudPoints::showBox() {
    widgets::PointBox::Content content;
    const CaseInput* survey = m_surveys.current();
    const render::View& view = m_area.views().view();
    if (survey != nullptr && evidenceFormOf(*survey) == EvidenceForm::Cloud) {
        content.cloud = true;
        content.shown = view.cloud == survey->id;
        content.colour = view.pointColour;
        if (content.shown && m_work.cloud) {
            content.status = statusText();
            content.complaint = m_work.failure ? m_work.failure->inOneLine() : QString();
            content.findings = m_work.opened != nullptr ? m_work.opened->octree->findings() : Findings();
        }
        content.photographs = photographsOf(*survey);
        if (m_work.pictures.busy()) {
            content.adding = tr("Adding its photographs, %1 %").arg(std::lround(100.0 * m_work.picturesFraction));
        }
        content.scanners = survey->scanners;
        content.noMeasuring = EvidenceWork::whyNoDebris(m_computation.currentRun());
        content.measuring = m_work.distances.running();
        content.measured = measuredText();
        content.savable = distancesKept();
        if (const auto& made = m_work.distances.result(); made != nullptr && m_work.distances.answered().survey.id == survey->id) {
            content.findings.append(made->made.compared.findings);
        }
    }
    m_deck.evidence().survey().points().setContent(content);
    m_actions.enable(ActionId::CloudPoints, content.cloud && m_computation.inputs().fe != nullptr);
    m_actions[ActionId::CloudPoints].setChecked(content.shown);
    m_actions.enable(ActionId::MeasureCloud, content.cloud && content.noMeasuring.isEmpty() && !content.measuring);
}

}  // namespace rubble
