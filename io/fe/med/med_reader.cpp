#include "io/fe/med/med_reader.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <memory>

#include "io/fe/exodus/exodus_names.h"
#include "io/fe/med/med_fields.h"
#include "io/fe/med/med_file.h"
#include "io/fe/med/med_mesh.h"
#include "io/fe/series/death_list.h"
#include "io/fe/series/series_result.h"

namespace rubble::io {

namespace {

constexpr double none = std::numeric_limits<double>::quiet_NaN();

/// What a field says of the elements at one step: nothing, or the value of each.
using CellMarks = std::vector<double>;

class MedSeries : public MeshSeries {
public:
    MedSeries(const std::string& path, const ImportSettings& settings)
        : m_file(path), m_result(chooseMedResult(m_file, settings, m_facts.findings)), m_mesh(m_file.mesh(m_result.mesh)) {
        keepRisingSteps();
        m_first = firstCells(m_mesh);
        const std::vector<bool> reached = reachedNodes();
        m_elements = medElements(m_mesh, carryingCells(), reached, path, m_facts.findings);
        decideDeaths(path);
        noteMesh(path);
        m_facts.hasVelocity = m_result.velocity &&
                              std::all_of(m_result.steps.begin(), m_result.steps.end(),
                                          [&](const MedStep& step) { return stepOf(m_result.velocity->field, step) != nullptr; });
        m_facts.flag.choices = m_result.choices;
    }

    SeriesStep step(std::size_t k) override {
        SeriesStep step;
        if (k == 0) {
            step.mesh = m_elements.mesh;
        }
        if (m_result.flag) {
            step.flags = flagsByField(m_result.steps[k]);
        } else if (m_inferred) {
            step.flags = flagsByValues(m_result.steps[k]);
        }
        return step;
    }

    SeriesFields fields(std::size_t k) const override {
        SeriesFields fields;
        fields.positions = m_mesh.nodes;
        if (m_result.displacement) {
            const std::vector<Vec3> moved = vectorsAt(*m_result.displacement, m_result.steps[k]);
            for (std::size_t n = 0; n < moved.size(); ++n) {
                fields.positions[n] += moved[n];
            }
        }
        if (hasVelocity()) {
            fields.velocities = vectorsAt(*m_result.velocity, m_result.steps[k]);
        }
        return fields;
    }

private:
    // An analysis that went on from an earlier instant has its states behind those that it gave up.
    void keepRisingSteps() {
        std::vector<MedStep> kept;
        std::int64_t dropped = 0;
        for (const MedStep& step : m_result.steps) {
            for (; !kept.empty() && kept.back().time >= step.time; ++dropped) {
                kept.pop_back();
            }
            kept.push_back(step);
        }
        if (dropped > 0) {
            m_facts.findings.add({"med.clock", "States at times that a later state has or has passed again were dropped", {}},
                                 {"med.clock.remedy", "Nothing to do if the analysis was gone on with from an earlier time.", {}},
                                 m_file.path(), dropped);
        }
        m_result.steps = std::move(kept);
        for (const MedStep& step : m_result.steps) {
            m_facts.times.push_back(step.time);
        }
    }

    static const MedStep* stepOf(const MedField& field, const MedStep& state) {
        const auto same = [&](const MedStep& step) { return step.number == state.number && step.iteration == state.iteration; };
        auto found = std::find_if(field.steps.begin(), field.steps.end(), same);
        if (found == field.steps.end()) {
            found =
                std::find_if(field.steps.begin(), field.steps.end(), [&](const MedStep& step) { return step.time == state.time; });
        }
        return found == field.steps.end() ? nullptr : &*found;
    }

    /// Calls back for each node or cell that has values: its place, and the place of its values.
    template <class Take>
    void visit(const std::vector<MedValues>& list, const Take& take) const {
        for (const MedValues& values : list) {
            // Values on cells of a type that the mesh does not have stand nowhere.
            std::size_t begin = 0, end = values.type == 0 ? m_mesh.nodes.size() : 0;
            for (std::size_t b = 0; values.type != 0 && b < m_mesh.cells.size(); ++b) {
                if (m_mesh.cells[b].type == values.type) {
                    begin = m_first[b];
                    end = m_first[b + 1];
                }
            }
            for (std::size_t i = 0; i < values.count; ++i) {
                const std::int64_t entity = values.entities.empty() ? static_cast<std::int64_t>(i) : values.entities[i] - 1;
                if (entity >= 0 && static_cast<std::size_t>(entity) < end - begin) {
                    take(begin + static_cast<std::size_t>(entity), values, i);
                }
            }
        }
    }

