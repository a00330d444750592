#pragma once

#include <QWidget>

class QComboBox;
class QLabel;
class QToolButton;

namespace rubble::widgets {

/// The time in large figures and the buttons that move it. Knows no clock: emits what the user asks for.
class Transport : public QWidget {
    Q_OBJECT

public:
    explicit Transport(QWidget* parent = nullptr);

    void setTime(double time);
    /// @param last   s, the latest instant that can be shown
    /// @param feEnd  s, end of the FE result
    void setSpan(double last, double feEnd);
    void setPlaying(bool playing);
    void setRate(double rate);
    void setAvailable(bool available);

signals:
    void playToggled();
    void stepped(int states);
    void jumpedToFirst();
    void jumpedToLast();
    void ratePicked(double rate);

private:
    QLabel* m_time;
    QLabel* m_span;
    QToolButton* m_play;
    QComboBox* m_rate;
};

}  // namespace rubble::widgets
