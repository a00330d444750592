#include "widgets/render/shapes/structure_faces.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <limits>
#include <random>
#include <set>

#include "tests/scenes/fe_scenes.h"
#include "tests/widgets/scenes/ballistic_run.h"

namespace rubble::render {
namespace {

constexpr double infinity = std::numeric_limits<double>::infinity();

using FaceKey = std::pair<ElementIndex, std::array<std::uint32_t, 4>>;

std::set<FaceKey> shown(const StructureFaces& faces, double time) {
    std::set<FaceKey> keys;
    for (const std::uint32_t i : faces.visible(faces.slotAt(time))) {
        auto nodes = faces.faces()[i].nodes;
        std::sort(nodes.begin(), nodes.end());
        EXPECT_TRUE(keys.emplace(faces.faces()[i].element, nodes).second) << "a face is there twice";
    }
    return keys;
}

/// The plain definition: faces of active elements that no other active element has.
std::set<FaceKey> byDefinition(const Mesh& mesh, const std::vector<bool>& active) {
    std::set<FaceKey> all;
    for (std::size_t e = 0; e < active.size(); ++e) {
        if (!active[e]) {
            continue;
        }
        for (const auto& local : facesOf(mesh.shapes[e])) {
            std::array<std::uint32_t, 4> nodes;
            for (std::size_t i = 0; i < 4; ++i) {
                nodes[i] = mesh.cornersOf(idAt<ElementIndex>(e))[static_cast<std::size_t>(local[i])];
            }
            std::sort(nodes.begin(), nodes.end());
            all.emplace(idAt<ElementIndex>(e), nodes);
        }
    }
    std::set<FaceKey> outer;
    for (const FaceKey& face : all) {
        const auto sharing =
            std::count_if(all.begin(), all.end(), [&](const FaceKey& other) { return other.second == face.second; });
        if (sharing == 1) {
            outer.insert(face);
        }
    }
    return outer;
}

TEST(StructureFaces, AgreeWithThePlainDefinitionWhateverDiesAndComesBack) {
    const auto fe = scenes::makeScene({{.name = "block", .size = Vec3(4, 3, 3), .cells = {4, 3, 3}}}, 6, 0.1);
    std::mt19937 engine(11);
    for (int round = 0; round < 5; ++round) {
        FeResult::Contents contents = fe->contents();
        for (std::size_t k = 0; k < fe->stateCount(); ++k) {
            for (std::size_t e = 0; e < fe->mesh().elementCount(); ++e) {
                contents.activity.set(k, idAt<ElementIndex>(e), std::uniform_int_distribution<int>(0, 2)(engine) != 0);
            }
        }
        const FeResult random(contents);
        const StructureFaces faces(random.mesh(), showTimes(random));
        for (std::size_t k = 0; k < random.stateCount(); ++k) {
            std::vector<bool> active;
            for (std::size_t e = 0; e < random.mesh().elementCount(); ++e) {
                active.push_back(random.activity().active(k, idAt<ElementIndex>(e)));
            }
            const auto expected = byDefinition(random.mesh(), active);
            EXPECT_EQ(shown(faces, random.times()[k]), expected);
            EXPECT_EQ(shown(faces, random.times()[k] + 0.0999), expected);  // up to just before the next state
        }
    }
}

TEST(StructureFaces, AllFacesAreSixToAHexahedron) {
    const auto fe = scenes::makeScene({{.size = Vec3(3, 3, 3), .cells = {3, 3, 3}}}, 2, 0.1);
    EXPECT_EQ(StructureFaces(fe->mesh(), showTimes(*fe), false).visible(0).size(), 27u * 6u);
    EXPECT_EQ(StructureFaces(fe->mesh(), showTimes(*fe)).visible(0).size(), 9u * 6u);
}

TEST(StructureFaces, ShellsShowBothSidesAndBeamsAreLines) {
    Mesh mesh;
    mesh.nodes = {Vec3(0, 0, 0), Vec3(1, 0, 0), Vec3(1, 1, 0), Vec3(0, 1, 0), Vec3(0, 0, 1)};
    mesh.shapes = {ElementShape::Quadrilateral, ElementShape::Triangle, ElementShape::Beam};
    mesh.offsets = {0, 4, 7, 9};
    mesh.corners = {0, 1, 2, 3, 0, 1, 4, 0, 4};
    mesh.elementIds = {1, 2, 3};
    const ShowTimes always{{0, 1, 2, 3}, {{-infinity, infinity}, {-infinity, infinity}, {-infinity, 2.0}}};
    const StructureFaces faces(mesh, always);
    ASSERT_EQ(faces.visible(faces.slotAt(0.0)).size(), 5u);
    EXPECT_EQ(faces.visible(faces.slotAt(2.0)).size(), 4u);
    EXPECT_EQ(faces.faces().back().nodes, (std::array<std::uint32_t, 4>{0, 4, StructureFaces::none, StructureFaces::none}));
}

TEST(StructureFaces, CollapsedElementsKeepTheirRealFaces) {
    Mesh mesh;
    mesh.nodes.assign(8, Vec3::Zero());
    mesh.shapes = {ElementShape::Hexahedron};
    mesh.offsets = {0, 8};
    mesh.corners = {0, 1, 2, 2, 4, 5, 6, 6};  // a wedge written as a hexahedron
    const StructureFaces faces(mesh, {{0, 1}, {{-infinity, infinity}}});
    EXPECT_EQ(faces.faces().size(), 5u);
    const auto triangles = std::count_if(faces.faces().begin(), faces.faces().end(),
                                         [](const auto& face) { return face.nodes[3] == StructureFaces::none; });
    EXPECT_EQ(triangles, 2);
}

TEST(ShowTimes, AnElementIsStructureUntilItIsAFragment) {
    const auto data = scenes::withoutRun(scenes::collapsingWall());
    const ShowTimes fe = showTimes(*data.fe);
    const ShowTimes born = showTimes(*data.fe, *data.fragments, false);
    const ShowTimes carried = showTimes(*data.fe, *data.fragments, true);
    EXPECT_EQ(born.spans, fe.spans);  // a state birth is the state of the death
    for (const Fragment& f : data.fragments->list) {
        ASSERT_EQ(carried.of(f.element).size(), 1u);
        EXPECT_EQ(carried.of(f.element).back().to, f.handOverTime);
    }
}

TEST(ShowTimes, AFragmentThatEndsGivesItsElementBack) {
    auto data = scenes::withoutRun(scenes::makeScene({{.cells = {1, 1, 1}}}, 6, 1.0));
    FeResult::Contents contents = data.fe->contents();
    for (const std::size_t k : {2u, 3u}) {
        contents.activity.set(k, idAt<ElementIndex>(0), false);
    }
    const FeResult revived(contents);
    FragmentSet fragments;
    Fragment fragment;
    fragment.handOverTime = 1.0;
    fragment.birthTime = 2.0;
    fragment.endTime = 4.0;
    fragments.list.push_back(fragment);
    const ShowTimes follow = showTimes(revived, fragments, true);
    EXPECT_EQ(follow.spans, (std::vector<TimeSpan>{{-infinity, 1.0}, {4.0, infinity}}));
    fragments.list[0].endTime = infinity;  // latched
    EXPECT_EQ(showTimes(revived, fragments, true).spans, (std::vector<TimeSpan>{{-infinity, 1.0}}));
    EXPECT_EQ(showTimes(revived, fragments, false).spans, (std::vector<TimeSpan>{{-infinity, 2.0}}));
}

TEST(StructureFaces, FollowFromSlotToSlotWhatIsVisibleInEach) {
    scenes::Block block{.size = Vec3(4, 3, 3), .cells = {4, 3, 3}};
    block.deathState = [](std::size_t e) { return 1 + e * 5 % 11; };
    const auto fe = scenes::makeScene({block}, 12, 0.1);
    const StructureFaces faces(fe->mesh(), showTimes(*fe));
    ASSERT_GT(faces.slotCount(), 8u);
    std::mt19937 random(23);
    std::uniform_int_distribution<std::size_t> any(0, faces.slotCount() - 1);
    std::size_t slot = 0;
    std::vector<std::uint32_t> visible = faces.visible(slot);
    for (int i = 0; i < 100; ++i) {
        const std::size_t to = any(random);
        faces.follow(visible, slot, to);
        EXPECT_EQ(visible, faces.visible(to)) << slot << " to " << to;
        slot = to;
    }
}

}  // namespace
}  // namespace rubble::render
