#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <cmath>
#include <fstream>
#include <functional>
#include <iostream>
#include <map>
#include <memory>
#include <set>
#include <sstream>

#include "io/case/case_file.h"
#include "io/exports/provenance.h"
#include "io/validation/kept_validation.h"
#include "tests/scenes/validation_records.h"
#include "tests/support/ascii_grid.h"
#include "tests/support/browser.h"
#include "tests/support/photographed_case.h"
#include "tests/support/small_collapse.h"
#include "tests/support/temporary_folder.h"

namespace rubble::cli {

namespace {

using testing::HasSubstr;
using testing::Not;

/// The page of the small collapse, with a photograph.
class SmallPage : public PhotoOfCase {
public:
    SmallPage() {
        SetUp();
        m_case.bookmarks = {{0.25, "The second block goes."}, {99.0, "Long after."}};
        io::keepValidation(scenes::tossRecord(), m_folder / "cache");
        const Outcome outcome = CommandRun()
                                    .with("RUBBLE_CACHE", m_folder / "cache")
                                    .cli({"export", m_out, "--case", save(), "--export", "page=" + path()});
        EXPECT_EQ(outcome.exitCode, 0) << outcome.err;
        EXPECT_THAT(outcome.err, HasSubstr("mm of those recorded"));
    }
    std::string path() const { return m_folder / "a/small.html"; }
    const std::string& runFile() const { return m_out; }
    const std::string& fePath() const { return m_path; }

private:
    void TestBody() override {}
};

/// The page of the small collapse in a browser, opened anew for each test; nothing is run where there is none.
class PageInBrowser : public PageTest<SmallPage> {
protected:
    void SetUp() override {
        PageTest::SetUp();
        if (m_browser == nullptr) {
            return;
        }
        m_page = Shared::page()->path();
        m_ready = m_browser->open(m_page);
    }
    /// Nobody was asked for anything but the page itself, and nothing went wrong.
    void TearDown() override {
        PageTest::TearDown();
        if (m_browser != nullptr) {
            EXPECT_THAT(m_browser->requests(), testing::Each(testing::EndsWith("small.html")));
        }
    }
    /// A copy of the page, changed; its path. It ends as the page does, for the sake of TearDown().
    std::string changed(const std::function<void(std::string&)>& change) {
        std::string text = textOf(m_page);
        change(text);
        const std::string path = m_folder / "changed-small.html";
        std::ofstream(path, std::ios::binary) << text;
        return path;
    }
    /// What the page says where its pictures stand in place of the views.
    void expectPicturesInBothLanguages(Browser& browser, const std::string& chinese);
    /// Rows of fragments.csv by the column names.
    std::vector<std::map<std::string, std::string>> table();

