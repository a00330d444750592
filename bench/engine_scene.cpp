#include "bench/engine_scene.h"

#include <algorithm>
#include <charconv>
#include <cmath>
#include <fstream>
#include <map>
#include <optional>
#include <stdexcept>
#include <string>
#include <string_view>

#include "core/base/csv_text.h"

namespace rubble::bench {

namespace {

template <class... Acts>
struct Visitor : Acts... {
    using Acts::operator()...;
};

/// Where a piece is at some instants, in order.
using Track = std::vector<std::pair<double, Pose>>;

Pose between(const Pose& from, const Pose& to, double share) {
    return {from.position + share * (to.position - from.position), from.orientation.slerp(share, to.orientation)};
}

Pose poseAt(const Track& track, double time) {
    const auto after = std::ranges::lower_bound(track, time, {}, &Track::value_type::first);
    if (after == track.end()) {
        return track.back().second;
    }
    if (after == track.begin() || after->first == time) {
        return after->second;
    }
    const auto before = after - 1;
    return between(before->second, after->second, (time - before->first) / (after->first - before->first));
}

/// Steps without anything that enters or leaves between them.
struct Interval {
    std::vector<double> ends;            ///< s, since it began
    std::map<PieceId, Track> tracks;     ///< of the pieces that move
    std::map<PieceId, Pose> lastPlaces;  ///< of all that has moved or entered so far
};

void move(Interval& interval, const EngineScene::PieceMoves& to, double stepEnd) {
    Track& track = interval.tracks[to.piece];
    if (track.empty()) {
        track.emplace_back(0.0, interval.lastPlaces.at(to.piece));
    }
    // A piece that stood for some steps.
    const double stepBegin = interval.ends.empty() ? 0.0 : interval.ends.back();
    if (track.back().first < stepBegin) {
        track.emplace_back(stepBegin, track.back().second);
    }
    track.emplace_back(stepEnd, to.pose);
    interval.lastPlaces[to.piece] = to.pose;
}

/// Ends the interval: its steps again, of another length.
void endInterval(Interval& interval, double perSecond, std::vector<EngineScene::Call>& calls) {
    if (interval.ends.empty()) {
        return;
    }
    const double span = interval.ends.back();
    const auto steps = static_cast<std::int64_t>(std::max(1.0, std::ceil(span * perSecond - 1e-6)));
    const double dt = span / static_cast<double>(steps);
    for (std::int64_t i = 1; i <= steps; ++i) {
        for (const auto& [piece, track] : interval.tracks) {
            calls.emplace_back(EngineScene::PieceMoves{piece, poseAt(track, i == steps ? span : static_cast<double>(i) * dt)});
        }
        calls.emplace_back(EngineScene::Step{dt});
    }
    interval.ends.clear();
    interval.tracks.clear();
}

}  // namespace

double EngineScene::seconds() const {
    double seconds = 0.0;
    for (const Call& call : calls) {
        if (const auto* step = std::get_if<Step>(&call)) {
            seconds += step->dt;
        }
    }
    return seconds;
}

EngineScene EngineScene::withoutPieces() const {
    EngineScene scene = *this;
    std::erase_if(scene.calls, [](const Call& call) {
        return std::holds_alternative<PieceEnters>(call) || std::holds_alternative<PieceLeaves>(call) ||
               std::holds_alternative<PieceMoves>(call);
    });
    return scene;
}

EngineScene EngineScene::inSubsteps(int count) const {
    EngineScene scene = *this;
    scene.settings.substeps = count;
    std::erase_if(scene.calls, [](const Call& call) { return std::holds_alternative<Substeps>(call); });
    return scene;
}

EngineScene EngineScene::inSteps(double perSecond) const {
    EngineScene scene{settings, {}};
    Interval interval;
    std::vector<PieceMoves> moves;
    std::uint32_t pieces = 0;
    for (const Call& call : calls) {
        if (const auto* to = std::get_if<PieceMoves>(&call)) {
            moves.push_back(*to);
        } else if (const auto* step = std::get_if<Step>(&call)) {
            const double end = (interval.ends.empty() ? 0.0 : interval.ends.back()) + step->dt;
            for (const PieceMoves& move : moves) {
                bench::move(interval, move, end);
            }
            moves.clear();
            interval.ends.push_back(end);
        } else {
            endInterval(interval, perSecond, scene.calls);
            if (const auto* piece = std::get_if<PieceEnters>(&call)) {
                interval.lastPlaces[PieceId{pieces++}] = piece->pose;
            }
            scene.calls.push_back(call);
        }
    }
    endInterval(interval, perSecond, scene.calls);
    return scene;
}

SceneRecorder::SceneRecorder(std::unique_ptr<RigidWorld> world, const WorldSettings& settings, EngineScene& scene)
    : ForwardingWorld(std::move(world)), m_scene(scene) {
    if (settings.terrain) {
        throw std::runtime_error("scenes of an engine stand on level ground; this run has a terrain");
    }
    m_scene = {settings, {}};
    m_scene.settings.cancelled = {};
}

BodyId SceneRecorder::addBody(const NewBody& body) {
    m_scene.calls.emplace_back(EngineScene::BodyEnters{body});
    return ForwardingWorld::addBody(body);
}

void SceneRecorder::removeBody(BodyId body) {
    m_scene.calls.emplace_back(EngineScene::BodyLeaves{body});
    ForwardingWorld::removeBody(body);
}

PieceId SceneRecorder::addPiece(const CollisionShape& shape, const Pose& pose, Material material,
                                std::span<const std::uint32_t> nodes) {
    m_scene.calls.emplace_back(EngineScene::PieceEnters{shape, pose, material});
    return ForwardingWorld::addPiece(shape, pose, material, nodes);
}

void SceneRecorder::removePiece(PieceId piece) {
    m_scene.calls.emplace_back(EngineScene::PieceLeaves{piece});
    ForwardingWorld::removePiece(piece);
}

void SceneRecorder::movePiece(PieceId piece, const Pose& atStepEnd) {
    m_scene.calls.emplace_back(EngineScene::PieceMoves{piece, atStepEnd});
    ForwardingWorld::movePiece(piece, atStepEnd);
}

void SceneRecorder::setSubsteps(int substeps) {
    m_scene.calls.emplace_back(EngineScene::Substeps{substeps});
    ForwardingWorld::setSubsteps(substeps);
}

void SceneRecorder::step(double dt) {
    m_scene.calls.emplace_back(EngineScene::Step{dt});
    ForwardingWorld::step(dt);
}

namespace {

constexpr std::string_view legend =
    "# rubble engine scene 1. One call a line, in order; SI units, world axes, z up; quaternions x y z w.\n"
    "# set NAME VALUE: a setting of the world. pair MATERIAL MATERIAL friction restitution.\n"
    "# body mass  inertia about its axes (3)  place (3)  orientation (4)  velocity (3)  spin (3)  smallest side  volume  MATERIAL\n"
    "#      loose (1: structure that came loose)  parts, and for each: centre (3)  orientation (4)  half sides (3), in its axes\n"
    "# piece place (3)  orientation (4)  MATERIAL  parts, as for a body. Bodies and pieces are numbered from 0 as they enter.\n"
    "# body-leaves NUMBER. piece-leaves NUMBER. move NUMBER place (3) orientation (4): where the piece is after the next step.\n"
    "# substeps NUMBER: of all steps from now on. step seconds.\n";

/// A line of numbers and words.
class LineWriter {
public:
    explicit LineWriter(std::ofstream& out, std::string_view word) : m_out(out) { m_out << word; }
    ~LineWriter() { m_out << '\n'; }
    LineWriter(const LineWriter&) = delete;
    LineWriter& operator=(const LineWriter&) = delete;

