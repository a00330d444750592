#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <zlib.h>

#include <array>
#include <cmath>
#include <cstring>
#include <fstream>
#include <map>

#include "core/base/build.h"
#include "core/base/error.h"
#include "core/fe/mesh.h"
#include "io/base/base64.h"
#include "io/exports/page/page_export.h"
#include "io/exports/page/page_scene.h"
#include "io/exports/page/page_site.h"
#include "io/run/fragment_places.h"
#include "tests/io/run_over_fe.h"
#include "tests/io/sample_run.h"
#include "tests/scenes/validation_records.h"
#include "tests/support/temporary_folder.h"
#include "tests/support/whole_file.h"

namespace rubble::io {

namespace {

using nlohmann::json;

std::string between(const std::string& text, const std::string& from, const std::string& to) {
    const std::size_t begin = text.find(from) + from.size();
    return text.substr(begin, text.find(to, begin) - begin);
}

/// A page read by its own rules, without the writer's code.
class ReadPage {
public:
    explicit ReadPage(const std::string& text) : facts(json::parse(between(text, "id=\"facts\">", "</script>"))) {
        std::string packed;
        EXPECT_TRUE(decodeBase64(between(text, "id=\"data\">", "</script>"), packed));
        m_bytes.resize(facts["scene"]["dataBytes"].get<std::size_t>());
        uLongf size = m_bytes.size();
        EXPECT_EQ(uncompress(m_bytes.data(), &size, reinterpret_cast<const Bytef*>(packed.data()), packed.size()), Z_OK);
        EXPECT_EQ(size, m_bytes.size());
    }

    std::vector<double> numbers(const std::string& name) const {
        const json& entry = facts["scene"]["arrays"][name];
        std::vector<double> out(entry["count"].get<std::size_t>());
        EXPECT_EQ(entry["type"], "f64");
        std::memcpy(out.data(), m_bytes.data() + entry["at"].get<std::size_t>(), out.size() * sizeof(double));
        return out;
    }
    std::vector<std::int64_t> integers(const std::string& name) const {
        const json& entry = facts["scene"]["arrays"][name];
        std::vector<std::int64_t> out;
        const std::uint8_t* at = m_bytes.data() + entry["at"].get<std::size_t>();
        while (out.size() < entry["count"].get<std::size_t>()) {
            std::uint64_t value = 0;
            for (int shift = 0;; shift += 7) {
                value |= static_cast<std::uint64_t>(*at & 0x7fu) << shift;
                if ((*at++ & 0x80u) == 0) {
                    break;
                }
            }
            out.push_back(static_cast<std::int64_t>(value >> 1) ^ -static_cast<std::int64_t>(value & 1));
        }
        return out;
    }
    std::vector<std::uint8_t> octets(const std::string& name) const {
        const json& entry = facts["scene"]["arrays"][name];
        const auto from = m_bytes.begin() + entry["at"].get<std::ptrdiff_t>();
        return {from, from + entry["count"].get<std::ptrdiff_t>()};
    }
    std::vector<std::int64_t> steps(const std::string& name) const {
        std::vector<std::int64_t> out = integers(name);
        for (std::size_t i = 1; i < out.size(); ++i) {
            out[i] += out[i - 1];
        }
        return out;
    }

    std::vector<std::int64_t> runs(const std::string& name) const {
        std::vector<std::int64_t> out;
        const std::vector<std::int64_t> packed = integers(name);
        for (auto number = packed.begin(); number != packed.end(); ++number) {
            out.push_back(*number);
            if (out.back() == 0) {
                ++number;
                out.insert(out.end(), static_cast<std::size_t>(*number), 0);
            }
        }
        return out;
    }

