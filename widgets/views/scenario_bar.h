#pragma once

#include <QFrame>
#include <QStringList>

class QComboBox;
class QLabel;
class QPushButton;

namespace rubble::widgets {

/// Stands above the views while one of them shows the run of another scenario: which one, and how to get one.
class ScenarioBar : public QFrame {
    Q_OBJECT

public:
    explicit ScenarioBar(QWidget* parent = nullptr);

    /// Scenarios with a run that can be shown; `chosen` is one of them or empty.
    void setScenarios(const QStringList& names, const QString& chosen);
    QString chosen() const;

signals:
    void scenarioChosen(const QString& name);
    /// A kept run is to be opened from its file.
    void openRequested();

private:
    QLabel* m_words;
    QComboBox* m_names;
    QPushButton* m_open;
};

}  // namespace rubble::widgets
