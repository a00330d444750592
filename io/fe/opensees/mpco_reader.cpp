#include "io/fe/opensees/mpco_reader.h"

#include <algorithm>
#include <charconv>
#include <filesystem>
#include <limits>
#include <map>
#include <memory>
#include <set>

#include "core/base/error.h"
#include "core/base/nearest_names.h"
#include "io/fe/opensees/mpco_classes.h"
#include "io/fe/opensees/mpco_file.h"
#include "io/fe/series/numbered_files.h"
#include "io/fe/series/series_result.h"

namespace rubble::io {

namespace {

namespace fs = std::filesystem;

constexpr std::string_view pieceMark = ".part-";

/// "wall" and 3 of wall.part-3.mpco; nothing for a file that is no piece.
std::optional<std::pair<std::string, int>> pieceOf(const std::string& path) {
    const std::string name = fs::path(path).filename().string();
    const std::size_t mark = name.rfind(pieceMark);
    int number = 0;
    if (mark == std::string::npos) {
        return std::nullopt;
    }
    const char* const begin = name.data() + mark + pieceMark.size();
    const auto [end, error] = std::from_chars(begin, name.data() + name.size(), number);
    if (error != std::errc{} || number < 0 || std::string_view(end) != ".mpco") {
        return std::nullopt;
    }
    return std::pair(name.substr(0, mark), number);
}

std::map<int, std::string> piecesBeside(const std::string& path) {
    std::map<int, std::string> pieces;
    const auto own = pieceOf(path);
    for (const std::string& other : own ? filesBeside(path) : std::vector<std::string>{}) {
        const auto piece = pieceOf(other);
        if (piece && piece->first == own->first) {
            pieces.emplace(piece->second, other);
        }
    }
    return pieces;
}

std::vector<std::string> piecesOf(const std::string& path) {
    std::vector<std::string> files;
    for (auto& [number, file] : piecesBeside(path)) {
        files.push_back(std::move(file));
    }
    return files.empty() ? std::vector<std::string>{path} : files;
}

// The processes of an analysis are counted from 0, and each writes its own piece.
void requireAllPieces(const std::string& path) {
    const std::map<int, std::string> pieces = piecesBeside(path);
    std::vector<std::string> missing;
    for (int n = 0; !pieces.empty() && n < pieces.rbegin()->first && missing.size() < 100; ++n) {
        if (!pieces.contains(n)) {
            missing.push_back(pieceOf(path)->first + std::string(pieceMark) + std::to_string(n) + ".mpco");
        }
    }
    if (!missing.empty()) {
        throw WorldError(
            {"mpco.pieces", "{0} is a piece of a parallel analysis; beside it is missing {1}", {path, quotedList(missing, 10)}},
            {"mpco.pieces.remedy", "Copy all pieces of the analysis into one folder.", {}});
    }
}

/// One stage as all pieces together hold it.
struct JoinedModel {
    Mesh mesh;
    std::vector<std::vector<std::uint32_t>> rows;            ///< node of each row of results, by piece
    std::set<std::pair<std::int64_t, std::string>> leftOut;  ///< number and class of elements that are no structure
};

/// Puts the pieces of a model together: nodes on the border of two pieces stand in both.
class ModelJoin {
public:
    JoinedModel result;

    void addNodes(const MpcoModel& model) {
        for (std::size_t n = 0; n < model.nodeIds.size(); ++n) {
            if (m_nodes.try_emplace(model.nodeIds[n], static_cast<std::uint32_t>(result.mesh.nodes.size())).second) {
                result.mesh.nodeIds.push_back(model.nodeIds[n]);
                result.mesh.nodes.push_back(model.nodes[n]);
            }
        }
    }

    void addElements(const MpcoModel& model, const std::string& path) {
        if (result.mesh.offsets.empty()) {
            result.mesh.offsets.push_back(0);
        }
        for (const MpcoTable& table : model.tables) {
            const MpcoClass kind = mpcoClass(table.name);
            for (std::size_t at = 0; at + table.width <= table.rows.size(); at += table.width) {
                addElement(model, table, kind, std::span(table.rows).subspan(at, table.width), path);
            }
        }
    }

    void addRows(const std::vector<std::int64_t>& numbers, const std::string& path) {
        std::vector<std::uint32_t>& rows = result.rows.emplace_back();
        for (const std::int64_t number : numbers) {
            rows.push_back(nodeAt(number, path, "a table of results"));
        }
    }

private:
    std::uint32_t nodeAt(std::int64_t number, const std::string& path, const std::string& user) const {
        const auto found = m_nodes.find(number);
        if (found == m_nodes.end()) {
            throw ParseError({"mpco.bad_node", "{0}: {1} uses the node {2}, which is not there", {path, user, number}},
                             {"mpco.bad_node.remedy", "Copy the file again, and all pieces of a parallel analysis with it.", {}});
        }
        return found->second;
    }

