#include "io/site/clouds/ply_cloud.h"

#include <algorithm>
#include <cmath>

#include "io/base/file_words.h"
#include "io/fe/meshes/ply_header.h"
#include "io/json/run_behind.h"
#include "io/site/clouds/cloud_records.h"
#include "io/site/clouds/text_source.h"

namespace rubble::io {

namespace {

class PlyOpening {
public:
    explicit PlyOpening(const std::string& path) : m_file(std::make_unique<CloudFile>(path)) {
        MeshLines lines(path);
        m_ply = readPlyHeader(lines, path);
        const std::streamoff at = lines.file().tellg();
        m_start = at < 0 ? m_file->size() : static_cast<std::uint64_t>(at);
        m_head.format = "PLY";
        m_head.version = "1.0";
        takeOrigin();
        m_head.coding = m_ply.text ? "text" : m_ply.bigEndian ? "bytes, big end first" : "bytes, little end first";
    }

    std::unique_ptr<CloudSource> open() && {
        const auto points = std::find_if(m_ply.elements.begin(), m_ply.elements.end(),
                                         [](const PlyElement& element) { return element.name == "vertex"; });
        if (points == m_ply.elements.end()) {
            refuse("it has no element vertex");
        }
        for (const PlyProperty& property : points->properties) {
            if (property.list) {
                refuse("its points have a list, " + property.name);
            }
            plan(property);
        }
        if (!m_plan.hasPlaces()) {
            refuse("its points have no x, y and z");
        }
        m_plan.describe(m_head);
        m_head.fullColour = m_wide ? 65535.0 : 255.0;
        noteFaces();
        for (auto element = m_ply.elements.begin(); element != points; ++element) {
            passOver(*element);
        }
        return m_ply.text ? lines(*points) : records(*points);
    }

private:
    [[noreturn]] void refuse(const std::string& what) const {
        refuseContent({"cloud.ply", "{0} is no point cloud that can be read: {1}", {m_file->path(), what}},
                      "Export the points anew as PLY with x, y and z.");
    }

    /// Which instant of which run a scan of ours shows.
    void takeOrigin() {
        for (const std::string& comment : m_ply.comments) {
            std::string_view words = comment;
            const std::string_view key = takeWord(words);
            double number = 0.0;
            if (key == "instant" && takeReal(words, number) && std::isfinite(number)) {
                m_head.instant = number;
            } else if (key == "run") {
                m_head.run = fingerprintOf(takeWord(words));
            } else if (key == "scanner") {
                m_head.ours = takeReal(words, number) && takeReal(words, number) && takeReal(words, number);
            }
            m_head.ours = m_head.ours || m_head.instant.has_value() || !m_head.run.empty();
        }
    }

    void plan(const PlyProperty& property) {
        m_plan.add(columnRole(property.name), property.name);
        const ColumnRole role = m_plan.role(m_plan.size() - 1);
        if (role >= ColumnRole::Red && role <= ColumnRole::Blue) {
            m_wide = m_wide || (property.type.kind != NumberType::Kind::Real && property.type.bytes > 1);
            m_shares = m_shares || property.type.kind == NumberType::Kind::Real;
        }
    }

    void noteFaces() {
        for (const PlyElement& element : m_ply.elements) {
            if ((element.name == "face" || element.name == "tristrips") && element.count > 0) {
                addFinding(m_found, m_file->path(),
                           {"cloud.faces_left", "the file is a mesh; its corners are taken as points, its faces are left out", {}},
                           "none is needed if its corners are as dense as a scan; else give it as a mesh of the surroundings",
                           static_cast<std::int64_t>(element.count));
            }
        }
    }

    /// An element in front of the points.
    void passOver(const PlyElement& element) {
        if (m_ply.text) {
            CloudLines lines(std::make_shared<CloudFile>(m_file->path()), m_start);
            std::string_view line;
            for (std::uint64_t k = 0; k < element.count; ++k) {
                if (!lines.next(line)) {
                    m_file->failCut();
                }
            }
            m_start = lines.position();
            return;
        }
        std::uint64_t bytes = 0;
        for (const PlyProperty& property : element.properties) {
            if (property.list) {
                refuse("lists stand in front of its points");
            }
            bytes += property.type.bytes;
        }
        if (bytes > 0 && element.count > (m_file->size() - m_start) / bytes) {
            m_file->failCut();
        }
        m_start += element.count * bytes;
    }

    double colourScale() const { return m_shares ? 255.0 : 1.0; }

    std::unique_ptr<CloudSource> lines(const PlyElement& points) {
        TextPoints text;
        text.plan = std::move(m_plan);
        text.colourScale = colourScale();
        text.count = points.count;
        return textCloud(std::move(m_file), m_start, std::move(text), std::move(m_head), std::move(m_found));
    }

    std::unique_ptr<CloudSource> records(const PlyElement& points) {
        StoredPoints stored;
        stored.count = points.count;
        stored.bigEndian = m_ply.bigEndian;
        std::uint64_t step = 0;
        for (std::size_t c = 0; c < points.properties.size(); ++c) {
            StoredColumn column;
            column.role = m_plan.role(c);
            column.type = points.properties[c].type;
            column.start = m_start + step;
            column.colourScale = colourScale();
            step += column.type.bytes;
            stored.columns.push_back(column);
        }
        for (StoredColumn& column : stored.columns) {
            column.step = step;
        }
        return recordsCloud(std::move(m_file), std::move(stored), std::move(m_head), std::move(m_found));
    }

    std::unique_ptr<CloudFile> m_file;
    PlyHeader m_ply;
    std::uint64_t m_start = 0;
    ColumnPlan m_plan;
    CloudHead m_head;
    Findings m_found;
    bool m_wide = false;    ///< colours of 16 bits
    bool m_shares = false;  ///< colours from 0 to 1
};

}  // namespace

std::unique_ptr<CloudSource> openPlyCloud(const std::string& path) {
    return PlyOpening(path).open();
}

}  // namespace rubble::io
