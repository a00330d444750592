#pragma once

#include <QObject>
#include <deque>
#include <optional>

#include "app/gui/autosave.h"

class QBoxLayout;

namespace rubble {

namespace widgets {
class NoticeBar;
}

/// Offers what a program left behind that ended without being asked to, one case after another, in a bar above the centre.
class Recovery : public QObject {
    Q_OBJECT

public:
    Recovery(Document& document, Autosave& autosave, QBoxLayout& notices, QObject* parent = nullptr);

    /// Looks for such work and offers it.
    void look();
    std::size_t offered() const { return m_left.size(); }
    /// What stands in the bar; empty if there is none.
    QString text() const;

signals:
    /// The user wants this one back. What was left goes once the document has it.
    void recoverRequested(const rubble::LeftWork& work);
    void told(const QString& what);

private:
    void choose(const QString& id);
    void offer();

    Document& m_document;
    Autosave& m_autosave;
    std::deque<LeftWork> m_left;
    std::optional<LeftWork> m_asked;
    widgets::NoticeBar* m_bar;
};

}  // namespace rubble