    void addElement(const MpcoModel& model, const MpcoTable& table, const MpcoClass& kind, std::span<const std::int64_t> row,
                    const std::string& path) {
        const std::int64_t number = row[0];
        std::vector<std::uint32_t> nodes;
        std::vector<Vec3> places;
        for (const std::int64_t node : row.subspan(1)) {
            nodes.push_back(nodeAt(node, path, "element " + englishInteger(number)));
            places.push_back(result.mesh.nodes[nodes.back()]);
        }
        const auto shape = isNoStructure(kind.name) ? std::nullopt : mpcoShape(table.geometry, kind.name, places);
        if (!shape || (*shape == ElementShape::Beam && (places[1] - places[0]).norm() <= shortest * places[0].norm())) {
            result.leftOut.emplace(number, kind.name);
            return;
        }
        if (!m_elements.insert(number).second) {
            return;  // an element of the border that two pieces hold
        }
        Mesh& mesh = result.mesh;
        mesh.shapes.push_back(*shape);
        mesh.elementIds.push_back(number);
        mesh.part.push_back(partOf(kind));
        mesh.corners.insert(mesh.corners.end(), nodes.begin(), nodes.begin() + cornerCount(*shape));
        mesh.offsets.push_back(static_cast<std::uint32_t>(mesh.corners.size()));
        const auto section = model.section.find(number);
        mesh.section.push_back(section == model.section.end() || isSolid(*shape) ? std::numeric_limits<double>::quiet_NaN()
                                                                                 : section->second);
    }

    std::uint32_t partOf(const MpcoClass& kind) {
        std::vector<Part>& parts = result.mesh.parts;
        for (std::size_t p = 0; p < parts.size(); ++p) {
            if (parts[p].name == kind.name && parts[p].fileId == kind.tag) {
                return static_cast<std::uint32_t>(p);
            }
        }
        parts.push_back({kind.name, kind.tag});
        return static_cast<std::uint32_t>(parts.size() - 1);
    }

    static constexpr double shortest = 1e-9;  // of the distance from the origin: less is rounding

    std::unordered_map<std::int64_t, std::uint32_t> m_nodes;  // by number
    std::set<std::int64_t> m_elements;
};

class MpcoSeries : public MeshSeries {
public:
    MpcoSeries(const std::string& path, const ImportSettings& settings) {
        if (!settings.onlyThisFile) {
            requireAllPieces(path);
        }
        const std::string displacement = settings.displacement.empty() ? "DISPLACEMENT" : settings.displacement;
        bool plane = false;
        for (const std::string& file : settings.onlyThisFile ? std::vector<std::string>{path} : piecesOf(path)) {
            m_pieces.push_back(std::make_unique<const MpcoFile>(file, displacement));
            plane = plane || m_pieces.back()->plane();
        }
        requireStates(displacement, !settings.displacement.empty());
        alignStates();
        dropSetBack();
        m_facts.hasVelocity = std::all_of(m_states.begin(), m_states.end(), [&](const State& state) { return hasVelocity(state); });
        for (const State& state : m_states) {
            m_facts.times.push_back(timeOf(state));
        }
        m_layouts.resize(m_states.size());
        noteWorkarounds(path, plane, settings.onlyThisFile);
    }

    SeriesStep step(std::size_t k) override {
        SeriesStep step;
        if (k > 0 && stagesOf(m_states[k]) == stagesOf(m_states[k - 1])) {
            m_layouts[k] = m_layouts[k - 1];
            return step;
        }
        JoinedModel model = join(m_states[k]);
        noteLeftOut(model.leftOut);
        auto layout = std::make_shared<Layout>(Layout{model.mesh.nodes, std::move(model.rows)});
        // Most stages change a few elements: those without any share what they have in common.
        m_layouts[k] = k > 0 && m_layouts[k - 1]->nodes == layout->nodes && m_layouts[k - 1]->rows == layout->rows
                           ? m_layouts[k - 1]
                           : std::shared_ptr<const Layout>(std::move(layout));
        step.mesh = std::move(model.mesh);
        return step;
    }

