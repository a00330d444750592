#include "app/python/array_result.h"

#include <pybind11/stl.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <set>

#include "app/python/arrays.h"
#include "core/base/error.h"

namespace rubble::python {

namespace {

/// States as they were given, in SI.
class ArraySource : public StateSource {
public:
    ArraySource(std::vector<double> times, std::vector<Vec3> positions, std::vector<Vec3> velocities)
        : m_times(std::move(times)), m_positions(std::move(positions)), m_velocities(std::move(velocities)) {}

    FeState read(std::size_t k) const override { return {m_times.at(k), slice(m_positions, k), slice(m_velocities, k)}; }

private:
    std::vector<Vec3> slice(const std::vector<Vec3>& all, std::size_t k) const {
        const auto nodes = static_cast<std::ptrdiff_t>(all.size() / m_times.size());
        const auto first = all.begin() + static_cast<std::ptrdiff_t>(k) * nodes;
        return {first, first + nodes};
    }

    std::vector<double> m_times;
    std::vector<Vec3> m_positions;   // state by state
    std::vector<Vec3> m_velocities;  // likewise, or empty
};

UsageError wrong(const std::string& name, const std::string& what, const std::string& remedy) {
    return UsageError({"python.value", "{0}: {1}.", {name, what}}, {"python.value.remedy", "{0}", {remedy}});
}

const UnitSystem& unitsNamed(const std::string& id) {
    std::string known;
    for (const UnitSystem& system : unitSystems()) {
        if (system.id == id) {
            return system;
        }
        known += (known.empty() ? "" : ", ") + std::string(system.id);
    }
    throw wrong("units", "there is no system \"" + id + "\"", "Systems: " + known + ".");
}

std::vector<double> takeTimes(const py::object& argument, double seconds) {
    const auto array = takeArray<double>(argument, "times", Values::Reals, {-1});
    std::vector<double> times(array.data(), array.data() + array.size());
    if (times.empty()) {
        throw wrong("times", "there is no state", "Give at least one state.");
    }
    for (std::size_t k = 0; k < times.size(); ++k) {
        times[k] *= seconds;
        if (!std::isfinite(times[k]) || (k > 0 && times[k] <= times[k - 1])) {
            throw wrong("times", "state " + std::to_string(k) + " is not later than the one before", "Times must ascend.");
        }
    }
    return times;
}

std::vector<Vec3> takeVectors(const py::object& argument, const std::string& name, py::ssize_t states, py::ssize_t nodes,
                              double scale) {
    const auto array = takeArray<double>(argument, name, Values::Reals, {states, nodes, 3});
    std::vector<Vec3> vectors(static_cast<std::size_t>(array.size() / 3));
    for (std::size_t i = 0; i < vectors.size(); ++i) {
        vectors[i] = scale * Eigen::Map<const Vec3>(array.data() + 3 * i);
    }
    return vectors;
}

ElementShape shapeOf(py::ssize_t corners) {
    switch (corners) {
        case 8:
            return ElementShape::Hexahedron;
        case 6:
            return ElementShape::Wedge;
        case 5:
            return ElementShape::Pyramid;
        case 4:
            return ElementShape::Tetrahedron;
        default:
            throw UsageError(
                {"python.shape", "elements has {0} columns.", {static_cast<std::int64_t>(corners)}},
                {"python.shape.corners",
                 "A row holds the nodes of one solid, counted from 0: 8 of a hexahedron, 6 of a wedge, 5 of a pyramid, 4 of a "
                 "tetrahedron.",
                 {}});
    }
}

void takeElements(Mesh& mesh, const py::object& argument) {
    const auto array = takeArray<std::int64_t>(argument, "elements", Values::Integers, {-1, -1});
    const ElementShape shape = shapeOf(array.shape(1));
    const auto nodes = static_cast<std::int64_t>(mesh.nodes.size());
    const auto columns = static_cast<std::size_t>(array.shape(1));
    const auto rows = static_cast<std::size_t>(array.shape(0));
    mesh.shapes.assign(rows, shape);
    mesh.section.assign(rows, std::numeric_limits<double>::quiet_NaN());
    mesh.offsets.push_back(0);
    for (std::size_t e = 0; e < rows; ++e) {
        mesh.elementIds.push_back(static_cast<std::int64_t>(e) + 1);
        for (std::size_t c = 0; c < columns; ++c) {
            const std::int64_t node = array.data()[e * columns + c];
            if (node < 0 || node >= nodes) {
                throw wrong("elements",
                            "element " + std::to_string(e) + " names node " + std::to_string(node) + " of " + std::to_string(nodes),
                            "Nodes are counted from 0.");
            }
            mesh.corners.push_back(static_cast<std::uint32_t>(node));
        }
        mesh.offsets.push_back(static_cast<std::uint32_t>(mesh.corners.size()));
    }
}

void takeDensity(Mesh& mesh, const py::object& argument, double scale) {
    const std::size_t elements = mesh.elementCount();
    mesh.density.assign(elements, std::numeric_limits<double>::quiet_NaN());
    if (argument.is_none()) {
        return;
    }
    if (PyFloat_Check(argument.ptr()) != 0 || PyLong_Check(argument.ptr()) != 0) {
        mesh.density.assign(elements, scale * argument.cast<double>());
    } else {
        const auto array = takeArray<double>(argument, "density", Values::Reals, {static_cast<py::ssize_t>(elements)});
        std::transform(array.data(), array.data() + array.size(), mesh.density.begin(),
                       [&](double value) { return scale * value; });
    }
    for (std::size_t e = 0; e < elements; ++e) {
        if (!(mesh.density[e] > 0.0) || mesh.density[e] > 25000.0) {
            throw wrong("density", "that of element " + std::to_string(e) + " is " + englishNumber(mesh.density[e]) + " kg/m3",
                        "Densities lie above 0 and up to 25,000 kg/m3: look at units.");
        }
    }
}

void takeParts(Mesh& mesh, const py::object& parts, const py::object& names) {
    mesh.part.assign(mesh.elementCount(), 0);
    std::int64_t last = 0;
    if (!parts.is_none()) {
        const auto array =
            takeArray<std::int64_t>(parts, "parts", Values::Integers, {static_cast<py::ssize_t>(mesh.elementCount())});
        for (std::size_t e = 0; e < mesh.elementCount(); ++e) {
            const std::int64_t part = array.data()[e];
            if (part < 0 || part >= static_cast<std::int64_t>(std::max<std::size_t>(1, mesh.elementCount()))) {
                throw wrong("parts", "element " + std::to_string(e) + " is of part " + std::to_string(part),
                            "Parts are counted from 0.");
            }
            mesh.part[e] = static_cast<std::uint32_t>(part);
            last = std::max(last, part);
        }
    }
    const auto given = names.is_none() ? std::vector<std::string>() : names.cast<std::vector<std::string>>();
    if (!names.is_none() && static_cast<std::int64_t>(given.size()) != last + 1) {
        throw wrong("part_names", "there are " + std::to_string(given.size()) + " names for " + std::to_string(last + 1) + " parts",
                    "Give one name for each part.");
    }
    for (std::int64_t p = 0; p <= last; ++p) {
        mesh.parts.push_back({given.empty() ? "part " + std::to_string(p) : given[static_cast<std::size_t>(p)], p + 1});
    }
    std::set<std::string> unique(given.begin(), given.end());
    if (unique.size() != given.size() || unique.contains("")) {
        throw wrong("part_names", "a name is empty or there twice", "Give every part a name of its own.");
    }
}

Activity takeActivity(const py::object& argument, std::size_t states, std::size_t elements) {
    const auto array = takeArray<bool>(argument, "active", Values::Booleans,
                                       {static_cast<py::ssize_t>(states), static_cast<py::ssize_t>(elements)});
    Activity activity(states, elements);
    for (std::size_t k = 0; k < states; ++k) {
        for (std::size_t e = 0; e < elements; ++e) {
            activity.set(k, idAt<ElementIndex>(e), array.data()[k * elements + e]);
        }
    }
    return activity;
}

template <class T>
void feed(Hasher& hasher, const std::vector<T>& values) {
    hasher.value(static_cast<std::uint64_t>(values.size())).bytes(values.data(), values.size() * sizeof(T));
}

}  // namespace

std::shared_ptr<const FeResult> resultOfArrays(const ArrayInput& input) {
    const UnitSystem& system = unitsNamed(input.units);
    auto mesh = std::make_shared<Mesh>();
    FeResult::Contents contents;
    contents.times = takeTimes(input.times, system.units.seconds);
    const std::size_t states = contents.times.size();
    std::vector<Vec3> positions =
        takeVectors(input.positions, "positions", static_cast<py::ssize_t>(states), -1, system.units.metres);
    const std::size_t nodes = positions.size() / states;
    for (std::size_t n = 0; n < nodes; ++n) {
        if (!positions[n].allFinite()) {
            throw wrong("positions", "node " + std::to_string(n) + " has no place at the first state",
                        "The first state must be whole.");
        }
        mesh->nodeIds.push_back(static_cast<std::int64_t>(n) + 1);
        mesh->nodes.push_back(positions[n]);
    }
    takeElements(*mesh, input.elements);
    takeDensity(*mesh, input.density, system.units.density());
    takeParts(*mesh, input.parts, input.partNames);
    std::vector<Vec3> velocities;
    if (!input.velocities.is_none()) {
        velocities = takeVectors(input.velocities, "velocities", static_cast<py::ssize_t>(states), static_cast<py::ssize_t>(nodes),
                                 system.units.metres / system.units.seconds);
    }
    contents.activity = takeActivity(input.active, states, mesh->elementCount());
    contents.hasVelocity = !velocities.empty();
    contents.format = "arrays";
    contents.path = "arrays";
    contents.activityFrom = "argument active";
    contents.units = system.units;
    contents.unitsFrom = "argument units";
    Hasher hasher;
    hasher.text("arrays");
    feed(hasher, contents.times);
    feed(hasher, positions);
    feed(hasher, velocities);
    feed(hasher, mesh->corners);
    feed(hasher, mesh->offsets);
    feed(hasher, mesh->density);
    feed(hasher, mesh->part);
    for (const Part& part : mesh->parts) {
        hasher.text(part.name);
    }
    for (std::size_t k = 0; k < states; ++k) {
        for (std::size_t e = 0; e < mesh->elementCount(); ++e) {
            hasher.value(contents.activity.active(k, idAt<ElementIndex>(e)));
        }
    }
    contents.fingerprint = hasher.finish();
    contents.source = std::make_shared<ArraySource>(contents.times, std::move(positions), std::move(velocities));
    contents.mesh = std::move(mesh);
    return std::make_shared<FeResult>(std::move(contents));
}

}  // namespace rubble::python
