#pragma once

#include <QObject>

namespace rubble {

class Computation;
class Document;
class IslandDisplay;
class Session;
class ViewArea;

/// Shows the run of another scenario of the case in a view of its own, with the camera and the clock of the others.
class ScenarioPane : public QObject {
    Q_OBJECT

public:
    /// @param islands  tells apart the islands of the other run as well; must outlive the pane
    ScenarioPane(Session& session, ViewArea& area, const IslandDisplay& islands, QObject* parent = nullptr);

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
    const IslandDisplay& m_islands;
    Kept& m_kept;
};

}  // namespace rubble
