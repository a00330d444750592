#include "widgets/language.h"

#include <gtest/gtest.h>

#include <QCheckBox>
#include <QComboBox>
#include <QFile>
#include <QLabel>
#include <QMenu>
#include <QMenuBar>
#include <QRegularExpression>
#include <QSettings>
#include <QSpinBox>
#include <QTemporaryDir>
#include <QTest>
#include <QTextBlock>
#include <QTextBrowser>
#include <algorithm>
#include <regex>
#include <set>

#include "app/gui/computation.h"
#include "app/gui/help.h"
#include "app/gui/manual.h"
#include "app/gui/mnemonics.h"
#include "app/gui/new_case.h"
#include "app/gui/playback.h"
#include "app/gui/settings.h"
#include "app/gui/view_area.h"
#include "io/case_file.h"
#include "io/exports.h"
#include "tests/app/gui/spoken_texts.h"
#include "tests/app/gui/workbench.h"
#include "widgets/accuracy_panel.h"
#include "widgets/new_case_wizard.h"
#include "widgets/preferences_dialog.h"
#include "widgets/spoken_text.h"

namespace rubble {

class Languages : public FreshWorkbench {
protected:
    void speak(const char* language) {
        widgets::speak(QLatin1String(language));
        QTest::qWait(50);
    }
    QStringList namesOfTheFile() const { return namesIn(window->computation().inputs().fe.get()); }
    void chooseAll() {
        for (int entry = PanelDeck::Case; entry <= PanelDeck::Accuracy; ++entry) {
            window->deck().choose(static_cast<PanelDeck::Entry>(entry));
            QTest::qWait(10);
        }
        window->deck().choose(PanelDeck::Case);
        QTest::qWait(10);
    }
};

TEST_F(Languages, AnEmptyWindowSpeaksChineseOnly) {
    speak("zh_CN");
    chooseAll();
    for (const auto& [place, text] : textsOf(*window)) {
        EXPECT_TRUE(strangeWords(text, namesOfTheFile()).isEmpty()) << qPrintable(place) << ": " << qPrintable(text);
    }
}

TEST_F(Languages, AWindowWithAResultAndARunSpeaksChineseOnly) {
    speak("zh_CN");
    openArch();
    makeCheap();
    window->simulate(false);
    ASSERT_TRUE(QTest::qWaitFor(
        [&] {
            const RunRecord* record = window->computation().currentRun();
            return record != nullptr && record->outcome != nullptr && !record->running && !window->computation().busy();
        },
        patience));
    chooseAll();
    const QStringList names = namesOfTheFile();
    for (const auto& [place, text] : textsOf(*window)) {
        EXPECT_TRUE(strangeWords(text, names).isEmpty()) << qPrintable(place) << ": " << qPrintable(text);
    }
    // Tables of the run are the same whatever is spoken.
    std::vector<std::string> tables;
    QTemporaryDir folder;
    const QString path = folder.filePath(QStringLiteral("fragments.csv"));
    const auto write = [&] {
        io::exportFragments(path.toStdString(), *window->computation().currentRun()->reader, Execution{});
        tables.push_back(textOf(path));
    };
    write();
    QLocale::setDefault(QLocale(QLocale::German));
    write();
    speak("en");
    write();
    EXPECT_GT(tables[0].size(), 10000u);
    EXPECT_EQ(tables[0], tables[1]);
    EXPECT_EQ(tables[0], tables[2]);
}

TEST_F(Languages, TheWizardOfANewCaseSaysWhatOneSaysThatBeganInChinese) {
    std::vector<Texts> told;
    for (const char* first : {"zh_CN", "en"}) {
        speak(first);
        window->newCase(arch());
        NewCase& making = *window->caseInTheMaking();
        for (int step = widgets::NewCaseWizard::Units; step < widgets::NewCaseWizard::StepCount; ++step) {
            making.wizard().go(static_cast<widgets::NewCaseWizard::Step>(step));
            ASSERT_TRUE(
                QTest::qWaitFor([&] { return making.settled() && making.computation().results().fragments != nullptr; }, patience));
        }
        // Undo names the edit.
        making.document().setParameter(QStringLiteral("ground_height"), -1.0);
        ASSERT_TRUE(QTest::qWaitFor([&] { return making.settled(); }, patience));
        speak("zh_CN");
        const Texts texts = textsOf(making.wizard());
        EXPECT_GT(texts.size(), 500u);
        const QStringList names = namesIn(making.computation().inputs().fe.get());
        for (const auto& [place, text] : texts) {
            EXPECT_TRUE(strangeWords(text, names).isEmpty()) << first << ", " << qPrintable(place) << ": " << qPrintable(text);
        }
        told.push_back(texts);
        making.wizard().reject();
        ASSERT_TRUE(QTest::qWaitFor([&] { return window->caseInTheMaking() == nullptr; }, patience));
    }
    for (const auto& [place, text] : told.front()) {
        const auto switched = told.back().find(place);
        ASSERT_NE(switched, told.back().end()) << qPrintable(place);
        EXPECT_EQ(text.toStdString(), switched->second.toStdString()) << qPrintable(place);
    }
}

TEST_F(Languages, PlacesOfWhatIsOddInAFileAreSaidWhole) {
    speak("zh_CN");
    const auto said = [](const char* english) { return widgets::spokenText(english).toStdString(); };
    EXPECT_EQ(said("element 20,373 (beam) at state 57 (2.85 s)"), "状态 57 (2.85 s) 的单元 20,373（梁）");
    EXPECT_EQ(said("element 20,373 (beam) at state 57 (2.85 s), 0.48 times its first volume"),
              "状态 57 (2.85 s) 的单元 20,373（梁），体积为最初的 0.48 倍");
    EXPECT_EQ(said("element 7 (beam) at state 2 (0.1 s), 0.001 thick per length"),
              "状态 2 (0.1 s) 的单元 7（梁），厚度与长度之比为 0.001");
    EXPECT_EQ(said("element 7 (beam), 3.2 s, but reported at state 2 (0.1 s)"), "单元 7（梁），3.2 s，但到状态 2 (0.1 s) 才报告");
    EXPECT_EQ(said("element 7 (beam), 3.2 s"), "单元 7（梁），3.2 s");
}

TEST_F(Languages, AWindowThatSwitchedSaysWhatOneSaysThatBeganInIt) {
    openArch();
    chooseAll();
    const Texts english = textsOf(*window);
    const double time = window->computation().inputs().fe->times()[3];
    window->showInstant(time);
    window->document().setParameter(QStringLiteral("friction"), 0.5);
    ASSERT_TRUE(QTest::qWaitFor([&] { return prepared(); }, patience));
    window->area().views().setAnimated(false);
    window->area().views().turn(0.1, 0.0);  // longer words leave a fitted view another size; one that was turned stays
    const render::View view = window->area().views().view();
    const int index = window->document().undoStack().index();
    speak("zh_CN");
    // Nothing but words has changed.
    EXPECT_DOUBLE_EQ(window->playback().clock().time(), time);
    EXPECT_EQ(window->document().undoStack().index(), index);
    EXPECT_EQ(window->area().views().view(), view);
    EXPECT_EQ(rail(PanelDeck::Grid), widgets::StageState::UpToDate);
    // Keys of settings are no words.
    static const QRegularExpression keyPlace(QStringLiteral("<code>([^<]*)</code>"));
    int keys = 0;
    for (const QWidget* widget : window->findChildren<QWidget*>()) {
        if (const QRegularExpressionMatch key = keyPlace.match(widget->toolTip()); key.hasMatch()) {
            ++keys;
            EXPECT_TRUE(std::ranges::all_of(key.captured(1), [](QChar c) { return c.unicode() < 128; }))
                << qPrintable(key.captured(1));
        }
    }
    EXPECT_GT(keys, 20);
    window->document().undoStack().undo();
    ASSERT_TRUE(QTest::qWaitFor([&] { return prepared(); }, patience));
    chooseAll();
    const Texts switched = textsOf(*window);
    const QStringList names = namesOfTheFile();
    for (const auto& [place, text] : switched) {
        EXPECT_TRUE(strangeWords(text, names).isEmpty()) << qPrintable(place) << ": " << qPrintable(text);
    }
    speak("en");
    window->document().undoStack().clear();
    chooseAll();
    static const QRegularExpression chinese(QStringLiteral("[\\x{4e00}-\\x{9fff}]"));
    std::size_t compared = 0;
    for (const auto& [place, text] : textsOf(*window)) {
        EXPECT_FALSE(text.contains(chinese) && !text.contains(QStringLiteral("简体中文")))
            << qPrintable(place) << ": " << qPrintable(text);
        // Figures that go on (memory, times), what a cluster answers and what the history says of steps taken since are others now.
        const bool lives = place.contains(QLatin1String("StatusLine")) || place.contains(QLatin1String("PlaceChoice")) ||
                           place.contains(QLatin1String("redo")) || place.contains(QLatin1String("undo")) ||
                           place.contains(QLatin1String("Transport")) || place.contains(QLatin1String("PredictionBox")) ||
                           text.startsWith(QLatin1String("Redo")) || text.startsWith(QLatin1String("Undo"));
        const auto before = english.find(place);
        if (!lives && before != english.end()) {
            ++compared;
            EXPECT_EQ(QString(text).remove(u'&').toStdString(), QString(before->second).remove(u'&').toStdString())
                << qPrintable(place);
        }
    }
    EXPECT_GT(compared, 500u);
}

TEST_F(Languages, EveryActionOfEveryMenuHasAMnemonicOfItsOwn) {
    for (const char* language : {"en", "zh_CN"}) {
        speak(language);
        const auto letterOf = [](const QString& text) {
            const qsizetype at = text.indexOf(u'&');
            return at < 0 || at + 1 >= text.size() ? QChar() : text[at + 1].toUpper();
        };
        std::set<QChar> titles;
        for (QAction* title : window->menuBar()->actions()) {
            ASSERT_NE(title->menu(), nullptr);
            EXPECT_TRUE(!letterOf(title->text()).isNull() && titles.insert(letterOf(title->text())).second)
                << qPrintable(title->text());
            emit title->menu()->aboutToShow();
            std::set<QChar> letters;
            for (const QAction* action : title->menu()->actions()) {
                if (!action->isSeparator()) {
                    EXPECT_TRUE(!letterOf(action->text()).isNull() && letters.insert(letterOf(action->text())).second)
                        << language << ": " << qPrintable(title->text()) << " > " << qPrintable(action->text());
                }
            }
        }
        EXPECT_EQ(titles.size(), static_cast<std::size_t>(window->menuBar()->actions().size()));
    }
}

// Numbers of a locale belong on screen: files are the same whatever the window speaks and the system counts in.
TEST_F(Languages, FilesAreTheSameInEveryLanguageAndLocale) {
    openArch();
    window->document().setParameter(QStringLiteral("friction"), 0.25);
    ASSERT_TRUE(QTest::qWaitFor([&] { return prepared(); }, patience));
    std::vector<std::string> cases;
    const auto write = [&] {
        QTemporaryDir folder;
        const QString path = folder.filePath(QStringLiteral("arch.rubble"));
        io::saveCase(path.toStdString(), window->document().theCase());
        // When a line of the journal was written is the clock's, and its digest follows.
        static const std::regex clock("\"(when|digest)\": \"[^\"]*\"");
        cases.push_back(std::regex_replace(textOf(path), clock, ""));
    };
    write();
    EXPECT_NE(cases.front().find("0.25"), std::string::npos);
    speak("zh_CN");
    write();
    QLocale::setDefault(QLocale(QLocale::German));
    write();
    speak("en");
    EXPECT_EQ(cases[0], cases[1]);
    EXPECT_EQ(cases[0], cases[2]);
}

TEST_F(Languages, WhatAFieldShowsIsReadFromItAgainInEveryLanguage) {
    for (const char* language : {"en", "zh_CN"}) {
        speak(language);
        widgets::AccuracyPanel panel;
        widgets::AccuracyPanel::Request request;
        request.varied = {{"cluster_shape", {"oriented_box", "hull"}}, {"step_rate", {"60"}}};
        panel.setRequest(request);
        ASSERT_EQ(panel.request().varied.size(), 2U) << language;
        EXPECT_EQ(panel.request().varied[0].values, request.varied[0].values) << language;
        EXPECT_EQ(panel.request().varied[1].key, "step_rate") << language;
    }
    speak("en");
}

TEST_F(Languages, PreferencesAreInForceAtOnceAndKept) {
    QSettings().clear();
    window->actions()["preferences"].trigger();
    auto* dialog = window->findChild<widgets::PreferencesDialog*>();
    ASSERT_NE(dialog, nullptr);
    ASSERT_TRUE(QTest::qWaitForWindowExposed(dialog, patience));
    auto* language = dialog->findChild<QComboBox*>(QStringLiteral("language"));
    language->setFocus();
    QTest::keyClick(language, Qt::Key_End);
    QTest::qWait(50);
    EXPECT_EQ(widgets::currentLanguage(), QStringLiteral("zh_CN"));
    EXPECT_EQ(dialog->windowTitle(), QStringLiteral("首选项"));
    for (const auto& [place, text] : textsOf(*dialog)) {
        EXPECT_TRUE(strangeWords(text, {}).isEmpty()) << qPrintable(place) << ": " << qPrintable(text);
    }
    auto* autosave = dialog->findChild<QSpinBox*>(QStringLiteral("autosave"));
    autosave->setFocus();
    QTest::keyClick(autosave, Qt::Key_Up);
    EXPECT_EQ(QSettings().value(QStringLiteral("autosave_seconds")).toInt(), widgets::Preferences().autosaveSeconds + 30);
    auto* theme = dialog->findChild<QComboBox*>(QStringLiteral("theme"));
    QTest::keyClick(theme, Qt::Key_End);
    EXPECT_EQ(window->area().views().view().theme, render::Theme::Dark);
    QTest::keyClick(dialog->findChild<QCheckBox*>(QStringLiteral("simplify")), Qt::Key_Space);
    QSettings settings;
    EXPECT_FALSE(settings.value(QStringLiteral("simplify_moving")).toBool());
    EXPECT_EQ(readPreferences(settings), window->preferences());
    QTest::mouseClick(dialog->findChild<QAbstractButton*>(QStringLiteral("defaults")), Qt::LeftButton);
    EXPECT_EQ(window->preferences(), widgets::Preferences());
    EXPECT_EQ(readPreferences(settings), widgets::Preferences());
}

TEST(Settings, DamagedOnesAreAsDeliveredAndNamed) {
    QTemporaryDir folder;
    const QString path = folder.filePath(QStringLiteral("rubble.ini"));
    const auto with = [&](const QByteArray& text, QStringList& complaints) {
        QFile file(path);
        EXPECT_TRUE(file.open(QIODevice::WriteOnly | QIODevice::Truncate));
        file.write(text);
        file.close();
        QSettings settings(path, QSettings::IniFormat);
        return readPreferences(settings, &complaints);
    };
    QStringList complaints;
    const widgets::Preferences some =
        with("[General]\nlanguage=klingon\nthreads=-3\nmemory_mib=lots\nautosave_seconds=60\ntheme=dark\n", complaints);
    EXPECT_EQ(complaints, QStringList({QStringLiteral("language"), QStringLiteral("threads"), QStringLiteral("memory_mib")}));
    EXPECT_EQ(some.theme, QStringLiteral("dark"));
    EXPECT_EQ(some.autosaveSeconds, 60);
    EXPECT_EQ(some.threads, 0);
    complaints.clear();
    EXPECT_EQ(with(QByteArray("\x00\x01[[[\nno key at all", 18), complaints), widgets::Preferences());
    EXPECT_FALSE(complaints.isEmpty());
    complaints.clear();
    EXPECT_EQ(with("", complaints), widgets::Preferences());
    EXPECT_TRUE(complaints.isEmpty());
}

TEST_F(Languages, F1LeadsToThePageAboutWhatHasTheFocus) {
    const std::vector<ManualPage> pages = manualPages();
    const auto stands = [&](const HelpTopic& topic) {
        return std::any_of(pages.begin(), pages.end(), [&](const ManualPage& page) {
            return page.name.contains(topic.page, Qt::CaseInsensitive) &&
                   (topic.heading.isEmpty() || page.headings.contains(topic.heading)) && page.text.contains(topic.words);
        });
    };
    openArch();
    std::size_t told = 0;
    for (const QWidget* widget : window->findChildren<QWidget*>()) {
        const HelpTopic topic = helpAbout(widget);
        EXPECT_TRUE(stands(topic)) << widget->metaObject()->className() << ": " << qPrintable(topic.page) << " # "
                                   << qPrintable(topic.heading) << ", " << qPrintable(topic.words);
        told += topic.page == QLatin1String("Start") ? 0 : 1;
    }
    EXPECT_GT(told, 300u);
    window->deck().choose(PanelDeck::Run);
    QWidget* field = window->findChild<QWidget*>(QStringLiteral("step_rate"));
    ASSERT_NE(field, nullptr);
    EXPECT_EQ(helpAbout(field), (HelpTopic{QStringLiteral("Parameters"), {}, QStringLiteral("step_rate")}));
    field->setFocus();
    QTest::keyClick(field->focusProxy() != nullptr ? field->focusProxy() : field, Qt::Key_F1);
    EXPECT_TRUE(window->help().manual().pointedAt().contains(QStringLiteral("step_rate")));
}

TEST_F(Languages, WhatIsThisNumberKnowsEveryFigureInBothLanguages) {
    for (const char* language : {"en", "zh_CN"}) {
        speak(language);
        std::size_t figures = 0;
        for (const QLabel* label : window->findChildren<QLabel*>(QStringLiteral("value"))) {
            if (label->accessibleName().isEmpty()) {
                continue;
            }
            ++figures;
            const HelpTopic topic = helpAbout(label);
            window->help().manual().showPlace(topic.page, topic.heading, topic.words);
            EXPECT_FALSE(window->help().manual().pointedAt().isEmpty())
                << language << ": " << qPrintable(label->accessibleName()) << " as " << qPrintable(topic.words);
        }
        EXPECT_GT(figures, 30u);
    }
}

TEST_F(Languages, PagesInChineseHaveTheHeadingsOfTheEnglishOnes) {
    speak("zh_CN");
    std::size_t own = 0;
    for (const ManualPage& page : manualPages()) {
        if (page.ownLanguage && page.text.contains(u'|') == false) {
            ++own;
        }
        EXPECT_EQ(headingsOf(page.text).size(), page.headings.size()) << qPrintable(page.name);
    }
    EXPECT_GT(own, 5u);
    ManualWindow manual;
    manual.showPlace(QStringLiteral("Basic Grid"), QStringLiteral("This machine"), {});
    EXPECT_TRUE(manual.findChild<QTextBrowser*>()->textCursor().block().text() == QStringLiteral("本机"));
}

TEST(Manual, FindsWordsWithTheHeadingTheyStandUnder) {
    const std::vector<ManualPage> pages{
        {QStringLiteral("One"), QStringLiteral("# One\n\nA *pile* of stone\n\n## Deep\n\nstone in a pile\n")},
        {QStringLiteral("Pile"), QStringLiteral("# Pile\n\nnothing\n")}};
    const std::vector<ManualFind> finds = findInManual(pages, QStringLiteral("PILE stone"));
    ASSERT_EQ(finds.size(), 2u);
    EXPECT_EQ(finds[0].heading, QString());
    EXPECT_EQ(finds[0].line, QStringLiteral("A pile of stone"));
    EXPECT_EQ(finds[1].heading, QStringLiteral("Deep"));
    ASSERT_EQ(findInManual(pages, QStringLiteral("pile")).size(), 3u);
    EXPECT_EQ(findInManual(pages, QStringLiteral("pile")).front().page, 1);
    EXPECT_TRUE(findInManual(pages, QStringLiteral("  ")).empty());
}

}  // namespace rubble
