#include <QKeyEvent>
#include <QSignalSpy>
#include <QThread>

#include "app/gui/stage/playback.h"
#include "app/gui/stage/view_area.h"
#include "tests/app/gui/workbench.h"

namespace rubble {

namespace {

/// Keys that come one after the other, each once the one before is done with.
class Typist : public QObject {
public:
    Typist(QWidget& window, int keys) : m_window(window), m_left(keys) {
        window.installEventFilter(this);
        post();
    }
    bool done() const { return m_left == 0; }

protected:
    bool eventFilter(QObject* watched, QEvent* event) override {
        if (event->type() == QEvent::KeyPress && static_cast<QKeyEvent*>(event)->key() == Qt::Key_F13) {
            QThread::msleep(15);
            if (--m_left > 0) {
                post();
            }
            return true;
        }
        return QObject::eventFilter(watched, event);
    }

private:
    void post() { QCoreApplication::postEvent(&m_window, new QKeyEvent(QEvent::KeyPress, Qt::Key_F13, Qt::NoModifier)); }

    QWidget& m_window;
    int m_left;
};

class InputFirst : public FreshWorkbench {};

TEST_F(InputFirst, DropsFramesOfPlaybackAndDrawsTheLast) {
    openArch();
    widgets::PlaybackClock& clock = window->rooms().playback->clock();
    clock.setLoop(std::pair(clock.first(), clock.last()));
    QTest::keyClick(window, Qt::Key_Space);
    ASSERT_TRUE(clock.playing());
    double drawn = -1.0;
    QObject::connect(&window->area().views(), &widgets::ViewWidget::shown, window, [&](double time) { drawn = time; });
    ASSERT_TRUE(QTest::qWaitFor([&] { return drawn > clock.first(); }, patience));
    const QSignalSpy frames(&clock, &widgets::PlaybackClock::timeChanged);
    const long before = clock.turn().dropped();
    constexpr int keys = 100;
    const Typist typist(*window, keys);
    ASSERT_TRUE(QTest::qWaitFor([&] { return typist.done(); }, patience));
    EXPECT_LT(frames.count(), keys / 4);
    EXPECT_GT(clock.turn().dropped(), before);
    const auto count = frames.count();
    ASSERT_TRUE(QTest::qWaitFor([&] { return frames.count() > count + 2; }, patience)) << "it goes on once nobody types";
    QTest::keyClick(window, Qt::Key_Space);
    EXPECT_FALSE(clock.playing());
    EXPECT_TRUE(QTest::qWaitFor([&] { return drawn == clock.time(); }, patience)) << "the last one is drawn";
}

}  // namespace

}  // namespace rubble