    SeriesFields fields(std::size_t k) const override {
        const Layout& layout = *m_layouts[k];
        SeriesFields fields;
        fields.positions = layout.nodes;
        fields.velocities.assign(hasVelocity() ? layout.nodes.size() : 0, Vec3::Zero());
        for (std::size_t p = 0; p < m_pieces.size(); ++p) {
            const std::size_t state = m_states[k][p];
            if (m_pieces[p]->states()[state].displacement.empty()) {
                continue;
            }
            const std::vector<std::uint32_t>& rows = layout.rows[p];
            const std::vector<Vec3> moved = m_pieces[p]->displacements(state);
            const std::vector<Vec3> speeds = hasVelocity() ? m_pieces[p]->velocities(state) : std::vector<Vec3>{};
            for (std::size_t r = 0; r < rows.size() && r < moved.size(); ++r) {
                fields.positions[rows[r]] = layout.nodes[rows[r]] + moved[r];
                if (r < speeds.size()) {
                    fields.velocities[rows[r]] = speeds[r];
                }
            }
        }
        return fields;
    }

private:
    using State = std::vector<std::size_t>;  // of each piece

    struct Layout {
        std::vector<Vec3> nodes;
        std::vector<std::vector<std::uint32_t>> rows;
    };

    const MpcoState& record(const State& state, std::size_t piece) const { return m_pieces[piece]->states()[state[piece]]; }
    double timeOf(const State& state) const { return record(state, 0).time; }

    State stagesOf(const State& state) const {
        State stages;
        for (std::size_t p = 0; p < state.size(); ++p) {
            stages.push_back(record(state, p).stage);
        }
        return stages;
    }

    using MeshSeries::hasVelocity;
    bool hasVelocity(const State& state) const {
        for (std::size_t p = 0; p < state.size(); ++p) {
            if (record(state, p).velocity.empty()) {
                return false;
            }
        }
        return true;
    }

    void requireStates(const std::string& displacement, bool asked) const {
        const bool any = std::any_of(m_pieces.begin(), m_pieces.end(), [](const auto& piece) { return !piece->states().empty(); });
        if (any) {
            return;
        }
        const std::string& path = m_pieces.front()->path();
        const Message remedy{"mpco.no_displacement.remedy",
                             "Record it: recorder mpco FILE -N displacement velocity. Nodal results in the file: {0}. With "
                             "displacement=none its stages are the states and nothing moves.",
                             {quotedList(m_pieces.front()->nodalResults(), 100)}};
        if (asked) {
            throw UsageError({"mpco.unknown_displacement", "{0} has no states with the nodal result \"{1}\"", {path, displacement}},
                             remedy);
        }
        throw ParseError({"mpco.no_displacement", "{0} has no states with displacements of the nodes", {path}}, remedy);
    }

    // Pieces are written one after the other: a state counts once all have it.
    void alignStates() {
        std::vector<std::map<std::pair<std::int64_t, double>, std::size_t>> places(m_pieces.size());
        for (std::size_t p = 0; p < m_pieces.size(); ++p) {
            for (std::size_t k = 0; k < m_pieces[p]->states().size(); ++k) {
                const MpcoState& state = m_pieces[p]->states()[k];
                places[p].insert_or_assign({state.step, state.time}, k);
            }
        }
        std::set<std::pair<std::int64_t, double>> incomplete;
        for (std::size_t k = 0; k < m_pieces.front()->states().size(); ++k) {
            const MpcoState& first = m_pieces.front()->states()[k];
            State state{k};
            for (std::size_t p = 1; p < m_pieces.size(); ++p) {
                if (const auto found = places[p].find({first.step, first.time}); found != places[p].end()) {
                    state.push_back(found->second);
                }
            }
            if (state.size() == m_pieces.size()) {
                m_states.push_back(std::move(state));
            } else {
                incomplete.emplace(first.step, first.time);
            }
        }
        for (std::size_t p = 1; p < m_pieces.size(); ++p) {
            for (const auto& [key, k] : places[p]) {
                if (!places.front().contains(key)) {
                    incomplete.insert(key);
                }
            }
        }
        if (!incomplete.empty()) {
            m_facts.findings.add(
                {"mpco.piece_states", "States that not all pieces hold were left out", {}},
                {"mpco.piece_states.remedy", "Open the result again once all processes have written them.", {}},
                "step " + englishInteger(incomplete.begin()->first) + " at " + englishNumber(incomplete.begin()->second) + " s",
                static_cast<std::int64_t>(incomplete.size()));
        }
    }

    // Gravity is often applied first, and the clock set back before the collapse.
    void dropSetBack() {
        std::vector<State> kept, dropped;
        for (const State& state : m_states) {
            while (!kept.empty() && timeOf(kept.back()) >= timeOf(state)) {
                dropped.push_back(kept.back());
                kept.pop_back();
            }
            kept.push_back(state);
        }
        if (dropped.empty()) {
            return;
        }
        m_states = std::move(kept);
        double last = timeOf(dropped.front());
        for (const State& state : dropped) {
            last = std::max(last, timeOf(state));
        }
        m_facts.findings.add(
            {"mpco.clock", "The clock of the analysis was set back: earlier states at the same times were dropped", {}},
            {"mpco.clock.remedy", "Nothing to do if they only applied the loads, such as gravity.", {}},
            "states up to " + englishNumber(last) + " s", static_cast<std::int64_t>(dropped.size()));
        noteLost(dropped);
    }