    io::TemporaryFolder m_folder;
    std::string m_page;
    std::string m_ready;
};

void PageInBrowser::expectPicturesInBothLanguages(Browser& browser, const std::string& chinese) {
    const auto told = [&](const std::string& expression) { return browser.evaluate(expression); };
    EXPECT_EQ(told("document.getElementById('stills').hidden"), false);
    EXPECT_EQ(told("document.getElementById('stage').hidden"), true);
    EXPECT_EQ(told("[...document.querySelectorAll('[role=tab]')].map((each) => each.id)"),
              (nlohmann::json{"tab-story", "tab-evidence", "tab-health", "tab-about"}))
        << "picking and looking need the views";
    // A chapter leads to the picture of its time.
    told("document.querySelector('.chapters button[data-time=\"0.25\"]').click()");
    EXPECT_EQ(told("document.activeElement.dataset.time"), "0.25");
    EXPECT_EQ(told("(() => { const box = document.activeElement.getBoundingClientRect();"
                   " return box.bottom > 0 && box.top < innerHeight; })()"),
              true);
    told("document.getElementById('chinese').click()");
    EXPECT_THAT(told("document.getElementById('reason').textContent").get<std::string>(), HasSubstr(chinese));
    EXPECT_THAT(told("document.querySelector('#stills img').alt").get<std::string>(), HasSubstr("碎块"));
    told("document.getElementById('english').click()");
    EXPECT_THAT(told("document.getElementById('reason').textContent").get<std::string>(), Not(HasSubstr(chinese)));
    EXPECT_THAT(told("document.querySelector('#stills img').alt").get<std::string>(), HasSubstr("FE result and fragments"));
    EXPECT_THAT(browser.complaints(), testing::IsEmpty());
}

std::vector<std::map<std::string, std::string>> PageInBrowser::table() {
    cli({"export", Shared::page()->runFile(), "--export", "fragments=" + (m_folder / "f.csv")});
    std::istringstream lines(textOf(m_folder / "f.csv"));
    std::vector<std::vector<std::string>> rows;
    for (std::string line; std::getline(lines, line);) {
        std::istringstream cells(line);
        rows.emplace_back();
        for (std::string cell; std::getline(cells, cell, ',');) {
            rows.back().push_back(cell);
        }
    }
    std::vector<std::map<std::string, std::string>> named;
    for (std::size_t r = 1; r < rows.size(); ++r) {
        named.emplace_back();
        for (std::size_t c = 0; c < rows[r].size(); ++c) {
            named.back()[rows[0][c]] = rows[r][c];
        }
    }
    return named;
}

TEST_F(PageInBrowser, CountsAndPlacesAreThoseOfTheRun) {
    if (!m_browser) {
        return;
    }
    EXPECT_THAT(m_ready, testing::MatchesRegex("[0-9]+")) << said("document.getElementById('reason').textContent");
    EXPECT_EQ(said("page.player.pieces.masses.length"), smallDead);
    said("page.jump(page.player.end)");
    EXPECT_EQ(said("page.player.pieceCount"), smallDead);
    EXPECT_EQ(said("page.player.activeCount"), smallElements - smallDead);
    said("page.jump(0)");
    EXPECT_EQ(said("page.player.pieceCount"), 0);
    EXPECT_EQ(said("page.player.activeCount"), smallElements);
    const auto rows = table();
    ASSERT_EQ(rows.size(), static_cast<std::size_t>(smallDead));
    for (const auto& row : rows) {
        const std::string element = "page.player.structure.ids.indexOf(" + row.at("element_id") + ")";
        const auto place = said("page.player.middleAt(" + element + ", page.player.end)");
        // The page rounds; its own claim is 5 mm at most.
        EXPECT_NEAR(place[0], std::stod(row.at("final_x_m")), 5e-3);
        EXPECT_NEAR(place[1], std::stod(row.at("final_y_m")), 5e-3);
        EXPECT_NEAR(place[2], std::stod(row.at("final_z_m")), 5e-3);
    }
    EXPECT_LE(said("page.facts.precision.place").get<double>(), 5e-3);
}

TEST_F(PageInBrowser, PlaysScrubsAndPicksByMouseAndByKeys) {
    if (!m_browser) {
        return;
    }
    said("document.getElementById('time').value = 0.3; document.getElementById('time').dispatchEvent(new Event('input'))");
    EXPECT_NEAR(said("page.player.time").get<double>(), 0.3, 1e-9);
    EXPECT_THAT(said("document.getElementById('clock').textContent").get<std::string>(), HasSubstr("0.30 s"));
    EXPECT_EQ(m_browser->waitFor("!page.player.glancing && page.player.quality"), 1) << "once let be, it is drawn in full";
    said("page.player.pace = 0.1");
    said("document.getElementById('play').focus()");
    m_browser->press("Enter");
    m_browser->waitFor("page.player.playing && page.player.time > 0.3");
    m_browser->press("Enter");
    EXPECT_GT(said("page.player.time").get<double>(), 0.3);
    EXPECT_FALSE(said("page.player.playing").get<bool>());
    // Where the middle of a fragment is drawn, that fragment is picked, or one in front of it.
    const auto at = said(R"js((() => {
        page.jump(page.player.end);
        const player = page.player;
        const element = player.pieces.elements[0];
        const p = player.middleAt(element, player.time);
        const pane = player.panes()[1];
        const m = player.camera.matrix(pane.width / pane.height);
        const clip = [0, 1, 3].map((r) => m[r] * p[0] + m[4 + r] * p[1] + m[8 + r] * p[2] + m[12 + r]);
        const scale = player.canvas.clientWidth / player.canvas.width;
        const box = document.getElementById('views').getBoundingClientRect();
        return [box.left + scale * (pane.x + pane.width * (0.5 + 0.5 * clip[0] / clip[2])),
            box.top + scale * (player.canvas.height - pane.y - pane.height * (0.5 + 0.5 * clip[1] / clip[2]))];
    })())js");
    m_browser->click(at[0], at[1]);
    const int chosen = said("page.player.chosen").get<int>();
    ASSERT_GE(chosen, 0);
    const std::string rows = said("document.getElementById('chosen').textContent");
    EXPECT_THAT(rows, HasSubstr(said("String(page.player.structure.ids[page.player.chosen])").get<std::string>()));
    EXPECT_THAT(rows, HasSubstr("mass"));
    EXPECT_EQ(said("document.getElementById('said').textContent.length > 0"), true) << "screen readers hear of it";
    EXPECT_GT(said("page.player.pathPoints.length").get<int>(), 2);
}

