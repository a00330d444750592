#include <gtest/gtest.h>
#include <vtkCellData.h>
#include <vtkDataArray.h>
#include <vtkExodusIIReader.h>
#include <vtkFieldData.h>
#include <vtkInformation.h>
#include <vtkMultiBlockDataSet.h>
#include <vtkNew.h>
#include <vtkPointData.h>
#include <vtkStreamingDemandDrivenPipeline.h>
#include <vtkUnstructuredGrid.h>
#include <vtkXMLUnstructuredGridReader.h>

#include <array>
#include <filesystem>
#include <fstream>
#include <regex>
#include <set>

#include "io/exports/convert/fe_conversion.h"
#include "io/fe/fe_reader.h"
#include "tests/io/exports/convert/mixed_result.h"
#include "tests/support/temporary_folder.h"
#include "tests/support/whole_file.h"

namespace rubble::io {
namespace {

std::set<std::int64_t> deadOf(const FeResult& fe, std::size_t k) {
    std::set<std::int64_t> dead;
    for (std::size_t e = 0; e < fe.mesh().elementCount(); ++e) {
        if (!fe.activity().active(k, idAt<ElementIndex>(e))) {
            dead.insert(fe.mesh().elementIds[e]);
        }
    }
    return dead;
}

/// VTK's own reader of Exodus II, which shares no code with ours.
class ExodusWitness {
public:
    explicit ExodusWitness(const std::string& path) {
        m_reader->SetFileName(path.c_str());
        m_reader->UpdateInformation();
        m_reader->ApplyDisplacementsOff();
        m_reader->GenerateGlobalElementIdArrayOn();
        m_reader->SetAllArrayStatus(vtkExodusIIReader::ELEM_BLOCK, 1);
        m_reader->SetAllArrayStatus(vtkExodusIIReader::NODAL, 1);
    }

    std::vector<double> times() {
        vtkInformation* const information = m_reader->GetOutputInformation(0);
        const int count = information->Length(vtkStreamingDemandDrivenPipeline::TIME_STEPS());
        const double* const first = information->Get(vtkStreamingDemandDrivenPipeline::TIME_STEPS());
        return {first, first + count};
    }

