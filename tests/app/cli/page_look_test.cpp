#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <fstream>
#include <iostream>
#include <memory>

#include "io/case/case_file.h"
#include "io/site/input_files.h"
#include "tests/support/ascii_grid.h"
#include "tests/support/browser.h"
#include "tests/support/photographed_case.h"

namespace rubble::cli {

namespace {

using testing::HasSubstr;
using testing::Not;

/// The page of the small collapse, within a wall and a picture of the ground.
class WalledPage : public SmallRun {
public:
    WalledPage() {
        run({}, "1");
        std::ofstream(m_folder / "wall.obj") << "v -2 3 0\nv 9 3 0\nv 9 3 2.5\nv -2 3 2.5\nf 1 2 3\nf 1 3 4\n";
        writeGreyTiff(m_folder / "ground.tif", 60, 60);
        std::ofstream(m_folder / "ground.tfw") << "1\n0\n0\n-1\n-30\n30\n";
        Case theCase = io::caseForFe(m_path, m_folder / "small.rubble");
        theCase.inputs.push_back({"surroundings-1", InputRole::Surroundings, "wall.obj", {}});
        theCase.inputs.push_back({"orthophoto-1", InputRole::Orthophoto, "ground.tif",
                                  io::digestOfInput(m_folder / "ground.tif", InputRole::Orthophoto, Execution()).sha256});
        io::saveCase(m_folder / "small.rubble", theCase);
        const Outcome outcome = cli({"export", m_out, "--case", m_folder / "small.rubble", "--export", "page=" + path()});
        EXPECT_EQ(outcome.exitCode, 0) << outcome.err;
        notes = outcome.err;
    }
    std::string path() const { return m_folder / "small.html"; }

    std::string notes;

private:
    void TestBody() override {}
};

/// That page in a browser, opened anew for each test; nothing is run where there is none.
class PageLook : public PageTest<WalledPage> {
protected:
    void SetUp() override {
        PageTest::SetUp();
        if (m_browser == nullptr) {
            return;
        }
        m_notes = Shared::page()->notes;
        m_browser->open(Shared::page()->path());
        m_browser->waitFor("page.player.site.photo");
        said("page.jump(page.player.end)");
    }
    void TearDown() override {
        PageTest::TearDown();
        if (m_browser != nullptr) {
            EXPECT_EQ(said("page.player.renderer.gl.getError()"), 0);
        }
    }
    /// Pixels of the pane of the fragments that become {darker, brighter} by a change of the page.
    nlohmann::json changedBy(const std::string& change) {
        return said(
            "(() => { const player = page.player; const gl = player.renderer.gl; const pane = player.panes()[1];"
            " const pixels = () => { player.draw(); const out = new Uint8Array(4 * pane.width * pane.height);"
            " gl.readPixels(pane.x, pane.y, pane.width, pane.height, gl.RGBA, gl.UNSIGNED_BYTE, out); return out; };"
            " const before = pixels(); " +
            change +
            "; const after = pixels(); const counts = [0, 0];"
            " for (let i = 0; i < after.length; i += 4) { const by = after[i] + after[i + 1] - before[i] - before[i + 1];"
            " counts[0] += by < -12 ? 1 : 0; counts[1] += by > 12 ? 1 : 0; } return counts; })()");
    }

