#pragma once

#include <QFrame>

class QLabel;
class QLineEdit;

namespace rubble::widgets {

/// The note of a bookmark, in a small window at its flag. Enter keeps it, Esc leaves it as it was.
class BookmarkEditor : public QFrame {
    Q_OBJECT

public:
    explicit BookmarkEditor(QWidget* parent = nullptr);

    /// @param when  the instant in words; @param at  the place of the flag, global
    void open(const QString& when, const QString& note, const QPoint& at);
    QLineEdit& note() { return *m_note; }

signals:
    void noteChosen(const QString& note);
    void removeRequested();

private:
    QLabel* m_when;
    QLineEdit* m_note;
};

}  // namespace rubble::widgets
