#pragma once

#include <QObject>

namespace rubble {

class Computation;
class Document;
class Session;
class ViewArea;

/// Shows the run of another scenario of the case in a view of its own, with the camera and the clock of the others.
class ScenarioPane : public QObject {
    Q_OBJECT

public:
    ScenarioPane(Session& session, ViewArea& area, QObject* parent = nullptr);

    /// Whether the layout has a view for it.
    void setShown(bool shown);
    void choose(const QString& scenario);

private:
    /// What outlives the window.
    struct Kept {
        QString chosen;
    };
    void refresh(const QString& newest);
    void openKept();

    Session& m_session;
    Document& m_document;
    Computation& m_computation;
    ViewArea& m_area;
    Kept& m_kept;
};

}  // namespace rubble
