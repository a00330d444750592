#include <fuzzer/FuzzedDataProvider.h>

#include <array>
#include <memory>
#include <string>
#include <vector>

#include "io/fe/series/series_result.h"
#include "io/fe/vtk/grid_series.h"
#include "tests/fuzz/fuzzed_file.h"

using namespace rubble;

namespace {

// Names that mean something to the reader, and one that means nothing.
constexpr std::array names{"STATUS",  "EROSION_STATUS", "vtkGhostType", "ELEMENT_ID", "NODE_ID",      "PART_ID",
                           "density", "thickness",      "area",         "velocity",   "displacement", "pressure"};

std::vector<io::GridArray> arraysFrom(FuzzedDataProvider& data) {
    std::vector<io::GridArray> arrays(data.ConsumeIntegralInRange<std::size_t>(0, 4));
    for (io::GridArray& array : arrays) {
        array.name = data.PickValueInArray(names);
        array.components = data.ConsumeIntegralInRange<std::size_t>(1, 3);
        array.values.resize(data.ConsumeIntegralInRange<std::size_t>(0, 40));
        for (double& value : array.values) {
            value = data.ConsumeBool() ? data.ConsumeIntegral<std::int8_t>() : data.ConsumeFloatingPoint<double>();
        }
    }
    return arrays;
}

io::Grid gridFrom(FuzzedDataProvider& data) {
    io::Grid grid;
    grid.points.resize(data.ConsumeIntegralInRange<std::size_t>(0, 12));
    for (Vec3& point : grid.points) {
        for (int axis = 0; axis < 3; ++axis) {
            point[axis] = data.ConsumeBool() ? data.ConsumeIntegral<std::int8_t>() : data.ConsumeFloatingPoint<double>();
        }
    }
    grid.types = data.ConsumeBytes<std::uint8_t>(data.ConsumeIntegralInRange<std::size_t>(0, 6));
    grid.offsets.resize(data.ConsumeBool() ? grid.types.size() + 1 : data.ConsumeIntegralInRange<std::size_t>(0, 8));
    for (std::int64_t& offset : grid.offsets) {
        offset = data.ConsumeBool() ? data.ConsumeIntegral<std::int8_t>() : data.ConsumeIntegral<std::int64_t>();
    }
    grid.connectivity.resize(data.ConsumeIntegralInRange<std::size_t>(0, 48));
    for (std::int64_t& point : grid.connectivity) {
        point = data.ConsumeBool() ? data.ConsumeIntegral<std::int8_t>() : data.ConsumeIntegral<std::int64_t>();
    }
    grid.pointData = arraysFrom(data);
    grid.cellData = arraysFrom(data);
    return grid;
}

/// Grids made of bytes, as files hand them over: nothing in them is checked.
class MadeGrids : public io::GridSource {
public:
    explicit MadeGrids(FuzzedDataProvider& data) {
        const auto states = data.ConsumeIntegralInRange<std::size_t>(1, 3);
        for (std::size_t k = 0; k < states; ++k) {
            m_times.push_back(static_cast<double>(k));
            m_grids.push_back(gridFrom(data));
        }
    }

    const std::vector<double>& times() const override { return m_times; }
    bool sameCells(std::size_t, const std::vector<std::string>&) const override { return false; }

    io::Grid read(std::size_t k, const io::GridSelection& selection) const override {
        io::Grid grid = m_grids[k];
        for (io::GridArray& array : grid.pointData) {
            if (!selection.wantsPoint(array.name)) {
                array.values.clear();
            }
        }
        for (io::GridArray& array : grid.cellData) {
            if (!selection.wantsCell(array.name)) {
                array.values.clear();
            }
        }
        return grid;
    }

private:
    std::vector<double> m_times;
    std::vector<io::Grid> m_grids;
};

}  // namespace

/// Takes grids as any library may hand them over for a series of the VTK family.
extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* bytes, std::size_t size) {
    fuzzResult([&] {
        FuzzedDataProvider data(bytes, size);
        const std::string path = (fuzzFolder() / "grid").string();
        const auto series = std::make_shared<io::GridSeries>(path, std::make_unique<const MadeGrids>(data), ImportSettings{});
        return io::readSeries(path, series, {}, fuzzExecution());
    });
    return 0;
}