    std::string m_notes;
};

TEST_F(PageLook, BeginsWithMaterials) {
    if (!m_browser) {
        return;
    }
    EXPECT_EQ(said("page.player.fine"), true);
    // 2,000 kg/m3 and nobody's word: masonry, as the program guesses.
    EXPECT_THAT(said("document.getElementById('legend').textContent").get<std::string>(), HasSubstr("masonry (assumed)"));
    EXPECT_THAT(said("document.querySelector('input[value=highlight]').parentNode.textContent").get<std::string>(),
                HasSubstr("material"));
    said("document.getElementById('contrast').click()");
    EXPECT_EQ(said("page.player.fine"), false) << "high contrast keeps plain colours";
    EXPECT_THAT(said("document.getElementById('panel-look').textContent").get<std::string>(), HasSubstr("High contrast shows"));
}

TEST_F(PageLook, SunEdgesAndSurroundingsAreDrawn) {
    if (!m_browser) {
        return;
    }
    said("page.panels.lookFrom('corner')");
    const nlohmann::json unlit = changedBy("player.renderer.shadows.forEach((each) => { each.works = false; })");
    EXPECT_EQ(unlit[0], 0) << "a shadow only takes light";
    EXPECT_GT(unlit[1].get<int>(), 500);
    const nlohmann::json edged = changedBy("player.edges = false");
    EXPECT_GT(edged[1].get<int>(), 300);
    EXPECT_GT(edged[1].get<int>(), 20 * edged[0].get<int>()) << "edges are dark";
    const nlohmann::json bare = changedBy("player.site.solid = null");
    EXPECT_GT(bare[0].get<int>() + bare[1].get<int>(), 500) << "the wall";
    const nlohmann::json earth = changedBy("player.site.photo = null");
    EXPECT_GT(earth[0].get<int>() + earth[1].get<int>(), 5000) << "the picture of the ground";
    const nlohmann::json plain = changedBy("player.setStyle('analysis')");
    EXPECT_GT(plain[0].get<int>() + plain[1].get<int>(), 5000);
}

// The blocks have contours against what lies behind them; while the page moves and in analysis nothing has.
TEST_F(PageLook, WhatStandsOutHasAContourAtRest) {
    if (!m_browser) {
        return;
    }
    said("page.panels.lookFrom('corner')");
    const std::string without = "player.drawContours = () => {}";
    const nlohmann::json still = changedBy(without);
    EXPECT_EQ(still[0], 0) << "a contour only takes light";
    EXPECT_GT(still[1].get<int>(), 200);
    // They are lines: a small part of the pane, and none of them far from where depths jump.
    EXPECT_LT(still[1].get<int>(), said("page.player.panes()[1].width * page.player.panes()[1].height").get<int>() / 50);
    said("page.player.drawn = 0, page.player.drawContours = () => { ++page.player.drawn; }");
    said("page.player.glancing = true, page.player.draw(), page.player.settle()");
    EXPECT_EQ(said("page.player.drawn"), 0) << "nothing has one while it moves";
    said("page.player.draw()");
    EXPECT_EQ(said("page.player.drawn"), 2) << "both panes have them at rest";
    said("delete page.player.drawContours, page.player.setStyle('analysis')");
    EXPECT_EQ(changedBy(without), nlohmann::json::array({0, 0})) << "analysis has none";
}

TEST_F(PageLook, TheStyleIsChosenByKeysAndKeptInTheOtherLanguage) {
    if (!m_browser) {
        return;
    }
    said("document.getElementById('tab-look').click(), document.querySelector('input[name=style]:checked').focus()");
    EXPECT_EQ(said("document.activeElement.value"), "presentation");
    m_browser->press("ArrowRight");
    EXPECT_EQ(said("page.player.style"), "analysis");
    EXPECT_EQ(said("document.activeElement.value"), "analysis") << "the focus stays on what was chosen";
    EXPECT_THAT(said("document.getElementById('legend').textContent").get<std::string>(), HasSubstr("fragments"));
    said("document.getElementById('chinese').click()");
    EXPECT_EQ(said("document.querySelector('input[name=style]:checked').value"), "analysis");
    EXPECT_THAT(said("document.querySelector('input[name=style]:checked').labels[0].textContent").get<std::string>(),
                HasSubstr("分析"));
    said("document.querySelector('input[name=style]:checked').focus()");
    m_browser->press("ArrowLeft");
    EXPECT_EQ(said("page.player.style"), "presentation");
    EXPECT_THAT(said("document.getElementById('legend').textContent").get<std::string>(), HasSubstr("砌体（假定）"));
}

TEST_F(PageLook, WithoutTexturesOfDepthsThereAreNoShadows) {
    if (!m_browser) {
        return;
    }
    EXPECT_EQ(said("(() => { const gl = page.player.renderer.gl; gl.checkFramebufferStatus = () => 0;"
                   " const made = new Shadow(gl); delete gl.checkFramebufferStatus; return made.works; })()"),
              false);
    EXPECT_THAT(said("document.getElementById('panel-look').textContent").get<std::string>(), Not(HasSubstr("no shadows")));
    said("page.player.renderer.shadows.forEach((each) => { each.works = false; }), page.panels.build(), page.player.draw()");
    EXPECT_THAT(said("document.getElementById('panel-look').textContent").get<std::string>(), HasSubstr("draws no shadows"));
}

TEST_F(PageLook, SurroundingsAreMeasuredAndTold) {
    if (!m_browser) {
        return;
    }
    EXPECT_THAT(m_notes, HasSubstr("what stands around the structure, 2 triangles, lies within"));
    const std::string limits = said("document.getElementById('panel-about').textContent");
    EXPECT_THAT(limits, HasSubstr("in 2 triangles"));
    EXPECT_THAT(limits, Not(HasSubstr("do not draw what surrounds")));
    // Straight at the wall, over all that lies before it.
    const auto hit = said(R"js((() => {
        const { player } = page;
        const pane = player.panes()[0];
        const m = player.camera.matrix(pane.width / pane.height);
        const p = [8, 3, 2];
        const clip = [0, 1, 3].map((r) => m[r] * p[0] + m[4 + r] * p[1] + m[8 + r] * p[2] + m[12 + r]);
        const scale = player.canvas.clientWidth / player.canvas.width;
        return player.pickAt(scale * (pane.x + pane.width * (0.5 + 0.5 * clip[0] / clip[2])),
            scale * (player.canvas.height - pane.y - pane.height * (0.5 + 0.5 * clip[1] / clip[2])));
    })())js");
    ASSERT_TRUE(hit["point"].is_array()) << hit;
    EXPECT_EQ(hit["element"], -1);
    EXPECT_NEAR(hit["point"][1].get<double>(), 3.0, 0.01);
}

