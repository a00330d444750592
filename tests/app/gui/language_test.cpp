#include "widgets/basics/language.h"

#include <gmock/gmock.h>
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

#include "app/gui/case/new_case.h"
#include "app/gui/help/help.h"
#include "app/gui/help/manual.h"
#include "app/gui/session/settings.h"
#include "app/gui/stage/playback.h"
#include "app/gui/stage/view_area.h"
#include "app/gui/window/mnemonics.h"
#include "io/case/case_file.h"
#include "io/exports/exports.h"
#include "tests/app/gui/spoken_texts.h"
#include "tests/app/gui/workbench.h"
#include "widgets/accuracy/accuracy_panel.h"
#include "widgets/basics/wording.h"
#include "widgets/case/new_case_wizard.h"
#include "widgets/case/preferences_dialog.h"
#include "widgets/figures/report/report_language.h"
#include "widgets/figures/report/spoken_text.h"
#include "widgets/views/status_line.h"

namespace rubble {

class Languages : public FreshWorkbench {
protected:
    void speak(const char* language) {
        renewed->speak(QLatin1String(language));
        QTest::qWait(50);
    }
    QStringList namesOfTheFile() const { return namesIn(session->computation().inputs().fe.get()); }
    void chooseAll() {
        for (int entry = PanelDeck::Case; entry <= PanelDeck::Accuracy; ++entry) {
            window->rooms().deck->choose(static_cast<PanelDeck::Entry>(entry));
            QTest::qWait(10);
        }
        window->rooms().deck->choose(PanelDeck::Case);
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
    window->rooms().runs->simulate(false);
    ASSERT_TRUE(QTest::qWaitFor(
        [&] {
            const RunRecord* record = session->computation().currentRun();
            return record != nullptr && record->outcome != nullptr && !record->running && !session->computation().busy();
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
        io::exportFragments(path.toStdString(), *session->computation().currentRun()->reader, Execution{});
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

TEST_F(Languages, TheWizardOfANewCaseSpeaksChineseOnlyAndIsNotTakenAway) {
    speak("zh_CN");
    window->rooms().opening->newCase(arch());
    NewCase& making = *window->rooms().opening->caseInTheMaking();
    for (int step = widgets::NewCaseWizard::Units; step < widgets::NewCaseWizard::StepCount; ++step) {
        making.wizard().go(static_cast<widgets::NewCaseWizard::Step>(step));
        ASSERT_TRUE(
            QTest::qWaitFor([&] { return making.settled() && making.computation().results().fragments != nullptr; }, patience));
    }
    // Undo names the edit.
    making.document().setParameter(QStringLiteral("ground_height"), -1.0);
    ASSERT_TRUE(QTest::qWaitFor([&] { return making.settled(); }, patience));
    const Texts texts = textsOf(making.wizard());
    EXPECT_GT(texts.size(), 500u);
    const QStringList names = namesIn(making.computation().inputs().fe.get());
    for (const auto& [place, text] : texts) {
        EXPECT_TRUE(strangeWords(text, names).isEmpty()) << qPrintable(place) << ": " << qPrintable(text);
    }
    widgets::Preferences preferences = session->preferences();
    preferences.language = QStringLiteral("en");
    session->setPreferences(preferences);
    QTest::qWait(300);
    EXPECT_EQ(widgets::currentLanguage(), QStringLiteral("zh_CN")) << "another language waits for the wizard";
    ASSERT_EQ(window->rooms().opening->caseInTheMaking(), &making);
    making.wizard().reject();
    ASSERT_TRUE(QTest::qWaitFor([&] { return widgets::currentLanguage() == QLatin1String("en"); }, patience));
}

TEST_F(Languages, PlacesOfWhatIsOddInAFileAreSaidWhole) {
    speak("zh_CN");
    const auto said = [](const char* english) { return figures::spokenText(english).toStdString(); };
    EXPECT_EQ(said("element 20,373 (beam) at state 57 (2.85 s)"), "状态 57 (2.85 s) 的单元 20,373（beam）");
    EXPECT_EQ(said("element 20,373 (beam) at state 57 (2.85 s), 0.48 times its first volume"),
              "状态 57 (2.85 s) 的单元 20,373（beam），体积为最初的 0.48 倍");
    EXPECT_EQ(said("element 7 (beam) at state 2 (0.1 s), 0.001 thick per length"),
              "状态 2 (0.1 s) 的单元 7（beam），厚度与长度之比为 0.001");
    EXPECT_EQ(said("element 7 (beam), 3.2 s, but reported at state 2 (0.1 s)"), "单元 7（beam），3.2 s，但到状态 2 (0.1 s) 才报告");
    EXPECT_EQ(said("element 7 (beam), 3.2 s"), "单元 7（beam），3.2 s");
}

TEST_F(Languages, ANameThatIsAWordAsWellStaysAsItIs) {
    speak("zh_CN");
    const Message named{"components.unknown", "There is no component \"{0}\" among {1}", {"beam", 3}};
    EXPECT_THAT(widgets::worded(named).toStdString(), testing::HasSubstr("beam"));
    EXPECT_THAT(figures::chineseWords()(named),
                testing::AllOf(testing::HasSubstr("beam"), testing::Not(testing::HasSubstr("component"))));
    // What core says of a kind of element is a word.
    const Message kind{"x", "{0}", {"beam"}};
    EXPECT_EQ(widgets::worded(kind).toStdString(), "梁");
    EXPECT_EQ(figures::chineseWords()(kind), "梁");
}

// Pages of runs said "请提高 step_rate，或设置 auto_remedy = true" where window and report have names.
TEST_F(Languages, SettingsOfAPageHaveNames) {
    speak("zh_CN");
    const Message remedy{
        "x",
        "raise step_rate or substeps; light bodies between far heavier ones ask for it. Where as many are held back after "
        "that, what they did is less sure",
        {}};
    const std::string words = widgets::worded(remedy).toStdString();
    EXPECT_THAT(words, testing::Not(testing::AnyOf(testing::HasSubstr("step_rate"), testing::HasSubstr("substeps"))));
    EXPECT_EQ(figures::chineseWords(true)(remedy), words);
    EXPECT_THAT(figures::chineseWords()(remedy), testing::HasSubstr("step_rate")) << "a command line speaks keys";
}

// A window that takes the place of another shows and says what one does that was there from the start.
TEST_F(Languages, ASwitchChangesTheWordsAndNothingElse) {
    openArch();
    makeCheap();
    simulateToEnd();
    Document& document = session->document();
    document.duplicateScenario(document.active()->id);
    document.setParameter(QStringLiteral("friction"), 0.5);
    document.applyPreset(QStringLiteral("paper"));
    document.undoStack().undo();
    ASSERT_TRUE(QTest::qWaitFor([&] { return prepared(); }, patience));
    window->rooms().inspection->selection().select({window->area().views().data().fragments->list.front().element});
    window->area().views().setAnimated(false);
    window->area().views().turn(0.1, 0.0);
    const double time = session->computation().inputs().fe->times()[3];
    window->rooms().playback->showInstant(time);
    window->rooms().deck->choose(PanelDeck::Run);
    // The way of what is selected is part of the view, and is read beside it.
    const auto read = [&] { return !window->rooms().inspection->selection().reading(); };
    ASSERT_TRUE(QTest::qWaitFor(read, patience));
    const RunRecord* run = session->computation().currentRun();
    const auto hash = run->outcome->trajectoryHash;
    const render::View view = window->area().views().view();
    const Case theCase = document.theCase();
    const int index = document.undoStack().index();
    const int edits = document.undoStack().count();
    const QString named = document.undoStack().text(index - 1);
    const QSize size = window->size();
    for (const char* language : {"zh_CN", "en"}) {
        speak(language);
        ASSERT_TRUE(QTest::qWaitFor(read, patience));
        EXPECT_EQ(session->computation().currentRun(), run);
        EXPECT_EQ(run->outcome->trajectoryHash, hash);
        EXPECT_EQ(window->area().views().view(), view) << "view, selection and cameras: " << language;
        EXPECT_EQ(window->area().views().data().trajectory, run->reader);
        EXPECT_DOUBLE_EQ(window->rooms().playback->clock().time(), time);
        EXPECT_EQ(window->rooms().deck->stack().currentIndex(), PanelDeck::Run);
        EXPECT_EQ(window->rooms().deck->rail().current(), PanelDeck::Run);
        EXPECT_EQ(document.theCase(), theCase);
        EXPECT_TRUE(document.modified());
        EXPECT_EQ(document.undoStack().index(), index);
        EXPECT_EQ(document.undoStack().count(), edits);
        EXPECT_TRUE(window->actions()[ActionId::Redo].isEnabled());
        EXPECT_EQ(window->rooms().project->runs().runs().size(), 1u);
        EXPECT_EQ(window->size(), size);
        EXPECT_TRUE(window->isVisible());
        EXPECT_EQ(rail(PanelDeck::Grid), widgets::StageState::UpToDate);
    }
    EXPECT_EQ(document.undoStack().text(index - 1), named);
    speak("zh_CN");
    window->actions()[ActionId::History].trigger();
    chooseAll();
    const QStringList names = namesOfTheFile() << QStringLiteral("paper");  // of the preset
    for (const auto& [place, text] : textsOf(*window)) {
        EXPECT_TRUE(strangeWords(text, names).isEmpty()) << qPrintable(place) << ": " << qPrintable(text);
    }
    for (int i = 0; i < document.undoStack().count(); ++i) {
        EXPECT_TRUE(strangeWords(document.undoStack().text(i), names).isEmpty()) << qPrintable(document.undoStack().text(i));
    }
    // What was done before the switch can be undone after it.
    const Scenario edited = document.scenario();
    document.undoStack().undo();
    EXPECT_FALSE(document.scenario() == edited);
    ASSERT_TRUE(QTest::qWaitFor([&] { return prepared(); }, patience));
}

TEST_F(Languages, ARunGoesOnThroughASwitchAndItsProgressShows) {
    openArch();
    window->rooms().runs->simulate(false);
    ASSERT_TRUE(QTest::qWaitFor([&] { return session->computation().simulating(); }, patience));
    const RunRecord* run = session->computation().currentRun();
    speak("zh_CN");
    EXPECT_EQ(session->computation().currentRun(), run);
    ASSERT_TRUE(session->computation().simulating()) << "the switch has ended the run";
    ASSERT_TRUE(QTest::qWaitFor(
        [&] {
            return !session->computation().simulating() || !window->findChild<widgets::StatusLine*>()->activityText().isEmpty();
        },
        patience));
    const QString activity = window->findChild<widgets::StatusLine*>()->activityText();
    EXPECT_FALSE(activity.isEmpty()) << "nobody says how far the run has got";
    EXPECT_TRUE(strangeWords(activity, {}).isEmpty()) << qPrintable(activity);
    EXPECT_TRUE(window->actions()[ActionId::Cancel].isEnabled());
    EXPECT_FALSE(window->actions()[ActionId::Simulate].isEnabled());
    window->actions()[ActionId::Cancel].trigger();
    ASSERT_TRUE(QTest::qWaitFor([&] { return !session->computation().busy(); }, patience));
    EXPECT_TRUE(window->actions()[ActionId::Simulate].isEnabled());
    EXPECT_EQ(window->rooms().project->runs().runs().size(), 1u) << "the history of runs knows what began before the switch";
}

TEST_F(Languages, AFailureIsSaidInTheLanguageThatIsChosenAfterIt) {
    QTemporaryDir folder;
    const QString path = folder.filePath(QStringLiteral("nothing.exo"));
    QFile(path).open(QIODevice::WriteOnly);
    window->open(path);
    ASSERT_TRUE(
        QTest::qWaitFor([&] { return window->rooms().deck->failure().has_value() && !session->computation().busy(); }, patience));
    speak("zh_CN");
    ASSERT_TRUE(window->rooms().deck->failure().has_value());
    EXPECT_TRUE(strangeWords(window->rooms().deck->failure()->what(), {path, QStringLiteral("nothing.exo")}).isEmpty())
        << qPrintable(window->rooms().deck->failure()->what());
    const Texts texts = textsOf(*window);
    EXPECT_TRUE(std::ranges::any_of(texts, [&](const auto& each) {
        return each.second.contains(window->rooms().deck->failure()->what());
    })) << "the new window does not say what is wrong";
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
    session->document().setParameter(QStringLiteral("friction"), 0.25);
    ASSERT_TRUE(QTest::qWaitFor([&] { return prepared(); }, patience));
    std::vector<std::string> cases;
    const auto write = [&] {
        QTemporaryDir folder;
        const QString path = folder.filePath(QStringLiteral("arch.rubble"));
        io::saveCase(path.toStdString(), session->document().theCase());
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
    window->actions()[ActionId::Preferences].trigger();
    auto* dialog = window->findChild<widgets::PreferencesDialog*>();
    ASSERT_NE(dialog, nullptr);
    ASSERT_TRUE(QTest::qWaitForWindowExposed(dialog, patience));
    dialog->move(70, 50);
    auto* language = dialog->findChild<QComboBox*>(QStringLiteral("language"));
    language->setFocus();
    QTest::keyClick(language, Qt::Key_End);
    QTest::qWait(50);
    ASSERT_TRUE(QTest::qWaitFor([&] { return widgets::currentLanguage() == QLatin1String("zh_CN"); }, patience));
    dialog = window->findChild<widgets::PreferencesDialog*>();
    ASSERT_NE(dialog, nullptr) << "the dialog comes again with the new window";
    EXPECT_EQ(dialog->pos(), QPoint(70, 50));
    EXPECT_EQ(dialog->windowHandle()->transientParent(), window->windowHandle()) << "it stays in front of the window";
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
    EXPECT_EQ(readPreferences(settings), session->preferences());
    QTest::mouseClick(dialog->findChild<QAbstractButton*>(QStringLiteral("defaults")), Qt::LeftButton);
    EXPECT_EQ(session->preferences(), widgets::Preferences());
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
    window->rooms().deck->choose(PanelDeck::Run);
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
