#include "app/gui/manual.h"

#include <gtest/gtest.h>

#include <QTextBrowser>
#include <set>

#include "app/gui/actions.h"
#include "app/gui/options.h"
#include "core/scenario/parameters.h"

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
        EXPECT_TRUE(manual.contains(QStringLiteral("|%1|%2|").arg(QString::fromUtf8(row.text), QLatin1String(row.key)))) << row.id;
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

TEST(Actions, KeysAndIdsAreUnique) {
    std::set<std::string> ids;
    std::set<std::string> keys;
    for (const ActionRow& row : actionTable()) {
        EXPECT_TRUE(ids.insert(std::string(row.id)).second) << row.id;
        if (row.key[0] != '\0') {
            EXPECT_TRUE(keys.insert(row.key).second) << row.key;
            EXPECT_FALSE(QKeySequence::fromString(QLatin1String(row.key), QKeySequence::PortableText).isEmpty()) << row.key;
        }
    }
}

}  // namespace rubble
