#pragma once

#include <QAbstractButton>
#include <QTest>
#include <string>

#include "app/gui/stage/panel_deck.h"
#include "app/gui/window/window_rooms.h"
#include "tests/app/gui/workbench.h"
#include "tests/support/small_collapse.h"
#include "widgets/figures/number_text.h"

namespace rubble {

/// A window in which somebody opens small results of all time scales.
class HourOfUse : public FreshWorkbench {
protected:
    void TearDown() override {
        session->document().undoStack().setClean();
        session->computation().cancel();
        FreshWorkbench::TearDown();
        figures::setResultSpan(0.0);
    }
    QString smallAs(const char* name) {
        return QString::fromStdString(cli::writeSmallCollapse(folder.filePath(QLatin1String(name)).toStdString()));
    }
    /// The small collapse in other times, this far [m] above its ground: no two of them are one result.
    QString timedAs(const char* name, double perSecond, double lift = 0.0) {
        const QString path = folder.filePath(QLatin1String(name));
        io::ExodusBuilder builder = cli::smallCollapse();
        for (double& time : builder.times) {
            time *= perSecond;
        }
        for (Vec3& node : builder.nodes) {
            node.z() += lift;
        }
        builder.write(path.toStdString());
        return path;
    }
    void openAndAwait(const QString& path) {
        window->open(path);
        ASSERT_TRUE(QTest::qWaitFor([&] { return prepared() && session->document().openPath() == path; }, patience));
    }
    void clickPanel(PanelDeck::Entry entry) {
        QTest::mouseClick(window->rooms().deck->rail().findChildren<QAbstractButton*>().at(entry), Qt::LeftButton);
    }

    QTemporaryDir folder;
};

}  // namespace rubble
