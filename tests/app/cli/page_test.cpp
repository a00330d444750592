#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <cmath>
#include <fstream>
#include <iostream>
#include <map>
#include <memory>
#include <set>
#include <sstream>

#include "io/case/case_file.h"
#include "io/exports/provenance.h"
#include "tests/support/browser.h"
#include "tests/support/photographed_case.h"
#include "tests/support/small_collapse.h"

namespace rubble::cli {

namespace {

using testing::HasSubstr;
using testing::Not;

/// The page of the small collapse in a browser; nothing is run where there is none.
class PageInBrowser : public PhotoOfCase {
protected:
    void SetUp() override {
        if (Browser::program().empty()) {
            std::cout << "not run: no Chromium here\n";
            return;
        }
        PhotoOfCase::SetUp();
        m_case.bookmarks = {{0.25, "The second block goes."}};
        const Outcome outcome = cli({"export", m_out, "--case", save(), "--export", "page=" + m_page});
        ASSERT_EQ(outcome.exitCode, 0) << outcome.err;
        EXPECT_THAT(outcome.err, HasSubstr("mm of those recorded"));
        m_browser = std::make_unique<Browser>(m_folder / "profile", 1280, 800);
        m_ready = m_browser->open(m_page);
    }
    /// Nobody was asked for anything but the page itself, and nothing went wrong.
    void TearDown() override {
        if (m_browser) {
            EXPECT_THAT(m_browser->requests(), testing::Each(testing::EndsWith("small.html")));
            EXPECT_THAT(m_browser->complaints(), testing::IsEmpty());
        }
    }
    nlohmann::json said(const std::string& expression) { return m_browser->evaluate(expression); }
    /// Rows of fragments.csv by the column names.
    std::vector<std::map<std::string, std::string>> table();

    std::string m_page = m_folder / "small.html";
    std::unique_ptr<Browser> m_browser;
    std::string m_ready;
};

std::vector<std::map<std::string, std::string>> PageInBrowser::table() {
    cli({"export", m_out, "--export", "fragments=" + (m_folder / "f.csv")});
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

TEST_F(PageInBrowser, WithoutWebGlThePicturesStandThere) {
    if (!m_browser) {
        return;
    }
    Browser plain(m_folder / "plain", 800, 600, {"--disable-3d-apis"});
    EXPECT_EQ(plain.open(m_page), "noWebGl");
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

TEST_F(SmallRun, APageCarriesItsProvenanceAndNoAddressOfOthers) {
    run({}, "0.5");
    const std::string page = m_folder / "a/small.html";
    const Outcome outcome = cli({"export", m_out, "--export", "page=" + page});
    ASSERT_EQ(outcome.exitCode, 0) << outcome.err;
    const std::string text = textOf(page);
    EXPECT_THAT(text, HasSubstr("default-src 'none'"));
    EXPECT_THAT(text, Not(HasSubstr("http://")));
    EXPECT_THAT(text, Not(HasSubstr("https://")));
    EXPECT_THAT(text, Not(HasSubstr("{{")));
    const auto provenance = io::readProvenance(page);
    ASSERT_TRUE(provenance.has_value());
    EXPECT_EQ(provenance->kind, "page");
    EXPECT_EQ(provenance->fePath, m_path);
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
