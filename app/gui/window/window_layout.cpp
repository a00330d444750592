#include <QActionGroup>
#include <QApplication>
#include <QComboBox>
#include <QCoreApplication>
#include <QDockWidget>
#include <QHBoxLayout>
#include <QLabel>
#include <QMenuBar>
#include <QResizeEvent>
#include <QSplitter>
#include <QStackedWidget>
#include <QToolBar>
#include <QToolButton>
#include <map>
#include <utility>
#include <vector>

#include "app/gui/case/layout_memory.h"
#include "app/gui/help/help.h"
#include "app/gui/session/file_dialog_columns.h"
#include "app/gui/session/session.h"
#include "app/gui/stage/dock_area.h"
#include "app/gui/stage/view_area.h"
#include "app/gui/window/first_visit.h"
#include "app/gui/window/key_rules.h"
#include "app/gui/window/main_window.h"
#include "app/gui/window/mnemonics.h"
#include "app/gui/window/wheel_guard.h"
#include "app/gui/window/window_focus.h"
#include "widgets/accuracy/accuracy_page.h"
#include "widgets/basics/evidence_tabs.h"
#include "widgets/basics/page_stack.h"
#include "widgets/evidence/causes_page.h"
#include "widgets/evidence/ensemble_page.h"
#include "widgets/evidence/evidence_page.h"
#include "widgets/evidence/survey_view.h"
#include "widgets/views/status_line.h"
#include "widgets/views/timeline.h"
#include "widgets/views/tour.h"
#include "widgets/views/transport.h"