TEST_F(PageInBrowser, EveryControlIsReachedByTheKeyAndHasAName) {
    if (!m_browser) {
        return;
    }
    said("document.body.focus()");
    std::set<std::string> reached;
    for (int i = 0; i < 40; ++i) {
        m_browser->press("Tab");
        reached.insert(said("document.activeElement.id || document.activeElement.tagName"));
    }
    for (const char* id :
         {"english", "chinese", "contrast", "views", "first", "back", "play", "forward", "time", "pace", "tab-story"}) {
        EXPECT_TRUE(reached.contains(id)) << id;
    }
    const auto nameless = said(R"js([...document.querySelectorAll('button, input, select, [role="application"]')]
        .filter((each) => !(each.textContent.trim() || each.getAttribute('aria-label') || (each.labels && each.labels.length > 0)))
        .map((each) => each.outerHTML.slice(0, 80)))js");
    EXPECT_EQ(nameless, nlohmann::json::array());
}

TEST_F(PageInBrowser, ChaptersPhotographsMapAndBothLanguages) {
    if (!m_browser) {
        return;
    }
    EXPECT_THAT(said("document.getElementById('panel-story').textContent").get<std::string>(), HasSubstr("The second block goes."));
    EXPECT_EQ(said("document.querySelectorAll('#panel-evidence img').length"), 2) << "the map and the photograph";
    EXPECT_THAT(said("document.getElementById('panel-evidence').textContent").get<std::string>(),
                HasSubstr("The silhouettes overlap by"));
    said("document.getElementById('chinese').click()");
    EXPECT_EQ(said("document.documentElement.lang"), "zh-CN");
    EXPECT_THAT(said("document.getElementById('panel-story').textContent").get<std::string>(), HasSubstr("章节"));
    // No word is left in the other language.
    EXPECT_EQ(said("Object.entries(words).filter(([key, pair]) => key !== 'roles' && pair[0] === pair[1]).length"), 0);
}

TEST_F(PageInBrowser, ThousandsAreGroupedInEveryNumber) {
    if (!m_browser) {
        return;
    }
    EXPECT_EQ(said("sayNumber(6790, 4)"), "6,790") << "as beside it 65,870 t";
    EXPECT_EQ(said("sayNumber(65870.4, 4)"), "65,870");
    EXPECT_EQ(said("sayNumber(-1234.56, 6)"), "-1,234.56");
    EXPECT_EQ(said("sayNumber(999, 4)"), "999");
    EXPECT_EQ(said("sayNumber(0.00001234)"), "0.0000123");
    EXPECT_EQ(said("sayCount(6790)"), "6,790");
    EXPECT_EQ(said("sayFixed(12345.678, 2)"), "12,345.68");
    // The line of the map is written by them.
    EXPECT_EQ(said("say('mapLine', sayCount(1204), sayNumber(65870, 4), sayNumber(6790, 4), '0.25', '0', '0', '1')")
                  .get<std::string>()
                  .rfind("1,204 fragments of 65,870 t on 6,790 m\u00b2", 0),
              0U);
}

