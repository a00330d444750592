#include "widgets/views/bookmark_editor.h"

#include <QGuiApplication>
#include <QHBoxLayout>
#include <QLabel>
#include <QLineEdit>
#include <QPushButton>
#include <QScreen>
#include <QVBoxLayout>
#include <algorithm>

namespace rubble::widgets {

BookmarkEditor::BookmarkEditor(QWidget* parent) : QFrame(parent, Qt::Popup), m_when(new QLabel), m_note(new QLineEdit) {
    setObjectName(QStringLiteral("tourCard"));
    setAccessibleName(tr("Bookmark"));
    auto* column = new QVBoxLayout(this);
    column->setContentsMargins(10, 8, 10, 8);
    column->setSpacing(6);
    m_when->setObjectName(QStringLiteral("muted"));
    m_note->setObjectName(QStringLiteral("bookmarkNote"));
    m_note->setPlaceholderText(tr("Note: what is to be seen here"));
    m_note->setAccessibleName(tr("Note of the bookmark"));
    m_note->setToolTip(tr("What is to be seen at this instant; saved with the case"));
    m_note->setMaxLength(400);
    m_note->setMinimumWidth(260);
    column->addWidget(m_when);
    column->addWidget(m_note);
    auto* row = new QHBoxLayout;
    auto* remove = new QPushButton(tr("Remove"));
    remove->setObjectName(QStringLiteral("removeBookmark"));
    remove->setToolTip(tr("Remove this bookmark; can be undone"));
    auto* keep = new QPushButton(tr("Keep"));
    keep->setObjectName(QStringLiteral("primary"));
    keep->setToolTip(tr("Keep the bookmark with this note (Enter)"));
    row->addWidget(remove);
    row->addStretch();
    row->addWidget(keep);
    column->addLayout(row);
    const auto take = [this] {
        hide();
        emit noteChosen(m_note->text().trimmed());
    };
    connect(m_note, &QLineEdit::returnPressed, this, take);
    connect(keep, &QPushButton::clicked, this, take);
    connect(remove, &QPushButton::clicked, this, [this] {
        hide();
        emit removeRequested();
    });
}

void BookmarkEditor::open(const QString& when, const QString& note, const QPoint& at) {
    m_when->setText(when);
    m_note->setText(note);
    adjustSize();
    const QScreen* screen = QGuiApplication::screenAt(at);
    const QRect room = screen != nullptr ? screen->availableGeometry() : QRect(at, size());
    const QPoint corner(std::clamp(at.x() - 20, room.left(), std::max(room.left(), room.right() - width())),
                        std::max(room.top(), at.y() - height() - 12));
    move(corner);
    show();
    m_note->setFocus();
    m_note->selectAll();
}

}  // namespace rubble::widgets