    json facts;

private:
    std::vector<std::uint8_t> m_bytes;
};

/// Places of the bodies of a page at a time, by its keys.
class PlayedBodies {
public:
    explicit PlayedBodies(const ReadPage& page) : m_instants(page.numbers("instants")), m_step(page.facts["scene"]["placeStep"]) {
        const auto counts = page.integers("keyCounts");
        const auto numbers = page.integers("keys");
        std::size_t at = 0;
        for (const std::int64_t count : counts) {
            ++at;  // bits of the turn
            std::array<std::int64_t, 8> now{};
            m_keys.emplace_back();
            for (std::int64_t k = 0; k < count; ++k) {
                for (std::int64_t& number : now) {
                    number += numbers[at++];
                }
                m_keys.back().push_back(now);
            }
        }
        EXPECT_EQ(at, numbers.size());
    }
    Pose at(std::size_t body, double time) const {
        const auto& keys = m_keys[body];
        std::size_t k = 0;
        while (k + 1 < keys.size() && timeOf(keys[k + 1]) <= time) {
            ++k;
        }
        const Pose from = poseOf(keys[k]);
        if (k + 1 == keys.size() || time <= timeOf(keys[k])) {
            return from;
        }
        const Pose to = poseOf(keys[k + 1]);
        const double share = (time - timeOf(keys[k])) / (timeOf(keys[k + 1]) - timeOf(keys[k]));
        return {from.position + share * (to.position - from.position), from.orientation.slerp(share, to.orientation)};
    }

private:
    using Key = std::array<std::int64_t, 8>;
    double timeOf(const Key& key) const { return m_instants[static_cast<std::size_t>(key[0])]; }
    Pose poseOf(const Key& key) const {
        const auto number = [&](std::size_t i) { return static_cast<double>(key[i]); };
        return {m_step * Vec3(number(1), number(2), number(3)), Quat(number(7), number(4), number(5), number(6)).normalized()};
    }

    std::vector<double> m_instants;
    double m_step;
    std::vector<std::vector<Key>> m_keys;
};

class Page : public testing::Test {
protected:
    void record(std::size_t frames, std::size_t fed) {
        m_sample = runOverFe(11, frames, m_fe);
        m_sample.feed(*createRun(m_folder / "a.run.h5", m_sample.origin), fed);
        m_run = openRun(m_folder / "a.run.h5");
    }
    /// The same with what else was found in the simulation.
    void recordFound(const Message& what, const Message& remedy) {
        m_sample = runOverFe(11, 12, m_fe);
        m_sample.result.findings.add(what, remedy, "");
        m_sample.feed(*createRun(m_folder / "a.run.h5", m_sample.origin));
        m_run = openRun(m_folder / "a.run.h5");
    }
    ReadPage exported(PageExtras extras = {}) {
        m_report = exportPage(m_folder / "a.html", *m_run, *m_fe, extras, Execution());
        m_text = wholeFile(m_folder / "a.html");
        return ReadPage(m_text);
    }

