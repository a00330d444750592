#pragma once

#include <QWidget>

class QLabel;
class QProgressBar;
class QPushButton;

namespace rubble::widgets {

class PlaceChoice;

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
    QLabel* m_progress;
};

}  // namespace rubble::widgets
