#include "app/gui/window/main_window.h"

#include <QApplication>
#include <QCloseEvent>
#include <QComboBox>
#include <QDateTime>
#include <QDockWidget>
#include <QFileInfo>
#include <QLabel>
#include <QLocale>
#include <QMenuBar>
#include <QMessageBox>
#include <QMimeData>
#include <QScreen>
#include <QUrl>
#include <QVBoxLayout>
#include <array>
#include <limits>
#include <utility>

#include "app/gui/case/layout_memory.h"
#include "app/gui/exports/figure_return.h"
#include "app/gui/help/help.h"
#include "app/gui/help/manual.h"
#include "app/gui/session/session.h"
#include "app/gui/stage/dock_area.h"
#include "app/gui/stage/view_area.h"
#include "app/gui/window/done_notice.h"
#include "core/base/build.h"
#include "widgets/accuracy/accuracy_page.h"
#include "widgets/basics/evidence_tabs.h"
#include "widgets/basics/theme.h"
#include "widgets/evidence/evidence_page.h"
#include "widgets/evidence/evidence_panel.h"
#include "widgets/evidence/evidence_table.h"
#include "widgets/evidence/survey_box.h"
#include "widgets/figures/palette.h"
#include "widgets/figures/shown_units.h"
#include "widgets/views/status_line.h"
#include "widgets/views/timeline.h"
#include "widgets/views/transport.h"