    // An element that was removed before the clock was set back is in no state that is left.
    void noteLost(const std::vector<State>& dropped) {
        const auto numbers = [&](const State& state) {
            std::set<std::int64_t> found;
            for (const std::int64_t number : join(state).mesh.elementIds) {
                found.insert(number);
            }
            return found;
        };
        std::set<State> stages;
        std::set<std::int64_t> before, after;
        for (const State& state : m_states) {
            if (stages.insert(stagesOf(state)).second) {
                after.merge(numbers(state));
            }
        }
        for (const State& state : dropped) {
            if (stages.insert(stagesOf(state)).second) {
                before.merge(numbers(state));
            }
        }
        std::erase_if(before, [&](std::int64_t number) { return after.contains(number); });
        if (!before.empty()) {
            m_facts.findings.add(
                {"mpco.lost", "Elements that were removed before the clock was set back are not in the result", {}},
                {"mpco.lost.remedy", "Let the analysis go on without setting the clock back (loadConst without -time).", {}},
                "element " + englishInteger(*before.begin()), static_cast<std::int64_t>(before.size()));
        }
    }

    JoinedModel join(const State& state) const {
        ModelJoin join;
        std::vector<MpcoModel> models;
        for (std::size_t p = 0; p < m_pieces.size(); ++p) {
            models.push_back(m_pieces[p]->model(record(state, p).stage));
            join.addNodes(models.back());
        }
        for (std::size_t p = 0; p < m_pieces.size(); ++p) {
            join.addElements(models[p], m_pieces[p]->path());
            join.addRows(m_pieces[p]->rowNodes(record(state, p).stage), m_pieces[p]->path());
        }
        return std::move(join.result);
    }

    void noteLeftOut(const std::set<std::pair<std::int64_t, std::string>>& leftOut) {
        for (const auto& [number, name] : leftOut) {
            if (m_leftOut.insert(number).second) {
                m_facts.findings.add(
                    {"mpco.left_out", "Elements that are no structure were left out: springs, contacts, loads, links", {}},
                    {"mpco.left_out.remedy", "Nothing to do if they are none.", {}},
                    "element " + englishInteger(number) + ", " + name);
            }
        }
    }

    void noteWorkarounds(const std::string& path, bool plane, bool alone) {
        if (plane) {
            m_facts.findings.add({"fe.plane", "The model is plane: the third coordinate of its nodes was taken as zero", {}},
                                 {"fe.plane.remedy", "Frames in a plane mostly have y up: --set up_axis=y.", {}}, path);
        }
        const bool cut = std::any_of(m_pieces.begin(), m_pieces.end(), [](const auto& piece) { return piece->unfinished(); });
        if (cut) {
            m_facts.findings.add({"fe.unfinished", "The last state is not whole and was left out", {}},
                                 {"fe.unfinished.remedy", "Open the result again once the analysis has gone on.", {}}, path);
        }
        if (m_pieces.size() == 1 && pieceOf(path)) {
            const Message copy{"mpco.one_piece.remedy", "Copy all pieces of the analysis into one folder.", {}};
            const Message asked{"mpco.one_piece.asked", "Set only_this_file=false to open the whole result.", {}};
            m_facts.findings.add({"mpco.one_piece", "One piece of a parallel analysis was read as the whole", {}},
                                 alone ? asked : copy, path);
        }
    }

    std::vector<std::unique_ptr<const MpcoFile>> m_pieces;
    std::vector<State> m_states;
    std::vector<std::shared_ptr<const Layout>> m_layouts;
    std::set<std::int64_t> m_leftOut;
};

}  // namespace

bool recognisesMpco(const FileHead& head) {
    return std::any_of(head.hdf5Names.begin(), head.hdf5Names.end(),
                       [](const std::string& name) { return name.starts_with("MODEL_STAGE["); });
}

std::vector<std::string> mpcoMembers(const std::string& path) {
    return withDeathList(piecesOf(path));
}

bool isMpcoPiece(const std::string& path) {
    return pieceOf(path).has_value();
}

FeResult::Contents readMpco(const std::string& path, const ImportSettings& settings, const Execution& execution) {
    return readSeries(path, std::make_shared<MpcoSeries>(path, settings), settings, execution);
}

}  // namespace rubble::io
