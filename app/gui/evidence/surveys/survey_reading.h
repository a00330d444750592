#pragma once

#include <QObject>
#include <functional>
#include <string>
#include <utility>

#include "core/scenario/case.h"

class QWidget;

namespace rubble {

class Document;
class PanelDeck;
class Session;

/// How clouds and tables are read, where their files do not say it: asked when one is added, and kept in fields of the panel.
class SurveyReading : public QObject {
    Q_OBJECT

public:
    using Current = std::function<const CaseInput*()>;
    /// What is done with another reading of the current survey. @param read  the survey with it
    using Read = std::function<void(const CaseInput& read)>;

    SurveyReading(Session& session, PanelDeck& deck, QWidget* window, Current current, Read read, QObject* parent = nullptr);

    /// Asks how a survey is read if its file leaves that open. @return false: somebody gave up
    bool ask(CaseInput& survey, const QString& path);
    /// Shows how the current survey is read.
    void show();

private:
    Document& m_document;
    PanelDeck& m_deck;
    QWidget* m_window;
    Current m_current;
    Read m_read;
    using Shown = std::pair<std::string, CloudRequest>;
    Shown m_shown;  ///< id of the survey that stands in the fields, and how it is read
};

}  // namespace rubble