    /// Notes where each field of elements ever has values. @return where any has
    std::vector<bool> carryingCells() {
        std::vector<bool> any(m_first.back(), false);
        m_carries.assign(m_result.onCells.size(), any);
        for (std::size_t f = 0; f < m_result.onCells.size(); ++f) {
            const auto& [field, place] = m_result.onCells[f];
            for (const MedStep& step : field.steps) {
                visit(m_file.values(field, step, place, false),
                      [&](std::size_t cell, const MedValues&, std::size_t) { m_carries[f][cell] = any[cell] = true; });
            }
        }
        return any;
    }

    std::vector<bool> nodesAt(const MedStep& state) const {
        std::vector<bool> there(m_mesh.nodes.size(), false);
        if (const MedStep* step = stepOf(m_result.displacement->field, state)) {
            visit(m_file.values(m_result.displacement->field, *step, MedPlace::Nodes, false),
                  [&](std::size_t node, const MedValues&, std::size_t) { there[node] = true; });
        }
        return there;
    }

    std::vector<bool> reachedNodes() {
        std::vector<bool> reached;
        for (std::size_t k = 0; m_result.displacement && k < m_result.steps.size(); ++k) {
            const std::vector<bool> there = nodesAt(m_result.steps[k]);
            m_nodesVary = m_nodesVary || (k > 0 && there != m_nodes);
            reached.resize(there.size(), false);
            for (std::size_t n = 0; n < there.size(); ++n) {
                reached[n] = reached[n] || there[n];
            }
            m_nodes = there;
        }
        return reached;
    }

    // One mark an element: 1 where a field has values on it, 0 where every field of this step that ever has lacks them, else
    // nothing.
    CellMarks marksAt(const MedStep& state) const {
        CellMarks marks(m_first.back(), none);
        for (std::size_t f = 0; f < m_result.onCells.size(); ++f) {
            const auto& [field, place] = m_result.onCells[f];
            const MedStep* step = stepOf(field, state);
            for (std::size_t c = 0; step && c < marks.size(); ++c) {
                marks[c] = m_carries[f][c] && std::isnan(marks[c]) ? 0.0 : marks[c];
            }
            if (step) {
                visit(m_file.values(field, *step, place, false),
                      [&](std::size_t cell, const MedValues&, std::size_t) { marks[cell] = 1.0; });
            }
        }
        return marks;
    }

    bool valuesVary() const {
        return std::any_of(m_result.steps.begin(), m_result.steps.end(), [&](const MedStep& state) {
            const CellMarks marks = marksAt(state);
            return std::find(marks.begin(), marks.end(), 0.0) != marks.end();
        });
    }

    void decideDeaths(const std::string& path) {
        m_marks.assign(m_elements.cell.size(), 1.0);
        if (m_result.flag) {
            m_facts.flag.name = m_result.flag->name;
            m_facts.flag.activeByName = m_result.flag->activeByName;
            m_marks.assign(m_elements.cell.size(), none);
            return;
        }
        if (!deathListBeside(path).empty()) {
            return;
        }
        const bool byValues = valuesVary();
        m_inferred = byValues || m_nodesVary;
        if (!m_inferred) {
            return;
        }
        m_facts.flag.name = byValues ? "values on elements" : "nodes of elements";
        m_facts.flag.activeByName = 1;
        m_facts.findings.add(
            {"med.inferred",
             "The file does not say which elements are dead: those that a state leaves out of its fields were taken",
             {}},
            {"med.inferred.remedy",
             "If the model of the analysis did not change there, put a list of deaths (element,time) beside it.",
             {}},
            path);
    }

