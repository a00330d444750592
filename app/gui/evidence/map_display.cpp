#include "app/gui/evidence/map_display.h"

#include <QDockWidget>
#include <QFileInfo>
#include <QMainWindow>
#include <algorithm>
#include <utility>

#include "app/gui/evidence/map_export.h"
#include "app/gui/session/save_path.h"
#include "app/gui/session/session.h"
#include "app/gui/stage/actions.h"
#include "app/gui/stage/dock_area.h"
#include "app/gui/stage/playback.h"
#include "core/analysis/debris/collapse_plan.h"
#include "core/base/error.h"
#include "io/case/case_file.h"
#include "io/exports/provenance.h"
#include "io/run/run_cautions.h"
#include "io/site/input_files.h"
#include "io/site/survey_file.h"
#include "io/site/surveys/evidence_origin.h"
#include "widgets/figures/figure_file.h"
#include "widgets/figures/map_picture.h"
#include "widgets/run/caution_words.h"

namespace rubble {

namespace {

constexpr int restMs = 250;
constexpr double packageContours = 0.5;  // m, of a GeoPackage of a map without contours
constexpr double dockShare = 0.45;       // of the centre, when it is first opened

/// Side of the cells that what stands is outlined by, m: a tenth of those of the map, or larger where there would be too many.
double outlineCell(double cell, const std::vector<PlanBox>& standing) {
    constexpr double most = 2000.0;  // along a side
    PlanBox all;
    for (const PlanBox& box : standing) {
        all.extend(box);
    }
    return all.isEmpty() ? cell : std::max(0.1 * cell, static_cast<double>(all.sizes().maxCoeff()) / most);
}

/// What stood there, what still stands, and what was found.
void addOutlines(MapWork::Made& made, const EvidenceRun& run, const std::vector<CaseInput>& surveys, const Case& theCase,
                 const Frame& frame, const std::string& base, const Execution& execution) {
    const CollapsePlan plan(*run.fragments, run.fe->mesh());
    made.outlines.push_back({figures::MapOutline::Of::Structure, {plan.outline()}});
    const std::vector<PlanBox> standing =
        made.map.live ? made.map.live->standing : standingAtTime(run.mapped(), made.map, execution);
    made.outlines.push_back(
        {figures::MapOutline::Of::Standing, standingOutline(standing, outlineCell(made.map.map.cell, standing), execution)});
    for (const CaseInput& survey : surveys) {
        const std::string path = io::inputPath(base, survey);
        const bool measured = io::surveyOriginOf(path, survey.read).measured();
        figures::MapOutline found{measured ? figures::MapOutline::Of::Evidence : figures::MapOutline::Of::Simulated, {}};
        figures::MapOutline area{figures::MapOutline::Of::Area, {}};
        const auto take = [](figures::MapOutline& into, const Outline& outline) {
            for (const OutlinePolygon& polygon : outline.polygons) {
                into.rings.insert(into.rings.end(), polygon.begin(), polygon.end());
            }
        };
        take(area, survey.scope.area);
        try {
            Findings ignored;
            take(found, io::readScope(path, frame, theCase.site, ignored, execution));
            if (!found.rings.empty()) {
                made.drawn.push_back({found.of == figures::MapOutline::Of::Evidence ? "evidence" : "simulated_no_evidence", path,
                                      io::digestOfInput(path, InputRole::Survey, execution).sha256});
            }
        } catch (const Cancelled&) {
            throw;
        } catch (const Error&) {
            // A height model has no outline; what is wrong with a file is said where it is compared.
        }
        made.outlines.push_back(std::move(found));
        made.outlines.push_back(std::move(area));
    }
}

}  // namespace

MapWork::MapWork(Session& session) {
    connect(&session.document(), &Document::replaced, this, [this] {
        forget();
        emit changed();
    });
}

void MapWork::forget() {
    m_making = nullptr;
    making.reset();
    m_worker.cancel();
    answer.drop();
    answer.end();
}

void MapWork::start(const Order& order, const EvidenceRun& run, std::shared_ptr<const io::RunReader> reader, const Case& theCase,
                    const Frame& frame, const std::string& base) {
    answer.ask(order);
    making = order;
    m_making = std::make_shared<Made>();
    m_making->run = std::move(reader);
    m_worker.start({Worker::Kind::Study,
                    [made = m_making, run, order, theCase, frame, base](const Execution& execution) {
                        MapSettings settings;
                        settings.cell = order.cell;
                        made->map = mapOfRun(run.mapped(), order.time, settings, order.live, execution);
                        addOutlines(*made, run, order.surveys, theCase, frame, base, execution);
                    },
                    [this, made = m_making](const std::exception_ptr& thrown) {
                        if (made != m_making) {
                            return;  // another one is awaited
                        }
                        m_making = nullptr;
                        const auto failure = failureOf(thrown);
                        if (thrown == nullptr) {
                            answer.take(made);
                        } else if (failure) {
                            answer.drop();
                        }
                        answer.end(failure ? &*failure : nullptr);
                        emit changed();
                    }});
    emit changed();
}

MapDisplay::MapDisplay(Session& session, Playback& playback, DockArea& docks, Actions& actions, QObject* parent)
    : QObject(parent),
      m_session(session),
      m_document(session.document()),
      m_computation(session.computation()),
      m_playback(playback),
      m_work(session.part<MapWork>()),
      m_panel(new widgets::RunMapPanel),
      m_dock(docks.addDock(m_panel, tr("Debris map"), QStringLiteral("mapDock"))) {
    m_panel->setChoice(m_work.choice);
    m_rest.setSingleShot(true);
    m_rest.setInterval(restMs);
    connect(&m_rest, &QTimer::timeout, this, &MapDisplay::refresh);
    connect(m_panel, &widgets::RunMapPanel::mapRequested, this, &MapDisplay::refresh);
    connect(m_panel, &widgets::RunMapPanel::drawnChanged, this, &MapDisplay::showGround);
    connect(m_panel, &widgets::RunMapPanel::saveRequested, this, &MapDisplay::save);
    connect(&playback.clock(), &widgets::PlaybackClock::timeChanged, this, [this] {
        if (wanted() && !m_panel->choice().atEnd) {
            m_rest.start();
        }
    });
    connect(&m_computation, &Computation::runBegun, this, &MapDisplay::refresh);
    connect(&m_computation, &Computation::runEnded, this, &MapDisplay::refresh);
    connect(&m_computation, &Computation::runReopened, this, &MapDisplay::refresh);
    connect(&m_computation, &Computation::prepared, this, &MapDisplay::refresh);
    connect(&m_document, &Document::surveysChanged, this, &MapDisplay::refresh);
    connect(&m_document, &Document::scenarioChanged, this, [this] {
        if (wanted()) {
            m_rest.start();  // a run that the case has outgrown says so on its map
        }
    });
    connect(&m_work, &MapWork::changed, this, &MapDisplay::show);
    // What is told since is about something else.
    connect(&session, &Session::told, this, [this] { m_waitTold = false; });
    QAction& shown = actions[ActionId::DebrisMap];
    connect(&shown, &QAction::triggered, this, [this, &docks](bool visible) {
        m_dock->setVisible(visible);
        if (visible) {
            m_dock->raise();
            docks.resizeDocks({m_dock}, {static_cast<int>(dockShare * docks.width())}, Qt::Horizontal);
        }
    });
    connect(m_dock, &QDockWidget::visibilityChanged, this, [this, &shown] {
        shown.setChecked(!m_dock->isHidden());
        refresh();
    });
    connect(&actions[ActionId::ExportMap], &QAction::triggered, &shown, [this, &shown] {
        if (m_dock->isHidden()) {
            shown.trigger();
        }
        save();
    });
    show();
}

MapDisplay::~MapDisplay() {
    m_work.choice = m_panel->choice();
}

bool MapDisplay::wanted() const {
    return !m_dock->isHidden();
}

std::optional<MapWork::Order> MapDisplay::orderNow() const {
    const RunRecord* record = m_computation.currentRun();
    if (!EvidenceWork::whyNoDebris(record).isEmpty() || m_computation.inputs().fe == nullptr || record->reader->frameCount() == 0) {
        return std::nullopt;
    }
    const widgets::RunMapChoice& choice = m_panel->choice();
    MapWork::Order order{record->reader.get(), record->reader->frameCount(), record->outcome != nullptr, std::nullopt, choice.cell,
                         choice.live};
    for (const CaseInput& input : m_document.theCase().inputs) {
        if (input.role == InputRole::Survey) {
            order.surveys.push_back(input);
        }
    }
    if (!choice.atEnd) {
        // Before the first fragment moves there is nothing to be mapped.
        const MapSpan span = mapSpan(EvidenceRun(m_computation.inputs(), record).mapped());
        order.time = std::clamp(m_playback.clock().time(), span.first, span.last);
    }
    return order;
}

void MapDisplay::refresh() {
    const std::optional<MapWork::Order> order = orderNow();
    const bool known = m_work.answer.running() ? m_work.making == order
                                               : order && m_work.answer.result() != nullptr && !m_work.answer.stale(*order);
    if (order && wanted() && !known) {
        const RunRecord* record = m_computation.currentRun();
        m_work.start(*order, EvidenceRun(m_computation.inputs(), record), record->reader, m_document.theCase(),
                     m_computation.inputs().frame, m_document.base().toStdString());
        return;
    }
    if (!order) {
        m_work.forget();
    }
    show();
}

void MapDisplay::show() {
    const std::shared_ptr<const MapWork::Made>& made = m_work.answer.result();
    widgets::RunMapPanel::Content content;
    content.making = m_work.answer.running();
    if (made != nullptr) {
        content.map = std::shared_ptr<const RunMap>(made, &made->map);
        content.place = pictureStyle(io::mapOrigin(*made->run, made->map.map, made->map.shown),
                                     runCautions(io::standingAt(*made->run, made->map.map.time)));
        content.place.provenance.clear();
        content.place.outlines = made->outlines;
    } else {
        const auto& failure = m_work.answer.failure();
        content.why = failure ? failure->inOneLine() : EvidenceWork::whyNoDebris(m_computation.currentRun());
    }
    m_panel->setContent(content);
    if (m_waitTold && !content.making) {
        m_session.tell(made != nullptr ? tr("The debris map is there: save it now.") : QString());
    }
    showGround();
}

void MapDisplay::showGround() {
    const std::shared_ptr<const MapWork::Made>& made = m_work.answer.result();
    const widgets::RunMapChoice& choice = m_panel->choice();
    // Without the panel no legend would say what the colours on the ground mean.
    const bool shown = choice.onGround && wanted() && made != nullptr && made->map.map.has(choice.layer);
    if (!shown && m_ground == nullptr) {
        return;
    }
    m_ground = shown ? std::make_shared<const Orthophoto>(figures::groundPicture(made->map.map, choice.layer)) : nullptr;
    emit groundChanged();
}

void MapDisplay::save() {
    if (m_work.answer.result() == nullptr) {
        const bool making = m_work.answer.running();
        m_session.tell(making ? tr("The debris is being mapped: save the map once it stands here.")
                              : tr("Simulate first, or show one of the runs: there is no debris yet."));
        m_waitTold = making;
        return;
    }
    const QFileInfo base(m_document.base());
    const QString path = askSavePath(m_panel->window(), tr("Debris map"),
                                     base.absolutePath() + u'/' + base.completeBaseName() + QStringLiteral("-map.tif"),
                                     tr("GeoTIFF (*.tif);;GeoPackage (*.gpkg);;Tables (*.csv);;Images (*.png)"));
    if (!path.isEmpty()) {
        saveTo(path);
    }
}

void MapDisplay::saveTo(const QString& path) {
    const std::shared_ptr<const MapWork::Made> made = m_work.answer.result();
    if (made == nullptr) {
        return;
    }
    const widgets::RunMapChoice& choice = m_panel->choice();
    figures::MapPictureStyle style = m_panel->style();
    style.provenance = io::footLine(made->run->origin());
    style.cautions = widgets::cautionWords(runCautions(io::standingAt(*made->run, made->map.map.time))).toStdString();
    style.subject = io::mapSubject(made->run->origin(), m_document.path().toStdString());
    style.fitted = true;
    const double contours = choice.contours > 0.0 ? choice.contours : packageContours;
    m_computation.write(
        [path, made, style, contours, layer = choice.layer](const Execution& execution) {
            const std::string file = path.toStdString();
            if (QFileInfo(path).suffix().compare(QLatin1String("png"), Qt::CaseInsensitive) == 0) {
                figures::writePng(file, figures::mapPicture(made->map.map, layer, style));
                const bool outlined =
                    std::any_of(style.outlines.begin(), style.outlines.end(), [](const figures::MapOutline& outline) {
                        return outline.of == figures::MapOutline::Of::Evidence || outline.of == figures::MapOutline::Of::Simulated;
                    });
                io::writeMapProvenance(file, io::mapOrigin(*made->run, made->map.map, made->map.shown,
                                                           outlined ? made->drawn : std::vector<io::ShownFile>()));
            } else {
                io::writeRunMap(file, made->map, made->map.map.present(), contours, *made->run, execution);
            }
        },
        [session = &m_session, path](const std::exception_ptr& thrown) { session->tellWritten(path, thrown); });
}

}  // namespace rubble