TEST_F(PageInBrowser, WithoutWebGlThePicturesStandThere) {
    if (!m_browser) {
        return;
    }
    Browser plain(m_folder / "plain", 800, 600, {"--disable-3d-apis"});
    EXPECT_EQ(plain.open(m_page), "noWebGl");
    expectPicturesInBothLanguages(plain, "此浏览器没有 WebGL 2");
    EXPECT_EQ(plain.evaluate("document.getElementById('stills').hidden"), false);
    EXPECT_NE(plain.evaluate("getComputedStyle(document.getElementById('stills')).display"), "none");
    EXPECT_EQ(
        plain.evaluate("document.documentElement.className = 'opening contrast', window.dispatchEvent(new ErrorEvent('error')),"
                       " document.documentElement.className.trim()"),
        "contrast");
    EXPECT_GE(plain.evaluate("document.querySelectorAll('#stills img').length").get<int>(), 3);
    EXPECT_EQ(
        plain.evaluate("[...document.querySelectorAll('#stills img')].every((each) => each.complete && each.naturalWidth > 100)"),
        true);
    EXPECT_THAT(plain.evaluate("document.getElementById('panel-story').textContent").get<std::string>(), HasSubstr("fragments"));
}

TEST_F(PageInBrowser, DamagedDataAndALostContextLeaveThePictures) {
    if (!m_browser) {
        return;
    }
    const std::string damaged = changed([](std::string& text) {
        const std::size_t data = text.find("id=\"data\">");
        text.replace(text.find("</script>", data) - 400, 200, std::string(200, 'A'));
    });
    EXPECT_EQ(m_browser->open(damaged), "damaged");
    expectPicturesInBothLanguages(*m_browser, "无法显示视图");
    m_browser->open(m_page);
    said("page.player.play()");
    said("page.player.renderer.gl.getExtension('WEBGL_lose_context').loseContext()");
    m_browser->waitFor("document.documentElement.dataset.ready === 'lost'");
    expectPicturesInBothLanguages(*m_browser, "浏览器失去了图形环境");
}

TEST_F(PageInBrowser, APageThatWasCutShortSaysSo) {
    if (!m_browser) {
        return;
    }
    const std::string cut = changed([](std::string& text) { text.resize(text.find("id=\"data\">") + 100); });
    const auto seen = [&](const std::string& id) {
        return said("getComputedStyle(document.getElementById('" + id + "')).display !== 'none'");
    };
    EXPECT_EQ(seen("unread"), false) << "the script of the whole page ran";
    EXPECT_EQ(m_browser->open(cut), "unread");
    EXPECT_EQ(seen("unread"), true);
    EXPECT_EQ(seen("stills"), true);
}

TEST_F(PageInBrowser, WordsFitWhatIsShown) {
    if (!m_browser) {
        return;
    }
    const auto caption = [&](const std::string& time) {
        said("page.jump(" + time + ")");
        return said("document.getElementById('fragmentCaption').textContent").get<std::string>();
    };
    EXPECT_THAT(caption("page.player.frames[page.player.frames.length - 2]"), HasSubstr("(simulated)"));
    EXPECT_THAT(caption("0.5 * (page.player.frames[page.player.frames.length - 2] + page.player.end)"),
                HasSubstr("(simulated, interpolated)"));
    EXPECT_THAT(caption("0"), HasSubstr("(simulated)")) << "there is nothing yet";
    // A bookmark after the end is told and leads nowhere.
    EXPECT_THAT(said("document.querySelector('.chapters .outside').textContent").get<std::string>(),
                testing::AllOf(HasSubstr("Long after."), HasSubstr("outside the time of the run")));
    EXPECT_EQ(said("document.querySelectorAll('.chapters button[data-time=\"99\"]').length"), 0);
    EXPECT_EQ(said("[...document.querySelectorAll('#marks i')].every((each) => parseFloat(each.style.left) <= 100)"), true);
    // Legends.
    said("page.facts.scene.components = Array.from({ length: 23 }, (_, i) => `part ${i}`)");
    said("page.player.setColours('component')");
    EXPECT_THAT(said("document.getElementById('legend').textContent").get<std::string>(), HasSubstr("20 more"));
    said("page.panels.build()");
    EXPECT_EQ(said("[...document.querySelectorAll('.components li')].length"), 23);
    EXPECT_EQ(said("document.querySelector('.components').hidden"), false);
    said("page.player.setColours('cluster')");
    EXPECT_THAT(said("document.getElementById('legend').textContent").get<std::string>(), HasSubstr("a colour for each cluster"));
    // Tables of source and health.
    const auto health = [&] { return said("document.getElementById('panel-health').textContent").get<std::string>(); };
    EXPECT_THAT(health(), testing::AllOf(HasSubstr("Tosses of a cube, blind. 32 falls simulated, of which 3 are in no mean."),
                                         HasSubstr("run-out, Plate [m]"), HasSubstr("-0.25 (-0.375 to -0.125)"),
                                         HasSubstr("0 of 1 figures are as asked")));
    said("document.getElementById('chinese').click()");
    EXPECT_THAT(health(),
                testing::AllOf(HasSubstr("盲算"), HasSubstr("散落距离, Plate [m]"), HasSubstr("-0.25 (-0.375 至 -0.125)")));
    const std::string source =
        said("[...document.querySelectorAll('#panel-about tr')].map((each) => each.textContent).join()").get<std::string>();
    EXPECT_THAT(source,
                testing::AllOf(HasSubstr("已加上坐标框架原点"), HasSubstr("稳定时间"), Not(HasSubstr("origin of the frame"))));
    said("page.facts.validation = null, page.panels.build()");
    EXPECT_THAT(health(), HasSubstr("未与实测的下落比较过"));
    // A photograph of which nothing is known is not said to be one of no case.
    said("page.facts.photographs = 2, page.panels.build()");
    EXPECT_THAT(said("document.getElementById('panel-evidence').textContent").get<std::string>(), HasSubstr("2 张照片中有 1 张"));
}

