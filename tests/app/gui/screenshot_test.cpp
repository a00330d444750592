#include "app/gui/window/screenshot.h"

#include <QApplication>
#include <QFile>
#include <QImage>
#include <QTemporaryDir>
#include <QTimer>

#include "app/gui/stage/view_area.h"
#include "tests/app/gui/workbench.h"
#include "widgets/views/view_widget.h"

namespace rubble {
namespace {

class Pictured : public Workbench {
protected:
    /// The picture that the program saves and leaves with.
    QImage taken(const std::vector<ActionId>& actions) {
        Options options;
        options.path = arch();
        options.actions = actions;
        EXPECT_EQ(leavesWith(options), 0);
        return QImage(options.screenshot);
    }
    int leavesWith(Options& options) {
        options.screenshot = m_folder.filePath(QStringLiteral("a.png"));
        Screenshot screenshot(*window, options);
        QTimer hangs;
        hangs.setSingleShot(true);
        QObject::connect(&hangs, &QTimer::timeout, [] { QCoreApplication::exit(7); });
        hangs.start(patience);
        return QApplication::exec();
    }
    QTemporaryDir m_folder;
};

TEST_F(Pictured, AnActionThatAsksIsPicturedWithItsDialogAndHangsNothing) {
    openArch();
    const QImage plain = taken({});
    ASSERT_EQ(plain.size(), window->size() * window->devicePixelRatioF());
    const QImage asking = taken({ActionId::Site, ActionId::FeOnly});
    ASSERT_EQ(asking.size(), plain.size());
    int different = 0;
    for (int y = 0; y < plain.height(); y += 4) {
        for (int x = 0; x < plain.width(); x += 4) {
            different += plain.pixel(x, y) != asking.pixel(x, y);
        }
    }
    EXPECT_GT(different, plain.width() * plain.height() / 16 / 10) << "the dialog covers a tenth of the window";
    EXPECT_EQ(QApplication::activeModalWidget(), nullptr);
    EXPECT_NE(window->area().views().view().layout, render::Layout::FeOnly) << "what would come after the dialog is not done";
}

TEST_F(Pictured, AFileThatCannotBeReadEndsTheProgramInsteadOfHoldingIt) {
    for (const char* name : {"gone.rubble", "gone.exo"}) {
        Options options;
        options.path = m_folder.filePath(QLatin1String(name));
        window->open(options.path);
        EXPECT_EQ(leavesWith(options), 1) << name;
        EXPECT_FALSE(QFile::exists(options.screenshot)) << name;
    }
}

}  // namespace
}  // namespace rubble