namespace rubble {

namespace {

/// By the names of the preferences.
constexpr std::array<std::pair<ActionId, const char*>, 3> themeActions{
    {{ActionId::ThemeSystem, "system"}, {ActionId::ThemeLight, "light"}, {ActionId::ThemeDark, "dark"}}};

/// px, of the frame that a window manager puts around a window: the foot of the window stays on the screen.
constexpr QSize roomOfFrame(8, 36);

}  // namespace

struct MainWindow::Kept {
    std::optional<LayoutMemory::Layout> layout;  ///< of an earlier window; unset: this is the first one
    bool keepsLayout = false;                    ///< also from one start of the program to the next
    std::optional<QPoint> preferencesPlace;      ///< where they stood open
    std::string failed;                          ///< id of what the status bar says that the computation could not do
    bool toldOfCase = false;                     ///< the sentence of the status line is about the case that is open
    QString manualPage;                          ///< that was open; empty: none was
};

MainWindow::MainWindow(Session& session, QWidget* parent)
    : QMainWindow(parent),
      m_session(session),
      m_kept(session.part<Kept>()),
      m_actions(*this),
      m_area(new ViewArea),
      m_accuracyPage(new widgets::AccuracyPage),
      m_evidencePage(new widgets::EvidencePage),
      m_timeline(new widgets::Timeline),
      m_transport(new widgets::Transport),
      m_status(new widgets::StatusLine),
      m_colours(new QComboBox),
      m_notices(new QVBoxLayout),
      m_title(new QLabel) {
    setAcceptDrops(true);
    setWindowIcon(QIcon(QStringLiteral(":/desktop/org.rubble.Rubble.svg")));
    resize(1280, 800);
    const widgets::Preferences& preferences = session.preferences();
    figures::chooseColours(preferences.colours);
    figures::chooseUnits(preferences.units);
    m_rooms = std::make_unique<WindowRooms>(session, WindowParts{*this, m_actions, *m_area, *m_accuracyPage, *m_evidencePage,
                                                                 *m_timeline, *m_transport, *m_status, *m_colours, *m_notices});
    m_help = std::make_unique<Help>(*this);
    buildLayout();
    buildMenus();
    buildToolBar();
    connectSession();
    connectActions();
    prepareTour();
    prepareKeys();
    new DoneNotice(*this);
    goOn();
}

MainWindow::~MainWindow() {
    keepLook();
}

void MainWindow::goOn() {
    setTheme(m_session.preferences().theme);
    widgets::ViewWidget::simplifyAbove(m_session.preferences().simplify ? widgets::ViewWidget::slowDraw
                                                                        : std::numeric_limits<double>::infinity());
    m_actions[ActionId::KeepCopies].setChecked(m_session.preferences().keepCopies);
    m_rooms->goOn();
    if (m_kept.layout) {
        m_layout->show(*m_kept.layout);
    }
    showCentre();
    showTitle();
    if (const auto& failure = m_rooms->deck->failure()) {
        m_area->setError(failure->what(), failure->remedy());
    }
    m_session.computation().tellProgress();
    if (const QStringList complaints = m_session.takeComplaints(); !complaints.isEmpty()) {
        m_status->setMessage(
            tr("Preferences that could not be read are as delivered: %1").arg(complaints.join(QStringLiteral(", "))));
    }
}

void MainWindow::openAgain() {
    if (m_kept.preferencesPlace) {
        showPreferences();
        findChild<widgets::PreferencesDialog*>()->move(*m_kept.preferencesPlace);
    }
    if (!m_kept.manualPage.isEmpty()) {
        m_help->manual().showPage(m_kept.manualPage);
    }
}

void MainWindow::keepLook() {
    m_kept.layout = m_layout->now();
    const auto* preferences = findChild<widgets::PreferencesDialog*>();
    m_kept.preferencesPlace = preferences != nullptr && preferences->isVisible() ? std::optional(preferences->pos()) : std::nullopt;
    m_kept.manualPage = m_help->openPage();
}

void MainWindow::connectSession() {
    connect(&m_session, &Session::told, m_status, &widgets::StatusLine::setMessage);
    connect(&m_session, &Session::failed, this, &MainWindow::showFailure);
    connect(&m_session.computation(), &Computation::failed, this, &MainWindow::showFailure);
    connect(&m_session.document(), &Document::titleChanged, this, &MainWindow::showTitle);
    connect(&m_session.computation(), &Computation::failed, this, [this](const Failure& failure) { m_kept.failed = failure.id; });
    connect(&m_session, &Session::failed, this,
            [this](const Failure& failure) { m_kept.failed = failure.id == m_kept.failed ? m_kept.failed : std::string(); });
    connect(&m_session, &Session::told, this, [this] { m_kept.failed.clear(); });
    // What is mended is not said any more.
    connect(&m_session.computation(), &Computation::stateChanged, this, [this] {
        if (!m_kept.failed.empty() && !m_session.computation().failure()) {
            m_kept.failed.clear();
            m_status->setMessage({});
        }
    });
    // What came of the case before is not about this one; what the start had to say stays.
    connect(&m_session, &Session::told, this, [this] { m_kept.toldOfCase = true; });
    connect(&m_session.document(), &Document::replaced, this, [this] {
        if (std::exchange(m_kept.toldOfCase, false)) {
            m_status->setMessage({});
        }
    });
    connect(&m_session, &Session::preferencesChanged, this, [this] {
        const widgets::Preferences& now = m_session.preferences();
        figures::chooseColours(now.colours);
        widgets::ViewWidget::simplifyAbove(now.simplify ? widgets::ViewWidget::slowDraw : std::numeric_limits<double>::infinity());
        m_actions[ActionId::KeepCopies].setChecked(now.keepCopies);
        setTheme(now.theme);
        m_area->views().update();
        if (auto* dialog = findChild<widgets::PreferencesDialog*>()) {
            dialog->show(now);
        }
    });
}

void MainWindow::connectActions() {
    const auto on = [this](ActionId id, auto slot) { connect(&m_actions[id], &QAction::triggered, this, slot); };
    const auto prefer = [this](auto change) {
        widgets::Preferences preferences = m_session.preferences();
        change(preferences);
        m_session.setPreferences(preferences);
    };
    on(ActionId::KeepCopies, [prefer](bool keep) { prefer([keep](widgets::Preferences& now) { now.keepCopies = keep; }); });
    // Chosen once, it is that of the next start too.
    on(ActionId::Presentation, [prefer](bool shown) { prefer([shown](widgets::Preferences& now) { now.materials = shown; }); });
    for (const auto& [id, theme] : themeActions) {
        on(id, [prefer, theme = theme] { prefer([theme](widgets::Preferences& now) { now.theme = QLatin1String(theme); }); });
    }
    on(ActionId::PresetDefault, [this] { m_session.document().applyPreset(QStringLiteral("default")); });
    on(ActionId::PresetPaper, [this] { m_session.document().applyPreset(QStringLiteral("paper")); });
    on(ActionId::Quit, [this] { close(); });
    on(ActionId::Preferences, [this] { showPreferences(); });
    on(ActionId::Manual, [this] {
        // Without a field or a dock in use it is about the panel.
        const QWidget* focus = QApplication::focusWidget();
        const bool aside = focus == nullptr || focus == this || m_rooms->deck->rail().isAncestorOf(focus);
        m_help->showAbout(aside ? m_rooms->deck->shownPanel() : focus);
    });
    on(ActionId::ManualSearch, [this] { m_help->search(); });
    on(ActionId::About, [this] { showAbout(); });
    on(ActionId::ResetLayout, [this] { m_layout->reset(); });
    connect(&m_rooms->deck->stack(), &QStackedWidget::currentChanged, this, &MainWindow::showCentre);
    connect(&m_rooms->deck->evidenceTabs(), &widgets::EvidenceTabs::currentChanged, this, &MainWindow::showCentre);
    // Points of a cloud stand in the views, also while their panel is open; what else it shows brings its page back.
    connect(m_rooms->deck.get(), &PanelDeck::asked, this, &MainWindow::showCentre);
    connect(m_rooms->cloudPoints.get(), &CloudPoints::viewsRequested, this, [this] { m_centre->setCurrentWidget(m_area); });
    connect(m_centre, &QStackedWidget::currentChanged, this, [this] {
        const bool inFront = m_centre->currentWidget() == m_area;
        m_rooms->inspection->docks().setViewsInFront(inFront);
        m_actions.setViewsInFront(inFront);
        m_rooms->states->offerColours();
    });
    // What hides when the window ends comes too late for its actions.
    connect(m_evidencePage, &widgets::EvidencePage::modelSeen, m_rooms->states.get(),
            [this](bool seen) { m_actions.setModelInFront(seen); });
    widgets::EvidencePanel& panel = m_rooms->deck->evidence();
    connect(&panel, &widgets::EvidencePanel::photographChosen, this, &MainWindow::showCentre);
    connect(&panel.list(), &widgets::EvidenceTable::chosen, this, &MainWindow::showCentre);
    connect(&panel.survey(), &widgets::SurveyBox::compareRequested, this, &MainWindow::showCentre);
}

void MainWindow::open(const QString& path, bool simulate) {
    m_rooms->opening->open(path, simulate);
}

void MainWindow::showFailure(const Failure& failure) {
    m_rooms->opening->stayStill();
    m_rooms->deck->showFailure(failure);
    m_area->setError(failure.what(), failure.remedy());
    m_status->setMessage(failure.what());
    m_kept.toldOfCase = true;
}

void MainWindow::restoreLayout() {
    m_kept.keepsLayout = true;
    resize(size().boundedTo(screen()->availableSize() - roomOfFrame));
    m_layout->restore();
    // It comes with a selection, and there is none yet.
    m_rooms->inspection->dock("inspectorDock").hide();
}

void MainWindow::setTheme(const QString& name) {
    widgets::applyTheme(widgets::themeNamed(name));
    for (const auto& [id, theme] : themeActions) {
        if (name == QLatin1String(theme) || (name.isEmpty() && id == ActionId::ThemeSystem)) {
            m_actions[id].setChecked(true);
        }
    }
    m_rooms->useTheme();
    showTitle();
}

void MainWindow::showPreferences() {
    auto* dialog = findChild<widgets::PreferencesDialog*>();
    if (dialog == nullptr) {
        dialog = new widgets::PreferencesDialog(m_session.preferences(), this);
        dialog->setAttribute(Qt::WA_DeleteOnClose);
        connect(dialog, &widgets::PreferencesDialog::changed, &m_session, &Session::setPreferences);
        connect(dialog, &widgets::PreferencesDialog::keptRunsRequested, &m_actions[ActionId::KeptRuns], &QAction::trigger);
    }
    dialog->show();
    dialog->raise();
    dialog->activateWindow();
}

void MainWindow::showCentre() {
    const int entry = m_rooms->deck->stack().currentIndex();
    const int page = m_rooms->deck->evidenceTabs().current();
    if (entry != PanelDeck::Accuracy && entry != PanelDeck::Evidence) {
        m_lastEntry = entry;
    }
    m_centre->setCurrentIndex(entry == PanelDeck::Accuracy ? 1 : entry == PanelDeck::Evidence ? 2 + page : 0);
}

void MainWindow::showTitle() {
    Document& document = m_session.document();
    if (document.empty()) {
        m_title->clear();
        setWindowTitle(QStringLiteral("Rubble"));
        return;
    }
    const CaseScenario* active = document.active();
    const QString name = QString::fromStdString(document.theCase().title);
    const QDateTime when = QFileInfo(document.path()).lastModified();
    const QLocale locale;
    const QString at = when.date() == QDate::currentDate() ? locale.toString(when.time(), QLocale::ShortFormat)
                                                           : locale.toString(when, QLocale::ShortFormat);
    const QString saved = document.modified()         ? tr("changed")
                          : document.path().isEmpty() ? tr("not saved")
                          : document.readOnly()       ? tr("read only")
                                                      : tr("saved %1").arg(at);
    m_title->setText(QStringLiteral("<span style='color:%1'>%2 · %3 <b>%4</b> · %5</span>&nbsp;&nbsp;")
                         .arg(widgets::tints().muted.name(), name.toHtmlEscaped(), tr("scenario"),
                              active != nullptr ? QString::fromStdString(active->name).toHtmlEscaped() : QString(), saved));
    m_title->setFixedHeight(menuBar()->sizeHint().height() - 2);
    m_title->setAlignment(Qt::AlignVCenter | Qt::AlignRight);
    // The menu bar asks its corner for its size only when it is set.
    menuBar()->setCornerWidget(m_title);
    m_title->show();
    setWindowTitle(QStringLiteral("%1%2 – Rubble").arg(name, document.modified() ? QStringLiteral(" *") : QString()));
}

void MainWindow::showAbout() {
    QMessageBox::about(
        this, tr("About Rubble"),
        tr("<h3>Rubble %1</h3><p>Turns the elements that a collapse analysis deactivates into rigid fragments and shows where "
           "they go.</p><p>Method: Xu, Lu, Guan, Ren: Physics engine-driven visualization of deactivated elements and its "
           "application in bridge collapse simulation. Automation in Construction 35 (2013) 471-481.</p>")
            .arg(QString::fromUtf8(versionText().data(), static_cast<qsizetype>(versionText().size()))));
}

void MainWindow::closeEvent(QCloseEvent* event) {
    if (!m_rooms->files->mayLeave()) {
        event->ignore();
        return;
    }
    if (m_kept.keepsLayout) {
        m_layout->save();
    }
    m_session.computation().cancel();
    m_rooms->accuracy->work().cancel();
    m_rooms->calibration->work().cancel();
    m_rooms->validation->work().cancel();
    m_rooms->errors->work().cancel();
    m_rooms->evidence->work().cancel();
    m_rooms->survey->cancel();
    m_rooms->studies->work().cancel();
    event->accept();
}

void MainWindow::dragEnterEvent(QDragEnterEvent* event) {
    if (event->mimeData()->hasUrls() && event->mimeData()->urls().front().isLocalFile()) {
        event->acceptProposedAction();
    }
}

void MainWindow::dropEvent(QDropEvent* event) {
    const QList<QUrl> urls = event->mimeData()->urls();
    if (!urls.isEmpty() && urls.front().isLocalFile()) {
        event->acceptProposedAction();
        // A menu that stays open would take the clicks from the question that may follow.
        while (QApplication::activePopupWidget() != nullptr && QApplication::activePopupWidget()->close()) {
        }
        QStringList paths;
        for (const QUrl& url : urls) {
            paths << url.toLocalFile();
        }
        if (!FigureReturn::carriesSource(paths.front()) && m_rooms->evidence->takes(paths)) {
            m_rooms->evidence->add(paths);
        } else {
            open(paths.front());
        }
    }
}

}  // namespace rubble
