#include "widgets/views/picture_turn.h"

#include <gtest/gtest.h>

#include <QApplication>
#include <QKeyEvent>
#include <QSignalSpy>
#include <QTest>
#include <QThread>
#include <QWidget>
#include <functional>

namespace rubble::widgets {

namespace {

/// Does something with each key.
class Keys : public QWidget {
public:
    std::function<void()> act;
    int seen = 0;

    void post() { QCoreApplication::postEvent(this, new QKeyEvent(QEvent::KeyPress, Qt::Key_F13, Qt::NoModifier)); }

protected:
    void keyPressEvent(QKeyEvent*) override {
        ++seen;
        if (act) {
            act();
        }
    }
};

constexpr int patience = 60'000;  // ms

TEST(PictureTurn, IsOneForAllThatIsAskedWhileEventsWait) {
    PictureTurn turn;
    const QSignalSpy due(&turn, &PictureTurn::due);
    Keys keys;
    keys.act = [&] { EXPECT_EQ(due.count(), 0) << "events that wait come first"; };
    for (int i = 0; i < 20; ++i) {
        turn.ask();
        keys.post();
    }
    EXPECT_TRUE(turn.waits());
    ASSERT_TRUE(QTest::qWaitFor([&] { return due.count() > 0; }, patience));
    EXPECT_EQ(keys.seen, 20);
    EXPECT_EQ(due.count(), 1);
    EXPECT_EQ(turn.dropped(), 19);
    EXPECT_FALSE(turn.waits());
}

TEST(PictureTurn, ComesForEveryAskWhereNothingWaits) {
    PictureTurn turn;
    const QSignalSpy due(&turn, &PictureTurn::due);
    for (int i = 1; i <= 5; ++i) {
        turn.ask();
        ASSERT_TRUE(QTest::qWaitFor([&] { return due.count() == i; }, patience));
    }
    EXPECT_EQ(turn.dropped(), 0);
}

// A hand that never rests: what is asked for is drawn all the same, and the last of it too.
TEST(PictureTurn, IsDrawnInTheEndHoweverMuchInputComes) {
    PictureTurn turn;
    const QSignalSpy due(&turn, &PictureTurn::due);
    QObject::connect(&turn, &PictureTurn::due, &turn, [] { QThread::msleep(40); });
    Keys keys;
    int asked = 0;
    keys.act = [&] {
        turn.ask();
        ++asked;
        QThread::msleep(5);
        if (due.count() < 3) {
            keys.post();
        }
    };
    keys.post();
    ASSERT_TRUE(QTest::qWaitFor([&] { return due.count() >= 3 && !turn.waits(); }, patience));
    EXPECT_LT(due.count(), asked / 4) << asked;
}

TEST(PictureTurn, IsNotDrawnOnceItWasDropped) {
    PictureTurn turn;
    const QSignalSpy due(&turn, &PictureTurn::due);
    turn.ask();
    turn.drop();
    QTest::qWait(20);
    EXPECT_EQ(due.count(), 0);
}

}  // namespace

}  // namespace rubble::widgets
