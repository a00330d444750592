#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <vtkGLTFReader.h>
#include <vtkInformation.h>
#include <vtkMultiBlockDataSet.h>
#include <vtkNew.h>

#include <algorithm>
#include <cmath>
#include <filesystem>
#include <fstream>
#include <iterator>
#include <sstream>

#include "core/base/error.h"
#include "io/exports/exports.h"
#include "io/exports/gltf/body_motion.h"
#include "io/run/fragment_places.h"
#include "tests/io/run_over_fe.h"
#include "tests/io/sample_run.h"
#include "tests/support/gltf_rules.h"
#include "tests/support/temporary_folder.h"
#include "tests/support/whole_file.h"

namespace rubble::io {

namespace {

class Gltf : public testing::Test {
protected:
    void record(std::size_t clusters, std::size_t frames) {
        m_sample = makeSampleRun(7, clusters, frames);
        m_sample.feed(*createRun(m_folder / "a.run.h5", m_sample.origin));
        m_run = openRun(m_folder / "a.run.h5");
    }
    CheckedGlb exported() {
        exportGltf(m_folder / "a.glb", *m_run, nullptr, Execution());
        return checkGlb(wholeFile(m_folder / "a.glb"));
    }

    TemporaryFolder m_folder;
    SampleRun m_sample;
    std::shared_ptr<RunReader> m_run;
};

/// Value of a channel at a time, as an animation system takes it; of rotations the nearest key.
std::vector<float> valueAt(const CheckedGlb& file, std::size_t node, const std::string& path, float time) {
    const auto& animation = file.asset["animations"][0];
    for (const auto& channel : animation["channels"]) {
        if (channel["target"]["node"] != node || channel["target"]["path"] != path) {
            continue;
        }
        const auto& sampler = animation["samplers"][channel["sampler"].get<std::size_t>()];
        const auto times = file.floats(sampler["input"].get<std::size_t>());
        const auto values = file.floats(sampler["output"].get<std::size_t>());
        const std::size_t width = values.size() / times.size();
        std::size_t k = 0;
        while (k + 1 < times.size() && times[k + 1] <= time) {
            ++k;
        }
        std::vector<float> value(values.begin() + static_cast<std::ptrdiff_t>(k * width),
                                 values.begin() + static_cast<std::ptrdiff_t>((k + 1) * width));
        if (sampler["interpolation"] == "LINEAR" && k + 1 < times.size() && time > times[k]) {
            const float share = (time - times[k]) / (times[k + 1] - times[k]);
            for (std::size_t c = 0; c < width; ++c) {
                value[c] += share * (values[(k + 1) * width + c] - value[c]);
            }
        }
        return value;
    }
    return {};
}

TEST_F(Gltf, KeepsTheRulesOfTheFormat) {
    record(40, 12);
    const CheckedGlb file = exported();
    EXPECT_THAT(file.broken, testing::IsEmpty());
    EXPECT_EQ(file.asset["asset"]["extras"]["fe_sha256"], m_sample.origin.feSha256);
    EXPECT_TRUE(std::filesystem::exists(m_folder / "a.glb.provenance.json"));
}

TEST_F(Gltf, AnIslandIsANodeForAsLongAsItsBodyIsThere) {
    std::shared_ptr<const FeResult> fe;
    m_sample = runOverFe(29, 40, fe);
    const std::size_t first = m_sample.description.fragments->size();
    BodyRecord& body = m_sample.bodies.back();
    std::erase_if(m_sample.carriers, [&](const Carrier& carrier) { return carrier.body == body.body; });
    body.cluster = noCluster;
    body.from = 0.2;
    body.to = 0.4;
    const Pose inFe{Vec3(1, 2, 3), Quat(Eigen::AngleAxisd(0.4, Vec3::UnitX()))};
    m_sample.islands.push_back({body.body, 2, inFe, {idAt<ElementIndex>(first), idAt<ElementIndex>(first + 1)}});
    m_sample.firstCarriers = std::min(m_sample.firstCarriers, m_sample.carriers.size());
    m_sample.feed(*createRun(m_folder / "a.run.h5", m_sample.origin));
    m_run = openRun(m_folder / "a.run.h5");
    exportGltf(m_folder / "a.glb", *m_run, fe.get(), Execution());
    const CheckedGlb file = checkGlb(wholeFile(m_folder / "a.glb"));
    EXPECT_THAT(file.broken, testing::IsEmpty());
    const auto& nodes = file.asset["nodes"];
    std::size_t island = 0;
    for (std::size_t n = 0; n < nodes.size(); ++n) {
        island = nodes[n].value("name", "").starts_with("island") ? n : island;
    }
    ASSERT_GT(island, 0u);
    EXPECT_EQ(nodes[island]["extras"]["elements"], 2);
    for (const auto& [time, scale] :
         {std::pair(0.1f, 0.0f), std::pair(0.2f, 1.0f), std::pair(0.35f, 1.0f), std::pair(0.5f, 0.0f)}) {
        EXPECT_EQ(valueAt(file, island, "scale", time).front(), scale) << time;
    }
    const auto& primitive = file.asset["meshes"][nodes[island]["mesh"].get<std::size_t>()]["primitives"][0];
    const std::vector<float> points = file.floats(primitive["attributes"]["POSITION"].get<std::size_t>());
    ASSERT_EQ(points.size(), 3u * 2u * 24u) << "two cubes apart: six faces of four corners each";
    Aabb drawn, expected;
    for (std::size_t i = 0; i < points.size(); i += 3) {
        drawn.extend(Vec3(points[i], -points[i + 2], points[i + 1]));
    }
    for (const ElementIndex e : m_sample.islands.back().elements) {
        for (const std::uint32_t node : fe->mesh().cornersOf(e)) {
            expected.extend(inFe.inverse() * fe->state(2)->positions[node]);
        }
    }
    EXPECT_LT((drawn.min() - expected.min()).norm() + (drawn.max() - expected.max()).norm(), 1e-4);
    exportGltf(m_folder / "b.glb", *m_run, nullptr, Execution());
    EXPECT_EQ(checkGlb(wholeFile(m_folder / "b.glb")).asset["nodes"].size(), nodes.size() - 1) << "without the FE result";
}

TEST_F(Gltf, TheCheckerSeesWhatIsBroken) {
    record(10, 6);
    exportGltf(m_folder / "a.glb", *m_run, nullptr, Execution());
    const std::string good = wholeFile(m_folder / "a.glb");
    ASSERT_THAT(checkGlb(good).broken, testing::IsEmpty());
    const auto broken = [&](const std::string& from, const std::string& to) {
        std::string bytes = good;
        const std::size_t at = bytes.find(from);
        EXPECT_NE(at, std::string::npos) << from;
        bytes.replace(at, from.size(), to);
        return checkGlb(bytes).broken.size();
    };
    EXPECT_GT(broken("glTF", "glTX"), 0u);
    EXPECT_GT(broken("\"version\":\"2.0\"", "\"version\":\"1.0\""), 0u);
    EXPECT_GT(broken("\"byteOffset\":0,", "\"byteOffset\":2,"), 0u);
    EXPECT_GT(broken("\"target\":34962", "\"target\":34963"), 0u);
    EXPECT_GT(broken("\"min\":[", "\"mix\":["), 0u);
    EXPECT_GT(broken("\"interpolation\":\"LINEAR\"", "\"interpolation\":\"LUNAR2\""), 0u);
    EXPECT_GT(checkGlb(good.substr(0, good.size() - 4)).broken.size(), 0u);
}

// Places of fragments as the run has them against the nodes and meshes of the file, in its own axes.
TEST_F(Gltf, BodiesAreWhereTheRunHasThem) {
    record(25, 10);
    const CheckedGlb file = exported();
    ASSERT_THAT(file.broken, testing::IsEmpty());
    std::size_t moved = 0;
    for (std::size_t n = 1; n < file.asset["nodes"].size(); ++n) {
        const std::string name = file.asset["nodes"][n]["name"];
        const std::size_t body = std::stoul(name.substr(5));
        // Recorded places count until the body leaves or is removed.
        for (std::size_t i = 0; i < m_run->frameCount(); ++i) {
            const auto frame = m_run->frame(i);
            if (body >= frame->bodies() || frame->time <= m_sample.bodies[body].from) {
                continue;
            }
            if (frame->states[body] == BodyState::Removed || frame->time > m_sample.bodies[body].to) {
                break;
            }
            const auto place = valueAt(file, n, "translation", static_cast<float>(frame->time));
            ASSERT_EQ(place.size(), 3u) << name;
            ++moved;
            const Eigen::Vector3f& at = frame->positions[body];
            EXPECT_NEAR(place[0], at.x(), 2e-3) << name;
            EXPECT_NEAR(place[1], at.z(), 2e-3) << name;
            EXPECT_NEAR(place[2], -at.y(), 2e-3) << name;
        }
    }
    EXPECT_GT(moved, 10u);
}

TEST_F(Gltf, FragmentsAppearWhenTheyAreBorn) {
    record(25, 10);
    const CheckedGlb file = exported();
    std::size_t checked = 0;
    for (std::size_t n = 1; n < file.asset["nodes"].size(); ++n) {
        const float born = file.asset["nodes"][n]["extras"]["visible_from_s"];
        if (born > 1e-3f) {
            ++checked;
            EXPECT_EQ(valueAt(file, n, "scale", born - 1e-3f), (std::vector<float>{0, 0, 0}));
        }
        EXPECT_EQ(valueAt(file, n, "scale", born + 1e-4f), (std::vector<float>{1, 1, 1}));
    }
    EXPECT_GT(checked, 5u);
}

TEST_F(Gltf, VtkReadsIt) {
    record(20, 8);
    exportGltf(m_folder / "a.glb", *m_run, nullptr, Execution());
    vtkNew<vtkGLTFReader> reader;
    reader->SetFileName((m_folder / "a.glb").c_str());
    reader->SetFrameRate(10);
    reader->UpdateInformation();
    ASSERT_EQ(reader->GetNumberOfAnimations(), 1);
    EXPECT_GT(reader->GetAnimationDuration(0), 0.0f);
    reader->EnableAnimation(0);
    reader->Update();
    const CheckedGlb file = checkGlb(wholeFile(m_folder / "a.glb"));
    vtkIdType expected = 0;
    for (const auto& mesh : file.asset["meshes"]) {
        expected +=
            file.asset["accessors"][mesh["primitives"][0]["attributes"]["POSITION"].get<std::size_t>()]["count"].get<vtkIdType>();
    }
    EXPECT_EQ(reader->GetOutput()->GetNumberOfPoints(), expected);
}

TEST_F(Gltf, ARunWithoutFragmentsIsRefusedInWords) {
    record(0, 2);
    try {
        exported();
        FAIL() << "nothing was refused";
    } catch (const UsageError& error) {
        EXPECT_EQ(error.message().id, "io.gltf.nothing");
    }
    EXPECT_FALSE(std::filesystem::exists(m_folder / "a.glb"));
}

TEST(FewerKeys, StayWithinTheToleranceAndDropTheRest) {
    std::vector<MotionKey> keys;
    for (int i = 0; i < 200; ++i) {
        const double t = 0.04 * i;
        MotionKey key;
        key.time = t;
        const auto height = static_cast<float>(std::max(0.0, 20.0 - 4.9 * t * t));
        key.position = {static_cast<float>(t), 0.0f, height};
        key.orientation = Eigen::AngleAxisf(static_cast<float>(0.7 * t), Eigen::Vector3f::UnitY());
        if (height == 0.0f) {
            key = keys.back();
            key.time = t;
        }
        keys.push_back(key);
    }
    const MotionTolerance tolerance;
    const std::vector<MotionKey> fewer = fewerKeys(keys, tolerance);
    EXPECT_LT(fewer.size(), keys.size() / 2);
    EXPECT_EQ(fewer.front().time, keys.front().time);
    EXPECT_EQ(fewer.back().time, keys.back().time);
    for (const MotionKey& key : keys) {
        const auto after = std::find_if(fewer.begin(), fewer.end(), [&](const MotionKey& kept) { return kept.time >= key.time; });
        ASSERT_NE(after, fewer.end());
        if (after->time == key.time) {
            continue;
        }
        const MotionKey& before = *std::prev(after);
        const auto share = static_cast<float>((key.time - before.time) / (after->time - before.time));
        EXPECT_LE((before.position + share * (after->position - before.position) - key.position).norm(), tolerance.distance + 1e-6);
        EXPECT_LE(before.orientation.slerp(share, after->orientation).angularDistance(key.orientation), tolerance.angle + 1e-4);
    }
}

}  // namespace

}  // namespace rubble::io
