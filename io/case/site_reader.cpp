#include "io/case/site_reader.h"

#include <algorithm>

#include "core/base/error.h"
#include "io/case/case_file.h"
#include "io/site/height_reading.h"
#include "io/site/input_files.h"
#include "io/site/orthophoto_file.h"
#include "io/site/place_check.h"
#include "io/site/site_mesh_file.h"

namespace rubble::io {

namespace {

/// m. Roofs, walls and banks are told from the ground at this distance of nodes.
constexpr double raisedCell = 0.5;

/// Reads the parts of a site that nothing rests on, one by one.
class SiteReading {
public:
    /// @param terrain  on which debris runs; null: none
    SiteReading(const Case& theCase, const std::string& casePath, const Mesh& fe, const TerrainGrid* terrain,
                const Execution& execution)
        : m_case(theCase), m_casePath(casePath), m_bounds(boundsAtRest(fe)), m_execution(execution) {
        if (terrain != nullptr) {
            const double cell = terrain->cell();
            m_terrain.extend(Vec3(terrain->x0(), terrain->y0(), 0.0));
            m_terrain.extend(Vec3(terrain->x0() + cell * static_cast<double>(terrain->nx() - 1),
                                  terrain->y0() + cell * static_cast<double>(terrain->ny() - 1), 0.0));
        }
    }

    void addOrthophoto(TerrainInput& site) const {
        std::int64_t count = 0;
        for (const CaseInput& input : m_case.inputs) {
            if (input.role != InputRole::Orthophoto || ++count > 1) {
                continue;
            }
            attempt(site, input, [&](const std::string& path) {
                site.orthophoto = readOrthophoto(path, m_case.frame, m_case.site, m_bounds, m_execution, site.findings);
                site.orthophotoInput = input.id;
                return Vec3(Vec3::Zero());
            });
        }
        if (count > 1) {
            site.findings.add({"case.orthophotos", "the case has {0} orthophotos; the first is used", {count}},
                              {"case.orthophotos.remedy", "keep one, or merge them into one raster", {}}, {}, count);
        }
    }

    void addSurroundings(TerrainInput& site) const {
        auto meshes = std::make_shared<std::vector<SiteMesh>>();
        for (const CaseInput& input : m_case.inputs) {
            if (input.role != InputRole::Surroundings) {
                continue;
            }
            const auto read = [&](const std::string& path) {
                SiteMeshReading reading = readSiteMesh(path, m_case.frame, m_case.site, m_execution,
                                                       {input.offset, SiteWindow(m_bounds, m_terrain), input.read});
                site.findings.append(reading.findings);
                meshes->push_back(std::move(reading.mesh));
                return reading.offset;
            };
            if (m_case.site.collide) {
                const std::string path = inputPath(m_casePath, input);
                const Vec3 offset = read(path);
                note(site, input, path, offset);
            } else {
                attempt(site, input, read);
            }
        }
        site.surroundings = meshes->empty() ? nullptr : meshes;
    }

    void raise(TerrainInput& site) const {
        if (!m_case.site.collide || site.surroundings == nullptr) {
            return;
        }
        if (site.grid == nullptr) {
            site.findings.add({"surroundings.no_terrain",
                               "debris cannot fall on the surroundings: the case has no terrain that they could be part of",
                               {}},
                              {"surroundings.no_terrain.remedy", "add a terrain; a level one will do", {}});
            return;
        }
        site.grid = terrainUnder(*site.grid, *site.surroundings, raisedCell, terrainNodesMax, m_execution);
        site.collided = true;
    }

private:
    template <class Read>
    void attempt(TerrainInput& site, const CaseInput& input, Read read) const {
        const std::string path = inputPath(m_casePath, input);
        try {
            const Vec3 offset = read(path);
            note(site, input, path, offset);
        } catch (const Cancelled&) {
            throw;
        } catch (const Error& error) {
            site.findings.add(error.message(), error.remedy(), path);
        }
    }
    void note(TerrainInput& site, const CaseInput& input, const std::string& path, const Vec3& offset) const {
        const InputDigest digest = digestOfInput(path, input.role, m_execution);
        site.files.push_back({input.id, path, digest.sha256, offset, digest.fileSha256, input.read});
        if (!input.sha256.empty() && !digest.is(input.sha256)) {
            site.findings.add({"case.site_changed", "the file is not the one the case was saved with", {}},
                              {"case.site_changed.remedy", "find the file with the SHA-256 of the case, or accept it as it is", {}},
                              path);
        }
    }

    const Case& m_case;
    const std::string& m_casePath;
    Aabb m_bounds;
    Aabb m_terrain;
    const Execution& m_execution;
};

}  // namespace

TerrainInput openSiteOfCase(const Case& theCase, const std::string& casePath, const Mesh& fe, const Execution& execution) {
    TerrainInput site = openTerrainOfCase(theCase, casePath, fe, execution);
    Findings findings = checkPlace(theCase.frame, theCase.site);
    findings.append(site.findings);
    site.findings = std::move(findings);
    const SiteReading reading(theCase, casePath, fe, site.grid.get(), execution);
    reading.addOrthophoto(site);
    reading.addSurroundings(site);
    reading.raise(site);
    return site;
}

TerrainInput openSurroundingsOfCase(Case theCase, const std::string& casePath, const Mesh& fe, const Frame& frame, const Site& site,
                                    const TerrainGrid* terrain, const Execution& execution) {
    theCase.frame = frame;
    theCase.site = site;
    theCase.site.collide = false;
    TerrainInput around;
    const SiteReading reading(theCase, casePath, fe, terrain, execution);
    reading.addOrthophoto(around);
    reading.addSurroundings(around);
    return around;
}

std::shared_ptr<const TerrainGrid> raisedTerrain(const TerrainGrid& terrain, std::span<const RecordedInput> meshes,
                                                 const Frame& frame, const Site& site, const Execution& execution) {
    std::vector<SiteMesh> read;
    for (const RecordedInput& mesh : meshes) {
        read.push_back(readSiteMesh(mesh.path, frame, site, execution, {mesh.offset, SiteWindow(), mesh.read}).mesh);
    }
    return terrainUnder(terrain, read, raisedCell, terrainNodesMax, execution);
}

void recordSite(RunOrigin& origin, const TerrainInput& input, const Site& site) {
    origin.site = site;
    origin.terrainRead = input.read;
    origin.site.collide = input.collided;
    origin.surroundings.clear();
    for (const SiteFile& file : input.files) {
        if (input.collided && file.input != input.orthophotoInput) {
            origin.surroundings.push_back({file.path, file.sha256, file.offset, file.read});
        }
    }
}

}  // namespace rubble::io