    std::vector<double> flagsByValues(const MedStep& state) {
        const CellMarks marks = marksAt(state);
        const std::vector<bool> there = m_nodesVary ? nodesAt(state) : std::vector<bool>{};
        for (std::size_t e = 0; e < m_marks.size(); ++e) {
            const double mark = marks[m_elements.cell[e]];
            if (!std::isnan(mark)) {
                m_marks[e] = mark;
            }
            const auto corners = m_elements.mesh.cornersOf(idAt<ElementIndex>(e));
            const bool whole =
                there.empty() || std::all_of(corners.begin(), corners.end(), [&](std::uint32_t corner) { return there[corner]; });
            if (!whole || (std::isnan(mark) && !there.empty())) {
                m_marks[e] = whole ? 1.0 : 0.0;
            }
        }
        return m_marks;
    }

    // What the field does not say at a state stays as it was; of several points of an element the mean counts.
    std::vector<double> flagsByField(const MedStep& state) {
        const MedFlag& flag = *m_result.flag;
        const MedStep* step = stepOf(flag.field, state);
        CellMarks marks(m_first.back(), none);
        const std::size_t components = flag.field.components.size();
        if (step) {
            visit(m_file.values(flag.field, *step, flag.place, true),
                  [&](std::size_t cell, const MedValues& values, std::size_t i) {
                      double sum = 0.0;
                      for (std::size_t p = 0; p < values.points; ++p) {
                          sum += values.values[(i * values.points + p) * components + flag.component];
                      }
                      marks[cell] = sum / static_cast<double>(values.points);
                  });
        }
        for (std::size_t e = 0; e < m_marks.size(); ++e) {
            const double mark = marks[m_elements.cell[e]];
            if (!std::isnan(mark)) {
                m_marks[e] = mark;
            }
        }
        return m_marks;
    }

    std::vector<Vec3> vectorsAt(const MedVector& vector, const MedStep& state) const {
        std::vector<Vec3> result(m_mesh.nodes.size(), Vec3::Constant(none));
        const MedStep* step = stepOf(vector.field, state);
        const std::size_t components = vector.field.components.size();
        if (!step) {
            return result;
        }
        visit(m_file.values(vector.field, *step, MedPlace::Nodes, true),
              [&](std::size_t node, const MedValues& values, std::size_t i) {
                  for (Eigen::Index a = 0; a < 3; ++a) {
                      const int component = vector.axis[static_cast<std::size_t>(a)];
                      result[node][a] =
                          component < 0 ? 0.0 : values.values[i * values.points * components + static_cast<std::size_t>(component)];
                  }
              });
        return result;
    }

    void noteMesh(const std::string& path) {
        if (m_mesh.axes < 3) {
            m_facts.findings.add({"fe.plane", "The model is plane: the third coordinate of its nodes was taken as zero", {}},
                                 {"fe.plane.remedy", "Frames in a plane mostly have y up: --set up_axis=y.", {}}, path);
        }
        if (m_mesh.steps > 1) {
            m_facts.findings.add(
                {"med.mesh_steps", "The mesh itself has several steps: the first was taken for all states", {}},
                {"med.mesh_steps.remedy", "Write the elements that are dead into a field, or a list of deaths.", {}},
                shownName(m_mesh.name), m_mesh.steps);
        }
    }

    MedFile m_file;
    MedResult m_result;
    MedMesh m_mesh;
    std::vector<std::size_t> m_first;  // first cell of each block
    MedElements m_elements;
    std::vector<std::vector<bool>> m_carries;  // cells on which a field ever has values, by field
    std::vector<bool> m_nodes;                 // that the newest state reaches
    bool m_nodesVary = false, m_inferred = false;
    std::vector<double> m_marks;  // the newest of each element
};

}  // namespace

bool recognisesMed(const FileHead& head) {
    return std::find(head.hdf5Names.begin(), head.hdf5Names.end(), "INFOS_GENERALES") != head.hdf5Names.end();
}

FeResult::Contents readMed(const std::string& path, const ImportSettings& settings, const Execution& execution) {
    return readSeries(path, std::make_shared<MedSeries>(path, settings), settings, execution);
}

}  // namespace rubble::io