namespace rubble {

namespace {

constexpr int compactBelow = 1440;
constexpr int panelWidth = 336;
// Below it the tables and buttons of the panels would be cut off.
constexpr int leastPanelWidth = 306;

}  // namespace

void MainWindow::buildLayout() {
    new FileDialogColumns(this);
    new WindowFocus(this);
    new WheelGuard(this);
    auto* centre = new QWidget;
    auto* column = new QVBoxLayout(centre);
    column->setContentsMargins(0, 0, 0, 0);
    column->setSpacing(0);
    auto* upper = new QHBoxLayout;
    upper->setSpacing(0);
    m_splitter = new QSplitter(Qt::Horizontal);
    m_splitter->setObjectName(QStringLiteral("mainSplitter"));
    m_splitter->setHandleWidth(1);
    m_splitter->setChildrenCollapsible(false);
    m_rooms->deck->stack().setMinimumWidth(leastPanelWidth);
    m_splitter->addWidget(&m_rooms->deck->stack());
    m_centre = new widgets::PageStack;
    m_centre->addWidget(m_area);
    m_centre->addWidget(m_accuracyPage);
    m_centre->addWidget(m_evidencePage);
    m_area->setBesidePhotograph(m_evidencePage->model());
    m_centre->addWidget(&m_rooms->studies->ensemblePage());
    m_centre->addWidget(&m_rooms->studies->causesPage());
    auto* middle = new QWidget;
    auto* stacked = new QVBoxLayout(middle);
    stacked->setContentsMargins(0, 0, 0, 0);
    stacked->setSpacing(0);
    stacked->addLayout(m_notices);
    stacked->addWidget(m_centre, 1);
    m_rooms->inspection->docks().setCentralWidget(middle);
    m_splitter->addWidget(&m_rooms->inspection->docks());
    m_splitter->setStretchFactor(1, 1);
    m_splitter->setSizes({panelWidth, 1000});
    upper->addWidget(&m_rooms->deck->rail());
    upper->addWidget(m_splitter, 1);
    column->addLayout(upper, 1);

    auto* bottom = new QWidget;
    bottom->setObjectName(QStringLiteral("bottom"));
    bottom->setAttribute(Qt::WA_StyledBackground);
    auto* lower = new QHBoxLayout(bottom);
    lower->setContentsMargins(0, 1, 0, 0);
    lower->setSpacing(0);
    lower->addWidget(m_transport);
    lower->addWidget(m_timeline, 1);
    column->addWidget(bottom);
    column->addWidget(m_status);
    setCentralWidget(centre);
}

void MainWindow::buildMenus() {
    QMenu* menu = nullptr;
    QString title;
    std::map<ActionChoice, QActionGroup*> choices;
    for (const ActionRow& row : actionTable()) {
        if (const QString name = QCoreApplication::translate("actions", row.menu); name != title) {
            title = name;
            menu = menuBar()->addMenu(title);
            menu->menuAction()->setProperty("source", QString::fromUtf8(row.menu));
        }
        if (row.place.line) {
            menu->addSeparator();
        }
        menu->addAction(&m_actions[row.id]);
        if (row.place.choice != ActionChoice::None) {
            QActionGroup*& choice = choices[row.place.choice];
            if (choice == nullptr) {
                choice = new QActionGroup(this);
            }
            choice->addAction(&m_actions[row.id]);
        }
    }
    menuBar()->setCornerWidget(m_title);
    giveMnemonics(*menuBar());
}

void MainWindow::addTools(QToolBar& bar, ToolSection section) {
    for (const ActionRow& row : toolRows(section)) {
        auto* button = new QToolButton;
        button->setDefaultAction(&m_actions[row.id]);
        button->setToolButtonStyle(row.place.tool->iconOnly ? Qt::ToolButtonIconOnly : Qt::ToolButtonTextOnly);
        button->setFocusPolicy(Qt::TabFocus);
        if (row.id == ActionId::Simulate) {
            button->setObjectName(QStringLiteral("primary"));
        }
        bar.addWidget(button);
    }
}

void MainWindow::buildToolBar() {
    auto* bar = addToolBar(tr("Tools"));
    bar->setObjectName(QStringLiteral("toolBar"));
    bar->setMovable(false);
    bar->setContextMenuPolicy(Qt::PreventContextMenu);
    bar->setIconSize({16, 16});
    for (const ToolSection section : {ToolSection::Case, ToolSection::Layout, ToolSection::View}) {
        addTools(*bar, section);
        bar->addSeparator();
    }
    auto* label = new QLabel(tr(" Colour by "));
    label->setObjectName(QStringLiteral("muted"));
    bar->addWidget(label);
    const std::array<std::pair<QString, render::ColourBy>, 7> choices = {{{tr("highlight"), render::ColourBy::Highlight},
                                                                          {tr("component"), render::ColourBy::Component},
                                                                          {tr("birth time"), render::ColourBy::BirthTime},
                                                                          {tr("speed"), render::ColourBy::Speed},
                                                                          {tr("cluster"), render::ColourBy::Cluster},
                                                                          {tr("error"), render::ColourBy::Error},
                                                                          {tr("island"), render::ColourBy::Island}}};
    for (const auto& [name, by] : choices) {
        m_colours->addItem(name, static_cast<int>(by));
    }
    m_colours->setToolTip(
        tr("What the colour of a fragment says; island: which loose part of the structure an element belongs to"));
    m_colours->setAccessibleName(tr("Colour by"));
    m_colours->setObjectName(QStringLiteral("colourBy"));
    m_colours->setFocusPolicy(Qt::TabFocus);
    bar->addWidget(m_colours);
    auto* space = new QWidget;
    space->setSizePolicy(QSizePolicy::Expanding, QSizePolicy::Preferred);
    bar->addWidget(space);
    addTools(*bar, ToolSection::Run);
    m_layout = std::make_unique<LayoutMemory>(*this, m_rooms->inspection->docks(), *m_splitter);
}

void MainWindow::prepareTour() {
    auto* simulate = findChild<QToolButton*>(QStringLiteral("primary"));
    m_tour = new widgets::Tour(
        {{m_centre, tr("What this is for"),
          tr("Elements that fail vanish from the conventional view; the other one shows how they fall, hit and come to rest as "
             "fragments.")},
         {simulate, tr("Simulate"),
          tr("Simulate (Ctrl+R) computes where the fragments go, and the views play what is computed meanwhile.")},
         {m_timeline, tr("The timeline"), tr("Drag to go to any instant of the collapse; Space plays and pauses.")},
         {m_centre, tr("The views"),
          tr("The left button turns the model, the wheel nears it, and a click on a fragment tells what became of it.")},
         {&m_rooms->deck->rail(), tr("The order of work"),
          tr("The rail leads from the file to the report, top to bottom, and marks what is up to date, stale or running.")},
         {&m_rooms->deck->stack(), tr("The panel of a stage"),
          tr("Each panel answers one question with few settings, and Ctrl+Z takes back every change.")},
         {menuBar(), tr("On from here"),
          tr("Case has New case… for a result of your own, and Help has the manual (F1) and this tour again.")}},
        this);
    m_visit = new FirstVisit(*this, *m_tour);
    connect(&m_actions[ActionId::Tour], &QAction::triggered, m_visit, &FirstVisit::begin);
}

bool MainWindow::studying() const {
    return !m_rooms->runs->costlyWork().isEmpty() && !m_session.computation().busy();
}

void MainWindow::prepareKeys() {
    widgets::ViewWidget& views = m_area->views();
    using Tool = widgets::PhotoView::Tool;
    std::vector<KeyRules::Closable> closables{
        {[this] { return m_tour->isVisible(); }, [this] { m_tour->end(); }},
        {[&views] { return views.isVisible() && views.tool() != widgets::ViewWidget::Tool::Select; },
         [&views] { views.leaveTool(); }, true},
        {[this] { return m_evidencePage->isVisible() && m_evidencePage->photo().tool() != Tool::Look; },
         [this] { m_evidencePage->setTool(Tool::Look); }, true},
        {[this] { return m_evidencePage->survey().isVisible() && m_evidencePage->survey().drawing().has_value(); },
         [this] { m_evidencePage->survey().draw(std::nullopt); }, true},
        {[&views] { return views.isVisible() && views.view().clip.has_value(); }, [this] { m_actions[ActionId::Clip].trigger(); }},
        // A page over the views; a study of its own that runs there is not hidden by the key that cancels it.
        {[this] { return m_centre->currentWidget() != m_area && !studying(); },
         [this] { m_rooms->deck->choose(static_cast<PanelDeck::Entry>(m_lastEntry)); }}};
    std::vector<const QWidget*> forms{&m_rooms->deck->stack()};
    for (const auto* dock : m_rooms->inspection->docks().findChildren<QDockWidget*>()) {
        forms.push_back(dock);
    }
    m_keys = new KeyRules(*this, std::move(forms), std::move(closables));
    connect(m_keys, &KeyRules::refused, this, [this](const QAction& action) {
        if (const QString words = m_actions.refusal(action); !words.isEmpty()) {
            m_session.tell(words);
        }
    });
    // What was shown is gone with the focus, which would go on to some field of what comes.
    const auto leave = [this] {
        if (const QWidget* focus = QApplication::focusWidget(); focus == nullptr || m_rooms->deck->stack().isAncestorOf(focus)) {
            m_keys->leaveFields();
        }
    };
    connect(&m_rooms->deck->stack(), &QStackedWidget::currentChanged, this, leave);
    connect(&m_rooms->deck->evidenceTabs(), &widgets::EvidenceTabs::currentChanged, this, leave);
    connect(m_area, &QStackedWidget::currentChanged, this, leave);
}

void MainWindow::resizeEvent(QResizeEvent* event) {
    QMainWindow::resizeEvent(event);
    m_rooms->deck->rail().setCompact(event->size().width() < compactBelow);
    m_transport->setFixedWidth(m_rooms->deck->rail().sizeHint().width() + panelWidth);
}

}  // namespace rubble
