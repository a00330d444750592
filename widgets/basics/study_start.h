#pragma once

#include <QElapsedTimer>
#include <QLabel>
#include <QTimer>
#include <QWidget>

class QProgressBar;
class QPushButton;

namespace rubble::widgets {

class PlaceChoice;

/// What is being done and how long it still takes. Counts down between reports; where the time is over it says so.
class ProgressLabel : public QLabel {
    Q_OBJECT

public:
    explicit ProgressLabel(QWidget* parent = nullptr);

    /// @param secondsLeft  NaN: not known yet
    void setProgress(const QString& what, double secondsLeft);
    /// A text that does not change by itself.
    void setPlain(const QString& text);

protected:
    void hideEvent(QHideEvent* event) override;

private:
    void tell();

    QString m_what;
    double m_left = 0.0;
    QElapsedTimer m_since;
    QTimer m_second;
};

/// What starts and stops a study: its two buttons, of which one is to be seen, where it is simulated, why it cannot be started, and
/// how far it is.
class StudyStart : public QWidget {
    Q_OBJECT

public:
    struct Words {
        QString start, startTip;
        QString cancelTip;
        QString cancelId;  ///< object name of the button that cancels; the one that starts is "primary"
        QString bar;       ///< what the bar is, for those who do not see it
    };
    /// @param place  of the study, which stands below the buttons; null: there is no choice
    explicit StudyStart(const Words& words, PlaceChoice* place = nullptr, QWidget* parent = nullptr);

    /// @param why  it cannot be started, or what happens meanwhile
    void setReady(bool ready, bool running, const QString& why);
    /// @param secondsLeft  NaN: not known yet
    void setProgress(const QString& what, double fraction, double secondsLeft);
    /// As a click on the button.
    void start();

signals:
    void startRequested();
    void cancelRequested();

private:
    QPushButton* m_start;
    QPushButton* m_cancel;
    PlaceChoice* m_place;
    QLabel* m_why;
    QProgressBar* m_bar;
    ProgressLabel* m_progress;
};

}  // namespace rubble::widgets