    LineWriter& operator<<(double number) {
        m_out << ' ' << exactNumber(number);
        return *this;
    }
    LineWriter& operator<<(std::size_t number) {
        m_out << ' ' << number;
        return *this;
    }
    LineWriter& operator<<(std::string_view word) {
        m_out << ' ' << word;
        return *this;
    }
    LineWriter& operator<<(const Vec3& v) { return *this << v.x() << v.y() << v.z(); }
    LineWriter& operator<<(const Quat& q) { return *this << q.x() << q.y() << q.z() << q.w(); }
    LineWriter& operator<<(const Pose& pose) { return *this << pose.position << pose.orientation; }
    LineWriter& operator<<(const CollisionShape& shape) {
        *this << shape.size();
        for (const ConvexPart& part : shape) {
            if (!part.points.empty()) {
                throw std::runtime_error("scenes of an engine have boxes alone; this run has hulls");
            }
            *this << part.box.centre << part.box.orientation << part.box.halfExtents;
        }
        return *this;
    }

private:
    std::ofstream& m_out;
};

/// Reads a line from its first word on.
class LineReader {
public:
    LineReader(std::string_view line, std::string where) : m_rest(line), m_where(std::move(where)) {}

    std::string_view word() {
        m_rest.remove_prefix(std::min(m_rest.find_first_not_of(' '), m_rest.size()));
        const std::string_view word = m_rest.substr(0, m_rest.find(' '));
        m_rest.remove_prefix(word.size());
        if (word.empty()) {
            fail("the line ends too early");
        }
        return word;
    }
    double number() {
        const std::string_view text = word();
        double number = 0.0;
        const auto [end, error] = std::from_chars(text.data(), text.data() + text.size(), number);
        if (error != std::errc{} || end != text.data() + text.size() || !std::isfinite(number)) {
            fail("\"" + std::string(text) + "\" is no number");
        }
        return number;
    }
    std::uint32_t count(std::size_t below) {
        const double read = number();
        if (read < 0.0 || read >= static_cast<double>(below) || read != std::floor(read)) {
            fail("a whole number below " + std::to_string(below) + " is expected");
        }
        return static_cast<std::uint32_t>(read);
    }
    Material material() {
        const std::string_view name = word();
        const std::optional<Material> material = materialNamed(name);
        if (!material) {
            fail("\"" + std::string(name) + "\" is no material");
        }
        return *material;
    }
    Vec3 vector() {
        const double x = number(), y = number(), z = number();
        return {x, y, z};
    }
    Pose pose() {
        Pose pose;
        pose.position = vector();
        pose.orientation = orientation();
        return pose;
    }
    Quat orientation() {
        const double x = number(), y = number(), z = number(), w = number();
        return {w, x, y, z};
    }
    CollisionShape shape() {
        constexpr std::size_t partsMax = 4096;
        CollisionShape shape;
        for (std::uint32_t i = count(partsMax); i > 0; --i) {
            ConvexPart part;
            part.box.centre = vector();
            part.box.orientation = orientation();
            part.box.halfExtents = vector();
            if (part.box.halfExtents.minCoeff() <= 0.0) {
                fail("a side of a part is not positive");
            }
            shape.push_back(std::move(part));
        }
        if (shape.empty()) {
            fail("a shape has no part");
        }
        return shape;
    }
    void end() {
        if (m_rest.find_first_not_of(' ') != std::string_view::npos) {
            fail("the line goes on where it should end");
        }
    }
    [[noreturn]] void fail(const std::string& what) const { throw std::runtime_error(m_where + ": " + what); }

private:
    std::string_view m_rest;
    std::string m_where;
};

/// Settings by name, as numbers.
template <class Take>
void forEachSetting(Take take) {
    take("gravity", [](auto& s) -> auto& { return s.gravity; });
    take("ground", [](auto& s) -> auto& { return s.ground; });
    take("ground_height", [](auto& s) -> auto& { return s.groundHeight; });
    take("body_contacts", [](auto& s) -> auto& { return s.bodyContacts; });
    take("iterations", [](auto& s) -> auto& { return s.iterations; });
    take("substeps", [](auto& s) -> auto& { return s.substeps; });
    take("freeze", [](auto& s) -> auto& { return s.freeze; });
    take("freeze_speed", [](auto& s) -> auto& { return s.freezeSpeed; });
    take("freeze_delay", [](auto& s) -> auto& { return s.freezeDelay; });
    take("overlap_speed", [](auto& s) -> auto& { return s.overlapSpeed; });
    take("overlap_time", [](auto& s) -> auto& { return s.overlapTime; });
    take("overlap_time_from_entry", [](auto& s) -> auto& { return s.overlapTimeFromEntry; });
    take("bounce_friction", [](auto& s) -> auto& { return s.bounceFriction; });
    take("parts_jammed", [](auto& s) -> auto& { return s.partsJammed; });
    take("splits_mass", [](auto& s) -> auto& { return s.splitsMass; });
}

void write(std::ofstream& out, const WorldSettings& settings) {
    forEachSetting([&](const char* name, auto member) {
        LineWriter(out, "set") << std::string_view(name) << static_cast<double>(member(settings));
    });
    LineWriter(out, "set") << std::string_view("ground_material") << materialName(settings.groundMaterial);
    LineWriter(out, "reach") << settings.reach.min() << settings.reach.max();
    for (const MaterialPair& pair : materialPairs()) {
        const PairProperties& p = settings.pairs.of(pair.first, pair.second);
        LineWriter(out, "pair") << materialName(pair.first) << materialName(pair.second) << p.friction << p.restitution;
    }
}

void readSetting(LineReader& line, WorldSettings& settings) {
    const std::string_view name = line.word();
    if (name == "ground_material") {
        settings.groundMaterial = line.material();
        return;
    }
    bool known = false;
    forEachSetting([&](const char* candidate, auto member) {
        if (name == candidate) {
            auto& value = member(settings);
            value = static_cast<std::remove_reference_t<decltype(value)>>(line.number());
            known = true;
        }
    });
    if (!known) {
        line.fail("there is no setting \"" + std::string(name) + "\"");
    }
}

NewBody readBody(LineReader& line) {
    NewBody body;
    body.mass = line.number();
    body.inertia = line.vector();
    body.pose = line.pose();
    body.velocity = line.vector();
    body.angularVelocity = line.vector();
    body.smallestSide = line.number();
    body.volume = line.number();
    body.material = line.material();
    body.loose = line.count(2) != 0;
    body.shape = line.shape();
    if (body.mass <= 0.0 || body.inertia.minCoeff() <= 0.0) {
        line.fail("a body without mass or inertia");
    }
    return body;
}

/// How many have entered so far.
struct Entered {
    std::size_t bodies = 0, pieces = 0;
};

void readLine(LineReader& line, EngineScene& scene, Entered& entered) {
    const std::string_view word = line.word();
    if (word == "set") {
        readSetting(line, scene.settings);
    } else if (word == "reach") {
        const Vec3 low = line.vector();
        scene.settings.reach = Aabb(low, line.vector());
    } else if (word == "pair") {
        const Material a = line.material(), b = line.material();
        const double friction = line.number();
        scene.settings.pairs.of(a, b) = {friction, line.number()};
    } else if (word == "body") {
        scene.calls.emplace_back(EngineScene::BodyEnters{readBody(line)});
        ++entered.bodies;
    } else if (word == "body-leaves") {
        scene.calls.emplace_back(EngineScene::BodyLeaves{BodyId{line.count(entered.bodies)}});
    } else if (word == "piece") {
        EngineScene::PieceEnters piece;
        piece.pose = line.pose();
        piece.material = line.material();
        piece.shape = line.shape();
        scene.calls.emplace_back(std::move(piece));
        ++entered.pieces;
    } else if (word == "piece-leaves") {
        scene.calls.emplace_back(EngineScene::PieceLeaves{PieceId{line.count(entered.pieces)}});
    } else if (word == "move") {
        const PieceId piece{line.count(entered.pieces)};
        scene.calls.emplace_back(EngineScene::PieceMoves{piece, line.pose()});
    } else if (word == "substeps") {
        scene.calls.emplace_back(EngineScene::Substeps{static_cast<int>(line.count(65))});
        if (std::get<EngineScene::Substeps>(scene.calls.back()).count < 1) {
            line.fail("a step has one substep at least");
        }
    } else if (word == "step") {
        const double dt = line.number();
        if (dt <= 0.0) {
            line.fail("a step takes no time");
        }
        scene.calls.emplace_back(EngineScene::Step{dt});
    } else {
        line.fail("\"" + std::string(word) + "\" is no call");
    }
    line.end();
}

}  // namespace

void writeScene(const EngineScene& scene, const std::filesystem::path& file) {
    std::ofstream out(file, std::ios::binary);
    out << legend;
    write(out, scene.settings);
    for (const EngineScene::Call& call : scene.calls) {
        std::visit(Visitor{
                       [&](const EngineScene::BodyEnters& c) {
                           const NewBody& b = c.body;
                           LineWriter(out, "body")
                               << b.mass << b.inertia << b.pose << b.velocity << b.angularVelocity << b.smallestSide << b.volume
                               << materialName(b.material) << std::size_t{b.loose ? 1U : 0U} << b.shape;
                       },
                       [&](const EngineScene::BodyLeaves& c) { LineWriter(out, "body-leaves") << std::size_t{at(c.body)}; },
                       [&](const EngineScene::PieceEnters& c) {
                           LineWriter(out, "piece") << c.pose << materialName(c.material) << c.shape;
                       },
                       [&](const EngineScene::PieceLeaves& c) { LineWriter(out, "piece-leaves") << std::size_t{at(c.piece)}; },
                       [&](const EngineScene::PieceMoves& c) { LineWriter(out, "move") << std::size_t{at(c.piece)} << c.pose; },
                       [&](const EngineScene::Substeps& c) { LineWriter(out, "substeps") << static_cast<std::size_t>(c.count); },
                       [&](const EngineScene::Step& c) { LineWriter(out, "step") << c.dt; },
                   },
                   call);
    }
    out.close();
    if (!out) {
        throw std::runtime_error(file.string() + " cannot be written; is there room on the disk?");
    }
}

EngineScene readScene(const std::filesystem::path& file) {
    std::ifstream in(file, std::ios::binary);
    if (!in) {
        throw std::runtime_error(file.string() + " cannot be read");
    }
    EngineScene scene;
    Entered entered;
    std::size_t number = 0;
    for (std::string line; std::getline(in, line);) {
        ++number;
        const std::string where = file.string() + ", line " + std::to_string(number);
        if (number == 1 && !line.starts_with("# rubble engine scene 1.")) {
            throw std::runtime_error(where + ": this is no scene of an engine");
        }
        if (!line.empty() && line[0] != '#') {
            LineReader reader(line, where);
            readLine(reader, scene, entered);
        }
    }
    if (scene.calls.empty()) {
        throw std::runtime_error(file.string() + " has nothing for an engine to do");
    }
    return scene;
}

}  // namespace rubble::bench
