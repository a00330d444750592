#include <pybind11/stl.h>

#include <limits>

#include "app/python/arrays.h"
#include "app/python/bindings.h"
#include "app/python/watched.h"
#include "core/base/error.h"
#include "core/evidence/cautions.h"
#include "core/validation/drop_figures.h"
#include "io/validation/drop_source.h"

namespace rubble::python {

namespace {

/// Bodies of a table that were let go, in all repeats.
struct Drop {
    io::DropSource source;
    std::vector<DropRepeat> repeats;

    std::size_t bodies() const { return source.series.bodies.size(); }
};
using Drops = std::shared_ptr<Drop>;

/// An array of [repeats, bodies, width] of what a function writes for each. @param fill  (repeat, body, first of `width` numbers)
template <class Fill>
py::array_t<double> arrayOfBodies(const Drop& drop, std::size_t width, Fill fill) {
    std::vector<py::ssize_t> shape{static_cast<py::ssize_t>(drop.repeats.size()), static_cast<py::ssize_t>(drop.bodies())};
    if (width > 1) {
        shape.push_back(static_cast<py::ssize_t>(width));
    }
    py::array_t<double> array(shape);
    double* next = array.mutable_data();
    for (const DropRepeat& repeat : drop.repeats) {
        for (std::size_t i = 0; i < drop.bodies(); ++i, next += width) {
            fill(repeat, i, next);
        }
    }
    return array;
}

py::array_t<double> positions(const Drop& drop, bool atEnd) {
    return arrayOfBodies(drop, 3, [&](const DropRepeat& repeat, std::size_t i, double* out) {
        const Pose& pose = atEnd ? repeat.result.bodies[i].trace.latest : repeat.bodies[i].pose;
        Eigen::Map<Vec3>(out, 3) = pose.position + drop.source.zero;
    });
}

py::array_t<double> orientations(const Drop& drop, bool atEnd) {
    return arrayOfBodies(drop, 4, [&](const DropRepeat& repeat, std::size_t i, double* out) {
        const DropOutcome& body = repeat.result.bodies[i];
        const Quat turn = atEnd ? placed(repeat.bodies[i], body, body.trace.latest).orientation : repeat.bodies[i].pose.orientation;
        Eigen::Map<Eigen::Vector4d>(out, 4) = Eigen::Vector4d(turn.w(), turn.x(), turn.y(), turn.z());
    });
}

py::array_t<double> figure(const Drop& drop, const std::string& key) {
    for (const DropFigure& each : dropFigures()) {
        if (key == each.key) {
            return arrayOfBodies(drop, 1, [&](const DropRepeat& repeat, std::size_t i, double* out) {
                const DropOutcome& body = repeat.result.bodies[i];
                *out = hasEnd(body) ? each.of(body, drop.source.zero) : std::numeric_limits<double>::quiet_NaN();
            });
        }
    }
    throw UsageError({"python.drop_figure", "A drop has no figure \"{0}\".", {key}},
                     {"python.drop_figure.remedy", "figures lists those that it has.", {}});
}

Drops dropTable(const std::string& path, const py::dict& settings, const std::optional<std::string>& terrain, bool apart, bool turn,
                bool lift, std::int64_t repeats, std::int64_t seed, const std::map<std::string, std::string>& vary,
                py::object progress) {
    io::DropRequest request;
    request.opening.path = path;
    request.opening.settings = settingsOf(settings);
    request.opening.terrain = terrain;
    request.apart = apart;
    request.turned = turn;
    request.lifted = lift;
    request.repeats = repeats;
    request.seed = seed;
    for (const auto& [key, distribution] : vary) {
        request.varied.push_back(variationFrom(key, distribution));
    }
    return watched(std::move(progress), [&](const Execution& execution) {
        auto drop = std::make_shared<Drop>();
        drop->source = io::openDrop(request, execution);
        drop->repeats = dropAll(drop->source.series, execution);
        return drop;
    });
}

}  // namespace

void addDrop(py::module_& module) {
    py::class_<Drop, Drops>(module, "Drop", "Bodies of a table that were let go and followed to rest. Arrays are copies.")
        .def_property_readonly(
            "ids",
            [](const Drop& drop) {
                std::vector<std::string> ids;
                for (const LooseBody& body : drop.source.table.bodies) {
                    ids.push_back(body.id);
                }
                return ids;
            },
            "Names of the bodies")
        .def_property_readonly(
            "endings",
            [](const Drop& drop) {
                std::vector<std::vector<std::string>> endings;
                for (const DropRepeat& repeat : drop.repeats) {
                    endings.emplace_back();
                    for (const DropOutcome& body : repeat.result.bodies) {
                        endings.back().emplace_back(endingName(body.ending));
                    }
                }
                return endings;
            },
            "[repeats][bodies] rest, moving, left, lost or refused")
        .def_property_readonly(
            "start_positions", [](const Drop& drop) { return positions(drop, false); },
            "[repeats, bodies, 3] m, where they were let go")
        .def_property_readonly(
            "final_positions", [](const Drop& drop) { return positions(drop, true); }, "[repeats, bodies, 3] m, where they ended")
        .def_property_readonly(
            "start_orientations", [](const Drop& drop) { return orientations(drop, false); }, "[repeats, bodies, 4] w x y z")
        .def_property_readonly(
            "final_orientations", [](const Drop& drop) { return orientations(drop, true); }, "[repeats, bodies, 4] w x y z")
        .def_property_readonly(
            "figures",
            [](const Drop&) {
                std::vector<std::string> keys;
                for (const DropFigure& each : dropFigures()) {
                    keys.emplace_back(each.key);
                }
                return keys;
            },
            "Keys of figure()")
        .def("figure", &figure, py::arg("key"),
             "[repeats, bodies] of a figure, such as run_out_m; NaN of bodies that left the terrain or were lost")
        .def_property_readonly(
            "drawn",
            [](const Drop& drop) {
                std::vector<std::map<std::string, std::string>> drawn;
                for (const DropRepeat& repeat : drop.repeats) {
                    drawn.emplace_back(repeat.drawn.begin(), repeat.drawn.end());
                }
                return drawn;
            },
            "[repeats] what was drawn for each")
        .def_property_readonly(
            "cautions",
            [](const Drop& drop) {
                std::vector<std::string> cautions;
                if (drop.source.series.varied.empty()) {
                    cautions.push_back(englishText(singleRunCaution().what));
                }
                return cautions;
            },
            "What must be known beside the figures")
        .def_property_readonly(
            "findings", [](const Drop& drop) { return findingsOf(io::findingsOf(drop.source, drop.repeats)); },
            "What was met on the way, each counted, with an example and a remedy")
        .def("__repr__", [](const Drop& drop) {
            return "<rubble.Drop " + std::to_string(drop.bodies()) + " bodies, " + std::to_string(drop.repeats.size()) +
                   " repeats>";
        });
    module.def("drop", &dropTable, py::arg("path"), py::kw_only(), py::arg("settings") = py::dict(),
               py::arg("terrain") = py::none(), py::arg("apart") = false, py::arg("turn") = false, py::arg("lift") = false,
               py::arg("repeats") = 1, py::arg("seed") = 1, py::arg("vary") = std::map<std::string, std::string>(),
               py::arg("progress") = py::none(),
               "Lets the bodies of a table fall, as rubble-cli drop does. vary maps parameters to distributions, such as "
               "{'friction': 'uniform:0.4:0.6'}, which every repeat draws from");
}

}  // namespace rubble::python
