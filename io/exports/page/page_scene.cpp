#include "io/exports/page/page_scene.h"

#include <algorithm>
#include <set>
#include <unordered_map>

#include "core/base/error.h"
#include "core/fe/components.h"
#include "core/fe/material.h"
#include "io/exports/page/page_export.h"
#include "io/exports/page/page_structure.h"
#include "io/run/fragment_places.h"
#include "io/run/shown_span.h"

namespace rubble::io {

namespace {

/// Times that all is packed again in steps a quarter as large before a page is given up.
constexpr int tightenings = 3;

/// Something rigid that a body carries: a fragment, or an element of an island.
struct PagePiece {
    std::size_t body = 0;
    std::int64_t fragment = -1;  ///< -1: an element of an island
    std::size_t element = 0;
    ElementShape shape = ElementShape::Hexahedron;
    ShownSpan shown;
    std::vector<Vec3> corners;  ///< m, in the frame of the body
};

class PieceCollector {
public:
    PieceCollector(const RunReader& run, const FeResult& fe, const FragmentSet& fragments)
        : m_fe(fe), m_fragments(fragments), m_bodies(run.bodies()), m_islands(run.islands()), m_carriers(run.carriers()) {
        std::erase_if(m_islands, [&](const IslandRecord& island) {
            return at(island.body) >= m_bodies.size() ||
                   std::ranges::any_of(island.elements, [&](ElementIndex e) { return at(e) >= fe.mesh().elementCount(); });
        });
    }

    std::vector<PagePiece> pieces() const;
    const std::vector<BodyRecord>& bodies() const { return m_bodies; }

private:
    void addFragments(std::vector<PagePiece>& pieces) const;
    void addIslands(std::vector<PagePiece>& pieces) const;