TEST_F(PageInBrowser, WhatWasMeasuredStaysInTheOtherLanguage) {
    if (!m_browser) {
        return;
    }
    said(
        "page.panels.toggleMeasure(), page.panels.picked({ element: -1, point: [0, 0, 0] }),"
        " page.panels.picked({ element: -1, point: [3, 4, 0] })");
    const auto measured = [&] { return said("document.getElementById('measured').textContent").get<std::string>(); };
    EXPECT_THAT(measured(), HasSubstr("5.00 m apart"));
    said("document.getElementById('chinese').click()");
    EXPECT_THAT(measured(), HasSubstr("相距 5.00 m"));
    said("page.panels.clear()");
    EXPECT_EQ(measured(), "");
}

TEST_F(PageInBrowser, AnotherSizeOfTheWindowKeepsWhatIsSeen) {
    if (!m_browser) {
        return;
    }
    m_browser->resize(390, 800);
    m_browser->waitFor("page.player.room[0] < 400");
    m_browser->resize(1920, 1080);
    m_browser->waitFor("page.player.room[0] > 1000");
    const double followed = said("page.player.camera.distance").get<double>();
    said("page.panels.lookFrom(null)");
    EXPECT_NEAR(followed, said("page.player.camera.distance").get<double>(), 1e-6 * followed);
}

TEST_F(PageInBrowser, APaceThatIsNotKeptIsTold) {
    if (!m_browser) {
        return;
    }
    const std::string text = ", page.refresh(), document.getElementById('lag').textContent";
    EXPECT_EQ(said("page.player.play(), page.player.advance(40)" + text), "");
    said("page.player.stop(), page.jump(0)");
    EXPECT_THAT(said("page.player.play(), page.player.advance(1000)" + text).get<std::string>(), HasSubstr("plays at 0.25"));
    EXPECT_EQ(said("page.player.stop()" + text), "");
}

TEST_F(PageInBrowser, CarriesItsProvenanceAndNoAddressOfOthers) {
    const std::string page = Shared::page()->path();
    const std::string text = textOf(page);
    EXPECT_THAT(text, HasSubstr("default-src 'none'"));
    EXPECT_THAT(text, Not(HasSubstr("http://")));
    EXPECT_THAT(text, Not(HasSubstr("https://")));
    EXPECT_THAT(text, Not(HasSubstr("{{")));
    const auto provenance = io::readProvenance(page);
    ASSERT_TRUE(provenance.has_value());
    EXPECT_EQ(provenance->kind, "page");
    EXPECT_EQ(provenance->fePath, Shared::page()->fePath());
}

/// Pages of runs of their own, in the browser of all.
class OtherPage : public SmallRun {
protected:
    void SetUp() override {
        if (m_browser == nullptr) {
            std::cout << "not run: no Chromium here\n";
            return;
        }
        m_browser->resize(1280, 800);
    }

