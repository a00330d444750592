#pragma once

#include <QObject>

namespace rubble {

class Computation;
class Document;
class ViewArea;

/// Shows the run of another scenario of the case in a view of its own, with the camera and the clock of the others.
class ScenarioPane : public QObject {
    Q_OBJECT

public:
    ScenarioPane(Document& document, Computation& computation, ViewArea& area, QObject* parent = nullptr);

    /// Whether the layout has a view for it.
    void setShown(bool shown);
    void choose(const QString& scenario);

private:
    void refresh(const QString& newest);
    void openKept();

    Document& m_document;
    Computation& m_computation;
    ViewArea& m_area;
    QString m_chosen;
};

}  // namespace rubble
