#pragma once

#include <QHash>
#include <QPointer>
#include <QPushButton>
#include <QScrollArea>
#include <functional>
#include <string>
#include <utility>
#include <vector>

#include "core/base/finding.h"
#include "core/pipeline/remedies.h"
#include "core/scenario/parameters.h"

class QGridLayout;
class QLabel;
class QVBoxLayout;

namespace rubble::widgets {

class ParameterEditor;
class PredictionBox;
struct PredictionContent;

/// A sentence that needs attention, in place: a finding (amber), an error (red) or a plain note.
class Notice : public QFrame {
    Q_OBJECT

public:
    enum class Kind { Note, Finding, Error };
    explicit Notice(QWidget* parent = nullptr);
    /// Shows a sentence and what to do about it; hides itself when both are empty.
    void set(Kind kind, const QString& what, const QString& remedy = {});
    QString text() const;

private:
    QLabel* m_label;
};

/// Does the remedy of a finding by setting one value; greyed once that is set.
class RemedyButton : public QPushButton {
    Q_OBJECT

public:
    explicit RemedyButton(const RemedySetting& setting, QWidget* parent = nullptr);
    /// As it is set now.
    void setScenario(const Scenario& scenario);

signals:
    void chosen(const QString& key, const rubble::ParameterValue& value);

private:
    RemedySetting m_setting;
};

/// Findings of a stage, one notice each, with count, example and remedy, and a button where the remedy can be done at once.
class FindingList : public QWidget {
    Q_OBJECT

public:
    /// What does the remedy of a finding where no setting does.
    struct Doing {
        std::string id;  ///< of what was found, or how such ids begin: "site."
        QString words;   ///< on the button
        std::function<void()> act;
    };

    explicit FindingList(QWidget* parent = nullptr);
    /// Of findings that are set from now on.
    void setDoings(std::vector<Doing> doings) { m_doings = std::move(doings); }
    /// A setting that several remedies ask for has one button.
    /// @param grounds    what the remedies are chosen by
    /// @param elsewhere  settings that buttons beside this list offer
    void set(const Findings& findings, const RemedyGrounds& grounds = {}, const std::vector<RemedySetting>& elsewhere = {});
    /// How many boxes there are: one for each kind of finding.
    std::int64_t count() const { return m_count; }
    /// As it is set now: what a remedy asks for may be set already.
    void setScenario(const Scenario& scenario);

signals:
    /// Set this, as the remedy of a finding says.
    void remedyChosen(const QString& key, const rubble::ParameterValue& value);

private:
    void addButtons(const Finding& finding, const RemedyGrounds& grounds, std::vector<RemedySetting>& offered);

    QVBoxLayout* m_column;
    std::vector<Doing> m_doings;
    std::int64_t m_count = 0;
    Scenario m_scenario;
};

/// The lists that have something to say in a panel, in front or not.
std::vector<FindingList*> findingLists(const QWidget& panel);

/// A group of a panel: small heading, then rows of label, value and unit.
class PanelGroup : public QWidget {
    Q_OBJECT

public:
    explicit PanelGroup(const QString& heading, QWidget* parent = nullptr);

    /// A row whose value is shown, right-aligned, in tabular figures; returns the label that shows it.
    QLabel* addValue(const QString& label, const QString& unit = {}, const QString& tip = {});
    ParameterEditor* addParameter(const Parameter& row, const std::string& subject = {});
    /// A row with an editor of its own, which takes the tip.
    void addField(const QString& label, QWidget* field, const QString& unit, const QString& tip);
    /// A widget over the full width.
    void addWide(QWidget* widget);
    /// A note in the muted colour over the full width.
    QLabel* addNote(const QString& text);

private:
    QGridLayout* m_grid;
};

/// The column of a page, below its title. What a study brings scrolls, so that it never makes the window higher than its screen.
QVBoxLayout* pageColumn(QWidget& page, const QString& title);
/// What a remedy asks for: a field comes into sight in what scrolls about it, and gets the keyboard.
void askIn(QWidget& field);

/// A panel of the rail: a title, one question, groups. Scrolls vertically when the window is low.
class Panel : public QScrollArea {
    Q_OBJECT

public:
    Panel(const QString& title, const QString& question, QWidget* parent = nullptr);

    PanelGroup* addGroup(const QString& heading);
    /// Over the full width. A list of findings follows the scenario, and what its remedies set leaves through edited().
    void addWide(QWidget* widget);
    /// Says below what scrolls that what the panel shows is older than the settings.
    void setStale(bool stale, const QString& why = {});
    /// Shows an error in place, or removes it with an empty text.
    void setError(const QString& what, const QString& remedy = {});
    /// Shows the values of a scenario in all editors of the panel.
    virtual void setScenario(const Scenario& scenario);
    /// Greys out all editors while there is nothing to set.
    virtual void setEditable(bool editable);
    /// What the setting is predicted to cost; nothing for a panel without costly controls.
    void setPrediction(const PredictionContent& content);
    PredictionBox* prediction() const { return m_prediction; }
    ParameterEditor* editor(const QString& key) const { return m_editors.value(key); }
    QSize sizeHint() const override;
    /// Called before rows are laid out anew: what is under the mouse, or has the focus, stays where it is on the screen.
    void keepInHand();

signals:
    /// The user changed a parameter.
    void edited(const QString& key, const rubble::ParameterValue& value);
    /// The user wants to know how figures that are not known can be found out.
    void predictionHelpRequested();

protected:
    /// A row for a parameter by key; its edits leave through edited().
    ParameterEditor* addParameter(PanelGroup* group, const std::string& key);
    /// Takes an editor that stands elsewhere in the panel: it shows the scenario, and its edits leave through edited().
    void takeEditor(ParameterEditor* editor);
    /// Gives the panel its box of predictions, here.
    void addPrediction();
    /// Rows for all unkeyed parameters of a stage that the panel does not show yet; nothing if there are none.
    /// @param elsewhere  says which of them another panel shows
    void addRemaining(Stage stage, const QString& heading, bool (*elsewhere)(std::string_view key) = nullptr);

    void resizeEvent(QResizeEvent* event) override;

private:
    void placeFoot();
    /// What of the panel has the focus, or null.
    QWidget* focused() const;
    QWidget* inHand() const;

    QVBoxLayout* m_column;
    Notice* m_error;
    Notice* m_stale;  ///< below what scrolls, so that nothing moves when it comes
    QPointer<QWidget> m_inHand;
    int m_inHandAt = 0;
    int m_scrolledAt = 0;
    PredictionBox* m_prediction = nullptr;
    QHash<QString, ParameterEditor*> m_editors;
    std::vector<FindingList*> m_findingLists;
};

}  // namespace rubble::widgets
