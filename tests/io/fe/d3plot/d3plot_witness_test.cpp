#include <gtest/gtest.h>
#include <vtkCellData.h>
#include <vtkCompositeDataIterator.h>
#include <vtkLSDynaReader.h>
#include <vtkMultiBlockDataSet.h>
#include <vtkNew.h>
#include <vtkSmartPointer.h>
#include <vtkUnsignedCharArray.h>
#include <vtkUnstructuredGrid.h>

#include <set>

#include "io/fe/fe_reader.h"
#include "tests/io/collapse_identity.h"
#include "tests/support/whole_file.h"

namespace rubble::io {

namespace {

using Places = std::multiset<std::array<float, 3>>;

/// What another reader says of a state: how many cells are dead, and where the points of the living and the dead are.
struct Witness {
    std::int64_t cells = 0, dead = 0;
    Places corners;
};

Witness witnessOf(vtkLSDynaReader& reader, int state) {
    reader.SetTimeStep(state);
    reader.Update();
    Witness witness;
    auto* blocks = vtkMultiBlockDataSet::SafeDownCast(reader.GetOutputDataObject(0));
    const auto iterator = vtkSmartPointer<vtkCompositeDataIterator>::Take(blocks->NewIterator());
    for (iterator->InitTraversal(); !iterator->IsDoneWithTraversal(); iterator->GoToNextItem()) {
        auto* grid = vtkUnstructuredGrid::SafeDownCast(iterator->GetCurrentDataObject());
        if (!grid) {
            continue;
        }
        witness.cells += grid->GetNumberOfCells();
        const auto* ghosts = vtkUnsignedCharArray::SafeDownCast(grid->GetCellData()->GetArray("vtkGhostType"));
        for (vtkIdType c = 0; c < grid->GetNumberOfCells(); ++c) {
            witness.dead += ghosts != nullptr && const_cast<vtkUnsignedCharArray*>(ghosts)->GetValue(c) != 0;
            double corner[3];
            grid->GetPoint(grid->GetCell(c)->GetPointId(0), corner);
            witness.corners.insert({static_cast<float>(corner[0]), static_cast<float>(corner[1]), static_cast<float>(corner[2])});
        }
    }
    return witness;
}

// Where VTK's reader works, it sees the same deaths and the same places. It wants the root to be named d3plot.
TEST(D3plotWitness, AnotherReaderSeesTheSame) {
    for (const char* name : {"d3plot/le32-multi", "d3plot/be64-single", "d3plot/le64-rootstates", "projectile"}) {
        const auto fe = openFe(fixture(name), {}, {}, Execution{});
        vtkNew<vtkLSDynaReader> reader;
        reader->SetFileName(fixture(name + std::string("/d3plot")).c_str());
        reader->SetRemoveDeletedCells(1);
        reader->SetDeletedCellsAsGhostArray(1);
        reader->UpdateInformation();
        ASSERT_EQ(static_cast<std::size_t>(reader->GetNumberOfTimeSteps()), fe->stateCount()) << name;
        const std::vector<std::int64_t> dead = deadPerState(*fe);
        for (std::size_t k = 0; k < fe->stateCount(); ++k) {
            const Witness witness = witnessOf(*reader, static_cast<int>(k));
            EXPECT_EQ(reader->GetTimeValue(static_cast<vtkIdType>(k)), fe->times()[k]) << name;
            EXPECT_EQ(witness.cells, static_cast<std::int64_t>(fe->mesh().elementCount())) << name;
            EXPECT_EQ(witness.dead, dead[k]) << name << ", state " << k;
            const auto state = fe->state(k);
            Places corners;
            for (std::size_t e = 0; e < fe->mesh().elementCount(); ++e) {
                const Vec3& corner = state->positions[fe->mesh().cornersOf(idAt<ElementIndex>(e))[0]];
                corners.insert({static_cast<float>(corner.x()), static_cast<float>(corner.y()), static_cast<float>(corner.z())});
            }
            EXPECT_TRUE(witness.corners == corners) << name << ", state " << k;
        }
    }
}

}  // namespace

}  // namespace rubble::io
