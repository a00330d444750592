#include "widgets/case/scenario_list.h"

#include <QEvent>
#include <QGridLayout>
#include <QListWidget>
#include <QPlainTextEdit>
#include <QPushButton>
#include <QVBoxLayout>
#include <algorithm>

#include "widgets/basics/theme.h"

namespace rubble::widgets {

namespace {

constexpr int idRole = Qt::UserRole;

}  // namespace

ScenarioList::ScenarioList(QWidget* parent)
    : QWidget(parent),
      m_list(new QListWidget),
      m_note(new QPlainTextEdit),
      m_duplicate(new QPushButton(tr("Duplicate"))),
      m_rename(new QPushButton(tr("Rename"))),
      m_remove(new QPushButton(tr("Delete"))),
      m_compare(new QPushButton(tr("Compare…"))) {
    auto* column = new QVBoxLayout(this);
    column->setContentsMargins(0, 0, 0, 0);
    column->setSpacing(6);
    m_list->setObjectName(QStringLiteral("scenarioList"));
    m_list->setAccessibleName(tr("Scenarios"));
    m_list->setToolTip(tr("The chosen scenario is the one that is worked on; F2 renames it"));
    m_list->setEditTriggers(QAbstractItemView::EditKeyPressed | QAbstractItemView::DoubleClicked);
    m_list->setHorizontalScrollBarPolicy(Qt::ScrollBarAlwaysOff);
    m_list->setFrameShape(QFrame::NoFrame);
    column->addWidget(m_list);
    m_note->setObjectName(QStringLiteral("scenarioNote"));
    m_note->setPlaceholderText(tr("Note: what this scenario stands for"));
    m_note->setAccessibleName(tr("Note on the scenario"));
    m_note->setToolTip(tr("What the chosen scenario stands for; saved with the case"));
    m_note->setTabChangesFocus(true);
    m_note->setFixedHeight(3 * m_note->fontMetrics().lineSpacing() + 12);
    m_note->installEventFilter(this);
    column->addWidget(m_note);
    auto* buttons = new QGridLayout;
    buttons->setSpacing(4);
    m_duplicate->setToolTip(tr("A copy of the chosen scenario, with all its settings, becomes the one that is worked on"));
    m_rename->setToolTip(tr("Give the chosen scenario another name (F2)"));
    m_remove->setToolTip(tr("Delete the chosen scenario; can be undone. The last one stays"));
    m_compare->setToolTip(tr("Show side by side in which settings and results two scenarios differ"));
    const std::array all = {m_duplicate, m_rename, m_remove, m_compare};
    for (std::size_t i = 0; i < all.size(); ++i) {
        buttons->addWidget(all[i], static_cast<int>(i / 2), static_cast<int>(i % 2));
    }
    column->addLayout(buttons);
    connect(m_list, &QListWidget::currentItemChanged, this, [this](QListWidgetItem* item) {
        if (!m_filling && item != nullptr && item->data(idRole).toString() != m_active) {
            finishNote();
            emit activated(item->data(idRole).toString());
        }
    });
    connect(m_list, &QListWidget::itemChanged, this, &ScenarioList::edited);
    connect(m_duplicate, &QPushButton::clicked, this, [this] {
        finishNote();
        emit duplicateRequested(m_active);
    });
    connect(m_rename, &QPushButton::clicked, this, [this] {
        if (m_list->currentItem() != nullptr) {
            m_list->setFocus();
            m_list->editItem(m_list->currentItem());
        }
    });
    connect(m_remove, &QPushButton::clicked, this, [this] { emit removeRequested(m_active); });
    connect(m_compare, &QPushButton::clicked, this, &ScenarioList::compareRequested);
    setContent({}, {});
}

const ScenarioLine* ScenarioList::activeLine() const {
    const auto found =
        std::find_if(m_lines.begin(), m_lines.end(), [this](const ScenarioLine& each) { return each.id == m_active; });
    return found != m_lines.end() ? &*found : nullptr;
}

void ScenarioList::setContent(const std::vector<ScenarioLine>& lines, const QString& active) {
    const bool other = active != m_active;
    const ScenarioLine* before = activeLine();
    const QString noteBefore = before != nullptr ? before->note : QString();
    m_filling = true;
    if (lines != m_lines || other) {
        m_lines = lines;
        m_active = active;
        m_list->clear();
        for (const ScenarioLine& line : lines) {
            auto* item = new QListWidgetItem(line.name, m_list);
            item->setData(idRole, line.id);
            item->setFlags(item->flags() | Qt::ItemIsEditable);
            item->setToolTip(QStringList({line.note, line.run}).join(QStringLiteral("\n")).trimmed());
            if (line.id == active) {
                QFont font = m_list->font();
                font.setWeight(QFont::DemiBold);
                item->setFont(font);
                m_list->setCurrentItem(item);
            }
        }
        const int shown = std::clamp(static_cast<int>(lines.size()), 1, 6);
        m_list->setFixedHeight(shown * (m_list->fontMetrics().height() + 8) + 4);
    }
    const ScenarioLine* line = activeLine();
    const QString note = line != nullptr ? line->note : QString();
    // What is being typed stays, unless the scenario or its note is another.
    if ((other || note != noteBefore || !m_note->hasFocus()) && note != m_note->toPlainText()) {
        m_note->setPlainText(note);
    }
    m_filling = false;
    setEnabled(!lines.empty());
    m_remove->setEnabled(lines.size() > 1);
    m_compare->setEnabled(lines.size() > 1);
}

void ScenarioList::edited(QListWidgetItem* item) {
    if (m_filling) {
        return;
    }
    const QString id = item->data(idRole).toString();
    const auto line = std::find_if(m_lines.begin(), m_lines.end(), [&](const ScenarioLine& each) { return each.id == id; });
    const QString name = item->text().trimmed();
    if (line == m_lines.end() || name == line->name) {
        return;
    }
    m_filling = true;
    item->setText(line->name);
    m_filling = false;
    if (!name.isEmpty()) {
        // The list is filled anew by what follows, and the editor is still closing.
        QMetaObject::invokeMethod(this, [this, id, name] { emit renamed(id, name); }, Qt::QueuedConnection);
    }
}

void ScenarioList::finishNote() {
    const ScenarioLine* line = activeLine();
    if (line != nullptr && line->note != m_note->toPlainText()) {
        emit noteEdited(line->id, m_note->toPlainText());
    }
}

bool ScenarioList::eventFilter(QObject* watched, QEvent* event) {
    if (watched == m_note && event->type() == QEvent::FocusOut) {
        finishNote();
    }
    return QWidget::eventFilter(watched, event);
}

}  // namespace rubble::widgets
