#include "widgets/case/new_case_wizard.h"

#include <QAbstractSpinBox>
#include <QButtonGroup>
#include <QCloseEvent>
#include <QHBoxLayout>
#include <QKeyEvent>
#include <QLabel>
#include <QLineEdit>
#include <QMessageBox>
#include <QPlainTextEdit>
#include <QProgressBar>
#include <QPushButton>
#include <QShortcut>
#include <QSplitter>
#include <QStackedWidget>
#include <QToolButton>
#include <QVBoxLayout>

#include "widgets/basics/theme.h"

namespace rubble::widgets {

namespace {

constexpr QSize firstSize(1120, 720);
constexpr int panelWidth = 400;

}  // namespace

NewCaseWizard::NewCaseWizard(const QString& file, QWidget* preview, QWidget* parent)
    : QDialog(parent),
      m_units(new NewCaseUnits),
      m_ground(new NewCaseGround),
      m_components(new NewCaseComponents),
      m_deaths(new NewCaseDeaths),
      m_summary(new NewCaseSummary),
      m_stack(new QStackedWidget),
      m_steps(new QButtonGroup(this)),
      m_undo(new QPushButton(tr("Undo"))),
      m_redo(new QPushButton(tr("Redo"))),
      m_cancel(new QPushButton(tr("Cancel"))),
      m_back(new QPushButton(tr("&Back"))),
      m_next(new QPushButton(tr("&Next"))),
      m_create(new QPushButton(tr("&Make the case"))),
      m_activity(new QLabel),
      m_progress(new QProgressBar),
      m_stop(new QPushButton(tr("Stop"))) {
    setWindowTitle(tr("New case from %1").arg(file));
    setObjectName(QStringLiteral("newCase"));
    setProperty("help", QStringLiteral("Case#A new case"));
    auto* column = new QVBoxLayout(this);
    column->setContentsMargins(0, 0, 0, 0);
    column->setSpacing(0);
    for (Panel* panel : panels()) {
        m_stack->addWidget(panel);
    }
    m_stack->setMinimumWidth(300);
    auto* splitter = new QSplitter(Qt::Horizontal);
    splitter->setObjectName(QStringLiteral("newCaseSplitter"));
    splitter->setAccessibleName(tr("Steps and preview"));
    splitter->setHandleWidth(1);
    splitter->setChildrenCollapsible(false);
    splitter->addWidget(m_stack);
    splitter->addWidget(preview);
    splitter->setStretchFactor(1, 1);
    splitter->setSizes({panelWidth, firstSize.width() - panelWidth});
    column->addWidget(buildSteps());
    column->addWidget(splitter, 1);
    column->addWidget(buildButtons());
    resize(firstSize);
    connect(m_summary, &NewCaseSummary::namedChanged, this, &NewCaseWizard::showState);
    setProgress({}, 0.0);
    setUndo({}, {});
    go(Units);
}

std::array<Panel*, NewCaseWizard::StepCount> NewCaseWizard::panels() const {
    return {m_units, m_ground, m_components, m_deaths, m_summary};
}

QWidget* NewCaseWizard::buildSteps() {
    auto* bar = new QWidget;
    bar->setObjectName(QStringLiteral("bottom"));
    bar->setAttribute(Qt::WA_StyledBackground);
    auto* row = new QHBoxLayout(bar);
    row->setContentsMargins(14, 8, 14, 8);
    row->setSpacing(4);
    const std::array<QString, StepCount> names{tr("1  Units and axes"), tr("2  Ground"), tr("3  Components"), tr("4  Deaths"),
                                               tr("5  Case")};
    for (int step = 0; step < StepCount; ++step) {
        auto* button = new QToolButton;
        button->setText(names[static_cast<std::size_t>(step)]);
        button->setCheckable(true);
        button->setFocusPolicy(Qt::StrongFocus);
        button->setToolTip(tr("Go to this step (Ctrl+%1)").arg(step + 1));
        button->setShortcut(QKeySequence(Qt::CTRL | static_cast<Qt::Key>(Qt::Key_1 + step)));
        m_steps->addButton(button, step);
        row->addWidget(button);
    }
    row->addStretch();
    connect(m_steps, &QButtonGroup::idClicked, this, &NewCaseWizard::goByHand);
    return bar;
}

QWidget* NewCaseWizard::buildButtons() {
    auto* bar = new QWidget;
    bar->setObjectName(QStringLiteral("bottom"));
    bar->setAttribute(Qt::WA_StyledBackground);
    auto* row = new QHBoxLayout(bar);
    row->setContentsMargins(14, 10, 14, 10);
    m_activity->setObjectName(QStringLiteral("muted"));
    m_progress->setRange(0, 1000);
    m_progress->setTextVisible(false);
    m_progress->setFixedWidth(120);
    m_progress->setAccessibleName(tr("Progress"));
    m_stop->setToolTip(tr("Stop what is being read or counted"));
    m_create->setObjectName(QStringLiteral("primary"));
    m_create->setToolTip(tr("Open the case in the window; it is saved when you say so"));
    m_back->setToolTip(tr("To the step before"));
    m_next->setToolTip(tr("To the next step"));
    m_cancel->setToolTip(tr("Leave without a case (Esc)"));
    for (QWidget* each : std::initializer_list<QWidget*>{m_undo, m_redo, m_activity, m_progress, m_stop}) {
        row->addWidget(each);
    }
    // All of the room between the buttons, on two lines where one is too short.
    m_activity->setWordWrap(true);
    row->setStretchFactor(m_activity, 1);
    row->addStretch();
    for (QPushButton* each : {m_cancel, m_back, m_next, m_create}) {
        row->addWidget(each);
    }
    for (QPushButton* each : {m_undo, m_redo, m_stop, m_cancel, m_back, m_next, m_create}) {
        each->setAutoDefault(false);
    }
    m_undo->setShortcut(QKeySequence::Undo);
    m_redo->setShortcut(QKeySequence(Qt::CTRL | Qt::SHIFT | Qt::Key_Z));
    connect(m_units, &Panel::edited, this,
            [this](const QString& key) { m_unitsChosen = m_unitsChosen || key == QLatin1String("units"); });
    connect(m_undo, &QPushButton::clicked, this, &NewCaseWizard::undoRequested);
    connect(m_redo, &QPushButton::clicked, this, &NewCaseWizard::redoRequested);
    connect(m_stop, &QPushButton::clicked, this, &NewCaseWizard::stopRequested);
    connect(m_cancel, &QPushButton::clicked, this, &NewCaseWizard::leaveByHand);
    connect(m_back, &QPushButton::clicked, this, [this] { go(static_cast<Step>(step() - 1)); });
    connect(m_next, &QPushButton::clicked, this, [this] { goByHand(step() + 1); });
    connect(m_create, &QPushButton::clicked, this, [this] {
        if (mayGoOn()) {
            emit createRequested();
        }
    });
    return bar;
}

NewCaseWizard::Step NewCaseWizard::step() const {
    return static_cast<Step>(m_stack->currentIndex());
}

void NewCaseWizard::go(Step step) {
    if (step < Units || step >= StepCount) {
        return;
    }
    m_stack->setCurrentIndex(step);
    m_steps->button(step)->setChecked(true);
    showState();
    emit stepChanged(step);
}

void NewCaseWizard::goByHand(int step) {
    if (step > this->step() && !mayGoOn()) {
        step = Units;
    }
    go(static_cast<Step>(step));
}

void NewCaseWizard::setOddDensities(const QString& components) {
    m_oddDensities = components;
}

bool NewCaseWizard::goesOn(const QString& title, const QString& what, const QString& why, const QString& onward) {
    QMessageBox box(QMessageBox::Warning, title, what, QMessageBox::NoButton, this);
    box.setInformativeText(why);
    QPushButton* back = box.addButton(tr("Back to the units"), QMessageBox::RejectRole);
    QPushButton* on = box.addButton(onward, QMessageBox::AcceptRole);
    box.setDefaultButton(back);
    box.setEscapeButton(back);
    box.exec();
    if (box.clickedButton() != on) {
        go(Units);
        return false;
    }
    return true;
}

bool NewCaseWizard::acceptsUnits() {
    const QString rivals = m_units->rivals();
    if (m_unitsChosen || rivals.isEmpty()) {
        return true;
    }
    const QString taken = QString::fromStdString(m_units->taken());
    m_unitsChosen = goesOn(tr("Units that nobody has said"), tr("The file fits %1 as well as %2.").arg(rivals, taken),
                           tr("Nothing in it decides. Ask who made the analysis: lengths, masses and times would be wrong by "
                              "powers of ten."),
                           tr("They are %1").arg(taken));
    if (m_unitsChosen) {
        emit unitsAccepted();
    }
    return m_unitsChosen;
}

bool NewCaseWizard::mayGoOn() {
    if (!acceptsUnits()) {
        return false;
    }
    if (m_oddDensities.isEmpty() || m_oddDensities == m_acceptedDensities) {
        return true;
    }
    if (!goesOn(tr("Densities of no material"), tr("No material has the density of %1 in these units.").arg(m_oddDensities),
                tr("Masses, and all that follows from them, would be wrong by the same factor. Choose the units that the file "
                   "is in, or set the densities under Components."),
                tr("Go on all the same"))) {
        return false;
    }
    m_acceptedDensities = m_oddDensities;
    return true;
}

void NewCaseWizard::setProgress(const QString& what, double fraction) {
    const bool runs = !what.isEmpty();
    m_activity->setText(runs ? what + QStringLiteral(" …") : QString());
    m_activity->setToolTip(what);
    m_activity->setVisible(runs);
    m_progress->setValue(static_cast<int>(1000.0 * fraction));
    m_progress->setVisible(runs);
    m_stop->setVisible(runs);
}

void NewCaseWizard::setReady(bool ready) {
    m_ready = ready;
    showState();
}

void NewCaseWizard::setUndo(const QString& undo, const QString& redo) {
    m_undo->setEnabled(!undo.isEmpty());
    m_redo->setEnabled(!redo.isEmpty());
    m_undo->setToolTip(undo.isEmpty() ? tr("Nothing to take back") : tr("Undo %1 (Ctrl+Z)").arg(undo));
    m_redo->setToolTip(redo.isEmpty() ? tr("Nothing to make again") : tr("Redo %1 (Ctrl+Shift+Z)").arg(redo));
}

void NewCaseWizard::showState() {
    const bool named = !m_summary->title().isEmpty() && !m_summary->scenarioName().isEmpty();
    m_back->setEnabled(step() > Units);
    m_next->setEnabled(step() + 1 < StepCount);
    m_create->setEnabled(m_ready && named);
}

void NewCaseWizard::changeEvent(QEvent* event) {
    QDialog::changeEvent(event);
    if (event->type() == QEvent::LanguageChange) {
        emit languageChanged();
    }
}

void NewCaseWizard::closeEvent(QCloseEvent* event) {
    if (mayLeave()) {
        QDialog::closeEvent(event);
    } else {
        event->ignore();
    }
}

bool NewCaseWizard::mayLeave() {
    if (step() == Units && !m_undo->isEnabled()) {
        return true;
    }
    QMessageBox box(QMessageBox::Question, tr("Leave the new case?"), tr("Nothing of what was chosen in these steps is kept."),
                    QMessageBox::NoButton, this);
    QPushButton* leave = box.addButton(tr("Leave"), QMessageBox::DestructiveRole);
    QPushButton* stay = box.addButton(tr("Go on with the case"), QMessageBox::RejectRole);
    box.setDefaultButton(stay);
    box.setEscapeButton(stay);
    box.exec();
    return box.clickedButton() == leave;
}

void NewCaseWizard::leaveByHand() {
    if (mayLeave()) {
        reject();
    }
}

void NewCaseWizard::keyPressEvent(QKeyEvent* event) {
    if (event->key() == Qt::Key_Escape) {
        QWidget* focused = focusWidget();
        const bool typed = qobject_cast<QLineEdit*>(focused) != nullptr || qobject_cast<QPlainTextEdit*>(focused) != nullptr ||
                           qobject_cast<QAbstractSpinBox*>(focused) != nullptr;
        if (typed && focused->hasFocus()) {
            m_next->isEnabled() ? m_next->setFocus() : m_back->setFocus();
        } else {
            leaveByHand();
        }
        return;
    }
    if (event->key() == Qt::Key_Return || event->key() == Qt::Key_Enter) {
        if (auto* button = qobject_cast<QPushButton*>(focusWidget())) {
            button->click();
        }
        return;
    }
    QDialog::keyPressEvent(event);
}

}  // namespace rubble::widgets