    struct State {
        std::size_t cells = 0;
        std::set<std::int64_t> dead;
        bool moves = false;
    };
    State read(double time) {
        m_reader->GetOutputInformation(0)->Set(vtkStreamingDemandDrivenPipeline::UPDATE_TIME_STEP(), time);
        m_reader->UpdateTimeStep(time);
        State state;
        auto* const blocks = vtkMultiBlockDataSet::SafeDownCast(m_reader->GetOutput()->GetBlock(0));
        for (unsigned b = 0; blocks && b < blocks->GetNumberOfBlocks(); ++b) {
            auto* const grid = vtkUnstructuredGrid::SafeDownCast(blocks->GetBlock(b));
            vtkDataArray* const status = grid ? grid->GetCellData()->GetArray("STATUS") : nullptr;
            vtkDataArray* const numbers = grid ? grid->GetCellData()->GetArray("GlobalElementId") : nullptr;
            if (!status || !numbers) {
                ADD_FAILURE() << "block " << b << " lacks STATUS or numbers";
                return state;
            }
            state.cells += static_cast<std::size_t>(grid->GetNumberOfCells());
            for (vtkIdType c = 0; c < grid->GetNumberOfCells(); ++c) {
                if (status->GetComponent(c, 0) == 0.0) {
                    state.dead.insert(static_cast<std::int64_t>(numbers->GetComponent(c, 0)));
                }
            }
            vtkDataArray* const moved = grid->GetPointData()->GetArray("disp_");
            state.moves |= moved && moved->GetMaxNorm() > 0.0;
        }
        return state;
    }

private:
    vtkNew<vtkExodusIIReader> m_reader;
};

/// Files of a series as its index names them.
std::vector<std::string> filesOf(const std::string& index) {
    std::ifstream stream(index);
    const std::string text{std::istreambuf_iterator<char>(stream), {}};
    const std::regex entry("file=\"([^\"]*)\"");
    std::vector<std::string> files;
    for (std::sregex_iterator it(text.begin(), text.end(), entry), end; it != end; ++it) {
        files.push_back((std::filesystem::path(index).parent_path() / (*it)[1].str()).string());
    }
    return files;
}

constexpr std::array<std::size_t, 16> deadOfAll{0, 0, 8, 23, 39, 54, 74, 97, 132, 161, 186, 203, 217, 222, 222, 222};

TEST(ConversionWitness, VtkSeesTheSameDeadInTheExodusFile) {
    const TemporaryFolder folder;
    const auto fe = openFe(fixture("d3plot/le32-multi/d3plot"), {}, {}, Execution{});
    convertFe(*fe, {}, folder / "slab.exo", false, Execution{});
    ExodusWitness witness(folder / "slab.exo");
    ASSERT_EQ(witness.times(), fe->times());
    for (std::size_t k = 0; k < fe->stateCount(); ++k) {
        const ExodusWitness::State state = witness.read(fe->times()[k]);
        EXPECT_EQ(state.cells, 1004u);
        EXPECT_EQ(state.dead.size(), deadOfAll[k]) << "state " << k;
        EXPECT_EQ(state.dead, deadOf(*fe, k)) << "state " << k;
        EXPECT_EQ(state.moves, k > 0) << "state " << k;
    }
}

TEST(ConversionWitness, VtkReadsEveryShapeOfTheExodusFile) {
    const TemporaryFolder folder;
    const MixedResult fe;
    convertFe(*fe, {}, folder / "mixed.exo", false, Execution{});
    ExodusWitness witness(folder / "mixed.exo");
    for (std::size_t k = 0; k < fe->stateCount(); ++k) {
        const ExodusWitness::State state = witness.read(fe->times()[k]);
        EXPECT_EQ(state.cells, 8u);
        EXPECT_EQ(state.dead.size(), 8u - fe->activity().activeCount(k)) << "state " << k;
    }
}

TEST(ConversionWitness, VtkSeesTheSameDeadInTheGridsAndHidesThem) {
    const TemporaryFolder folder;
    const auto fe = openFe(fixture("d3plot/le32-multi/d3plot"), {}, {}, Execution{});
    convertFe(*fe, {}, folder / "slab.pvd", false, Execution{});
    const std::vector<std::string> files = filesOf(folder / "slab.pvd");
    ASSERT_EQ(files.size(), fe->stateCount());
    for (std::size_t k = 0; k < files.size(); ++k) {
        vtkNew<vtkXMLUnstructuredGridReader> reader;
        reader->SetFileName(files[k].c_str());
        reader->Update();
        vtkUnstructuredGrid* const grid = reader->GetOutput();
        ASSERT_EQ(grid->GetNumberOfCells(), 1004);
        vtkDataArray* const status = grid->GetCellData()->GetArray("STATUS");
        vtkDataArray* const numbers = grid->GetCellData()->GetArray("ELEMENT_ID");
        ASSERT_TRUE(status && numbers && grid->GetCellGhostArray());
        std::set<std::int64_t> dead;
        for (vtkIdType c = 0; c < grid->GetNumberOfCells(); ++c) {
            if (status->GetComponent(c, 0) == 0.0) {
                dead.insert(static_cast<std::int64_t>(numbers->GetComponent(c, 0)));
            }
            EXPECT_EQ(grid->GetCellGhostArray()->GetValue(c), status->GetComponent(c, 0) == 0.0 ? 32 : 0);
        }
        EXPECT_EQ(dead.size(), deadOfAll[k]) << "state " << k;
        EXPECT_EQ(dead, deadOf(*fe, k)) << "state " << k;
        EXPECT_EQ(grid->GetFieldData()->GetArray("TimeValue")->GetComponent(0, 0), fe->times()[k]);
    }
}

}  // namespace
}  // namespace rubble::io
