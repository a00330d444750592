#pragma once

#include <QElapsedTimer>
#include <QObject>
#include <QTimer>

namespace rubble::widgets {

/// Lets input go before pictures that nobody asks for by hand: those of playback, of a run that grows, of views at rest. Such a
/// picture waits while events wait, and after a press, a key or a turn of the wheel as long as two pictures take, since a menu
/// needs several turns of the event loop to stand. What is asked for meanwhile is the same picture; none waits longer than
/// `longest`.
class PictureTurn : public QObject {
    Q_OBJECT

public:
    explicit PictureTurn(QObject* parent = nullptr);

    static constexpr qint64 longest = 500;  ///< ms
    /// A picture is wanted; `due` says when to draw it.
    void ask();
    /// What was asked for is not wanted any more.
    void drop();
    bool waits() const { return m_waits; }
    /// How often one picture stood for another that was asked for before it was drawn.
    long dropped() const { return m_dropped; }

signals:
    /// Nothing else waits: draw what is to be seen now.
    void due();

protected:
    bool eventFilter(QObject* watched, QEvent* event) override;

private:
    void look();
    bool inputIsRecent() const;

    QTimer m_idle;          ///< fires once no event waits
    QTimer m_drawn;         ///< fires once the picture is on the screen
    QElapsedTimer m_asked;  ///< since the picture that waits was asked for
    QElapsedTimer m_begun;  ///< since the last picture was due
    QElapsedTimer m_input;  ///< since the last press, key or turn of the wheel
    qint64 m_cost = 0;      ///< ms, of the last picture
    bool m_waits = false;
    long m_dropped = 0;
};

}  // namespace rubble::widgets
