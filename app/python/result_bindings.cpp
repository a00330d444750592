#include <pybind11/stl.h>

#include "app/python/arrays.h"
#include "app/python/bindings.h"
#include "core/clusters/clustering.h"
#include "core/clusters/sizing.h"
#include "core/fragments/fragment_set.h"

namespace rubble::python {

namespace {

using Set = std::shared_ptr<FragmentSet>;
using Clusters = std::shared_ptr<Clustering>;

/// A property that is a column of the table of fragments, seen through an array.
template <class T, class Member>
auto fragmentColumn(Member Fragment::* member, std::vector<py::ssize_t> shape = {}) {
    return [member, shape](const Set& set) -> py::array {
        const T* first = set->list.empty() ? nullptr : reinterpret_cast<const T*>(&(set->list.front().*member));
        return columnOver<T>(set, set->list, first, shape);
    };
}

template <class T, class Member>
auto clusterColumn(Member Cluster::* member, std::vector<py::ssize_t> shape = {}) {
    return [member, shape](const Clusters& clusters) -> py::array {
        const T* first = clusters->list.empty() ? nullptr : reinterpret_cast<const T*>(&(clusters->list.front().*member));
        return columnOver<T>(clusters, clusters->list, first, shape);
    };
}

void addFragments(py::module_& module) {
    py::class_<FragmentSet, Set>(
        module, "Fragments",
        "Every deactivated element as a rigid solid at its hand-over. Arrays are read-only views without a copy; they "
        "keep what they look at in memory.")
        .def_property_readonly("element", fragmentColumn<std::uint32_t>(&Fragment::element),
                               "Index of the element in the mesh [fragments]")
        .def_property_readonly("component", fragmentColumn<std::uint32_t>(&Fragment::component),
                               "Index of the component [fragments]")
        .def_property_readonly("birth_time", fragmentColumn<double>(&Fragment::birthTime),
                               "s, when it is shown and reported as born")
        .def_property_readonly("hand_over_time", fragmentColumn<double>(&Fragment::handOverTime),
                               "s, last state at which it was active")
        .def_property_readonly("mass", fragmentColumn<double>(&Fragment::mass), "kg [fragments]")
        .def_property_readonly("centre", fragmentColumn<double>(&Fragment::centre, {3}),
                               "m, centre of mass at hand-over [fragments, 3]")
        .def_property_readonly("velocity", fragmentColumn<double>(&Fragment::velocity, {3}), "m/s of the centre [fragments, 3]")
        .def_property_readonly("angular_velocity", fragmentColumn<double>(&Fragment::angularVelocity, {3}), "rad/s [fragments, 3]")
        .def_property_readonly("inertia", fragmentColumn<double>(&Fragment::inertia, {3, 3}),
                               "kg m2 about the centre, world axes; symmetric [fragments, 3, 3]")
        .def_property_readonly(
            "vertices",
            [](const Set& set) -> py::array {
                static const double none = 0.0;
                return arrayOver<double>(set, set->vertices.empty() ? &none : set->vertices.front().data(),
                                         {static_cast<py::ssize_t>(set->vertices.size()), 3});
            },
            "m, corners of all solids at hand-over, one fragment after the other [vertices, 3]")
        .def_property_readonly(
            "vertex_offsets",
            [](const Set& set) -> py::array {
                static const std::uint32_t none = 0;
                return arrayOver<std::uint32_t>(set, set->vertexOffsets.empty() ? &none : set->vertexOffsets.data(),
                                                {static_cast<py::ssize_t>(set->vertexOffsets.size())});
            },
            "First vertex of each fragment [fragments + 1]")
        .def("__len__", &FragmentSet::size)
        .def("__repr__", [](const FragmentSet& set) { return "<rubble.Fragments: " + std::to_string(set.size()) + ">"; });
}

void addClusters(py::module_& module) {
    py::class_<Clustering, Clusters>(module, "Clusters", "Which fragments one rigid body carries. Arrays are read-only views.")
        .def_property_readonly(
            "of",
            [](const Clusters& clusters) -> py::array {
                static const std::uint32_t none = 0;
                const auto* first = clusters->of.empty() ? &none : reinterpret_cast<const std::uint32_t*>(clusters->of.data());
                return arrayOver<std::uint32_t>(clusters, first, {static_cast<py::ssize_t>(clusters->of.size())});
            },
            "Cluster of each fragment [fragments]")
        .def_property_readonly("component", clusterColumn<std::uint32_t>(&Cluster::component),
                               "Component of the first member [clusters]")
        .def_property_readonly("members", clusterColumn<std::uint32_t>(&Cluster::memberCount), "Number of fragments [clusters]")
        .def_property_readonly("mass", clusterColumn<double>(&Cluster::mass), "kg [clusters]")
        .def_property_readonly("centre", clusterColumn<double>(&Cluster::centre, {3}),
                               "m, centre of mass at hand-over [clusters, 3]")
        .def_property_readonly("velocity", clusterColumn<double>(&Cluster::velocity, {3}), "m/s [clusters, 3]")
        .def("__len__", [](const Clustering& clusters) { return clusters.list.size(); })
        .def("__repr__",
             [](const Clustering& clusters) { return "<rubble.Clusters: " + std::to_string(clusters.list.size()) + ">"; });
}

}  // namespace

void addResults(py::module_& module) {
    addFragments(module);
    addClusters(module);
    py::class_<Sizing, std::shared_ptr<Sizing>>(module, "Sizing", "The Basic Grid that was found, and why.")
        .def_property_readonly(
            "grid", [](const Sizing& sizing) { return std::array<double, 3>{sizing.grid.l, sizing.grid.w, sizing.grid.h}; },
            "m, length, width and height of the Basic Grid; 0 where every fragment is its own body")
        .def_property_readonly(
            "mean_distance",
            [](const Sizing& sizing) {
                return std::array<double, 3>{sizing.axis[0].meanDistance, sizing.axis[1].meanDistance, sizing.axis[2].meanDistance};
            },
            "m, mean distance of neighbouring fragments along x, y and z")
        .def_readonly("multiple", &Sizing::commonMultiple, "Common multiple of the mean distances before clamping")
        .def_readonly("fragments", &Sizing::fragments, "Number of fragments")
        .def_readonly("clusters", &Sizing::clusters, "Clusters counted at this grid")
        .def_readonly("awake", &Sizing::awake, "Most of these at once, each from its birth on for awake_time")
        .def_readonly("bodies_max", &Sizing::bodiesMax, "Bodies allowed")
        .def_property_readonly(
            "stopped_by", [](const Sizing& sizing) { return std::string(stoppedByName(sizing.stoppedBy)); },
            "'efficiency', 'fps_unreachable' or 'user'")
        .def("__repr__", [](const Sizing& sizing) {
            return "<rubble.Sizing: " + std::to_string(sizing.clusters) + " clusters, " +
                   std::string(stoppedByName(sizing.stoppedBy)) + ">";
        });
}

}  // namespace rubble::python
