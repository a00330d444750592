#include "widgets/evidence/causes_panel.h"

#include <QCheckBox>
#include <QDialog>
#include <QDialogButtonBox>
#include <QDoubleSpinBox>
#include <QFormLayout>
#include <QHBoxLayout>
#include <QLabel>
#include <QListWidget>
#include <QMenu>
#include <QPushButton>
#include <QStyledItemDelegate>
#include <algorithm>

#include "widgets/basics/study_start.h"
#include "widgets/basics/wording.h"
#include "widgets/figures/number_text.h"
#include "widgets/figures/shown_units.h"

namespace rubble::widgets {

namespace {

constexpr int entryHeight = 24;  // px
constexpr int rowsMost = 7;

/// A row as wide as its list, however long its name is: the middle of that is left out.
class RowOfAList : public QStyledItemDelegate {
public:
    using QStyledItemDelegate::QStyledItemDelegate;
    QSize sizeHint(const QStyleOptionViewItem& option, const QModelIndex& index) const override {
        return {0, QStyledItemDelegate::sizeHint(option, index).height()};
    }
};

QWidget* rowOf(QPushButton* first, QPushButton* second) {
    auto* row = new QWidget;
    auto* line = new QHBoxLayout(row);
    line->setContentsMargins(0, 0, 0, 0);
    line->addWidget(first, 1);
    line->addWidget(second, 1);
    return row;
}

}  // namespace

CausesPanel::CausesPanel(QWidget* parent)
    : Panel(tr("Which cause?"), tr("Which of several supposed causes explains what was found?"), parent),
      m_start(new StudyStart({tr("Compare causes"),
                              tr("Simulate the ensemble of every cause that is ticked and hold it against the evidence that is "
                                 "ticked. Members that were "
                                 "simulated before are taken from the cache"),
                              tr("Stop; members that are done are kept, and comparing again goes on from there"),
                              QStringLiteral("cancelCauses"), tr("Progress of the comparison of causes")})),
      m_causes(new QListWidget),
      m_addCauses(new QPushButton(tr("Add cases…"))),
      m_removeCause(new QPushButton(tr("Remove"))),
      m_evidence(new QListWidget),
      m_addEvidence(new QPushButton(tr("Add evidence"))),
      m_removeEvidence(new QPushButton(tr("Remove"))),
      m_blind(new QCheckBox(tr("Blind test as well"))),
      m_findings(new FindingList) {
    addWide(m_start);
    for (QListWidget* list : {m_causes, m_evidence}) {
        list->setItemDelegate(new RowOfAList(list));
        list->setTextElideMode(Qt::ElideMiddle);
        list->setHorizontalScrollBarPolicy(Qt::ScrollBarAlwaysOff);
    }
    buildCauses();
    buildEvidence();
    addWide(m_findings);
    connect(m_start, &StudyStart::startRequested, this, &CausesPanel::compareRequested);
    connect(m_start, &StudyStart::cancelRequested, this, &CausesPanel::cancelRequested);
    setContent({});
}

void CausesPanel::buildCauses() {
    PanelGroup* group = addGroup(tr("Supposed causes"));
    m_causes->setObjectName(QStringLiteral("causes"));
    m_causes->setAccessibleName(tr("Supposed causes"));
    m_causes->setToolTip(
        tr("Causes that are ticked are compared: the scenarios of this case, and other cases and FE results of "
           "the same site"));
    group->addWide(m_causes);
    m_addCauses->setObjectName(QStringLiteral("addCauses"));
    m_addCauses->setToolTip(tr("Add cases or FE results of the same site, each computed for another cause"));
    m_removeCause->setToolTip(tr("Take the chosen cause off the list; its file stays"));
    group->addWide(rowOf(m_addCauses, m_removeCause));
    m_members = group->addNote({});
    connect(m_addCauses, &QPushButton::clicked, this, &CausesPanel::addCausesRequested);
    connect(m_removeCause, &QPushButton::clicked, this, [this] { emit causeRemoved(m_causes->currentRow()); });
    connect(m_causes, &QListWidget::currentRowChanged, this, &CausesPanel::showRemovable);
    connect(m_causes, &QListWidget::itemChanged, this, [this](QListWidgetItem* item) {
        if (!m_filling) {
            emit causeUsed(m_causes->row(item), item->checkState() == Qt::Checked);
        }
    });
}

void CausesPanel::buildEvidence() {
    PanelGroup* group = addGroup(tr("What was found"));
    m_evidence->setObjectName(QStringLiteral("causeEvidence"));
    m_evidence->setAccessibleName(tr("What was found"));
    m_evidence->setToolTip(
        tr("Evidence that is ticked counts: surveys of this case, its photographs taken at rest with an outline of the debris, and "
           "footprints, heights and times that are added"));
    group->addWide(m_evidence);
    auto* menu = new QMenu(m_addEvidence);
    connect(menu->addAction(tr("Footprint, polygons…")), &QAction::triggered, this, &CausesPanel::addFootprintRequested);
    connect(menu->addAction(tr("Heights of the debris above the ground, raster…")), &QAction::triggered, this,
            &CausesPanel::addHeightsRequested);
    connect(menu->addAction(tr("Heights of the surface with the debris, raster…")), &QAction::triggered, this,
            &CausesPanel::addSurfaceRequested);
    connect(menu->addAction(tr("Time at which debris reached a place…")), &QAction::triggered, this, &CausesPanel::askForTime);
    m_addEvidence->setMenu(menu);
    m_addEvidence->setObjectName(QStringLiteral("addEvidence"));
    m_addEvidence->setToolTip(tr("Add a file of what was found. Photographs and surveys of the case are added under Photographs"));
    m_removeEvidence->setToolTip(tr("Take the chosen file off the list; it stays where it is"));
    group->addWide(rowOf(m_addEvidence, m_removeEvidence));
    m_blind->setToolTip(tr(
        "Let each member in turn be what was observed and say how often its cause is found: how far footprints and heights could "
        "tell these causes apart at all. Without evidence this is done anyway"));
    group->addWide(m_blind);
    connect(m_blind, &QCheckBox::clicked, this, &CausesPanel::blindChosen);
    connect(m_removeEvidence, &QPushButton::clicked, this, [this] { emit evidenceRemoved(m_evidence->currentRow()); });
    connect(m_evidence, &QListWidget::currentRowChanged, this, &CausesPanel::showRemovable);
    connect(m_evidence, &QListWidget::itemChanged, this, [this](QListWidgetItem* item) {
        if (!m_filling) {
            emit evidenceUsed(m_evidence->row(item), item->checkState() == Qt::Checked);
        }
    });
}

void CausesPanel::askForTime() {
    QDialog dialog(window());
    dialog.setObjectName(QStringLiteral("timeEvidence"));
    dialog.setWindowTitle(tr("When debris reached a place"));
    auto* form = new QFormLayout(&dialog);
    const auto field = [&](const char* name, const QString& label, double least, double most, double value, const QString& unit,
                           const QString& tip) {
        auto* box = new QDoubleSpinBox;
        box->setObjectName(QLatin1String(name));
        box->setRange(least, most);
        box->setDecimals(2);
        box->setValue(value);
        box->setSuffix(QChar(0x00A0) + unit);
        box->setToolTip(tip);
        form->addRow(label, box);
        return box;
    };
    constexpr double far = 1e6;
    const QString metres = figures::shownUnit("m").name;
    const double perMetre = figures::shownUnit("m").perSi;
    // Debris of a blast comes down long after its microseconds.
    const figures::ShownUnit told = figures::timeUnit(1e-3);
    auto* time = field("seconds", tr("Time"), 0.0, far, 0.0, told.name,
                       tr("After the first debris came down anywhere: by a witness, a video, a gauge"));
    auto* x = field("x", tr("x of the place"), -far, far, 0.0, metres, tr("In the frame of the case"));
    auto* y = field("y", tr("y of the place"), -far, far, 0.0, metres, tr("In the frame of the case"));
    auto* radius = field("radius", tr("Within"), 0.01, far, usualTimeRadius * perMetre, metres, tr("Around the place"));
    auto* accuracy = field("accuracy", tr("Give or take"), 0.0, far, usualTimeAccuracy * told.perSi, told.name,
                           tr("How far the time may be off"));
    auto* buttons = new QDialogButtonBox(QDialogButtonBox::Ok | QDialogButtonBox::Cancel);
    buttons->button(QDialogButtonBox::Ok)->setText(tr("Add"));
    buttons->button(QDialogButtonBox::Ok)->setDefault(true);
    form->addRow(buttons);
    connect(buttons, &QDialogButtonBox::accepted, &dialog, &QDialog::accept);
    connect(buttons, &QDialogButtonBox::rejected, &dialog, &QDialog::reject);
    if (dialog.exec() == QDialog::Accepted) {
        emit timeTold(timeEvidence(time->value() / told.perSi, {typedIn(x->value(), "m"), typedIn(y->value(), "m")},
                                   typedIn(radius->value(), "m"), accuracy->value() / told.perSi));
    }
}

void CausesPanel::setBlind(bool blind) {
    m_blind->setChecked(blind);
}

void CausesPanel::fill(QListWidget& list, const std::vector<Entry>& entries, const QString& none) {
    const int current = list.currentRow();
    list.clear();
    for (const Entry& entry : entries) {
        auto* item = new QListWidgetItem(entry.name, &list);
        item->setToolTip(entry.name + u'\n' + entry.tip);
        // What was added can be taken off the list even where it cannot be used.
        const Qt::ItemFlags chosen =
            entry.usable || entry.removable ? Qt::ItemIsEnabled | Qt::ItemIsSelectable : Qt::ItemFlags(Qt::ItemIsSelectable);
        item->setFlags(entry.usable ? chosen | Qt::ItemIsUserCheckable : chosen);
        item->setCheckState(entry.used && entry.usable ? Qt::Checked : Qt::Unchecked);
    }
    if (entries.empty()) {
        auto* item = new QListWidgetItem(none, &list);
        item->setFlags(Qt::NoItemFlags);
    }
    list.setCurrentRow(std::min(current, static_cast<int>(entries.size()) - 1));
    list.setFixedHeight(std::clamp(list.count(), 1, rowsMost) * entryHeight + 6);
}

void CausesPanel::showRemovable() {
    const auto removable = [](const QListWidget& list, const std::vector<Entry>& entries) {
        const int row = list.currentRow();
        return row >= 0 && row < static_cast<int>(entries.size()) && entries[static_cast<std::size_t>(row)].removable;
    };
    m_removeCause->setEnabled(!m_content.running && removable(*m_causes, m_content.causes));
    m_removeEvidence->setEnabled(!m_content.running && removable(*m_evidence, m_content.evidence));
}

void CausesPanel::setContent(const Content& content) {
    m_content = content;
    m_filling = true;
    fill(*m_causes, content.causes, tr("none yet"));
    fill(*m_evidence, content.evidence, tr("none: a blind test"));
    m_filling = false;
    for (QWidget* editor : std::initializer_list<QWidget*>{m_causes, m_evidence, m_addCauses, m_addEvidence, m_blind}) {
        editor->setEnabled(content.available && !content.running);
    }
    showRemovable();
    m_start->setReady(content.ready, content.running, content.why);
    m_members->setText(content.members);
    m_members->setVisible(!content.members.isEmpty());
    m_findings->set(content.findings);
}

void CausesPanel::setProgress(const QString& what, double fraction, double secondsLeft) {
    m_start->setProgress(what, fraction, secondsLeft);
}

}  // namespace rubble::widgets
