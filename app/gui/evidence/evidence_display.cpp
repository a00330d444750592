#include "app/gui/evidence/evidence_display.h"

#include <QFileDialog>
#include <QFileInfo>
#include <algorithm>
#include <array>
#include <utility>

#include "app/gui/evidence/pairs_table.h"
#include "app/gui/evidence/photographs_edit.h"
#include "app/gui/session/session.h"
#include "app/gui/stage/actions.h"
#include "app/gui/stage/panel_deck.h"
#include "app/gui/stage/playback.h"
#include "app/gui/stage/scene_display.h"
#include "core/evidence/evidence_list.h"
#include "io/case/case_file.h"
#include "widgets/basics/theme.h"
#include "widgets/basics/wording.h"
#include "widgets/evidence/evidence_page.h"
#include "widgets/evidence/evidence_panel.h"
#include "widgets/views/view_widget.h"

namespace rubble {

namespace {

const QStringList suffixes{QStringLiteral("jpg"),  QStringLiteral("jpeg"), QStringLiteral("png"), QStringLiteral("tif"),
                           QStringLiteral("tiff"), QStringLiteral("heic"), QStringLiteral("heif")};

}  // namespace

EvidenceDisplay::EvidenceDisplay(Session& session, PanelDeck& deck, widgets::EvidencePage& page, Playback& playback,
                                 SceneDisplay& scene, Actions& actions, QObject* parent)
    : QObject(parent),
      m_session(session),
      m_document(session.document()),
      m_computation(session.computation()),
      m_deck(deck),
      m_page(page),
      m_playback(playback),
      m_scene(scene),
      m_work(session.part<EvidenceWork>()),
      m_kept(session.part<Kept>()),
      m_overlay(session.computation(), m_work, page.photo(), [this] { return m_scene.data(); }) {
    connect(&m_document, &Document::photographsChanged, this, &EvidenceDisplay::photographsChanged);
    connect(&m_document, &Document::evidenceChanged, this, &EvidenceDisplay::refresh);
    connect(&m_document, &Document::replaced, this, [this] {
        m_kept.chosen = -1;
        m_kept.answer.drop();
        // The file may be another one by now.
        m_kept.photo = {};
        m_kept.loading.clear();
        photographsChanged();
    });
    connect(&m_computation, &Computation::opened, this, [this] {
        // The same case may have been opened again, and the file be another one by now.
        m_kept.photo.path.clear();
        m_kept.loading.clear();
        loadCurrent();
    });
    connect(&m_computation, &Computation::runBegun, this, &EvidenceDisplay::refresh);
    connect(&m_computation, &Computation::runEnded, this, [this] {
        toItsTime();
        refresh();
    });
    connect(&m_computation, &Computation::prepared, this, &EvidenceDisplay::refresh);
    connect(&m_playback.clock(), &widgets::PlaybackClock::timeChanged, this, [this](double time) {
        m_page.model().setTime(time);
        drawLater();
    });
    connect(&m_deck.stack(), &QStackedWidget::currentChanged, this, [this](int entry) {
        if (entry == PanelDeck::Evidence) {
            toItsTime();
            refresh();
        }
    });
    connect(&m_work, &EvidenceWork::found, this, &EvidenceDisplay::takeFound);
    connect(&m_work, &EvidenceWork::loaded, this, &EvidenceDisplay::takeLoaded);
    connect(&m_overlay, &CameraOverlay::outlined, this, &EvidenceDisplay::showPage);
    connect(&m_overlay, &CameraOverlay::failed, &m_page, &widgets::EvidencePage::setHint);
    connect(&m_work, &EvidenceWork::compared, this,
            [this](const std::shared_ptr<const PhotoComparison>& made, const Failure* failure) {
                if (made != nullptr) {
                    m_kept.answer.take(made);
                }
                m_kept.answer.end(failure);
                showPanel();
            });
    connectPanel();
    connectPage();
    connectActions(actions);
    // The outlines of the simulation are drawn anew.
    photographsChanged();
    m_page.setBeside(m_kept.beside);
    if (m_kept.match) {
        m_page.setShow(m_kept.show);
    }
}

EvidenceDisplay::~EvidenceDisplay() {
    m_kept.beside = m_page.beside();
    m_kept.show = m_page.photo().show();
}

void EvidenceDisplay::connectPanel() {
    widgets::EvidencePanel& panel = m_deck.evidence();
    connect(&panel, &widgets::EvidencePanel::addRequested, this, &EvidenceDisplay::chooseFiles);
    connect(&panel, &widgets::EvidencePanel::removeRequested, this, &EvidenceDisplay::remove);
    connect(&panel, &widgets::EvidencePanel::photographChosen, this, &EvidenceDisplay::choose);
    connect(&panel, &widgets::EvidencePanel::photographEdited, this, &EvidenceDisplay::edit);
    connect(&panel, &widgets::EvidencePanel::readPairsRequested, this, &EvidenceDisplay::chooseTable);
    connect(&panel, &widgets::EvidencePanel::compareRequested, this, &EvidenceDisplay::compare);
    connect(&panel, &widgets::EvidencePanel::cancelRequested, this, [this] { m_work.cancelComparison(); });
    connect(&panel, &widgets::EvidencePanel::withFallenChosen, this, [this](bool with) {
        EvidenceSettings evidence = m_document.theCase().evidence;
        evidence.photographsWithFallen = with;
        m_document.setEvidence(evidence, [] { return tr("how photographs are compared"); });
    });
    connect(&panel, &widgets::EvidencePanel::addToggled, this,
            [this](bool adding) { m_page.setTool(adding ? widgets::PhotoView::Tool::Point : widgets::PhotoView::Tool::Look); });
    connect(&panel, &widgets::EvidencePanel::pairChosen, this, [this](int pair) {
        m_kept.chosenPair = pair;
        showPanel();
        showPage();
    });
    connect(&panel, &widgets::EvidencePanel::maskChosen, this, [this](int mask) {
        m_kept.chosenMask = mask;
        showPanel();
        showPage();
    });
}

void EvidenceDisplay::connectPage() {
    widgets::PhotoView& photo = m_page.photo();
    connect(&photo, &widgets::PhotoView::pointPlaced, this, &EvidenceDisplay::placePicture);
    connect(&photo, &widgets::PhotoView::markChosen, this, [this](int mark) {
        m_kept.chosenPair = mark;
        showPanel();
        showPage();
    });
    connect(&photo, &widgets::PhotoView::markMoved, this, [this](int mark, const QPointF& pixel) {
        if (const Photograph* photograph = current(); photograph != nullptr) {
            Photograph after = *photograph;
            after.pairs.at(static_cast<std::size_t>(mark)).picture = {pixel.x(), pixel.y()};
            edit(after, [mark] { return tr("point %1 moved").arg(mark + 1); });
        }
    });
    connect(&photo, &widgets::PhotoView::maskChosen, this, [this](int mask) {
        m_kept.chosenMask = mask;
        showPanel();
        showPage();
    });
    connect(&photo, &widgets::PhotoView::maskDrawn, this, [this](const PhotoMask& mask) {
        if (const Photograph* photograph = current(); photograph != nullptr) {
            Photograph after = *photograph;
            after.masks.push_back(mask);
            m_kept.chosenMask = static_cast<int>(after.masks.size()) - 1;
            edit(after, [kind = mask.kind] { return tr("%1 drawn").arg(widgets::maskWords(kind)); });
        }
    });
    connect(&m_page, &widgets::EvidencePage::modelClicked, this, [this](const QPointF& place) {
        const auto hit = m_page.model().hitAt(place);
        if (!hit) {
            m_page.setHint(tr("There is nothing of the model there: click on the structure, a fragment or the ground."));
            return;
        }
        QString name = tr("ground");
        const auto& components = m_computation.results().components;
        if (hit->pick && components != nullptr) {
            name = QString::fromStdString(components->list[at(components->of[at(hit->pick->element)])].name);
        }
        placeModel(hit->point, hit->node ? tr("%1, node").arg(name) : name);
    });
    connect(&m_page, &widgets::EvidencePage::toolChanged, this, [this](widgets::PhotoView::Tool tool) {
        m_deck.evidence().setAdding(tool == widgets::PhotoView::Tool::Point);
        forgetPair();
    });
    connect(&m_page, &widgets::EvidencePage::showChanged, this, &EvidenceDisplay::drawLater);
}

void EvidenceDisplay::connectActions(Actions& actions) {
    using widgets::PhotoView;
    const auto on = [&](ActionId id, auto slot) { connect(&actions[id], &QAction::triggered, this, slot); };
    on(ActionId::AddPhotographs, [this] { chooseFiles(); });
    constexpr std::array shows{ActionId::PhotoAlone, ActionId::PhotoSwipe, ActionId::PhotoBlend, ActionId::PhotoBlink,
                               ActionId::PhotoOutline};
    for (std::size_t i = 0; i < shows.size(); ++i) {
        on(shows[i], [this, show = static_cast<PhotoView::Show>(i)] {
            m_deck.chooseEvidence(PanelDeck::Photographs);
            m_page.setShow(m_kept.match ? show : PhotoView::Show::Photograph);
        });
    }
    on(ActionId::PhotoBeside, [this] {
        m_deck.chooseEvidence(PanelDeck::Photographs);
        m_page.setBeside(!m_page.beside());
    });
    on(ActionId::AddPoint, [this] {
        if (m_kept.chosen >= 0) {
            m_deck.chooseEvidence(PanelDeck::Photographs);
            m_page.setTool(PhotoView::Tool::Point);
        }
    });
    on(ActionId::ComparePhoto, [this] {
        m_deck.chooseEvidence(PanelDeck::Photographs);
        compare();
    });
    on(ActionId::LookThrough, [this] { lookThrough(); });
}

const Photograph* EvidenceDisplay::current() const {
    const auto& list = m_document.theCase().photographs;
    return m_kept.chosen >= 0 && m_kept.chosen < static_cast<int>(list.size()) ? &list[static_cast<std::size_t>(m_kept.chosen)]
                                                                               : nullptr;
}

QString EvidenceDisplay::pathOf(const Photograph& photograph) const {
    for (const CaseInput& input : m_document.theCase().inputs) {
        if (input.id == photograph.input) {
            return QString::fromStdString(io::inputPath(m_document.base().toStdString(), input));
        }
    }
    return {};
}

bool EvidenceDisplay::takes(const QStringList& paths) const {
    return !m_document.empty() && !paths.isEmpty() && std::all_of(paths.begin(), paths.end(), [](const QString& path) {
        return suffixes.contains(QFileInfo(path).suffix().toLower());
    });
}

void EvidenceDisplay::chooseFiles() {
    const QStringList paths =
        QFileDialog::getOpenFileNames(m_page.window(), tr("Add photographs"), QFileInfo(m_document.base()).absolutePath(),
                                      tr("Photographs (*.jpg *.jpeg *.png *.tif *.tiff *.heic *.heif *.JPG *.JPEG *.PNG *.TIF "
                                         "*.TIFF *.HEIC *.HEIF);;All files (*)"));
    if (!paths.isEmpty()) {
        add(paths);
    }
}

void EvidenceDisplay::add(const QStringList& paths) {
    if (!m_document.empty()) {
        m_deck.chooseEvidence(PanelDeck::Photographs);
        m_work.find(paths);
    }
}

void EvidenceDisplay::takeFound(const FoundPhotos& found) {
    const int before = static_cast<int>(m_document.theCase().photographs.size());
    const PhotographsEdit added = withFound(m_document.theCase(), m_document.base(), found.photos);
    m_deck.evidence().setError({});
    if (!added.known.isEmpty()) {
        m_session.tell(tr("%1: among the photographs already").arg(added.known.join(QStringLiteral(", "))));
    }
    if (added.what) {
        m_kept.chosen = before;
        put(added);
    }
    if (!found.failures.empty()) {
        m_deck.evidence().setError(found.failures.front().what(), found.failures.front().remedy());
    }
}

void EvidenceDisplay::put(const PhotographsEdit& edit) {
    m_document.setPhotographs(edit.photographs, edit.inputs, edit.what);
}

void EvidenceDisplay::remove() {
    if (current() != nullptr) {
        put(withoutPhotograph(m_document.theCase(), m_kept.chosen));
    }
}

void EvidenceDisplay::edit(const Photograph& after, const widgets::Wording& what) {
    if (const Photograph* before = current(); before != nullptr) {
        const bool otherTime = before->time != after.time;
        put(withEdited(m_document.theCase(), m_kept.chosen, after, what));
        if (otherTime) {
            toItsTime();
        }
    }
}

void EvidenceDisplay::choose(int photograph) {
    m_kept.chosen = photograph;
    m_kept.chosenPair = -1;
    m_kept.chosenMask = -1;
    m_kept.answer.drop();
    photographsChanged();
    toItsTime();
}

void EvidenceDisplay::toItsTime() {
    const Photograph* photograph = current();
    if (photograph != nullptr && visible() && !m_playback.clock().playing()) {
        m_playback.scrub(photograph->time.value_or(m_playback.clock().last()));
    }
}

void EvidenceDisplay::photographsChanged() {
    const int count = static_cast<int>(m_document.theCase().photographs.size());
    m_kept.chosen = std::clamp(m_kept.chosen, count > 0 ? 0 : -1, count - 1);
    forgetPair();
    loadCurrent();
    matchCurrent();
    refresh();
}

void EvidenceDisplay::loadCurrent() {
    const Photograph* photograph = current();
    const QString path = photograph != nullptr ? pathOf(*photograph) : QString();
    if (path.isEmpty()) {
        m_kept.photo = {};
        m_kept.loading.clear();
    } else if (path != m_kept.photo.path && path != m_kept.loading) {
        m_kept.photo = {};
        m_kept.loading = path;
        m_work.load(path);
    }
}

void EvidenceDisplay::takeLoaded(const LoadedPhoto& photo) {
    if (photo.path == m_kept.loading) {
        m_kept.photo = photo;
        m_kept.loading.clear();
        refresh();
    }
}

void EvidenceDisplay::matchCurrent() {
    const Photograph* photograph = current();
    if (photograph == nullptr) {
        m_kept.match.reset();
        m_kept.noMatch.reset();
        m_kept.matchedPairs.clear();
        return;
    }
    const bool known = m_kept.match || m_kept.noMatch;
    if (known && photograph->pairs == m_kept.matchedPairs && photograph->camera == m_kept.matchedKnowing) {
        return;
    }
    m_kept.matchedPairs = photograph->pairs;
    m_kept.matchedKnowing = photograph->camera;
    m_kept.match.reset();
    m_kept.noMatch.reset();
    try {
        m_kept.match = matchPhotograph(*photograph, Execution());
    } catch (...) {
        m_kept.noMatch = failureOf(std::current_exception());
    }
    m_overlay.dropOutlines();
}

void EvidenceDisplay::chooseTable() {
    readPairs(QFileDialog::getOpenFileName(m_page.window(), tr("Point pairs"), QFileInfo(m_document.base()).absolutePath(),
                                           tr("Tables of point pairs (*.csv);;All files (*)")));
}

void EvidenceDisplay::readPairs(const QString& path) {
    const Photograph* photograph = current();
    if (photograph == nullptr || path.isEmpty()) {
        return;
    }
    try {
        Photograph after = *photograph;
        if (const std::size_t count = addPairsOfTable(m_page.window(), path, m_session, after.pairs); count > 0) {
            m_deck.evidence().setError({});
            edit(after, [count, name = QFileInfo(path).fileName()] { return tr("%1 points from %2").arg(count).arg(name); });
        }
    } catch (...) {
        const auto failure = failureOf(std::current_exception());
        m_deck.evidence().setError(failure->what(), failure->remedy());
        m_session.tell(failure->inOneLine());
    }
}

void EvidenceDisplay::placePicture(const QPointF& pixel) {
    m_pendingPixel = pixel;
    finishPair();
}

void EvidenceDisplay::placeModel(const Vec3& point, const QString& name) {
    m_pendingModel = point;
    m_pendingName = name;
    finishPair();
}

void EvidenceDisplay::finishPair() {
    const Photograph* photograph = current();
    if (photograph != nullptr && m_pendingPixel && m_pendingModel) {
        Photograph after = *photograph;
        const auto number = after.pairs.size() + 1;
        after.pairs.push_back({m_pendingName.toStdString(), {m_pendingPixel->x(), m_pendingPixel->y()}, *m_pendingModel});
        m_kept.chosenPair = static_cast<int>(after.pairs.size()) - 1;
        edit(after, [number] { return tr("point %1 added").arg(number); });
        return;
    }
    m_page.setHint(m_pendingPixel   ? tr("Now click the same point in the model, at the right; nodes are caught. Esc ends.")
                   : m_pendingModel ? tr("Now click the same point in the photograph.")
                                    : QString());
    showPage();
}

void EvidenceDisplay::forgetPair() {
    m_pendingPixel.reset();
    m_pendingModel.reset();
    const auto tool = m_page.photo().tool();
    m_page.setHint(tool == widgets::PhotoView::Tool::Point
                       ? tr("Click a point in the photograph, then the same point in the model; or the other way round.")
                   : tool == widgets::PhotoView::Tool::Mask
                       ? tr("Click the corners around it; a double click or Enter closes, Backspace takes one back, Esc ends.")
                       : QString());
    showPage();
}

void EvidenceDisplay::lookThrough() {
    const Photograph* photograph = current();
    if (photograph != nullptr && m_kept.match) {
        emit lookThroughRequested(figures::viewCamera(m_kept.match->camera, photograph->facts.height, m_kept.match->distance));
        m_session.tell(tr("The view looks as the camera does; its distortion and principal point are left out here."));
    }
}

bool EvidenceDisplay::visible() const {
    return m_deck.rail().current() == PanelDeck::Evidence;
}

EvidenceDisplay::Compared EvidenceDisplay::comparedNow(const Photograph& photograph, const RunRecord& record) const {
    Compared now{photograph, record.reader.get(), m_document.theCase().evidence.photographsWithFallen};
    now.photograph.note.clear();
    return now;
}

bool EvidenceDisplay::comparisonStale() const {
    const RunRecord* record = m_computation.currentRun();
    const Photograph* photograph = current();
    return comparison() == nullptr || photograph == nullptr || record == nullptr ||
           m_kept.answer.stale(comparedNow(*photograph, *record)) || m_computation.runStale(m_document.scenario());
}

QString EvidenceDisplay::whyNoComparison() const {
    const Photograph* photograph = current();
    if (photograph == nullptr || !m_kept.match) {
        return tr("The camera is to be found first.");
    }
    const bool drawn = std::any_of(photograph->masks.begin(), photograph->masks.end(),
                                   [](const PhotoMask& mask) { return mask.kind == MaskClass::Debris; });
    if (!drawn) {
        return tr("Draw the outline of the debris on the photograph first.");
    }
    return EvidenceWork::whyNoDebris(m_computation.currentRun());
}

void EvidenceDisplay::compare() {
    const Photograph* photograph = current();
    if (photograph == nullptr || !whyNoComparison().isEmpty() || m_work.comparing()) {
        return;
    }
    const RunRecord* record = m_computation.currentRun();
    m_kept.answer.ask(comparedNow(*photograph, *record));
    m_work.compare(EvidenceRun(m_computation.inputs(), record), *photograph, *m_kept.match,
                   photographSettingsOf(m_document.theCase()));
    showPanel();
}

void EvidenceDisplay::refresh() {
    showPanel();
    showPage();
    drawLater();
}

void EvidenceDisplay::showPanel() {
    const Photograph* photograph = current();
    widgets::EvidencePanel::Content content;
    content.available = !m_document.empty();
    content.withFallen = m_document.theCase().evidence.photographsWithFallen;
    for (const Photograph& each : m_document.theCase().photographs) {
        content.names << QFileInfo(pathOf(each)).fileName();
    }
    if (photograph != nullptr) {
        content.chosen = m_kept.chosen;
        content.photograph = *photograph;
        content.findings = m_kept.photo.findings;
        const auto input = std::ranges::find(m_document.theCase().inputs, photograph->input, &CaseInput::id);
        content.unchanged = m_kept.photo.sha256.empty()            ? tr("reading the file")
                            : m_kept.photo.sha256 == input->sha256 ? tr("unchanged since it was added")
                                                                   : QString();
        if (m_kept.photo.failure) {
            content.unchanged = tr("the file cannot be shown");
            content.findings.add({"gui.photo", "{0}", {m_kept.photo.failure->what().toStdString()}},
                                 {"gui.photo.remedy", "{0}", {m_kept.photo.failure->remedy().toStdString()}});
        } else if (!m_kept.photo.sha256.empty() && m_kept.photo.sha256 != input->sha256) {
            content.unchanged = tr("changed since it was added");
            content.findings.add({"photo.changed", "The photograph {0} is another file than the case names.", {input->path}},
                                 {"photo.changed.remedy", "Put the file back, or add it as another photograph.", {}});
        }
        content.match = m_kept.match;
        content.noMatch = m_kept.noMatch ? m_kept.noMatch->what() : QString();
        content.remedy = m_kept.noMatch ? m_kept.noMatch->remedy() : QString();
        content.cautions = EvidenceWork::cautionsOf(*photograph, m_kept.match, m_computation.currentRun());
        content.comparison = comparison();
        const bool failed = m_kept.answer.failure() && m_kept.answer.asked().photograph.input == photograph->input;
        content.comparisonComplaint = failed ? m_kept.answer.failure()->inOneLine() : QString();
        content.noComparison = whyNoComparison();
        content.comparisonStale = comparisonStale();
        content.comparing = m_work.comparing();
        content.chosenPair = m_kept.chosenPair;
        content.chosenMask = m_kept.chosenMask;
    }
    m_deck.evidence().setContent(content);
    m_deck.evidence().setAdding(m_page.photo().tool() == widgets::PhotoView::Tool::Point);
    showRail();
    emit changed();
}

void EvidenceDisplay::showPage() {
    const Photograph* photograph = current();
    widgets::PhotoView::Content content;
    content.chosenMark = m_kept.chosenPair;
    content.chosenMask = m_kept.chosenMask;
    content.pending = m_pendingPixel;
    if (photograph != nullptr) {
        content.picture = m_kept.photo.picture;
        content.size = QSize(photograph->facts.width, photograph->facts.height);
        content.title = m_kept.photo.failure        ? m_kept.photo.failure->what() + u'\n' + m_kept.photo.failure->remedy()
                        : !m_kept.loading.isEmpty() ? tr("Reading %1").arg(QFileInfo(m_kept.loading).fileName())
                                                    : QFileInfo(pathOf(*photograph)).fileName();
        content.masks = photograph->masks;
        content.outlines = m_overlay.outlines();
        for (std::size_t i = 0; i < photograph->pairs.size(); ++i) {
            const PointPair& pair = photograph->pairs[i];
            widgets::PhotoMark mark{QString::fromStdString(pair.name), {pair.picture.x(), pair.picture.y()}, {}, true};
            if (m_kept.match) {
                mark.used = m_kept.match->used[i];
                if (const auto there = m_kept.match->camera.project(pair.model)) {
                    mark.projected = QPointF(there->x(), there->y());
                }
            }
            content.marks.push_back(mark);
        }
    }
    m_page.photo().setContent(content);
    m_page.modelMarks().setPairs(photograph != nullptr ? photograph->pairs : std::vector<PointPair>(),
                                 m_kept.match ? m_kept.match->used : std::vector<bool>(), m_kept.chosenPair, m_pendingModel);
    m_page.setReady(photograph != nullptr);
    const bool seen = m_kept.match && m_computation.inputs().fe != nullptr;
    m_page.setSeen(seen, photograph == nullptr
                             ? QString()
                             : tr("Click points that the photograph and the model both show; once the camera is found, "
                                  "the simulation is seen from there."));
    const render::SceneData scene = m_scene.data();
    if (!(scene == m_modelScene)) {
        const bool other = scene.fe != m_modelScene.fe;
        m_modelScene = scene;
        m_page.model().setData(scene);
        if (other) {
            render::View view = render::defaultView(scene, 640, 480, render::Layout::FragmentsOnly);
            view.time = m_playback.clock().time();
            m_page.model().setView(view);
            m_page.model().keepFitted();
        }
    }
    render::View view = m_page.model().view();
    view.theme = widgets::currentTheme();
    view.style = m_scene.style();
    view.legends = false;
    m_page.model().setView(view);
}

void EvidenceDisplay::showRail() {
    const auto& list = m_document.theCase().photographs;
    const bool stale = comparison() != nullptr && comparisonStale();
    const widgets::StageState state = answerState(m_work.comparing(), !list.empty() && m_kept.match, stale);
    const std::int64_t found =
        static_cast<std::int64_t>(m_kept.photo.findings.list().size()) +
        (m_kept.match ? static_cast<std::int64_t>(m_kept.match->wrong().size() + m_kept.match->findings.list().size()) : 0);
    m_deck.rail().setState(PanelDeck::Evidence, state, found);
}

void EvidenceDisplay::drawLater() {
    if (!visible()) {
        return;
    }
    m_overlay.drawLater([this] {
        const Photograph* photograph = current();
        CameraOverlay::Wanted wanted;
        if (photograph != nullptr) {
            wanted.match = m_kept.match;
            wanted.photograph = QSize(photograph->facts.width, photograph->facts.height);
            wanted.like = m_page.model().view();
            wanted.like.time = m_playback.clock().time();
            wanted.withFallen = m_document.theCase().evidence.photographsWithFallen;
        }
        return wanted;
    });
}

}  // namespace rubble
