#pragma once

#include <QHash>
#include <QObject>
#include <QString>
#include <string>
#include <vector>

#include "core/scenario/case.h"
#include "widgets/basics/wording.h"

class QBoxLayout;
class QWidget;

namespace rubble {

class Computation;
class Document;
class Session;
namespace widgets {
class NoticeBar;
}

/// Says above the centre which inputs of the case are missing, cannot be used or are no longer what they were, and mends it: by
/// another place, by taking them as they are, or without them.
class InputsDisplay : public QObject {
    Q_OBJECT

public:
    InputsDisplay(Session& session, QBoxLayout& notices, QWidget& window);

    void refresh();
    /// Takes a file for an input: silently if it is the one the case was made with, after a question in place if it is another.
    void locate(const std::string& id, const QString& path);
    /// Takes an input as it lies there now, as one undoable command.
    void accept(const std::string& id);
    /// What stands in the bars.
    QStringList texts() const;

signals:
    void withoutTerrainRequested();

private:
    /// A file that was chosen although it is another.
    struct Candidate {
        QString path;
        std::string sha256;
    };
    void choose(const std::string& id, const QString& what);
    void put(const std::string& id, const QString& path, const std::string& sha256, const widgets::Wording& what);
    void show(const CaseInput& input);
    widgets::NoticeBar& bar(const std::string& id);
    const CaseInput* inputOf(const std::string& id) const;

    Session& m_session;
    Document& m_document;
    Computation& m_computation;
    QBoxLayout& m_notices;
    QWidget& m_window;
    QHash<QString, widgets::NoticeBar*> m_bars;
    QHash<QString, Candidate> m_candidates;
};

}  // namespace rubble
