#include <gtest/gtest.h>

#include <QTest>
#include <array>
#include <functional>

#include "app/gui/new_case.h"
#include "app/gui/view_area.h"
#include "tests/app/gui/legibility.h"
#include "tests/app/gui/workbench.h"
#include "widgets/language.h"
#include "widgets/new_case_wizard.h"

namespace rubble {

namespace {

/// The panels of an empty window and the steps of the wizard, in both languages and at the sizes that the window is made for: what
/// stands on them can be read whole.
/// RUBBLE_TAKE_SCREENS names a folder for pictures of all of them, in both themes, to be looked at.
class Screens : public FreshWorkbench {
protected:
    /// Looks at one screen at every size, in every language and theme.
    void look(const QString& name, const std::function<QWidget*()>& screen) {
        static const std::array sizes{QSize(1280, 800), QSize(1920, 1080)};
        static const QString folder = qEnvironmentVariable("RUBBLE_TAKE_SCREENS");
        for (const char* language : {"en", "zh_CN"}) {
            widgets::speak(QLatin1String(language));
            for (const QSize& size : sizes) {
                if (folder.isEmpty() && size != sizes[0]) {
                    continue;  // what fits into the smallest window fits into larger ones
                }
                window->resize(size);
                QTest::qWait(300);  // what comes later (what a cluster answers) has its room by then
                const QWidget* shown = screen();
                ASSERT_NE(shown, nullptr) << name.toStdString();
                const QString where = QStringLiteral("%1-%2-%3").arg(name, QLatin1String(language)).arg(size.width());
                for (const QString& each : illegibleIn(*shown)) {
                    ADD_FAILURE() << where.toStdString() << ": " << each.toStdString();
                }
                for (const char* theme : {"light", "dark"}) {
                    if (!folder.isEmpty()) {
                        window->setTheme(QLatin1String(theme));
                        keep(*screen(), QStringLiteral("%1/%2-%3.png").arg(folder, where, QLatin1String(theme)));
                    }
                }
            }
        }
        widgets::speak(QStringLiteral("en"));
    }
    static void keep(QWidget& shown, const QString& path) {
        QTest::qWait(150);
        ASSERT_TRUE(pictureOf(shown).save(path)) << path.toStdString();
    }
};

constexpr std::array panels{"case", "fragments", "grid", "effects", "run", "accuracy", "evidence", "report", "ensemble", "causes"};

TEST_F(Screens, CanBeReadWholeWithoutACase) {
    look(QStringLiteral("start"), [&] { return window.get(); });
    for (int i = 0; i < static_cast<int>(panels.size()); ++i) {
        window->deck().choosePage(i);
        look(QStringLiteral("empty-%1").arg(QLatin1String(panels[static_cast<std::size_t>(i)])), [&] { return window.get(); });
    }
}

TEST_F(Screens, CanBeReadWholeInTheWizard) {
    window->newCase(arch());
    NewCase& making = *window->caseInTheMaking();
    static const std::array steps{"units", "ground", "components", "deaths", "case"};
    for (int step = 0; step < widgets::NewCaseWizard::StepCount; ++step) {
        making.wizard().go(static_cast<widgets::NewCaseWizard::Step>(step));
        ASSERT_TRUE(
            QTest::qWaitFor([&] { return making.settled() && making.computation().results().fragments != nullptr; }, patience));
        look(QStringLiteral("wizard-%1").arg(QLatin1String(steps[static_cast<std::size_t>(step)])),
             [&] { return &making.wizard(); });
    }
    making.wizard().reject();
}

}  // namespace

}  // namespace rubble
