#include "widgets/evidence/surveys/removal_box.h"

#include <QHBoxLayout>
#include <QLabel>
#include <QLineEdit>
#include <QListWidget>
#include <QMenu>
#include <QToolButton>
#include <QVBoxLayout>
#include <algorithm>

#include "core/evidence/surveys/stated_survey.h"
#include "widgets/basics/wording.h"

namespace rubble::widgets {

RemovalBox::RemovalBox(QWidget* parent)
    : QWidget(parent),
      m_since(new QLineEdit),
      m_said(new QLabel(tr("Write date and time, such as 2021-06-25 16:30"))),
      m_add(new QToolButton),
      m_remove(new QToolButton),
      m_list(new QListWidget) {
    auto* column = new QVBoxLayout(this);
    column->setContentsMargins(0, 0, 0, 0);
    column->setSpacing(4);
    auto* heading = new QHBoxLayout;
    heading->addWidget(new QLabel(tr("What was removed")), 1);
    m_add->setText(tr("Add"));
    m_add->setPopupMode(QToolButton::InstantPopup);
    m_add->setToolTip(tr("Add a place whose debris rescuers took away; say first from when on it was gone"));
    auto* menu = new QMenu(m_add);
    connect(menu->addAction(tr("Draw what was removed")), &QAction::triggered, this, [this] { emit drawRequested(since()); });
    connect(menu->addAction(tr("What was removed from a file…")), &QAction::triggered, this,
            [this] { emit fileRequested(since()); });
    m_add->setMenu(menu);
    m_remove->setText(tr("Remove"));
    m_remove->setToolTip(tr("Remove the chosen place from the list"));
    heading->addWidget(m_add);
    heading->addWidget(m_remove);
    column->addLayout(heading);
    auto* row = new QHBoxLayout;
    row->addWidget(new QLabel(tr("Gone since")));
    m_since->setAccessibleName(tr("From when on it was gone"));
    m_since->setPlaceholderText(tr("date and time"));
    m_since->setToolTip(tr(
        "Date and time by the clock of the site, such as 2021-06-25 16:30: of the chosen place, or of the next one. Surveys taken "
        "later are compared without it. Kept in the case"));
    row->addWidget(m_since, 1);
    column->addLayout(row);
    m_said->setWordWrap(true);
    column->addWidget(m_said);
    m_list->setAccessibleName(tr("Places whose debris was removed"));
    // A narrow panel cuts long names; a bar would lie over the only row.
    m_list->setHorizontalScrollBarPolicy(Qt::ScrollBarAlwaysOff);
    column->addWidget(m_list);
    connect(m_since, &QLineEdit::textEdited, this, &RemovalBox::showState);
    connect(m_since, &QLineEdit::editingFinished, this, &RemovalBox::takeTime);
    connect(m_list, &QListWidget::currentRowChanged, this, [this](int place) {
        if (!m_showing && place >= 0) {
            m_since->setText(QString::fromStdString(m_removals[static_cast<std::size_t>(place)].time));
        }
        showState();
    });
    connect(m_remove, &QToolButton::clicked, this, [this] {
        if (m_list->currentRow() >= 0) {
            emit removeRequested(m_list->currentRow());
        }
    });
    showState();
}

std::string RemovalBox::since() const {
    return clockTimeFrom(m_since->text().trimmed().toStdString());
}

void RemovalBox::setRemovals(const std::vector<Removal>& removals, bool some) {
    m_some = some;
    if (removals != m_removals || m_list->count() == 0) {
        m_showing = true;
        m_removals = removals;
        m_list->clear();
        for (const Removal& removal : removals) {
            m_list->addItem(tr("since %1: %2, places: %3")
                                .arg(QString::fromStdString(removal.time), QString::fromStdString(removal.name))
                                .arg(removal.area.polygons.size()));
            m_list->item(m_list->count() - 1)->setToolTip(m_list->item(m_list->count() - 1)->text());
        }
        m_showing = false;
    }
    const int count = m_list->count();
    m_list->setVisible(count > 0);
    m_list->setFixedHeight(std::clamp(count, 1, 4) * (m_list->fontMetrics().height() + 6) + 4);
    showState();
}

void RemovalBox::showState() {
    const QString text = m_since->text().trimmed();
    m_said->setVisible(!text.isEmpty() && since().empty());
    m_since->setEnabled(m_some);
    m_add->setEnabled(m_some && !since().empty());
    m_remove->setVisible(m_list->count() > 0);
    m_remove->setEnabled(m_list->currentRow() >= 0);
}

void RemovalBox::takeTime() {
    const int row = m_list->currentRow();
    if (row >= 0 && !since().empty() && since() != m_removals[static_cast<std::size_t>(row)].time) {
        emit timeChosen(row, since());
    }
}

}  // namespace rubble::widgets
