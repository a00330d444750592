#pragma once

#include <QPointer>
#include <QWidget>
#include <functional>
#include <vector>

class QFrame;
class QLabel;
class QPushButton;

namespace rubble::widgets {

/// One stop of the tour: a part of the window, and what it is for.
struct TourStop {
    QPointer<QWidget> part;
    QString title;
    QString words;  ///< one sentence
};

/// Leads through the window: darkens all but one part and says what that is for. Arrow keys, Enter and buttons go on and back, Esc
/// ends it. A click beside the card goes on as well. The keyboard stays with its buttons as long as it lasts.
class Tour : public QWidget {
    Q_OBJECT

public:
    /// @param window  is covered as long as the tour lasts
    Tour(std::vector<TourStop> stops, QWidget* window);

    void start();
    void end() { go(-1); }
    int current() const { return m_current; }

signals:
    void ended();

protected:
    bool event(QEvent* event) override;
    bool eventFilter(QObject* watched, QEvent* event) override;
    void paintEvent(QPaintEvent* event) override;
    void keyPressEvent(QKeyEvent* event) override;
    void mousePressEvent(QMouseEvent* event) override;
    bool focusNextPrevChild(bool next) override;

private:
    void go(int stop);
    void takeFocus();
    void tell(const TourStop& stop);
    bool takesKey(const QKeyEvent& key, QObject* on);
    void place();
    QRect partRect() const;

    std::vector<TourStop> m_stops;
    int m_current = -1;
    QFrame* m_card;
    QLabel* m_title;
    QLabel* m_words;
    QLabel* m_count;
    QPushButton* m_skip;
    QPushButton* m_back;
    QPushButton* m_next;
};

}  // namespace rubble::widgets