    TemporaryFolder m_folder;
    std::shared_ptr<const FeResult> m_fe;
    SampleRun m_sample;
    std::shared_ptr<RunReader> m_run;
    PageReport m_report;
    std::string m_text;
};

// A page is read by people who have neither files nor command line before them.
TEST_F(Page, RemediesNameSettingsAsTheirFieldsDo) {
    recordFound({"test.held", "{0} were held", {3}},
                {"test.held.remedy", "raise step_rate or substeps, or set auto_remedy = true", {}});
    const ReadPage page = exported();
    std::string remedies;
    for (const json& finding : page.facts["findings"]) {
        remedies += finding["remedy"]["en"].get<std::string>() + "\n";
    }
    EXPECT_THAT(remedies, testing::HasSubstr("raise “Steps per second” or “Substeps”, or set “"));
    EXPECT_THAT(remedies, testing::HasSubstr("” = on"));
    EXPECT_THAT(remedies, testing::Not(testing::HasSubstr("_")));
}

/// Corners of all pieces, m, in the frames of their bodies.
std::vector<Vec3> cornersOf(const ReadPage& page) {
    const auto numbers = page.integers("pieceCorners");
    const double step = page.facts["scene"]["cornerStep"];
    std::vector<Vec3> corners;
    Vec3 now = Vec3::Zero();
    for (std::size_t i = 0; i < numbers.size(); i += 3) {
        now +=
            step * Vec3(static_cast<double>(numbers[i]), static_cast<double>(numbers[i + 1]), static_cast<double>(numbers[i + 2]));
        corners.push_back(now);
    }
    return corners;
}

/// Corners of the fragments that a page shows at a time.
std::map<std::size_t, std::vector<Vec3>> shownAt(const ReadPage& page, const PlayedBodies& bodies, double time) {
    const auto bodyOf = page.steps("pieceBodies");
    const auto fragmentOf = page.steps("pieceFragments");
    const auto times = page.numbers("pieceTimes");
    const auto from = page.steps("pieceFrom");
    const auto to = page.steps("pieceTo");
    const auto ends = page.numbers("bodyEnds");
    const auto shapes = page.octets("pieceShapes");
    const std::vector<Vec3> corners = cornersOf(page);
    std::map<std::size_t, std::vector<Vec3>> shown;
    std::size_t corner = 0;
    for (std::size_t p = 0; p < bodyOf.size(); ++p) {
        const auto count = page.facts["scene"]["cornerCounts"][shapes[p]].get<std::size_t>();
        for (std::size_t c = 0; c < count; ++c, ++corner) {
            const double end = std::min(times[static_cast<std::size_t>(to[p])], ends[static_cast<std::size_t>(bodyOf[p])]);
            if (times[static_cast<std::size_t>(from[p])] <= time && time < end) {
                shown[static_cast<std::size_t>(fragmentOf[p])].push_back(bodies.at(static_cast<std::size_t>(bodyOf[p]), time) *
                                                                         corners[corner]);
            }
        }
    }
    return shown;
}

TEST_F(Page, FragmentsLieWhereTheRunHasThemAtEveryFrame) {
    record(24, 24);
    const ReadPage page = exported();
    EXPECT_LE(m_report.placeError, 5e-3);
    EXPECT_EQ(page.facts["precision"]["place"], m_report.placeError);
    EXPECT_TRUE(page.facts.contains("north"));
    EXPECT_TRUE(page.facts["north"].is_null()) << "nobody said where north is";
    const PlayedBodies bodies(page);
    const FragmentPlaces places(*m_run);
    const std::vector<BodyRecord> records = m_run->bodies();
    std::vector<bool> gone(records.size(), false);
    std::size_t compared = 0;
    double worst = 0.0;
    for (std::size_t i = 0; i < m_run->frameCount(); ++i) {
        const double time = m_run->frameTime(i);
        const auto shown = shownAt(page, bodies, time);
        const auto there = places.at(time);
        const auto frame = m_run->frame(i);
        for (std::size_t body = 0; body < frame->bodies(); ++body) {
            gone[body] = gone[body] || frame->states[body] == BodyState::Removed || !frame->positions[body].allFinite();
        }
        EXPECT_LE(shown.size(), there.size()) << time;
        for (const auto& each : there) {
            const auto vertices = places.fragments().verticesOf(each.fragment);
            // What has left the engine does not come back; at its entry a body is at its birth place, which made-up frames have
            // not.
            const std::size_t body = at(each.body);
            if (gone[body] || time <= records[body].from || time >= records[body].to) {
                continue;
            }
            ASSERT_TRUE(shown.contains(at(each.fragment))) << time;
            const auto& drawn = shown.at(at(each.fragment));
            for (std::size_t c = 0; c < vertices.size(); ++c, ++compared) {
                worst = std::max(worst, (drawn[c] - each.fromHandOver * vertices[c]).norm());
            }
        }
    }
    EXPECT_GT(compared, 100u);
    // Single precision of the recorded places is all that may come on top.
    EXPECT_LE(worst, m_report.placeError + 1e-5);
    EXPECT_GT(worst, 0.1 * m_report.placeError);
}

TEST_F(Page, NodesLieWhereTheResultHasThem) {
    record(12, 12);
    const ReadPage page = exported();
    const auto numbers = page.runs("nodes");
    const std::size_t nodes = m_fe->mesh().nodeCount();
    const std::size_t states = page.numbers("stateTimes").size();
    ASSERT_EQ(numbers.size(), 3 * nodes * states);
    ASSERT_EQ(states, m_fe->stateCount());
    std::vector<std::int64_t> places(numbers.size());
    for (std::size_t i = 0; i < numbers.size(); ++i) {
        const std::size_t width = 3 * nodes;
        std::int64_t expected = 0;
        if (i >= 2 * width) {
            expected = 2 * places[i - width] - places[i - 2 * width];
        } else if (i >= width) {
            expected = places[i - width];
        } else if (i % nodes > 0) {
            expected = places[i - 1];
        }
        places[i] = numbers[i] + expected;
    }
    const double step = page.facts["scene"]["nodeStep"];
    double worst = 0.0;
    for (std::size_t k = 0; k < states; ++k) {
        const auto state = m_fe->state(k);
        for (std::size_t e = 0; e < m_fe->mesh().elementCount(); ++e) {
            if (!m_fe->activity().active(k, idAt<ElementIndex>(e))) {
                continue;
            }
            for (const std::uint32_t node : m_fe->mesh().cornersOf(idAt<ElementIndex>(e))) {
                for (std::size_t c = 0; c < 3; ++c) {
                    const double shown = step * static_cast<double>(places[(3 * k + c) * nodes + node]);
                    worst = std::max(worst, std::abs(shown - state->positions[node][static_cast<int>(c)]));
                }
            }
        }
    }
    EXPECT_LE(worst, m_report.nodeError + 1e-9);
    EXPECT_LE(m_report.nodeError, 2e-3);
}

TEST_F(Page, StatesThatAreLeftOutArePlayedAndTheirErrorIsTold) {
    record(12, 12);
    PagePrecision few;
    few.placesMost = 3 * m_fe->mesh().nodeCount() * 3;
    const PageScene scene = pageScene(*m_run, *m_fe, few, Execution());
    ASSERT_EQ(m_fe->stateCount(), 7u);
    ASSERT_EQ(scene.statesThere, 7u);
    ASSERT_EQ(scene.statesKept, 3u) << "0, 3 and 6";
    // What dies before the next state that is kept waits at the one before.
    double worst = 0.0;
    for (const std::size_t first : {0u, 3u}) {
        for (std::size_t k = first + 1; k < first + 3; ++k) {
            for (std::size_t e = 0; e < m_fe->mesh().elementCount(); ++e) {
                const auto active = [&](std::size_t state) { return m_fe->activity().active(state, idAt<ElementIndex>(e)); };
                for (const std::uint32_t node : m_fe->mesh().cornersOf(idAt<ElementIndex>(e))) {
                    const Vec3 from = m_fe->state(first)->positions[node];
                    const double share = active(first + 3) ? static_cast<double>(k - first) / 3.0 : 0.0;
                    const Vec3 shown = from + share * (m_fe->state(first + 3)->positions[node] - from);
                    const double error = (shown - m_fe->state(k)->positions[node]).norm();
                    worst = std::max(worst, active(k) && active(first) ? error : 0.0);
                }
            }
        }
    }
    EXPECT_GT(worst, 0.4) << "nodes fall half a metre from state to state";
    EXPECT_NEAR(scene.nodeErrorBetween, worst, 2.0 * few.nodeStep);
    EXPECT_LE(scene.nodeError, few.nodeStep);
    EXPECT_EQ(pageScene(*m_run, *m_fe, {}, Execution()).nodeErrorBetween, 0.0) << "all states are kept";
}

TEST_F(Page, NoMoreStatesAreKeptThanABrowserHolds) {
    record(6, 6);
    for (const std::size_t most : {2u, 3u, 4u, 5u, 6u, 7u, 8u}) {
        PagePrecision few;
        few.placesMost = 3 * m_fe->mesh().nodeCount() * most;
        EXPECT_LE(pageScene(*m_run, *m_fe, few, Execution()).statesKept, most);
    }
}

TEST_F(Page, CoarseStepsAreTightenedUntilPlacesLieWithinTheBound) {
    record(12, 12);
    const PagePrecision coarse{0.02, 0.01, 0.04, 0.02, 0.02, PagePrecision().placesMost};
    const PageScene scene = pageScene(*m_run, *m_fe, coarse, Execution());
    EXPECT_LE(scene.placeError, pageErrorMost);
    EXPECT_LE(scene.nodeError, pageErrorMost);
    EXPECT_LT(scene.about["nodeStep"].get<double>(), coarse.nodeStep);
    const PagePrecision hopeless{20.0, 10.0, 40.0, 20.0, 20.0, PagePrecision().placesMost};
    try {
        pageScene(*m_run, *m_fe, hopeless, Execution());
        FAIL() << "nothing was refused";
    } catch (const UsageError& error) {
        EXPECT_EQ(error.message().id, "io.page.coarse");
        EXPECT_FALSE(error.remedy().empty());
    }
}

TEST_F(Page, ValidationIsThatOfTheBuildThatSimulated) {
    record(8, 8);
    PageExtras extras;
    extras.validation = {scenes::tossRecord()};
    EXPECT_TRUE(exported(extras).facts["validation"].is_null()) << "another build simulated";
    m_sample.origin.build = buildText();
    m_sample.feed(*createRun(m_folder / "own.run.h5", m_sample.origin), 8);
    m_run = openRun(m_folder / "own.run.h5");
    EXPECT_TRUE(exported().facts["validation"].is_null()) << "it was held against nothing";
    const json facts = exported(extras).facts["validation"];
    ASSERT_EQ(facts.size(), 2u);
    EXPECT_EQ(facts[0]["falls"], 32);
    EXPECT_EQ(facts[0]["lost"], 3);
    EXPECT_EQ(facts[0]["asked"], 1);
    EXPECT_EQ(facts[0]["holds"], 0);
    EXPECT_EQ(facts[1]["holds"], 1);
    EXPECT_EQ(facts[0]["quantities"][0]["name"]["en"], "run-out, Plate");
    EXPECT_EQ(facts[0]["quantities"][0]["error"], -0.25);
    EXPECT_EQ(facts[0]["quantities"][0]["high"], -0.125);
}

TEST_F(Page, SurroundingsThatTheViewsDoNotDrawAreNamed) {
    record(8, 8);
    EXPECT_EQ(exported().facts["around"]["names"], json::array());
    m_sample.origin.surroundings = {{"/site/roof.obj", "aa", Vec3::Zero()}};
    m_sample.feed(*createRun(m_folder / "roof.run.h5", m_sample.origin), 8);
    m_run = openRun(m_folder / "roof.run.h5");
    PageExtras extras;
    extras.around = {{"orthophoto", "/site/ortho.tif", "bb"}};
    const json facts = exported(extras).facts["around"];
    EXPECT_EQ(facts["names"], (json::array({"ortho.tif", "roof.obj"})));
    EXPECT_EQ(facts["fallenOn"], true);
}

TEST_F(Page, SurroundingsOfTheViewsLieWhereTheirFilesHaveThem) {
    record(8, 8);
    SiteMesh mesh;
    mesh.points = {{-8.1234, 6.0, -1.0}, {812345.6789, 6.0, -1.0}, {8.0, -600.00099, 4.0007}};
    mesh.triangles = {{0, 1, 2}, {2, 1, 0}};
    PageExtras extras;
    extras.surroundings = std::make_shared<std::vector<SiteMesh>>(2, mesh);
    extras.around = {{"surroundings", "/site/wall.obj", "bb"}, {"orthophoto", "/site/ortho.tif", "cc"}};
    const ReadPage page = exported(extras);
    EXPECT_EQ(page.facts["around"]["names"], json::array({"ortho.tif"})) << "there is no picture of the ground";
    EXPECT_EQ(page.facts["precision"]["siteTriangles"], 4);
    EXPECT_EQ(m_report.siteTriangles, 4u);
    EXPECT_EQ(page.steps("siteCorners"), (std::vector<std::int64_t>{0, 1, 2, 2, 1, 0, 3, 4, 5, 5, 4, 3}));
    const auto numbers = page.integers("sitePoints");
    const double step = page.facts["scene"]["site"]["step"];
    ASSERT_EQ(numbers.size(), 18u);
    Eigen::Matrix<std::int64_t, 3, 1> at = Eigen::Matrix<std::int64_t, 3, 1>::Zero();
    for (std::size_t i = 0; i < 6; ++i) {
        at += Eigen::Matrix<std::int64_t, 3, 1>(numbers[3 * i], numbers[3 * i + 1], numbers[3 * i + 2]);
        EXPECT_LE((step * at.cast<double>() - mesh.points[i % 3]).norm(), m_report.siteError + 1e-9) << i;
    }
    EXPECT_GT(m_report.siteError, 1e-4);
    EXPECT_LE(m_report.siteError, pageErrorMost);
    extras.orthophoto = std::make_shared<const Orthophoto>(Orthophoto{-10.0, -20.0, 0.5, 4096, 100, {}});
    extras.pictures = {{PagePictureKind::Ground, 0.0, {}, "image/jpeg", "x", {}}};
    const json facts = exported(extras).facts;
    EXPECT_EQ(facts["around"]["names"], json::array());
    EXPECT_EQ(facts["ground"]["picture"]["pixel"], 1.0) << "of 4,096 pixels 2,048 are taken";
    EXPECT_EQ(facts["ground"]["picture"]["width"], 2048.0);
}

TEST_F(Page, SurroundingsOfTooManyTrianglesAreLeftOutAndNamed) {
    record(8, 8);
    SiteMesh mesh;
    mesh.points = {Vec3::Zero(), Vec3::UnitX(), Vec3::UnitY()};
    mesh.triangles.assign(pageSiteTrianglesMost + 1, {0, 1, 2});
    PageExtras extras;
    extras.surroundings = std::make_shared<std::vector<SiteMesh>>(1, mesh);
    extras.around = {{"surroundings", "/site/town.obj", "bb"}};
    const json facts = exported(extras).facts;
    EXPECT_EQ(facts["around"]["names"], json::array({"town.obj"}));
    EXPECT_EQ(facts["around"]["large"], true);
    EXPECT_TRUE(facts["scene"]["site"].is_null());
    EXPECT_TRUE(m_report.siteLeftOut);
}

TEST_F(Page, ABookmarkOutsideOfTheRunIsMarked) {
    record(8, 8);
    Case theCase;
    theCase.bookmarks = {{0.2, "within"}, {99.0, "after"}, {-1.0, "before"}};
    theCase.inputs = {{"north", InputRole::Photograph, "north.png", "aa"}};
    PageExtras extras;
    extras.theCase = &theCase;
    const ReadPage page = exported(extras);
    for (const json& chapter : page.facts["chapters"]) {
        const std::string note = chapter.value("note", "");
        EXPECT_EQ(chapter.value("outside", false), note == "after" || note == "before") << chapter;
    }
    EXPECT_EQ(page.facts["photographs"], 1);
    EXPECT_TRUE(exported().facts["photographs"].is_null()) << "there is no case";
}

TEST_F(Page, SettingsHaveNamesAndValuesInBothLanguages) {
    m_sample = runOverFe(11, 8, m_fe);
    m_sample.origin.scenario.simulation.substeps = 3;
    m_sample.feed(*createRun(m_folder / "a.run.h5", m_sample.origin), 8);
    m_run = openRun(m_folder / "a.run.h5");
    PageExtras extras;
    extras.chinese = [](const Message& message) { return "zh:" + message.pattern; };
    const ReadPage page = exported(extras);
    ASSERT_FALSE(page.facts["provenance"]["settings"].empty());
    for (const json& row : page.facts["provenance"]["settings"]) {
        EXPECT_EQ(row["label"]["zh"], "zh:" + row["label"]["en"].get<std::string>());
        EXPECT_TRUE(row["run"].contains("zh")) << row;
    }
    EXPECT_EQ(page.facts["provenance"]["coordinates"]["zh"], "zh:metres, z up, origin of the frame added");
}

TEST_F(Page, ARunThatWasStoppedSaysSo) {
    record(20, 9);
    const ReadPage page = exported();
    EXPECT_EQ(page.facts["outcome"]["complete"], false);
    EXPECT_EQ(page.facts["outcome"]["frames"], 9);
    EXPECT_EQ(page.facts["outcome"]["end"], m_run->frameTime(8));
}

TEST_F(Page, ReadersWithoutScriptsReadItsCautions) {
    record(20, 9);
    PageExtras extras;
    extras.chinese = [](const Message& message) { return "<" + message.id + ">"; };
    const ReadPage page = exported(extras);
    const std::string read = between(m_text, "<div id=\"warnings\">", "</div>");
    EXPECT_GE(page.facts["cautions"].size(), 2u);
    for (const json& caution : page.facts["cautions"]) {
        EXPECT_NE(read.find("lang=\"zh-CN\">&lt;" + between(caution["what"]["zh"], "<", ">") + "&gt;。</p>"), std::string::npos)
            << read;
    }
    EXPECT_NE(read.find("<p role=\"note\">Not complete: the run goes up to"), std::string::npos) << read;
    EXPECT_EQ(m_text.find("{{"), std::string::npos) << "every place of the frame is filled";
}

TEST_F(Page, NotesOfTheAuthorCannotBecomePartOfThePage) {
    record(8, 8);
    Case theCase;
    theCase.bookmarks = {{0.2, "</script><img src=x onerror=alert(1)> {{data}}"}};
    PageExtras extras;
    extras.theCase = &theCase;
    extras.title = "<b>Bridge & Co</b>";
    const ReadPage page = exported(extras);
    EXPECT_EQ(m_text.find("<img src=x"), std::string::npos);
    EXPECT_EQ(m_text.find("<b>Bridge"), std::string::npos);
    bool found = false;
    for (const json& chapter : page.facts["chapters"]) {
        found = found || chapter.value("note", "") == theCase.bookmarks.front().note;
    }
    EXPECT_TRUE(found);
}

TEST_F(Page, MoreThanABrowserHoldsIsRefusedWithARemedy) {
    record(6, 6);
    const auto large = makeFe(m_sample, pagePiecesMost, 2);
    try {
        exportPage(m_folder / "large.html", *m_run, *large, {}, Execution());
        FAIL() << "nothing was refused";
    } catch (const UsageError& error) {
        EXPECT_EQ(error.message().id, "io.page.large");
        EXPECT_FALSE(error.remedy().empty());
    }
}

TEST_F(Page, ACancelLeavesNothing) {
    record(10, 10);
    const Execution execution;
    execution.cancel();
    EXPECT_THROW(exportPage(m_folder / "a.html", *m_run, *m_fe, {}, execution), Cancelled);
    EXPECT_FALSE(std::ifstream(m_folder / "a.html").good());
}

}  // namespace

}  // namespace rubble::io
