#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <array>
#include <cmath>
#include <cstdio>
#include <cstdlib>
#include <fstream>
#include <iostream>
#include <regex>
#include <sstream>

#include "io/exports/convert/grid_writer.h"
#include "io/exports/exports.h"
#include "tests/io/run_over_fe.h"
#include "tests/io/sample_run.h"
#include "tests/support/temporary_folder.h"

namespace rubble::io {

namespace {

using testing::HasSubstr;

/// What a program said, on both of its ways out.
std::string said(const std::string& command) {
    std::string text;
    std::FILE* pipe = ::popen((command + " 2>&1").c_str(), "r");
    std::array<char, 4096> buffer{};
    while (pipe != nullptr && std::fgets(buffer.data(), buffer.size(), pipe) != nullptr) {
        // hwloc speaks of the machine, not of the file.
        if (const std::string line = buffer.data(); !line.starts_with("[hwloc")) {
            text += line;
        }
    }
    if (pipe != nullptr) {
        ::pclose(pipe);
    }
    return text;
}

/// ParaView's Python; empty where there is none. RUBBLE_PVPYTHON may name another.
std::string paraView() {
    const char* named = std::getenv("RUBBLE_PVPYTHON");
    const std::string program = named != nullptr ? named : "pvpython";
    return said("command -v " + program).empty() ? std::string() : program;
}

/// Opens a file as ParaView does by itself, goes through its times and back, and says what there is.
constexpr const char* script = R"py(
import sys
from paraview import servermanager
from paraview.simple import OpenDataFile
from vtkmodules.util.numpy_support import vtk_to_numpy
reader = OpenDataFile(sys.argv[1])

def leaves(data):
    if data is None or not data.IsA('vtkCompositeDataSet'):
        return [data] if data is not None else []
    at, found = data.NewIterator(), []
    at.InitTraversal()
    while not at.IsDoneWithTraversal():
        found.append(at.GetCurrentDataObject())
        at.GoToNextItem()
    return found

def total(fields, name):
    arrays = [field.GetArray(name) for field in fields if field.GetArray(name) is not None]
    return float(sum(vtk_to_numpy(a).astype(float)[vtk_to_numpy(a) == vtk_to_numpy(a)].sum() for a in arrays))

def values(data):
    sets = [leaf for leaf in leaves(data) if leaf.GetNumberOfPoints() > 0]
    x = sum(vtk_to_numpy(leaf.GetPoints().GetData())[:, 0].astype(float).sum() for leaf in sets)
    points, cells = [leaf.GetPointData() for leaf in sets], [leaf.GetCellData() for leaf in sets]
    ids = [field.GetArray('element_id') for field in cells if field.GetArray('element_id') is not None]
    distinct = len({int(i) for a in ids for i in vtk_to_numpy(a)})
    return repr(float(x)), repr(total(points, 'speed')), repr(total(cells, 'speed')), distinct
reader.UpdatePipelineInformation()
times = getattr(reader, 'TimestepValues', None)
times = [times] if isinstance(times, float) else list(times or [])
print('reader', type(reader).__name__, 'times', len(times))
for t in times + times[::-1] or [0.0]:
    reader.UpdatePipeline(t)
    data = reader.GetDataInformation()
    print('at', repr(t), 'points', data.GetNumberOfPoints(), 'cells', data.GetNumberOfCells())
    print('values', repr(float(t)), *values(servermanager.Fetch(reader)))
print('arrays', sorted(a.Name for a in reader.PointData), sorted(a.Name for a in reader.CellData))
)py";

class ParaViewOpens : public testing::Test {
protected:
    void SetUp() override {
        if (m_program.empty()) {
            std::cout << "not run: no ParaView here\n";
            return;
        }
        m_sample = runOverFe(5, 9, m_fe);
        m_sample.feed(*createRun(m_folder / "a.run.h5", m_sample.origin));
        m_run = openRun(m_folder / "a.run.h5");
        std::ofstream(m_folder / "open.py") << script;
    }
    std::string opened(const std::string& file) {
        return said(m_program + " '" + (m_folder / "open.py") + "' '" + (m_folder / file) + "'");
    }
    /// Cells at each time, there and back; nothing else may have been said.
    std::vector<std::size_t> cellsOf(const std::string& text) {
        std::vector<std::size_t> cells;
        std::istringstream lines(text);
        for (std::string line; std::getline(lines, line);) {
            std::smatch found;
            if (std::regex_match(line, found, std::regex(R"(at \S+ points \d+ cells (\d+))"))) {
                cells.push_back(std::stoul(found[1]));
            } else {
                EXPECT_TRUE(line.starts_with("reader ") || line.starts_with("arrays ") || line.starts_with("values ")) << line;
            }
        }
        return cells;
    }

