#pragma once

#include <QWidget>

#include "core/simulation/effects/decisions.h"
#include "widgets/basics/panel.h"

class QLabel;
class QToolButton;

namespace rubble::widgets {

class ParameterEditor;

/// A share in [0, 1] as a thin bar.
class ShareBar : public QWidget {
    Q_OBJECT

public:
    explicit ShareBar(QWidget* parent = nullptr);
    void setShare(double share);
    double share() const { return m_share; }
    QSize sizeHint() const override { return {72, 6}; }

protected:
    void paintEvent(QPaintEvent* event) override;

private:
    double m_share = 0.0;
};

/// One effect: its switch, whether it takes part and why, what it cost in the last run, and its settings, folded away.
class EffectRow : public QWidget {
    Q_OBJECT

public:
    /// @param effect  the row of the parameter table that switches it
    EffectRow(EffectKind kind, const Parameter& effect, QWidget* parent = nullptr);

    EffectKind kind() const { return m_kind; }
    ParameterEditor* switchEditor() const { return m_switch; }
    /// Where its settings go; without any there is nothing to unfold.
    PanelGroup* settings();
    void setUnfolded(bool unfolded);
    bool unfolded() const;
    /// Null: not decided yet. Stale: decided under other settings than those shown.
    void setDecision(const EffectDecision* decision, bool stale);
    /// Null: no run has measured it.
    void setCost(const EffectReport* report, bool stale);
    /// What it shows in words, for tests.
    QString stateText() const;
    QString costText() const;

protected:
    bool eventFilter(QObject* watched, QEvent* event) override;

private:
    EffectKind m_kind;
    QToolButton* m_fold;
    QLabel* m_name;
    ParameterEditor* m_switch;
    QLabel* m_state;
    QWidget* m_costLine;
    QLabel* m_cost;
    QLabel* m_shareText;
    ShareBar* m_bar;
    PanelGroup* m_settings;
};

/// Milliseconds for people; what rounds to nothing says so.
QString shownMilliseconds(double ms);
/// A share of the step; "below 1 %" where it is.
QString shownStepShare(double share);

}  // namespace rubble::widgets
