#pragma once

#include <QObject>

#include "app/gui/case/project_files.h"

class QBoxLayout;

namespace rubble {

class Document;
class Session;
namespace widgets {
class NoticeBar;
}

/// Offers what a program left behind that ended without being asked to, one case after another, in a bar above the centre.
class Recovery : public QObject {
    Q_OBJECT

public:
    Recovery(Session& session, QBoxLayout& notices, QObject* parent = nullptr);

    /// Looks for such work and offers it.
    void look();
    std::size_t offered() const { return m_files.left.size(); }
    /// What stands in the bar; empty if there is none.
    QString text() const;

signals:
    /// The user wants this one back. What was left goes once the document has it.
    void recoverRequested(const rubble::LeftWork& work);

private:
    void choose(const QString& id);
    void offer();

    Session& m_session;
    Document& m_document;
    ProjectFiles& m_files;
    widgets::NoticeBar* m_bar;
};

}  // namespace rubble
