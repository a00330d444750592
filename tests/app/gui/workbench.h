#pragma once

#include <gtest/gtest.h>

#include <QApplication>
#include <QDialog>
#include <QImage>
#include <QTemporaryDir>
#include <QTest>
#include <QTimer>
#include <fstream>
#include <memory>
#include <sstream>
#include <string>

#include "app/gui/session/session.h"
#include "app/gui/window/main_window.h"
#include "app/gui/window/renewed_window.h"
#include "tests/support/places.h"

namespace rubble {

/// All that a file holds; empty if it cannot be read.
inline std::string textOf(const QString& path) {
    std::ifstream in(path.toStdString(), std::ios::binary);
    std::stringstream text;
    text << in.rdbuf();
    return text.str();
}

/// What a widget looks like.
QImage pictureOf(QWidget& shown);

/// A window of the smallest size, and the steps that tests begin with.
class Workbench : public testing::Test {
protected:
    /// A strip of the reinforced concrete arch: all that it does with an eighth of its elements.
    static QString arch() { return QString::fromStdString(buildPath("tests/narrow/rc-arch.exo")); }
    /// All of it, where numbers of it are asked for, or how a large model is handled.
    static QString wholeArch() { return QString::fromStdString(sourcePath("resources/samples/rc-arch.exo")); }
    /// ms. Patience for machines that do much else at the same time; nothing is asserted about how long things take.
    static constexpr int patience = 300'000;

    void SetUp() override {
        startProgram();
        window->resize(1280, 800);
        window->show();
        ASSERT_TRUE(QTest::qWaitForWindowExposed(window, patience));
        // Shortcuts need an active window, and a bare X server has no window manager to make one.
        QApplication::setActiveWindow(window);
    }

    /// As a start of the program makes them; ends those that are there.
    void startProgram() {
        endProgram();
        session = std::make_unique<Session>();
        renewed = std::make_unique<RenewedWindow>(*session);
        window = &renewed->window();
        QObject::connect(renewed.get(), &RenewedWindow::renewed, renewed.get(), [this] {
            window = &renewed->window();
            QApplication::setActiveWindow(window);
        });
    }
    void endProgram() {
        window = nullptr;
        renewed.reset();
        session.reset();
    }
    void openArch(const QString& path = arch()) {
        window->open(path);
        ASSERT_TRUE(QTest::qWaitFor([&] { return prepared(); }, patience));
    }
    bool prepared() const {
        return session->computation().results().clustering != nullptr && !session->computation().busy() &&
               !session->computation().stale(Stage::Clusters, session->document().scenario());
    }
    /// Settings under which the arch is simulated in seconds: few bodies, whole spans as the FE result has them, no settling.
    void makeCheap() {
        session->document().setParameter(QStringLiteral("loose_structure"), std::string("fe"));
        session->document().setParameter(QStringLiteral("multiple"), 8.0);
        session->document().setParameter(QStringLiteral("settle_time"), 0.0);
        ASSERT_TRUE(QTest::qWaitFor([&] { return prepared(); }, patience));
    }
    /// Simulates an hour of free fall of the arch, without a ground, until the first limit of health is passed. It goes on then.
    void fallUntilABreach() {
        session->document().setParameter(QStringLiteral("multiple"), 8.0);
        session->document().setParameter(QStringLiteral("ground"), std::string("off"));
        session->document().setParameter(QStringLiteral("settle_time"), 3600.0);
        ASSERT_TRUE(QTest::qWaitFor([&] { return prepared(); }, patience));
        window->rooms().runs->simulate(false);
        const auto marked = [&] {
            const RunRecord* record = session->computation().currentRun();
            return record != nullptr && record->running && !record->health().breaches.empty();
        };
        ASSERT_TRUE(QTest::qWaitFor(marked, patience));
    }
    /// What is done to a dialog once it stands, from within its own event loop.
    template <typename Do>
    static void whenAsked(Do act) {
        auto* timer = new QTimer;
        timer->setInterval(50);
        QObject::connect(timer, &QTimer::timeout, timer, [timer, act] {
            if (auto* dialog = qobject_cast<QDialog*>(QApplication::activeModalWidget())) {
                timer->stop();
                timer->deleteLater();
                act(*dialog);
            }
        });
        timer->start();
    }
    /// The run at hand is whole, and nothing else is computed.
    void awaitRun() {
        const auto whole = [&] {
            const RunRecord* record = session->computation().currentRun();
            return record != nullptr && record->outcome != nullptr && !session->computation().busy();
        };
        ASSERT_TRUE(QTest::qWaitFor(whole, patience));
    }
    void simulateToEnd() {
        window->rooms().runs->simulate(false);
        awaitRun();
    }
    /// What was asked of the window is laid out, and the picture of the views is that of the place they have.
    void drawViews();
    widgets::StageState rail(PanelDeck::Entry entry) { return window->rooms().deck->rail().state(entry); }

    std::unique_ptr<Session> session;
    std::unique_ptr<RenewedWindow> renewed;
    MainWindow* window = nullptr;  ///< the one of now
};

/// A workbench without a past: nothing was opened or run before, no preferences. It speaks English at its begin and afterwards.
class FreshWorkbench : public Workbench {
protected:
    void SetUp() override;
    void TearDown() override;

private:
    QTemporaryDir m_state;
    const QByteArray m_stateBefore = qgetenv("RUBBLE_STATE");
};

}  // namespace rubble
