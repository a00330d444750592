#include "tests/io/run_over_fe.h"

#include <gtest/gtest.h>
#include <vtkCellData.h>
#include <vtkPoints.h>
#include <vtkUnstructuredGrid.h>

#include <algorithm>
#include <utility>

#include "core/fe/mesh.h"

namespace rubble::io {

namespace {

class ShiftingSource : public StateSource {
public:
    ShiftingSource(const Mesh& mesh, std::function<void(std::size_t)> onRead) : m_mesh(mesh), m_onRead(std::move(onRead)) {}
    FeState read(std::size_t k) const override {
        if (m_onRead) {
            m_onRead(k);
        }
        FeState state;
        for (const Vec3& node : m_mesh.nodes) {
            state.positions.push_back(node + Vec3(0, 0, -0.5 * static_cast<double>(k)));
        }
        return state;
    }

private:
    const Mesh& m_mesh;
    std::function<void(std::size_t)> m_onRead;
};

}  // namespace

std::shared_ptr<const FeResult> makeFe(const SampleRun& run, std::size_t survivors, std::size_t states,
                                       std::function<void(std::size_t)> onRead) {
    auto mesh = std::make_shared<Mesh>();
    const FragmentSet& fragments = *run.description.fragments;
    for (std::size_t e = 0; e < fragments.size() + survivors; ++e) {
        mesh->offsets.push_back(static_cast<std::uint32_t>(mesh->corners.size()));
        for (int corner = 0; corner < 8; ++corner) {
            mesh->corners.push_back(static_cast<std::uint32_t>(mesh->nodes.size()));
            const double x = 3.0 * static_cast<double>(e) + ((corner & 1) ^ ((corner >> 1) & 1));
            mesh->nodes.emplace_back(x, (corner >> 1) & 1, corner >> 2);
            mesh->nodeIds.push_back(static_cast<std::int64_t>(mesh->nodes.size()));
        }
        mesh->elementIds.push_back(static_cast<std::int64_t>(1000 + e));
        mesh->shapes.push_back(ElementShape::Hexahedron);
        mesh->part.push_back(0);
        mesh->density.push_back(2400);
        mesh->section.push_back(0);
    }
    mesh->offsets.push_back(static_cast<std::uint32_t>(mesh->corners.size()));
    mesh->parts.push_back({"all", 1});
    FeResult::Contents contents;
    contents.activity = Activity(states, mesh->elementCount());
    for (std::size_t k = 0; k < states; ++k) {
        contents.times.push_back(0.1 * static_cast<double>(k));
        for (std::size_t e = 0; e < mesh->elementCount(); ++e) {
            const bool dead = e < fragments.size() && k >= fragments.list[e].birthState;
            contents.activity.set(k, idAt<ElementIndex>(e), !dead);
        }
    }
    contents.source = std::make_shared<ShiftingSource>(*mesh, std::move(onRead));
    contents.mesh = std::move(mesh);
    contents.path = "made-up.exo";
    return std::make_shared<FeResult>(std::move(contents));
}

SampleRun runOverFe(std::uint32_t seed, std::size_t frames, std::shared_ptr<const FeResult>& fe) {
    SampleRun run = makeSampleRun(seed, 30, frames);
    run.origin.scenario.regrouping.clear();
    run.islands.clear();
    fe = makeFe(run, 5, 7);
    run.description.fe = fe;
    return run;
}

void expectFragments(vtkUnstructuredGrid& grid, const SampleRun& run, const TrajectoryReader& trajectory, double time) {
    const FragmentSet& fragments = *run.description.fragments;
    const TrajectoryFrame frame = frameAtTime(trajectory, time);
    std::size_t expected = 0;
    for (const Carrier& carrier : run.carriers) {
        expected +=
            carrier.from <= time && fragments.list[at(carrier.fragment)].birthTime <= time && at(carrier.body) < frame.bodies();
    }
    std::size_t found = 0;
    const auto component = [](const Pose& p) {
        Eigen::Affine3d m = Eigen::Affine3d::Identity();
        m.linear() = p.orientation.normalized().toRotationMatrix();
        m.translation() = p.position;
        return m;
    };
    for (vtkIdType c = 0; c < grid.GetNumberOfCells(); ++c) {
        const double number = grid.GetCellData()->GetArray("fragment_id")->GetTuple1(c);
        if (number < 0.0) {
            continue;
        }
        ++found;
        const auto f = static_cast<std::size_t>(number);
        const Carrier& carrier =
            *std::find_if(run.carriers.begin(), run.carriers.end(), [f](const Carrier& k) { return at(k.fragment) == f; });
        const std::size_t b = at(carrier.body);
        const Eigen::Affine3d place = component({frame.positions[b].cast<double>(), frame.orientations[b].cast<double>()}) *
                                      component(carrier.handOverToBody);
        vtkPoints* points = grid.GetCell(c)->GetPoints();
        const auto vertices = fragments.verticesOf(idAt<FragmentId>(f));
        ASSERT_EQ(static_cast<std::size_t>(points->GetNumberOfPoints()), vertices.size());
        for (std::size_t v = 0; v < vertices.size(); ++v) {
            const Vec3 p = place * vertices[v] + Vec3(100000, -200000, 3);
            const double* read = points->GetPoint(static_cast<vtkIdType>(v));
            // Poses are single precision in the run file: 1e-7 of some 200 m, twice.
            EXPECT_LT((Vec3(read[0], read[1], read[2]) - p).norm(), 1e-4);
        }
        EXPECT_EQ(grid.GetCellData()->GetArray("element_id")->GetTuple1(c), 1000.0 + static_cast<double>(f));
        EXPECT_EQ(grid.GetCellData()->GetArray("component")->GetTuple1(c), static_cast<double>(f % 3));
        EXPECT_EQ(grid.GetCellData()->GetArray("cluster_id")->GetTuple1(c),
                  static_cast<double>(at(run.description.clustering->of[f])));
        EXPECT_FLOAT_EQ(static_cast<float>(grid.GetCellData()->GetArray("speed")->GetTuple1(c)), frame.speeds[b]);
    }
    EXPECT_EQ(found, expected) << time;
}

}  // namespace rubble::io
