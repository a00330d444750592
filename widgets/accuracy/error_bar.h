#pragma once

#include <QFrame>

class QLabel;
class QProgressBar;
class QPushButton;

namespace rubble::widgets {

class ProgressLabel;

/// Stands above the views while fragments are coloured by their error: says what they are compared with, or that there is nothing
/// to compare with and how to get it.
class ErrorBar : public QFrame {
    Q_OBJECT

public:
    explicit ErrorBar(QWidget* parent = nullptr);

    enum class State : std::uint8_t {
        NoRun,        ///< nothing was simulated yet
        NoReference,  ///< a reference can be computed
        Waiting,      ///< it cannot be computed now
        Computing,
        Shown,
        Failed,
    };
    /// @param words  what to say besides: why it waits or failed, how large the reference is
    void setState(State state, const QString& words = {});
    /// @param secondsLeft  NaN: not known yet
    void setProgress(double fraction, double secondsLeft);
    State state() const { return m_state; }
    QString text() const;

signals:
    void computeRequested();
    void cancelRequested();

private:
    State m_state = State::NoRun;
    ProgressLabel* m_words;
    QProgressBar* m_bar;
    QPushButton* m_compute;
    QPushButton* m_cancel;
};

}  // namespace rubble::widgets
