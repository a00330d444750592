#pragma once

#include <QWidget>
#include <vector>

class QListWidget;
class QListWidgetItem;
class QPlainTextEdit;
class QPushButton;

namespace rubble::widgets {

/// A scenario as the list shows it.
struct ScenarioLine {
    QString id;
    QString name;
    QString note;
    QString run;  ///< what is known of its runs, in a few words
    friend bool operator==(const ScenarioLine&, const ScenarioLine&) = default;
};

/// The scenarios of a case: the chosen one is worked on. Names are edited in place, the note of the chosen one stands below.
class ScenarioList : public QWidget {
    Q_OBJECT

public:
    explicit ScenarioList(QWidget* parent = nullptr);

    void setContent(const std::vector<ScenarioLine>& lines, const QString& active);
    const std::vector<ScenarioLine>& lines() const { return m_lines; }

signals:
    void activated(const QString& id);
    void duplicateRequested(const QString& id);
    void renamed(const QString& id, const QString& name);
    void noteEdited(const QString& id, const QString& note);
    void removeRequested(const QString& id);
    void compareRequested();

protected:
    bool eventFilter(QObject* watched, QEvent* event) override;

private:
    void edited(QListWidgetItem* item);
    void finishNote();
    const ScenarioLine* activeLine() const;

    QListWidget* m_list;
    QPlainTextEdit* m_note;
    QPushButton* m_duplicate;
    QPushButton* m_rename;
    QPushButton* m_remove;
    QPushButton* m_compare;
    std::vector<ScenarioLine> m_lines;
    QString m_active;
    bool m_filling = false;
};

}  // namespace rubble::widgets
