#include "io/fe/vtk/grid_series.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <span>
#include <unordered_map>
#include <utility>

#include "core/base/error.h"
#include "io/fe/exodus/exodus_names.h"
#include "io/fe/series/cell_shapes.h"
#include "io/fe/series/numbered_files.h"

namespace rubble::io {

namespace {

// Bits of vtkGhostType on cells; vtkLSDynaReader marks the dead as duplicates.
constexpr unsigned duplicateCell = 1u, hiddenCell = 32u;
// Some writers say "never" by a very large time.
constexpr double latestTime = 1e15;
// VTK cell types from here on have nodes on their edges.
constexpr int firstCurvedType = 21;

std::int64_t whole(double value) {
    return std::abs(value) < 9e15 ? static_cast<std::int64_t>(std::llround(value)) : -1;
}

double valueOf(const std::vector<GridArray>& arrays, const std::string& name, std::size_t i, double otherwise) {
    const GridArray* array = name.empty() ? nullptr : findArray(arrays, name);
    return array && i < array->values.size() ? array->values[i] : otherwise;
}

[[noreturn]] void failDamaged(const Message& what) {
    throw ParseError(what, {"vtk.damaged.remedy", "The file is damaged: copy it again or write it again.", {}});
}

void requireLengths(const Grid& grid, const std::string& path, std::size_t k) {
    const auto check = [&](const std::vector<GridArray>& arrays, std::size_t count) {
        for (const GridArray& array : arrays) {
            if (!array.values.empty() && array.values.size() != count * array.components) {
                failDamaged({"vtk.array_length",
                             "{0}: {1} at state {2} has {3} values instead of {4}",
                             {path, array.name, k, array.values.size(), count * array.components}});
            }
        }
    };
    check(grid.pointData, grid.points.size());
    check(grid.cellData, grid.cellCount());
    if (grid.offsets.size() != grid.cellCount() + 1 && grid.cellCount() > 0) {
        failDamaged(
            {"vtk.offsets", "{0}: state {1} has {2} offsets for {3} cells", {path, k, grid.offsets.size(), grid.cellCount()}});
    }
}

std::vector<Vec3> vectorsOf(const GridArray& array) {
    std::vector<Vec3> vectors(array.values.size() / 3);
    for (std::size_t i = 0; i < vectors.size(); ++i) {
        vectors[i] = {array.values[3 * i], array.values[3 * i + 1], array.values[3 * i + 2]};
    }
    return vectors;
}

// Nodes that both grids have lie at the same places. By number where there are numbers, else by position.
bool samePoints(const Grid& a, const Grid& b, const std::string& nodeNumbers) {
    const GridArray* left = findArray(a.pointData, nodeNumbers);
    const GridArray* right = findArray(b.pointData, nodeNumbers);
    if (!left || !right) {
        return a.points == b.points;
    }
    std::unordered_map<double, std::size_t> byNumber;
    for (std::size_t i = 0; i < std::min(left->values.size(), a.points.size()); ++i) {
        byNumber.emplace(left->values[i], i);
    }
    for (std::size_t i = 0; i < std::min(right->values.size(), b.points.size()); ++i) {
        const auto found = byNumber.find(right->values[i]);
        if (found != byNumber.end() && a.points[found->second] != b.points[i]) {
            return false;
        }
    }
    return true;
}

}  // namespace

GridSeries::GridSeries(std::string path, std::unique_ptr<const GridSource> source, const ImportSettings& settings)
    : m_path(std::move(path)), m_source(std::move(source)) {
    if (m_source->times().empty()) {
        throw ParseError({"fe.no_states", "{0} has no states: it is a mesh without results", {m_path}},
                         {"fe.no_states.remedy", "Give the result file of the analysis, not its input mesh.", {}});
    }
    m_facts.times = m_source->times();
    GridSelection all;
    all.everything = true;
    const Grid first = m_source->read(0, all);
    dropUnfinished(all);
    m_names = namesOfSeries(first, settings);
    m_facts.flag = m_names.flag;
    m_facts.hasVelocity = !m_names.velocity.empty();
    m_componentNames = first.componentNames;
    m_moves = !settings.displacement.empty() && settings.displacement != "none";
    if (!m_moves && !m_names.displacement.empty()) {
        decideDisplacement(first);
    }
}

// Some writers begin with the mesh alone: what the first state does not have is sought in the last.
GridNames GridSeries::namesOfSeries(const Grid& first, const ImportSettings& settings) const {
    GridSelection none;
    none.points = false;
    none.cells = false;
    Grid all = first;
    if (times().size() > 1) {
        const Grid last = m_source->read(times().size() - 1, none);
        for (const auto& [arrays, more] : {std::pair{&all.pointData, &last.pointData}, {&all.cellData, &last.cellData}}) {
            for (const GridArray& array : *more) {
                if (!findArray(*arrays, array.name)) {
                    arrays->push_back({array.name, array.components, {}});
                }
            }
        }
    }
    const GridNames ofAll = chooseGridNames(all, settings, m_path);
    ImportSettings byNames = settings;
    byNames.statusVariable = "";
    byNames.displacement = settings.displacement == "none" ? settings.displacement : "";
    GridNames names = chooseGridNames(first, byNames, m_path);
    if (names.flag.name.empty() || !settings.statusVariable.empty()) {
        names.flag = ofAll.flag;
        names.ghostFlag = ofAll.ghostFlag;
        names.ghostNamed = ofAll.ghostNamed;
    }
    if (names.displacement.empty() || !settings.displacement.empty()) {
        names.displacement = ofAll.displacement;
    }
    for (std::string GridNames::* name : {&GridNames::velocity, &GridNames::deathTime, &GridNames::ghost}) {
        if ((names.*name).empty()) {
            names.*name = ofAll.*name;
        }
    }
    return names;
}

void GridSeries::noteMissingTimes(const std::vector<std::string>& files) {
    // States of one file are states, whenever they are.
    m_facts.timed = files.size() < 2;
    m_facts.findings.add(
        {"vtk.no_times", "The series does not say when its states are: they were taken one second apart", {}},
        {"vtk.no_times.remedy",
         "Give a .pvd or .series file with the times, or files with TimeValue; if the files are pieces of one state, "
         "their .pvtu or .vtm; if they are no states of one analysis, set only_this_file=true.",
         {}},
        takenForStates(files), static_cast<std::int64_t>(times().size()));
}

void GridSeries::noteDroppedTimes(std::size_t count) {
    m_facts.findings.add({"xdmf.times_differ", "Times that only some of the collections have were left out", {}},
                         {"xdmf.times_differ.remedy", "Write all functions at the same times.", {}}, m_path,
                         static_cast<std::int64_t>(count));
}

void GridSeries::noteUnfinished(const std::string& file) {
    m_facts.findings.add({"fe.unfinished", "The last state is not whole and was left out", {}},
                         {"fe.unfinished.remedy", "Open the result again once the analysis has gone on.", {}}, file);
}

void GridSeries::noteLeftBlock(const std::string& file) {
    m_facts.findings.add({"vtk.left_block", "Blocks that are no unstructured grid were left out", {}},
                         {"vtk.left_block.remedy", "Write them as unstructured grids if the structure is made of them.", {}}, file);
}

void GridSeries::noteListedAgain(const std::string& file, std::int64_t times) {
    m_facts.findings.add({"vtk.listed_again", "Files that are listed more than once for a state were read once", {}},
                         {"vtk.listed_again.remedy", "Check the index; its writer may have been started twice.", {}},
                         file + ", listed " + englishInteger(times) + " times", times - 1);
}

void GridSeries::noteGaps(const std::vector<std::string>& numbered) {
    noteNumberGaps(numbered, m_facts.findings);
}

// The last state of a file may have a time before its tables are written.
void GridSeries::dropUnfinished(const GridSelection& all) {
    const std::size_t last = m_facts.times.size() - 1;
    try {
        if (last > 0) {
            requireLengths(m_source->read(last, all), m_path, last);
        }
    } catch (const Error&) {
        m_facts.times.pop_back();
        noteUnfinished(m_path + ", state " + englishInteger(static_cast<std::int64_t>(last)));
    }
}

void GridSeries::decideDisplacement(const Grid& first) {
    const std::size_t last = times().size() - 1;
    GridSelection selection;
    selection.cells = false;
    selection.pointArrays = {m_names.displacement, m_names.node};
    const Grid end = m_source->read(last, selection);
    const GridArray* displacement = findArray(end.pointData, m_names.displacement);
    const bool moved = displacement && std::any_of(displacement->values.begin(), displacement->values.end(),
                                                   [](double value) { return value != 0.0; });
    m_moves = moved && samePoints(first, end, m_names.node);
}

SeriesStep GridSeries::step(std::size_t k) {
    SeriesStep step;
    const std::vector<std::string> tell{m_names.element, m_names.part,      m_names.component,
                                        m_names.density, m_names.thickness, m_names.area};
    const bool same = k > 0 && m_source->sameCells(k, {m_names.element, m_names.part, m_names.component});
    GridSelection selection;
    selection.cells = !same;
    selection.points = !same;
    selection.cellArrays = {m_names.flag.name};
    if (!same) {
        selection.cellArrays.push_back(m_names.ghost);
        selection.cellArrays.insert(selection.cellArrays.end(), tell.begin(), tell.end());
        selection.pointArrays = {m_names.node, m_names.atRest};
    }
    const Grid grid = m_source->read(k, selection);
    if (!same) {
        requireLengths(grid, m_path, k);
        Hasher hasher;
        const auto feed = [&](const std::vector<GridArray>& arrays, const std::string& name) {
            if (const GridArray* array = findArray(arrays, name)) {
                hasher.values(std::span(array->values));
            }
        };
        hasher.value(grid.points.size())
            .values(std::span(grid.types))
            .values(std::span(grid.offsets))
            .values(std::span(grid.connectivity));
        feed(grid.cellData, m_names.element);
        feed(grid.cellData, m_names.part);
        feed(grid.cellData, m_names.component);
        feed(grid.pointData, m_names.node);
        feed(grid.cellData, m_names.ghost == m_names.flag.name ? std::string() : m_names.ghost);
        const Digest cells = hasher.finish();
        if (k == 0 || !(cells == m_cells)) {
            step.mesh = meshOf(grid, k);
            findGhosts(grid, k, step);
            if (std::adjacent_find(m_kept.begin(), m_kept.end()) != m_kept.end()) {
                step.cells = m_kept;
            }
            m_cells = cells;
        }
    }
    if (const GridArray* flags = findArray(grid.cellData, m_names.flag.name)) {
        for (const std::size_t cell : m_kept) {
            if (cell >= flags->values.size()) {
                failDamaged({"vtk.array_length",
                             "{0}: {1} at state {2} has {3} values and ends before cell {4}",
                             {m_path, m_names.flag.name, k, flags->values.size(), cell}});
            }
            step.flags.push_back(m_names.ghostFlag ? flagOf(flags->values[cell]) : flags->values[cell]);
        }
    }
    return step;
}

// By the name of the mark: bits of vtkGhostType, layers of vtkGhostLevels, the rank of the owner.
bool GridSeries::isGhost(double value) const {
    if (findAny({m_names.ghost}, {"vtkghosttype"}) == 0) {
        return value >= 0.0 && value < 256.0 && (static_cast<unsigned>(value) & duplicateCell) != 0;
    }
    return findAny({m_names.ghost}, {"vtkghostlevels"}) == 0 ? value > 0.0 : value >= 0.0;
}

// Copies of another piece are not dead: the mark tells death only in one piece, and where nothing bears it from the first.
double GridSeries::flagOf(double value) const {
    const bool copies = m_inPieces || (m_copiesAtFirst && !m_names.ghostNamed);
    const unsigned dead = copies ? hiddenCell : duplicateCell | hiddenCell;
    return value >= 0.0 && value < 256.0 ? ((static_cast<unsigned>(value) & dead) != 0 ? 1.0 : 0.0) : value;
}

void GridSeries::findGhosts(const Grid& grid, std::size_t k, SeriesStep& step) {
    m_inPieces = grid.pieces.size() > 1;
    const GridArray* marks = m_names.ghost.empty() ? nullptr : findArray(grid.cellData, m_names.ghost);
    std::int64_t count = 0;
    for (const std::size_t cell : m_kept) {
        const bool ghost = marks && cell < marks->values.size() && isGhost(marks->values[cell]);
        count += ghost ? 1 : 0;
        if (m_inPieces) {
            step.ghosts.push_back(ghost);
        }
    }
    for (const MeshPiece& piece : grid.pieces) {
        const auto end = std::lower_bound(m_kept.begin(), m_kept.end(), piece.elements);
        step.pieces.push_back({piece.nodes, static_cast<std::size_t>(end - m_kept.begin())});
    }
    if (k == 0 && count > 0 && !m_inPieces && m_names.ghostFlag && !m_names.ghostNamed) {
        m_copiesAtFirst = true;
        m_facts.findings.add({"vtk.copies",
                              "Cells are marked as copies ({0}) from the first state on: the mark was not taken for death",
                              {m_names.ghost}},
                             {"vtk.copies.remedy",
                              "Open all pieces of the result; if the mark tells death, set status_variable={0}.",
                              {m_names.ghost}},
                             m_path, count);
    }
}

// Converters write the links of rigid bodies as lines without a number.
bool GridSeries::isLink(const Grid& grid, std::size_t cell) {
    if (grid.types[cell] != 3 || m_names.element.empty() || valueOf(grid.cellData, m_names.element, cell, 1.0) != 0.0) {
        return false;
    }
    m_facts.findings.add({"vtk.links", "Lines without an element number were left out: they are links of rigid bodies", {}},
                         {"vtk.links.remedy", "Nothing to do.", {}}, "cell " + englishInteger(static_cast<std::int64_t>(cell)));
    return true;
}

Mesh GridSeries::meshOf(const Grid& grid, std::size_t k) {
    Mesh mesh;
    mesh.nodes = grid.points;
    if (const GridArray* atRest = findArray(grid.pointData, m_names.atRest);
        atRest && atRest->values.size() == 3 * grid.points.size()) {
        mesh.nodes = vectorsOf(*atRest);
    }
    if (const GridArray* numbers = findArray(grid.pointData, m_names.node); numbers && !numbers->values.empty()) {
        for (const double number : numbers->values) {
            mesh.nodeIds.push_back(whole(number));
        }
    }
    mesh.offsets.push_back(0);
    m_kept.clear();
    for (std::size_t cell = 0; cell < grid.cellCount(); ++cell) {
        if (!isLink(grid, cell)) {
            addCell(grid, cell, k, mesh);
            m_kept.resize(mesh.elementCount(), cell);
        }
    }
    if (k == 0) {
        m_straight.note(m_facts.findings);
    }
    return mesh;
}

void GridSeries::addCell(const Grid& grid, std::size_t cell, std::size_t k, Mesh& mesh) {
    const int type = grid.types[cell];
    const auto shape = shapeOfVtkCell(type);
    if (!shape && !isTakenApart(type)) {
        skipCell(grid, cell);
        return;
    }
    std::vector<std::uint32_t> corners = pointsOf(grid, cell, k);
    if (!shape) {
        addPieces(grid, cell, corners, mesh);
        return;
    }
    orderVtkCorners(type, corners);
    // Some writers give triangles four points and repeat the last.
    if (corners.size() < static_cast<std::size_t>(cornerCount(*shape))) {
        failDamaged({"vtk.short_cell",
                     "{0}: cell {1} at state {2} is a {3} of {4} points",
                     {m_path, cell, k, shapeName(*shape), corners.size()}});
    }
    if (k == 0 && type >= firstCurvedType) {
        std::vector<Vec3> places;
        for (const std::uint32_t corner : corners) {
            places.push_back(mesh.nodes[corner]);
        }
        m_straight.add(*shape, EdgeOrder::TopBeforeSides, places, "cell " + englishInteger(static_cast<std::int64_t>(cell)));
    }
    corners.resize(static_cast<std::size_t>(cornerCount(*shape)));
    addElement(grid, cell, *shape, corners, mesh);
}

void GridSeries::skipCell(const Grid& grid, std::size_t cell) {
    m_facts.findings.add({"vtk.skipped_cell", "Cells of a type that makes no fragment were left out", {}},
                         {"vtk.skipped_cell.remedy", "Nothing to do if they are masses, contacts or particles.", {}},
                         nameOfVtkCell(grid.types[cell]));
}

std::vector<std::uint32_t> GridSeries::pointsOf(const Grid& grid, std::size_t cell, std::size_t k) const {
    const std::int64_t begin = grid.offsets[cell], end = grid.offsets[cell + 1];
    const bool inside = begin >= 0 && end >= begin && static_cast<std::size_t>(end) <= grid.connectivity.size();
    std::vector<std::uint32_t> points;
    for (std::int64_t i = begin; inside && i < end; ++i) {
        const std::int64_t point = grid.connectivity[static_cast<std::size_t>(i)];
        if (point < 0 || static_cast<std::size_t>(point) >= grid.points.size()) {
            failDamaged({"vtk.bad_point",
                         "{0}: cell {1} at state {2} uses point {3} of {4}",
                         {m_path, cell, k, point, grid.points.size()}});
        }
        points.push_back(static_cast<std::uint32_t>(point));
    }
    return points;
}

// A body keeps its pieces when its points have moved and its faces are no longer flat.
void GridSeries::addPieces(const Grid& grid, std::size_t cell, const std::vector<std::uint32_t>& points, Mesh& mesh) {
    std::vector<std::int64_t> key{grid.types[cell]};
    std::vector<Vec3> places;
    for (const std::uint32_t point : points) {
        key.push_back(mesh.nodeIds.empty() ? static_cast<std::int64_t>(point) : mesh.nodeIds[point]);
        places.push_back(mesh.nodes[point]);
    }
    const auto [known, isNew] = m_pieces.try_emplace(std::move(key));
    if (isNew) {
        known->second = piecesOfVtkCell(grid.types[cell], places);
    }
    if (known->second.empty()) {
        skipCell(grid, cell);
        return;
    }
    if (isNew && known->second.size() > 1) {
        m_facts.findings.add(
            {"vtk.taken_apart", "Cells were taken apart into solids, shells or beams, which die together", {}},
            {"vtk.taken_apart.remedy", "Nothing to do: they fill the same volume.", {}},
            nameOfVtkCell(grid.types[cell]) + " into " + englishInteger(static_cast<std::int64_t>(known->second.size())));
    }
    for (const CellPiece& piece : known->second) {
        std::vector<std::uint32_t> corners;
        for (const std::uint32_t corner : piece.corners) {
            corners.push_back(points[corner]);
        }
        addElement(grid, cell, piece.shape, corners, mesh);
    }
}

void GridSeries::addElement(const Grid& grid, std::size_t cell, ElementShape shape, const std::vector<std::uint32_t>& corners,
                            Mesh& mesh) {
    mesh.shapes.push_back(shape);
    mesh.corners.insert(mesh.corners.end(), corners.begin(), corners.end());
    mesh.offsets.push_back(static_cast<std::uint32_t>(mesh.corners.size()));
    const std::int64_t part = whole(valueOf(grid.cellData, m_names.part, cell, 1.0));
    mesh.part.push_back(m_names.component.empty()
                            ? partOf(part, shape, mesh)
                            : componentOf(whole(valueOf(grid.cellData, m_names.component, cell, -1.0)), part, mesh));
    if (!m_names.element.empty()) {
        mesh.elementIds.push_back(whole(valueOf(grid.cellData, m_names.element, cell, -1.0)));
    }
    constexpr double nothing = std::numeric_limits<double>::quiet_NaN();
    mesh.density.push_back(valueOf(grid.cellData, m_names.density, cell, nothing));
    mesh.section.push_back(isShell(shape) ? valueOf(grid.cellData, m_names.thickness, cell, nothing)
                                          : valueOf(grid.cellData, m_names.area, cell, nothing));
}

// Numbers of parts count by kind: bricks and trusses of one number are two parts.
std::uint32_t GridSeries::partOf(std::int64_t id, ElementShape shape, Mesh& mesh) const {
    const std::string name = "part " + std::to_string(id) + (isSolid(shape) ? "" : isShell(shape) ? " shells" : " beams");
    for (std::size_t p = mesh.parts.size(); p-- > 0;) {
        if (mesh.parts[p].name == name) {
            return static_cast<std::uint32_t>(p);
        }
    }
    mesh.parts.push_back({name, id});
    return static_cast<std::uint32_t>(mesh.parts.size() - 1);
}

// The last state knows every death; 0 stands for never.
std::vector<std::pair<std::int64_t, double>> GridSeries::deathTimes() const {
    std::vector<std::pair<std::int64_t, double>> result;
    if (m_names.deathTime.empty() || m_names.element.empty()) {
        return result;
    }
    GridSelection selection;
    selection.points = false;
    selection.cells = false;
    selection.cellArrays = {m_names.element, m_names.deathTime};
    const Grid last = m_source->read(times().size() - 1, selection);
    const GridArray* numbers = findArray(last.cellData, m_names.element);
    const GridArray* deaths = findArray(last.cellData, m_names.deathTime);
    for (std::size_t c = 0; numbers && deaths && c < std::min(numbers->values.size(), deaths->values.size()); ++c) {
        if (deaths->values[c] > 0.0 && deaths->values[c] < latestTime) {
            result.emplace_back(whole(numbers->values[c]), deaths->values[c]);
        }
    }
    return result;
}

// A numbered list of names knows no kinds.
std::uint32_t GridSeries::componentOf(std::int64_t index, std::int64_t id, Mesh& mesh) const {
    const bool named = index >= 0 && static_cast<std::size_t>(index) < m_componentNames.size();
    const std::string name = named ? m_componentNames[static_cast<std::size_t>(index)] : "component " + std::to_string(index);
    for (std::size_t p = mesh.parts.size(); p-- > 0;) {
        if (mesh.parts[p].name == name) {
            return static_cast<std::uint32_t>(p);
        }
    }
    mesh.parts.push_back({name, m_names.part.empty() ? index : id});
    return static_cast<std::uint32_t>(mesh.parts.size() - 1);
}

SeriesFields GridSeries::fields(std::size_t k) const {
    GridSelection selection;
    selection.cells = false;
    selection.pointArrays = {m_names.velocity, m_moves ? m_names.displacement : ""};
    const Grid grid = m_source->read(k, selection);
    SeriesFields fields;
    fields.positions = grid.points;
    const GridArray* displacement = m_moves ? findArray(grid.pointData, m_names.displacement) : nullptr;
    if (displacement && displacement->values.size() == 3 * fields.positions.size()) {
        const std::vector<Vec3> moved = vectorsOf(*displacement);
        for (std::size_t n = 0; n < moved.size(); ++n) {
            fields.positions[n] += moved[n];
        }
    }
    const GridArray* velocity = findArray(grid.pointData, m_names.velocity);
    if (velocity && velocity->values.size() == 3 * fields.positions.size()) {
        fields.velocities = vectorsOf(*velocity);
    }
    return fields;
}

}  // namespace rubble::io
