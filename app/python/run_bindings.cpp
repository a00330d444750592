#include <pybind11/stl.h>

#include <algorithm>
#include <cmath>
#include <limits>

#include "app/python/arrays.h"
#include "app/python/bindings.h"
#include "app/python/recorded_run.h"
#include "app/python/watched.h"
#include "core/base/error.h"
#include "io/run/fragment_places.h"

namespace rubble::python {

namespace {

using Runs = std::shared_ptr<RecordedRun>;
using Frames = std::shared_ptr<TrajectoryFrame>;
using Maps = std::shared_ptr<RecordedMap>;

template <class T, class Row>
py::array rowsOf(const std::shared_ptr<const void>& owner, const std::vector<Row>& rows, py::ssize_t width) {
    static const T none{};
    const T* first = rows.empty() ? &none : reinterpret_cast<const T*>(rows.data());
    std::vector<py::ssize_t> shape{static_cast<py::ssize_t>(rows.size())};
    if (width > 1) {
        shape.push_back(width);
    }
    return arrayOver<T>(owner, first, std::move(shape));
}

template <class T, class Member>
auto outcomeColumn(Member FragmentOutcome::* member, std::vector<py::ssize_t> shape = {}) {
    return [member, shape](const Runs& run) -> py::array {
        const auto result = run->result();
        const T* first = result->fragments.empty() ? nullptr : reinterpret_cast<const T*>(&(result->fragments.front().*member));
        return columnOver<T>(result, result->fragments, first, shape);
    };
}

py::array timesOf(const RecordedRun& run) {
    std::vector<double> times(run.reader().frameCount());
    for (std::size_t i = 0; i < times.size(); ++i) {
        times[i] = run.reader().frameTime(i);
    }
    return arrayOf(times);
}

Frames frameOf(const RecordedRun& run, std::int64_t index) {
    const auto count = static_cast<std::int64_t>(run.reader().frameCount());
    const std::int64_t place = index < 0 ? index + count : index;
    if (place < 0 || place >= count) {
        throw py::index_error("there is no frame " + std::to_string(index) + ": the run has " + std::to_string(count));
    }
    const py::gil_scoped_release released;
    return std::const_pointer_cast<TrajectoryFrame>(run.reader().frame(static_cast<std::size_t>(place)));
}

Frames frameAtInstant(const RecordedRun& run, double time) {
    if (!std::isfinite(time)) {
        throw UsageError({"python.time", "The time is no number.", {}},
                         {"python.time.remedy", "Give seconds on the file's clock.", {}});
    }
    const py::gil_scoped_release released;
    return std::make_shared<TrajectoryFrame>(frameAtTime(run.reader(), time));
}

/// Centres of mass of all fragments at an instant, NaN where a fragment is not there [fragments, 3].
py::array placesAt(const RecordedRun& run, double time) {
    const auto fragments = run.fragments();
    auto places = std::make_shared<std::vector<Vec3>>(fragments->size(), Vec3::Constant(std::numeric_limits<double>::quiet_NaN()));
    {
        const py::gil_scoped_release released;
        for (const io::FragmentPlaces::Place& place : io::FragmentPlaces(run.reader()).at(time)) {
            (*places)[at(place.fragment)] = place.fromHandOver * fragments->list[at(place.fragment)].centre;
        }
    }
    return rowsOf<double>(places, *places, 3);
}

MapLayer layerNamed(const RecordedMap& map, const std::string& name) {
    std::string names;
    for (const MapLayer layer : map.made.map.present()) {
        if (mapLayerRow(layer).key == name) {
            return layer;
        }
        names += (names.empty() ? "" : ", ") + std::string(mapLayerRow(layer).key);
    }
    throw UsageError({"python.layer", "The map has no layer \"{0}\".", {name}},
                     {"python.layer.remedy", "Its layers: {0}.", {names}});
}

/// First cell and numbers of cells of the rectangle around a map.
struct Extent {
    std::int32_t i = 0;
    std::int32_t j = 0;
    py::ssize_t columns = 0;
    py::ssize_t rows = 0;
};

Extent extentOf(const DebrisMap& map) {
    if (map.cells.empty()) {
        return {};
    }
    const auto [west, east] =
        std::minmax_element(map.cells.begin(), map.cells.end(), [](const MapCell& a, const MapCell& b) { return a.i < b.i; });
    const auto [south, north] =
        std::minmax_element(map.cells.begin(), map.cells.end(), [](const MapCell& a, const MapCell& b) { return a.j < b.j; });
    return {west->i, south->j, py::ssize_t{east->i} - west->i + 1, py::ssize_t{north->j} - south->j + 1};
}

py::array raster(const RecordedMap& recorded, const std::string& name) {
    const DebrisMap& map = recorded.made.map;
    const std::vector<double>& values = map.layer(layerNamed(recorded, name));
    const Extent extent = extentOf(map);
    py::array_t<double> array({extent.rows, extent.columns});
    std::fill_n(array.mutable_data(), array.size(), std::numeric_limits<double>::quiet_NaN());
    for (std::size_t c = 0; c < map.cells.size(); ++c) {
        array.mutable_at(map.cells[c].j - extent.j, map.cells[c].i - extent.i) = values[c];
    }
    return array;
}

std::array<double, 4> boundsOf(const RecordedMap& recorded) {
    const DebrisMap& map = recorded.made.map;
    const Extent extent = extentOf(map);
    return {extent.i * map.cell, extent.j * map.cell, static_cast<double>(extent.i + extent.columns) * map.cell,
            static_cast<double>(extent.j + extent.rows) * map.cell};
}

py::dict mapLedger(const RecordedMap& map) {
    const MapLedger& ledger = map.made.map.ledger;
    py::dict row;
    row["fragments"] = ledger.fragments;
    row["mass"] = ledger.mass;
    row["volume"] = ledger.volume;
    row["footprint_area"] = ledger.footprintArea;
    row["live_elements"] = ledger.liveElements;
    row["live_mass"] = ledger.liveMass;
    return row;
}

void addFrame(py::module_& module) {
    py::class_<TrajectoryFrame, Frames>(module, "Frame",
                                        "All bodies at one instant; arrays are read-only views that keep it in memory.")
        .def_readonly("time", &TrajectoryFrame::time, "s, on the file's clock")
        .def_property_readonly(
            "positions", [](const Frames& frame) { return rowsOf<float>(frame, frame->positions, 3); },
            "m, centres of mass, float32 [bodies, 3]")
        .def_property_readonly(
            "orientations", [](const Frames& frame) { return rowsOf<float>(frame, frame->orientations, 4); },
            "Quaternions x, y, z, w, float32 [bodies, 4]")
        .def_property_readonly(
            "speeds", [](const Frames& frame) { return rowsOf<float>(frame, frame->speeds, 1); }, "m/s, float32 [bodies]")
        .def_property_readonly(
            "states", [](const Frames& frame) { return rowsOf<std::uint8_t>(frame, frame->states, 1); },
            "1 awake, 2 frozen, 3 removed [bodies]")
        .def("__len__", &TrajectoryFrame::bodies)
        .def("__repr__", [](const TrajectoryFrame& frame) {
            return "<rubble.Frame at " + englishNumber(frame.time) + " s: " + std::to_string(frame.bodies()) + " bodies>";
        });
}

void addMap(py::module_& module) {
    py::class_<RecordedMap, Maps>(module, "DebrisMap", "Debris by cells at one instant.")
        .def_property_readonly(
            "time", [](const RecordedMap& map) { return map.made.map.time; }, "s")
        .def_property_readonly(
            "cell", [](const RecordedMap& map) { return map.made.map.cell; }, "m, side of a cell")
        .def_property_readonly(
            "layers",
            [](const RecordedMap& map) {
                std::vector<std::string> names;
                for (const MapLayer layer : map.made.map.present()) {
                    names.emplace_back(mapLayerRow(layer).key);
                }
                return names;
            },
            "Names of the layers")
        .def_property_readonly("bounds", &boundsOf, "m, local: west, south, east and north edge of the raster")
        .def_property_readonly("ledger", &mapLedger, "Sums over what was mapped: fragments, kg, m3, m2")
        .def_property_readonly(
            "cells", [](const Maps& map) { return rowsOf<std::int32_t>(map, map->made.map.cells, 2); },
            "Cells that hold anything as (j, i): row to the north, column to the east; a view [cells, 2]")
        .def(
            "values",
            [](const Maps& map, const std::string& layer) {
                return rowsOf<double>(map, map->made.map.layer(layerNamed(*map, layer)), 1);
            },
            py::arg("layer"), "Values of a layer by cell, NaN where it has none; a view [cells]")
        .def("raster", &raster, py::arg("layer"),
             "A layer as a raster, first row in the south, NaN where there is nothing; a copy [rows, columns]")
        .def(
            "save",
            [](const RecordedMap& map, const std::string& path, py::object progress) {
                WatchedWork(std::move(progress)).run([&](const Execution& execution) { saveMap(map, path, execution); });
            },
            py::arg("path"), py::arg("progress") = py::none(),
            "Writes GeoTIFF (.tif), GeoPackage (.gpkg) or CSV by the ending of the name")
        .def("__repr__", [](const RecordedMap& map) {
            return "<rubble.DebrisMap at " + englishNumber(map.made.map.time) + " s: " + std::to_string(map.made.map.cells.size()) +
                   " cells>";
        });
}

void addRecordedRun(py::module_& module) {
    py::class_<RecordedRun, Runs>(module, "Run",
                                  "A recorded run, complete or not. frame() gives instants that were recorded, at() any.")
        .def_property_readonly(
            "path", [](const RecordedRun& run) { return run.reader().path(); }, "The run file")
        .def_property_readonly(
            "complete", [](const RecordedRun& run) { return run.reader().complete(); }, "Whether it was simulated to the end")
        .def_property_readonly(
            "fingerprint", [](const RecordedRun& run) { return run.reader().origin().fingerprint.hex(); },
            "Of inputs, settings and build")
        .def_property_readonly(
            "trajectory_hash", [](const RecordedRun& run) { return run.result()->trajectoryHash.hex(); },
            "Of every frame in double precision; the same description gives the same")
        .def_property_readonly("times", &timesOf, "s, of the frames [frames]; a copy")
        .def_property_readonly(
            "components", [](const RecordedRun& run) { return run.reader().componentNames(); }, "Names of the components")
        .def_property_readonly(
            "fragments", [](const RecordedRun& run) { return std::const_pointer_cast<FragmentSet>(run.fragments()); },
            "The fragments")
        .def_property_readonly(
            "clusters", [](const RecordedRun& run) { return std::const_pointer_cast<Clustering>(run.reader().clustering()); },
            "The clusters")
        .def_property_readonly("birth_positions", outcomeColumn<double>(&FragmentOutcome::birthPosition, {3}),
                               "m, of each fragment when born; a view [fragments, 3]")
        .def_property_readonly("final_positions", outcomeColumn<double>(&FragmentOutcome::finalPosition, {3}),
                               "m, of each fragment at the end; a view [fragments, 3]")
        .def_property_readonly("impact_speeds", outcomeColumn<double>(&FragmentOutcome::impactSpeed),
                               "m/s, just before the hardest hit; a view [fragments]")
        .def("frame", &frameOf, py::arg("index"), "A recorded instant; negative indices count from the end")
        .def("at", &frameAtInstant, py::arg("time"), "The bodies at any time, interpolated between two frames")
        .def("places", &placesAt, py::arg("time"),
             "m, centres of all fragments at a time, NaN where one is not there [fragments, 3]")
        .def(
            "export",
            [](RecordedRun& run, const std::string& kind, const std::string& path, const std::optional<std::string>& fe,
               py::object progress) {
                WatchedWork(std::move(progress)).run([&](const Execution& execution) { run.write(kind, path, fe, execution); });
            },
            py::arg("kind"), py::arg("path"), py::kw_only(), py::arg("fe") = py::none(), py::arg("progress") = py::none(),
            "Writes 'fragments' (CSV), 'series' and 'vtkhdf' (ParaView), 'bodies' (XDMF) or 'gltf'")
        .def(
            "debris_map",
            [](RecordedRun& run, std::optional<double> cell, std::optional<double> time, bool live,
               const std::optional<std::string>& fe, py::object progress) {
                return watched(std::move(progress), [&](const Execution& execution) {
                    return std::const_pointer_cast<RecordedMap>(run.map(cell, time, live, fe, execution));
                });
            },
            py::arg("cell") = py::none(), py::arg("time") = py::none(), py::kw_only(), py::arg("live") = true,
            py::arg("fe") = py::none(), py::arg("progress") = py::none(),
            "Debris by cells of a side in m (0.25, less where fragments are smaller), at the end or at a time in s")
        .def("__len__", [](const RecordedRun& run) { return run.reader().frameCount(); })
        .def("__repr__", [](const RecordedRun& run) {
            return "<rubble.Run " + run.reader().path() + ": " + std::to_string(run.reader().frameCount()) + " frames>";
        });
}

}  // namespace

void addRun(py::module_& module) {
    addFrame(module);
    addMap(module);
    addRecordedRun(module);
    module.def(
        "open_run",
        [](const std::string& path) {
            const py::gil_scoped_release released;
            return std::make_shared<RecordedRun>(io::openRun(path), std::nullopt);
        },
        py::arg("path"), "Opens a recorded run, complete or still growing");
}

}  // namespace rubble::python