    const FeResult& m_fe;
    const FragmentSet& m_fragments;
    std::vector<BodyRecord> m_bodies;
    std::vector<IslandRecord> m_islands;
    std::vector<Carrier> m_carriers;
};

void PieceCollector::addFragments(std::vector<PagePiece>& pieces) const {
    std::set<ElementIndex> inIslands;
    for (const IslandRecord& island : m_islands) {
        inIslands.insert(island.elements.begin(), island.elements.end());
    }
    for (const Carrier& carrier : m_carriers) {
        const std::size_t f = at(carrier.fragment);
        const Fragment& fragment = m_fragments.list[f];
        PagePiece piece{at(carrier.body),
                        static_cast<std::int64_t>(f),
                        at(fragment.element),
                        m_fragments.solid[f],
                        shownSpan(carrier, fragment, m_bodies[at(carrier.body)], inIslands.contains(fragment.element)),
                        {}};
        for (const Vec3& vertex : m_fragments.verticesOf(carrier.fragment)) {
            piece.corners.push_back(carrier.handOverToBody * vertex);
        }
        if (piece.shown.from < piece.shown.to) {
            pieces.push_back(std::move(piece));
        }
    }
}

void PieceCollector::addIslands(std::vector<PagePiece>& pieces) const {
    const Mesh& mesh = m_fe.mesh();
    for (const IslandRecord& island : m_islands) {
        const BodyRecord& body = m_bodies[at(island.body)];
        const auto then = m_fe.state(std::min<std::size_t>(island.state, m_fe.stateCount() - 1));
        const Pose toBody = island.inFe.inverse();
        for (const ElementIndex e : island.elements) {
            PagePiece piece{at(island.body), -1, at(e), mesh.shapes[at(e)], {body.from, body.to}, {}};
            for (const std::uint32_t node : mesh.cornersOf(e)) {
                piece.corners.push_back(toBody * then->positions[node]);
            }
            if (std::ranges::all_of(piece.corners, [](const Vec3& p) { return p.allFinite(); })) {
                pieces.push_back(std::move(piece));
            }
        }
    }
}

std::vector<PagePiece> PieceCollector::pieces() const {
    std::vector<PagePiece> pieces;
    addFragments(pieces);
    addIslands(pieces);
    std::ranges::stable_sort(pieces, [](const PagePiece& a, const PagePiece& b) {
        return a.shown.from != b.shown.from ? a.shown.from < b.shown.from : a.body < b.body;
    });
    return pieces;
}

/// Returns the largest error of a corner, m.
double addCorners(PageData& data, const std::vector<PagePiece>& pieces, double step) {
    PackedPlaces places(step);
    for (const PagePiece& piece : pieces) {
        for (const Vec3& corner : piece.corners) {
            places.add(corner);
        }
    }
    data.add("pieceCorners", places.numbers());
    return places.largestError();
}

void addPieces(PageScene& scene, const std::vector<PagePiece>& pieces) {
    std::vector<std::int64_t> bodies, fragments, elements;
    std::vector<std::uint8_t> shapes;
    std::vector<double> times;
    for (const PagePiece& piece : pieces) {
        bodies.push_back(static_cast<std::int64_t>(piece.body));
        fragments.push_back(piece.fragment);
        elements.push_back(static_cast<std::int64_t>(piece.element));
        shapes.push_back(static_cast<std::uint8_t>(piece.shape));
        times.push_back(piece.shown.from);
        times.push_back(piece.shown.to);
    }
    std::sort(times.begin(), times.end());
    times.erase(std::unique(times.begin(), times.end()), times.end());
    std::vector<std::int64_t> from, to;
    const auto numberOf = [&](double time) { return std::lower_bound(times.begin(), times.end(), time) - times.begin(); };
    for (const PagePiece& piece : pieces) {
        from.push_back(numberOf(piece.shown.from));
        to.push_back(numberOf(piece.shown.to));
    }
    const auto add = [&](const char* name, const std::vector<std::int64_t>& numbers) {
        PackedIntegers steps;
        steps.addSteps(numbers);
        scene.data.add(name, steps);
    };
    add("pieceBodies", bodies);
    add("pieceFragments", fragments);
    add("pieceElements", elements);
    scene.data.add("pieceShapes", shapes);
    scene.data.add("pieceTimes", times);
    add("pieceFrom", from);
    add("pieceTo", to);
    scene.about["pieceCount"] = pieces.size();
}

void addFragmentFigures(PageScene& scene, const RunReader& run, const FragmentSet& fragments) {
    std::vector<double> births;
    std::vector<float> masses;
    PackedIntegers clusters;
    const auto clustering = run.clustering();
    for (std::size_t f = 0; f < fragments.size(); ++f) {
        births.push_back(fragments.list[f].birthTime);
        masses.push_back(static_cast<float>(fragments.list[f].mass));
        const bool clustered = clustering && f < clustering->of.size();
        clusters.add(clustered ? static_cast<std::int64_t>(at(clustering->of[f])) : -1);
    }
    scene.data.add("fragmentBirths", births);
    scene.data.add("fragmentMasses", masses);
    scene.data.add("fragmentClusters", clusters);
    scene.about["fragmentCount"] = fragments.size();
}

/// Corners of every shape, and its faces seen from outside.
void addShapes(nlohmann::json& about) {
    about["cornerCounts"] = nlohmann::json::array();
    about["faces"] = nlohmann::json::array();
    for (int shape = 0; shape <= static_cast<int>(ElementShape::Beam); ++shape) {
        about["cornerCounts"].push_back(cornerCount(static_cast<ElementShape>(shape)));
        nlohmann::json faces = nlohmann::json::array();
        for (const auto& face : facesOf(static_cast<ElementShape>(shape))) {
            faces.push_back({face[0], face[1], face[2], face[3]});
        }
        about["faces"].push_back(faces);
    }
}

/// Of each component the number of its material, whether that was guessed from a density, and whether some material has that.
nlohmann::json materialsOf(const Components& components, const Scenario& scenario) {
    nlohmann::json materials = nlohmann::json::array();
    for (const Component& component : components.list) {
        const auto settings = scenario.components.find(component.name);
        const bool given = settings != scenario.components.end() && settings->second.material.has_value();
        materials.push_back(
            {{"kind", static_cast<int>(component.material)}, {"assumed", !given}, {"fits", someMaterialFits(component.density)}});
    }
    return materials;
}

PageScene packedScene(const RunReader& run, const FeResult& fe, const PagePrecision& precision, const Execution& execution) {
    const std::shared_ptr<const FragmentSet> made = run.fragments();
    const FragmentSet& fragments = *made;
    const Scenario& scenario = run.origin().scenario;
    const Components components = groupComponents(fe.mesh(), scenario.regrouping, scenario.components, scenario.assumptions);
    PageScene scene;
    addStructure(scene, run, fe, components.of, precision, execution);
    const PieceCollector collector(run, fe, fragments);
    const std::vector<PagePiece> pieces = collector.pieces();
    const std::vector<BodyRecord>& bodies = collector.bodies();
    std::vector<double> reach(bodies.size(), 0.0);
    for (const PagePiece& piece : pieces) {
        for (const Vec3& corner : piece.corners) {
            reach[piece.body] = std::max(reach[piece.body], corner.norm());
        }
    }
    const PageMotion motion = addMotion(scene.data, run, bodies, reach, precision, execution);
    addPieces(scene, pieces);
    scene.placeError = motion.largestError + addCorners(scene.data, pieces, precision.cornerStep);
    scene.data.add("bodyEnds", motion.end);
    addFragmentFigures(scene, run, fragments);
    std::vector<double> frames;
    for (std::size_t i = 0; i < run.frameCount(); ++i) {
        frames.push_back(run.frameTime(i));
    }
    scene.data.add("frames", frames);
    addShapes(scene.about);
    scene.about["bodyCount"] = bodies.size();
    scene.about["keyCount"] = motion.keys;
    scene.about["placeStep"] = precision.placeStep;
    scene.about["cornerStep"] = precision.cornerStep;
    scene.about["components"] = run.componentNames();
    scene.about["looseBodies"] = fe.contents().looseBodies;
    scene.about["materials"] = materialsOf(components, scenario);
    return scene;
}

}  // namespace

void checkPage(const RunReader& run, const FeResult& fe) {
    // Says why there are none.
    const FragmentPlaces places(run);
    const FragmentSet& fragments = places.fragments();
    for (const Fragment& fragment : fragments.list) {
        if (at(fragment.element) >= fe.mesh().elementCount()) {
            throw UsageError({"io.series.other_fe", "The run was not made from {0}: it has fewer elements", {fe.contents().path}},
                             {"io.series.other_fe.remedy", "Give the FE file that the run names.", {}});
        }
    }
    const std::size_t most = std::max(fragments.size(), fe.mesh().elementCount());
    if (most > pagePiecesMost) {
        throw UsageError({"io.page.large",
                          "A page shows at most {0} fragments or elements; the run has {1} fragments of {2} elements",
                          {pagePiecesMost, fragments.size(), fe.mesh().elementCount()}},
                         {"io.page.large.remedy", "Share a movie or a report, or export the run for ParaView (vtkhdf).", {}});
    }
    if (fragments.size() == 0 || run.frameCount() == 0) {
        throw UsageError({"io.page.nothing", "The run has no fragments that a page could show", {}},
                         {"io.page.nothing.remedy", "Choose a run in which elements were deactivated, and let it simulate.", {}});
    }
}

PageScene pageScene(const RunReader& run, const FeResult& fe, PagePrecision precision, const Execution& execution) {
    checkPage(run, fe);
    for (int tried = 0;; ++tried) {
        PageScene scene = packedScene(run, fe, precision, execution);
        const double error = std::max(scene.placeError, scene.nodeError);
        if (error <= pageErrorMost) {
            return scene;
        }
        if (tried == tightenings) {
            throw UsageError({"io.page.coarse",
                              "Places of this run would lie up to {0} m from those recorded; a page allows {1} m",
                              {error, pageErrorMost}},
                             {"io.page.coarse.remedy",
                              "Choose an origin of the frame near the model, or export the run for ParaView (vtkhdf).",
                              {}});
        }
        precision = precision.finer();
    }
}

}  // namespace rubble::io
