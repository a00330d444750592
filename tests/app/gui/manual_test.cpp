#include "app/gui/help/manual.h"

#include <gtest/gtest.h>

#include <QRegularExpression>
#include <QTextBlock>
#include <QTextBrowser>
#include <set>
#include <string>
#include <vector>

#include "app/gui/stage/actions.h"
#include "app/gui/window/options.h"
#include "core/scenario/parameters.h"
#include "widgets/basics/theme.h"

namespace rubble {

namespace {

QString wholeManual() {
    QString all;
    for (const ManualPage& page : manualPages()) {
        all += page.text;
    }
    return all;
}

}  // namespace

TEST(Manual, EveryParameterIsInIt) {
    const QString manual = wholeManual();
    for (const Parameter& row : parameterTable()) {
        const QString key = QString::fromStdString(std::string(row.key));
        EXPECT_TRUE(manual.contains(QStringLiteral("`%1`").arg(key))) << row.key;
    }
}

TEST(Manual, EveryActionIsInItWithItsKey) {
    const QString manual = wholeManual();
    for (const ActionRow& row : actionTable()) {
        EXPECT_TRUE(manual.contains(QStringLiteral("|%1|%2|").arg(QString::fromUtf8(row.text), QLatin1String(row.key))))
            << row.name;
    }
}

TEST(Manual, EveryOptionOfTheCommandLineIsInIt) {
    const QString manual = wholeManual();
    for (const char* name : {"--sample", "--simulate", "--accuracy", "--screenshot", "--time", "--size", "--theme", "--language",
                             "--action", "--photo", "--chart", "--measure"}) {
        EXPECT_TRUE(manual.contains(QLatin1String(name))) << name;
    }
}

TEST(Manual, HasAPageForEveryEntryOfTheRail) {
    for (const char* title : {"Case", "Fragments", "Basic Grid", "Effects", "Run", "Accuracy", "Photographs"}) {
        ManualWindow window;
        window.showPage(QLatin1String(title));
        EXPECT_TRUE(window.findChild<QTextBrowser*>()->toPlainText().startsWith(QLatin1String(title))) << title;
    }
}

// A click on a link blanked the page: the browser looked for a file beside the program.
TEST(Manual, LinksOpenThePageAndThePlaceTheyName) {
    ManualWindow window;
    auto* text = window.findChild<QTextBrowser*>();
    window.showPage(QStringLiteral("Case"));
    emit text->anchorClicked(QUrl(QStringLiteral("survey.md")));
    EXPECT_TRUE(text->toPlainText().startsWith(QLatin1String("Survey"))) << text->toPlainText().left(40).toStdString();
    emit text->anchorClicked(QUrl(QStringLiteral("command-line.md#worlds-made-elsewhere")));
    EXPECT_EQ(text->textCursor().block().text(), QStringLiteral("Worlds made elsewhere"));
}

TEST(Manual, LinksOfAnOpenPageFollowTheTheme) {
    widgets::applyTheme(render::Theme::Light);
    ManualWindow window;
    window.show();
    window.showPage(QStringLiteral("Survey"));
    const auto links = [&] {
        std::set<QString> colours;
        const QTextDocument& page = *window.findChild<QTextBrowser*>()->document();
        for (QTextBlock block = page.begin(); block.isValid(); block = block.next()) {
            for (auto part = block.begin(); !part.atEnd(); ++part) {
                if (part.fragment().charFormat().isAnchor()) {
                    colours.insert(part.fragment().charFormat().foreground().color().name());
                }
            }
        }
        return colours;
    };
    EXPECT_EQ(links(), std::set<QString>{widgets::tints().accent.name()});
    widgets::applyTheme(render::Theme::Dark);
    EXPECT_EQ(links(), std::set<QString>{widgets::tints().accent.name()});
    widgets::applyTheme(render::Theme::Light);
}

TEST(Manual, EveryLinkOfEveryPageLeadsSomewhere) {
    ManualWindow window;
    auto* text = window.findChild<QTextBrowser*>();
    static const QRegularExpression link(QStringLiteral("[^!]\\[[^\\]]*\\]\\(([^)]+)\\)"));
    int followed = 0;
    for (const ManualPage& page : manualPages()) {
        for (auto links = link.globalMatch(page.text); links.hasNext();) {
            const QString target = links.next().captured(1);
            window.showPage(page.name);
            text->moveCursor(QTextCursor::End);
            const int before = text->textCursor().position();
            emit text->anchorClicked(QUrl(target));
            EXPECT_NE(text->textCursor().position(), before) << page.name.toStdString() << ": " << target.toStdString();
            EXPECT_FALSE(text->toPlainText().isEmpty()) << target.toStdString();
            ++followed;
        }
    }
    EXPECT_GT(followed, 20);
}

TEST(Actions, EachIdHasItsRowInTheOrderOfTheIds) {
    int id = 0;
    for (const ActionRow& row : actionTable()) {
        EXPECT_EQ(static_cast<int>(row.id), id++) << row.name;
        EXPECT_EQ(actionNamed(QString::fromLatin1(row.name)), row.id);
    }
    EXPECT_EQ(id, static_cast<int>(ActionId::About) + 1);
    EXPECT_EQ(actionNamed(u"no_such_action"), std::nullopt);
}

TEST(Actions, StandInTheToolBarFromTheLeft) {
    const auto names = [](ToolSection section) {
        std::vector<std::string> found;
        for (const ActionRow& row : toolRows(section)) {
            found.emplace_back(row.name);
        }
        return found;
    };
    using Names = std::vector<std::string>;
    EXPECT_EQ(names(ToolSection::Case), (Names{"open", "undo", "redo"}));
    EXPECT_EQ(names(ToolSection::Layout), (Names{"stacked", "beside", "overlay", "four"}));
    EXPECT_EQ(names(ToolSection::View), (Names{"link", "fit", "measure_distance", "clip", "components"}));
    EXPECT_EQ(names(ToolSection::Run), (Names{"live", "simulate"}));
}

TEST(Actions, KeysAndNamesAreUnique) {
    std::set<std::string> names;
    std::set<std::string> keys;
    for (const ActionRow& row : actionTable()) {
        EXPECT_TRUE(names.insert(row.name).second) << row.name;
        if (row.key[0] != '\0') {
            EXPECT_TRUE(keys.insert(row.key).second) << row.key;
            EXPECT_FALSE(QKeySequence::fromString(QLatin1String(row.key), QKeySequence::PortableText).isEmpty()) << row.key;
        }
    }
}

}  // namespace rubble