    Browser* m_browser = Browser::ofAll();
};

TEST_F(OtherPage, WhatMovesAtTheEndHasItsSpeedThere) {
    if (!m_browser) {
        return;
    }
    const nlohmann::json made = run({}, "0");
    ASSERT_GT(made["still_moving"].get<int>(), 0) << made;
    const std::string page = m_folder / "small.html";
    Case theCase = io::caseForFe(m_path, m_folder / "small.rubble");
    addPhotograph(theCase, m_folder / "site.tif");
    io::saveCase(m_folder / "small.rubble", theCase);
    ASSERT_EQ(cli({"export", m_out, "--case", m_folder / "small.rubble", "--export", "page=" + page}).exitCode, 0);
    Browser& browser = *m_browser;
    browser.open(page);
    const auto textOfPart = [&](const std::string& id) {
        return browser.evaluate("document.getElementById('" + id + "').textContent").get<std::string>();
    };
    // What the window, the report and pictures say of such a run stands here too, beside the score of the photograph as well.
    EXPECT_THAT(textOfPart("warnings"), HasSubstr("Not all at rest"));
    EXPECT_THAT(textOfPart("panel-evidence"), HasSubstr("The photograph shows all at rest, but"));
    browser.evaluate("document.getElementById('chinese').click()");
    EXPECT_THAT(textOfPart("warnings"), testing::AllOf(HasSubstr("静止"), Not(HasSubstr("at rest"))));
    EXPECT_THAT(textOfPart("panel-evidence"), Not(HasSubstr("shows all at rest")));
    browser.evaluate("document.getElementById('english').click()");
    const auto fastest = [&](const std::string& time) {
        browser.evaluate("page.jump(" + time + ")");
        return browser
            .evaluate(
                "Math.max(...[...page.player.pieces.live].map((p) =>"
                " page.player.motion.speed(page.player.pieces.bodies[p], page.player.time)))")
            .get<double>();
    };
    const double before = fastest("page.player.end - 1e-4");
    EXPECT_GT(before, 1.0);
    EXPECT_NEAR(fastest("page.player.end"), before, 1e-6 * before);
    browser.evaluate("page.player.choose(page.player.pieces.elements[page.player.pieces.live[0]])");
    EXPECT_THAT(browser.evaluate("document.getElementById('chosen').textContent").get<std::string>(), HasSubstr("mean over"));
}

TEST_F(OtherPage, AMeasureMeetsTheTerrain) {
    if (!m_browser) {
        return;
    }
    const std::string terrain = io::AsciiGrid().write(m_folder / "slope.asc", [](double x, double) { return 0.05 * x - 1.0; });
    run({"--terrain", terrain}, "0.2");
    const std::string page = m_folder / "small.html";
    ASSERT_EQ(cli({"export", m_out, "--export", "page=" + page}).exitCode, 0);
    Browser& browser = *m_browser;
    browser.open(page);
    browser.evaluate("page.panels.lookFrom('corner')");
    const auto hit = browser.evaluate(R"js((() => {
        const pane = page.player.panes()[1];
        const scale = page.player.canvas.clientWidth / page.player.canvas.width;
        return page.player.pickAt(scale * (pane.x + pane.width / 2), scale * (page.player.canvas.height - pane.y) - 40);
    })())js");
    EXPECT_EQ(hit["element"], -1);
    ASSERT_TRUE(hit["point"].is_array()) << hit;
    // Heights on the page are rounded to a millimetre.
    EXPECT_NEAR(hit["point"][2].get<double>(), 0.05 * hit["point"][0].get<double>() - 1.0, 1e-3);
}

TEST_F(SmallRun, APageThatCannotBeWrittenSaysWhyAndLeavesNothing) {
    run({}, "0.5");
    EXPECT_EQ(cli({"export", m_out, "--export", "page=" + (m_folder / "small.txt")}).exitCode, 2);
    const Outcome full = CommandRun().fileSizeLimit(20000).cli({"export", m_out, "--export", "page=" + (m_folder / "full.html")});
    EXPECT_EQ(full.exitCode, 1);
    EXPECT_THAT(full.err, HasSubstr("full.html"));
    EXPECT_FALSE(std::ifstream(m_folder / "full.html").good());
}

}  // namespace

}  // namespace rubble::cli