    /// What the arrays hold at one time.
    struct Values {
        double time = 0.0;
        double x = 0.0;            ///< m, summed over the points
        double pointSpeed = 0.0;   ///< m/s, summed
        double cellSpeed = 0.0;    ///< m/s, summed over the cells that have one
        std::size_t elements = 0;  ///< different element numbers
    };
    static std::vector<Values> valuesOf(const std::string& text) {
        std::vector<Values> all;
        std::istringstream lines(text);
        for (std::string word; lines >> word;) {
            if (word == "values") {
                Values& each = all.emplace_back();
                lines >> each.time >> each.x >> each.pointSpeed >> each.cellSpeed >> each.elements;
            }
        }
        return all;
    }
    /// Of the fragments that are born, by the frame and who carries them [m/s].
    double fragmentSpeeds(double time) const {
        const TrajectoryFrame frame = frameAtTime(*m_run, time);
        double sum = 0.0;
        for (const Carrier& carrier : m_sample.carriers) {
            const bool born = m_sample.description.fragments->list[at(carrier.fragment)].birthTime <= time;
            if (born && carrier.from <= time && at(carrier.body) < frame.bodies()) {
                sum += static_cast<double>(frame.speeds[at(carrier.body)]);
            }
        }
        return sum;
    }

    std::string m_program = paraView();
    TemporaryFolder m_folder;
    std::shared_ptr<const FeResult> m_fe;
    SampleRun m_sample;
    std::shared_ptr<const RunReader> m_run;
};

TEST_F(ParaViewOpens, TheBodiesInTheReaderThatItTakesByItself) {
    if (m_program.empty()) {
        return;
    }
    exportBodies(m_folder / "a.xdmf", *m_run, Execution());
    const std::string text = opened("a.xdmf");
    EXPECT_THAT(text, HasSubstr("reader Xdmf3Reader"));
    EXPECT_THAT(text, HasSubstr("['orientation', 'speed', 'state']"));
    std::vector<std::size_t> bodies;
    for (std::size_t i = 0; i < m_run->frameCount(); ++i) {
        if (m_run->frame(i)->bodies() > 0) {
            bodies.push_back(m_run->frame(i)->bodies());
        }
    }
    std::vector<std::size_t> thereAndBack = bodies;
    thereAndBack.insert(thereAndBack.end(), bodies.rbegin(), bodies.rend());
    EXPECT_EQ(cellsOf(text), thereAndBack);
    const std::vector<Values> values = valuesOf(text);
    ASSERT_EQ(values.size(), thereAndBack.size()) << text;
    for (const Values& each : values) {
        const TrajectoryFrame frame = frameAtTime(*m_run, each.time);
        double x = 0.0, speed = 0.0;
        for (std::size_t b = 0; b < frame.bodies(); ++b) {
            x += static_cast<double>(frame.positions[b].x());
            speed += static_cast<double>(frame.speeds[b]);
        }
        // The very numbers of the run file, summed in the same order.
        EXPECT_NEAR(each.x, x, 1e-9 * 100.0 * static_cast<double>(frame.bodies())) << each.time;
        EXPECT_NEAR(each.pointSpeed, speed, 1e-9 * 30.0 * static_cast<double>(frame.bodies())) << each.time;
    }
}

TEST_F(ParaViewOpens, TheSeriesOfVtuFiles) {
    if (m_program.empty()) {
        return;
    }
    exportSeries(m_folder / "s.pvd", *m_run, *m_fe, Execution());
    const std::string text = opened("s.pvd");
    EXPECT_THAT(text, HasSubstr("reader PVDReader"));
    EXPECT_THAT(text, HasSubstr("'element_id'"));
    const std::vector<std::size_t> cells = cellsOf(text);
    ASSERT_FALSE(cells.empty());
    for (const std::size_t count : cells) {
        EXPECT_EQ(count, m_fe->mesh().elementCount()) << "an element is either structure or a fragment";
    }
    const std::vector<Values> values = valuesOf(text);
    ASSERT_EQ(values.size(), cells.size()) << text;
    for (const Values& each : values) {
        EXPECT_EQ(each.elements, m_fe->mesh().elementCount()) << each.time;
        EXPECT_NEAR(each.cellSpeed, fragmentSpeeds(each.time), 1e-9 + 1e-6 * each.cellSpeed) << each.time;
    }
    EXPECT_GT(values.back().cellSpeed + values[values.size() / 2].cellSpeed, 0.0) << "nothing was compared";
}

TEST_F(ParaViewOpens, AConvertedFeResult) {
    if (m_program.empty()) {
        return;
    }
    writeGridSeries(m_folder / "c.pvd", *m_fe, Vec3::Zero(), false, Execution());
    const std::string text = opened("c.pvd");
    EXPECT_THAT(text, HasSubstr("reader PVDReader times " + std::to_string(m_fe->times().size())));
    EXPECT_THAT(text, HasSubstr("'STATUS'"));
    const std::vector<std::size_t> cells = cellsOf(text);
    ASSERT_EQ(cells.size(), 2 * m_fe->times().size()) << text;
    for (const std::size_t count : cells) {
        EXPECT_EQ(count, m_fe->mesh().elementCount()) << "the dead are hidden, not gone";
    }
    const std::vector<Values> values = valuesOf(text);
    ASSERT_EQ(values.size(), cells.size()) << text;
    for (std::size_t k = 0; k < m_fe->times().size(); ++k) {
        double x = 0.0;
        for (const Vec3& place : m_fe->state(k)->positions) {
            x += place.x();
        }
        EXPECT_EQ(values[k].time, m_fe->times()[k]);
        EXPECT_NEAR(values[k].x, x, 1e-5 * (1.0 + std::abs(x))) << values[k].time;
    }
}

TEST_F(ParaViewOpens, TheFragmentsAsGltf) {
    if (m_program.empty()) {
        return;
    }
    exportGltf(m_folder / "g.glb", *m_run, nullptr, Execution());
    const std::string text = opened("g.glb");
    EXPECT_THAT(text, HasSubstr("reader glTFReader"));
    const std::vector<std::size_t> cells = cellsOf(text);
    ASSERT_FALSE(cells.empty()) << text;
    EXPECT_GT(cells.front(), 0u);
}

TEST_F(ParaViewOpens, TheVtkHdfFileFromVersion512On) {
    if (m_program.empty()) {
        return;
    }
    const std::string version = said(m_program + " --version");
    std::smatch found;
    ASSERT_TRUE(std::regex_search(version, found, std::regex(R"((\d+)\.(\d+))"))) << version;
    exportVtkHdf(m_folder / "t.vtkhdf", *m_run, *m_fe, Execution());
    if (std::stoi(found[1]) * 100 + std::stoi(found[2]) < 512) {
        // As the list of exports and the manual say of it: no reader, rather than one that shows something else.
        EXPECT_THAT(opened("t.vtkhdf"), HasSubstr("No reader found"));
        std::cout << "not run further: this is ParaView " << found[0] << '\n';
        return;
    }
    for (const std::size_t count : cellsOf(opened("t.vtkhdf"))) {
        EXPECT_EQ(count, m_fe->mesh().elementCount());
    }
}

}  // namespace

}  // namespace rubble::io