/// A cliff between the small collapse and the sun.
class PageTerrain : public SmallRun {};

TEST_F(PageTerrain, ThrowsShadowsToo) {
    if (Browser::ofAll() == nullptr) {
        std::cout << "not run: no Chromium here\n";
        return;
    }
    const std::string terrain =
        io::AsciiGrid().write(m_folder / "cliff.asc", [](double x, double) { return x < -5.0 ? 12.0 : 0.0; });
    run({"--terrain", terrain}, "0.2");
    ASSERT_EQ(cli({"export", m_out, "--export", "page=" + (m_folder / "cliff.html")}).exitCode, 0);
    Browser& browser = *Browser::ofAll();
    browser.resize(1280, 800);
    browser.open(m_folder / "cliff.html");
    browser.evaluate("page.jump(page.player.end), page.panels.lookFrom('top')");
    // Heights of the cliff between the box of what falls and the sun are within the map.
    const nlohmann::json counts = browser.evaluate(R"js((() => {
        const { player } = page;
        const gl = player.renderer.gl;
        const pane = player.panes()[1];
        const pixels = () => {
            player.draw();
            const out = new Uint8Array(4 * pane.width * pane.height);
            gl.readPixels(pane.x, pane.y, pane.width, pane.height, gl.RGBA, gl.UNSIGNED_BYTE, out);
            return out;
        };
        const before = pixels();
        const { renderer } = player;
        renderer.castShadow = (index, bounds, share, part, what) => Renderer.prototype.castShadow.call(renderer, index, bounds,
            share, part, { ...what, solids: [] });
        const after = pixels();
        const counts = [0, 0];
        for (let i = 0; i < after.length; i += 4) {
            const by = after[i] + after[i + 1] - before[i] - before[i + 1];
            counts[0] += by < -12 ? 1 : 0;
            counts[1] += by > 12 ? 1 : 0;
        }
        return [...counts, before.length / 4];
    })())js");
    EXPECT_EQ(counts[0], 0) << "a shadow only takes light";
    // The shadow of 12 m at the sun's height reaches some 8 m to the east: over the blocks.
    EXPECT_GT(counts[1].get<double>(), 0.03 * counts[2].get<double>());
    EXPECT_EQ(browser.evaluate("page.player.renderer.gl.getError()"), 0);
    EXPECT_THAT(browser.complaints(), testing::IsEmpty());
}

}  // namespace

}  // namespace rubble::cli
