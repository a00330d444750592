#include "app/gui/views/selection_display.h"

#include <algorithm>
#include <map>

#include "app/gui/session/session.h"
#include "app/gui/stage/playback.h"
#include "app/gui/stage/view_area.h"
#include "core/base/standard_gravity.h"
#include "core/fe/frame_transform.h"

namespace rubble {

namespace {

constexpr std::uint32_t noFragment = 0xffffffffu;

/// What tables add to places of the local frame, m.
Vec3 originOf(const FeResult& fe) {
    return FrameTransform(fe.contents().frame).localZero();
}

bool within(double value, const std::optional<double>& low, const std::optional<double>& high) {
    return (!low || value >= *low) && (!high || value <= *high);
}

}  // namespace

/// Where a fragment went, read on the worker.
struct SelectionDisplay::Way {
    FragmentId fragment{};
    std::shared_ptr<const FragmentSet> fragments;
    std::shared_ptr<const TrajectoryReader> trajectory;
    std::shared_ptr<const TrajectoryReader> reference;
    std::size_t frames = 0;
    std::optional<FragmentPath> path;
    std::optional<double> error;

    bool sameAs(const Way& other) const {
        return fragment == other.fragment && fragments == other.fragments && trajectory == other.trajectory &&
               reference == other.reference && frames == other.frames;
    }
};

SelectionDisplay::SelectionDisplay(Session& session, Playback& playback, ViewArea& area, widgets::Inspector& inspector,
                                   widgets::SelectForm& form, QObject* parent)
    : QObject(parent),
      m_session(session),
      m_computation(session.computation()),
      m_playback(playback),
      m_area(area),
      m_inspector(inspector),
      m_form(form),
      m_follow(session.part<Kept>().follow) {
    connect(&area.views(), &widgets::ViewWidget::selectionChanged, this, &SelectionDisplay::show);
    connect(&inspector, &widgets::Inspector::birthRequested, this, &SelectionDisplay::goToBirth);
    connect(&inspector, &widgets::Inspector::followRequested, this, &SelectionDisplay::follow);
    connect(&inspector, &widgets::Inspector::isolateRequested, this, &SelectionDisplay::isolate);
    connect(&inspector, &widgets::Inspector::hideRequested, this, &SelectionDisplay::hide);
    connect(&inspector, &widgets::Inspector::clusterRequested, this, &SelectionDisplay::growToClusters);
    connect(&inspector, &widgets::Inspector::clearRequested, this, &SelectionDisplay::clear);
    connect(&inspector, &widgets::Inspector::timeRequested, this, [this](double time) {
        m_playback.clock().pause();
        m_playback.scrub(time);
    });
    // Later, for the button that says it is made anew.
    connect(
        &inspector, &widgets::Inspector::materialChosen, this,
        [this](const QString& component, Material material) {
            m_session.document().setParameter(QStringLiteral("component[%1].material").arg(component),
                                              ParameterValue(std::string(materialName(material))));
        },
        Qt::QueuedConnection);
    connect(&form, &widgets::SelectForm::selectRequested, this, &SelectionDisplay::selectBy);
    connect(&playback.clock(), &widgets::PlaybackClock::timeChanged, this, &SelectionDisplay::showTime);
    connect(&m_computation, &Computation::prepared, this, &SelectionDisplay::refresh);
    connect(&m_computation, &Computation::runBegun, this, &SelectionDisplay::refresh);
    connect(&m_computation, &Computation::runEnded, this, &SelectionDisplay::refresh);
}

const render::SceneData& SelectionDisplay::data() const {
    return m_area.views().data();
}

const std::vector<ElementIndex>& SelectionDisplay::selection() const {
    return m_area.views().view().selection;
}

void SelectionDisplay::select(std::vector<ElementIndex> elements) {
    render::View view = m_area.views().view();
    view.selection = std::move(elements);
    m_area.views().setView(view);
}

void SelectionDisplay::refresh() {
    std::vector<std::string> names;
    for (std::size_t c = 0; data().components != nullptr && c < data().components->list.size(); ++c) {
        names.push_back(data().components->list[c].name);
    }
    m_form.setComponents(names);
    show();
}

void SelectionDisplay::indexFragments() {
    if (data().fragments == m_indexed) {
        return;
    }
    m_indexed = data().fragments;
    m_fragmentOf.clear();
    if (m_indexed != nullptr && data().fe != nullptr) {
        m_fragmentOf.assign(data().fe->mesh().elementCount(), noFragment);
        for (std::size_t f = 0; f < m_indexed->size(); ++f) {
            if (at(m_indexed->list[f].element) < m_fragmentOf.size()) {
                m_fragmentOf[at(m_indexed->list[f].element)] = static_cast<std::uint32_t>(f);
            }
        }
    }
}

/// Which elements islands carried; read anew when the run has grown.
void SelectionDisplay::indexIslands() {
    const std::size_t frames = data().trajectory != nullptr ? data().trajectory->frameCount() : 0;
    if (data().trajectory == m_islandsOf && frames == m_islandFrames) {
        return;
    }
    m_islandsOf = data().trajectory;
    m_islandFrames = frames;
    m_islands = {};
    if (frames > 0 && data().fe != nullptr) {
        try {
            m_islands = islandTimes(*data().trajectory, data().fe->mesh().elementCount());
        } catch (const std::exception&) {
            // The views say what is wrong with the run file.
        }
    }
}

std::optional<FragmentId> SelectionDisplay::fragmentOf(ElementIndex element) const {
    if (at(element) >= m_fragmentOf.size() || m_fragmentOf[at(element)] == noFragment) {
        return std::nullopt;
    }
    return idAt<FragmentId>(m_fragmentOf[at(element)]);
}

std::vector<FragmentId> SelectionDisplay::fragments() const {
    std::vector<FragmentId> found;
    for (const ElementIndex element : selection()) {
        if (const auto fragment = fragmentOf(element)) {
            found.push_back(*fragment);
        }
    }
    std::sort(found.begin(), found.end());
    return found;
}

/// Elements that the result does not have, of another result or of a saved view, are no selection.
bool SelectionDisplay::dropUnknown() {
    const std::size_t count = data().fe != nullptr ? data().fe->mesh().elementCount() : 0;
    const auto unknown = [count](ElementIndex element) { return at(element) >= count; };
    if (std::none_of(selection().begin(), selection().end(), unknown)) {
        return false;
    }
    std::vector<ElementIndex> known = selection();
    std::erase_if(known, unknown);
    select(std::move(known));
    return true;
}

void SelectionDisplay::show() {
    if (dropUnknown()) {
        return;  // shown by the change
    }
    indexFragments();
    if (selection().size() == 1) {
        indexIslands();
    }
    readWay();
    const auto& selected = selection();
    const bool there =
        !selected.empty() && data().components != nullptr && data().components->of.size() == data().fe->mesh().elementCount();
    if (!there) {
        m_inspector.showNothing();
    } else if (selected.size() == 1) {
        m_inspector.showElement(factsOf(selected.front()));
        m_inspector.setFollowing(m_follow);
    } else {
        m_inspector.showSums(sums());
    }
    emit changed(there);
}

widgets::Inspector::ElementFacts SelectionDisplay::factsOf(ElementIndex element) const {
    const FeResult& fe = *data().fe;
    const Components& components = *data().components;
    const Component& component = components.list[at(components.of[at(element)])];
    widgets::Inspector::ElementFacts facts;
    facts.number = fe.mesh().elementIds[at(element)];
    facts.component = component.name;
    facts.material = materialName(component.material);
    const auto& said = m_session.document().scenario().components;
    const auto own = said.find(component.name);
    facts.materialAssumed = own == said.end() || !own->second.material;
    facts.materialFits = someMaterialFits(component.density);
    facts.shape = shapeName(fe.mesh().shapes[at(element)]);
    facts.mass = components.mass(element);
    facts.volume = components.volume[at(element)];
    facts.reportedBy = fe.contents().activityFrom;
    for (std::size_t k = 0; k < fe.stateCount(); ++k) {
        if (fe.activity().active(k, element)) {
            facts.lastActive = fe.times()[k];
            facts.firstInactive = k + 1 < fe.stateCount() ? std::optional(fe.times()[k + 1]) : std::nullopt;
        }
    }
    const auto& deaths = fe.contents().deathTime;
    if (at(element) < deaths.size() && std::isfinite(deaths[at(element)])) {
        facts.exactDeath = deaths[at(element)];
    }
    if (m_islands.carried(element)) {
        facts.carriedSince = m_islands.since[at(element)];
    }
    if (const auto fragment = fragmentOf(element)) {
        facts.fragment = factsOf(*fragment);
    }
    return facts;
}

widgets::Inspector::FragmentFacts SelectionDisplay::factsOf(FragmentId id) const {
    const Fragment& fragment = data().fragments->list[at(id)];
    const Vec3 origin = originOf(*data().fe);
    widgets::Inspector::FragmentFacts facts;
    facts.id = id;
    facts.birthTime = fragment.birthTime;
    facts.birthPlace = fragment.centre + origin;
    facts.birthSpeed = fragment.velocity.norm();
    if (data().clustering != nullptr && at(id) < data().clustering->of.size()) {
        facts.cluster = data().clustering->of[at(id)];
        facts.clusterSize = data().clustering->list[at(*facts.cluster)].memberCount;
    }
    const RunRecord* record = m_computation.currentRun();
    if (record != nullptr && record->outcome != nullptr && at(id) < record->outcome->fragments.size()) {
        const FragmentOutcome& outcome = record->outcome->fragments[at(id)];
        facts.birthPlace = outcome.birthPosition + origin;
        facts.birthSpeed = outcome.birthSpeed;
    }
    if (m_way != nullptr && m_way->path) {
        facts.path = m_way->path;
        facts.error = m_way->error;
        if (!m_way->path->points.empty()) {
            facts.finalPlace = m_way->path->points.back().place + origin;
            facts.finalTime = m_way->path->points.back().time;
        }
    }
    facts.pathPending = m_reading;
    return facts;
}

widgets::Inspector::Sums SelectionDisplay::sums() const {
    const FeResult& fe = *data().fe;
    const Components& components = *data().components;
    widgets::Inspector::Sums sums;
    const auto after = std::upper_bound(fe.times().begin(), fe.times().end(), m_playback.clock().time() + 1e-9);
    const std::size_t state = after == fe.times().begin() ? 0 : static_cast<std::size_t>(after - fe.times().begin()) - 1;
    std::map<std::size_t, std::size_t> counts;
    for (const ElementIndex element : selection()) {
        ++sums.elements;
        sums.mass += components.mass(element);
        sums.dead += !fe.activity().active(state, element);
        ++counts[at(components.of[at(element)])];
        if (const auto fragment = fragmentOf(element)) {
            const double birth = data().fragments->list[at(*fragment)].birthTime;
            sums.firstBirth = sums.fragments == 0 ? birth : std::min(sums.firstBirth, birth);
            sums.lastBirth = sums.fragments == 0 ? birth : std::max(sums.lastBirth, birth);
            ++sums.fragments;
        }
    }
    for (const auto& [component, count] : counts) {
        sums.components.emplace_back(components.list[component].name, count);
    }
    std::stable_sort(sums.components.begin(), sums.components.end(),
                     [](const auto& a, const auto& b) { return a.second > b.second; });
    return sums;
}

void SelectionDisplay::readWay() {
    const auto fragment = selection().size() == 1 ? fragmentOf(selection().front()) : std::nullopt;
    if (!fragment || data().trajectory == nullptr || data().trajectory->frameCount() == 0) {
        m_worker.cancel();
        m_way.reset();
        m_reading = false;
        follow(false);
        setPath({});
        return;
    }
    auto way = std::make_shared<Way>();
    way->fragment = *fragment;
    way->fragments = data().fragments;
    way->trajectory = data().trajectory;
    way->reference = data().reference;
    way->frames = data().trajectory->frameCount();
    if (m_way != nullptr && m_way->sameAs(*way)) {
        return;
    }
    m_way = way;
    m_reading = true;
    follow(false);
    setPath({});
    const RunRecord* record = m_computation.currentRun();
    const double gravity = record != nullptr ? record->scenario.simulation.gravity : standardGravity;
    auto read = std::make_shared<Way>(*way);
    m_worker.start({Worker::Kind::Study,
                    [read, gravity](const Execution& execution) {
                        read->path = fragmentPath(*read->fragments, *read->trajectory, read->fragment, gravity, execution);
                        if (read->reference != nullptr && read->reference->frameCount() > 0 && !read->path->points.empty()) {
                            const PathPoint& last = read->path->points.back();
                            if (const auto there = fragmentPlace(*read->fragments, *read->reference, read->fragment, last.time)) {
                                read->error = (last.place - *there).norm();
                            }
                        }
                    },
                    [this, read](const std::exception_ptr&) { takeWay(read); }});
}

void SelectionDisplay::takeWay(const std::shared_ptr<Way>& way) {
    if (m_way == nullptr || !m_way->sameAs(*way)) {
        return;
    }
    m_way = way;
    m_reading = false;
    std::vector<Vec3> path;
    for (std::size_t k = 0; way->path && k < way->path->points.size(); ++k) {
        path.push_back(way->path->points[k].place);
    }
    setPath(std::move(path));
    if (selection().size() == 1) {
        m_inspector.showElement(factsOf(selection().front()));
        m_inspector.setFollowing(m_follow);
    }
}

void SelectionDisplay::setPath(std::vector<Vec3> path) {
    render::View view = m_area.views().view();
    view.path = std::move(path);
    m_area.views().setView(view);
}

void SelectionDisplay::showTime(double time) {
    if (selection().size() > 1 && !m_playback.clock().playing() && data().components != nullptr) {
        m_inspector.showSums(sums());
    }
    if (!m_follow || m_way == nullptr || !m_way->path || m_way->path->points.empty()) {
        return;
    }
    const auto& points = m_way->path->points;
    const auto after =
        std::lower_bound(points.begin(), points.end(), time, [](const PathPoint& p, double t) { return p.time < t; });
    const PathPoint& b = after == points.end() ? points.back() : *after;
    const PathPoint& a = after == points.begin() ? b : *(after - 1);
    const double share = b.time > a.time ? std::clamp((time - a.time) / (b.time - a.time), 0.0, 1.0) : 1.0;
    m_area.views().centreNow(a.place + share * (b.place - a.place));
}

void SelectionDisplay::follow(bool follow) {
    m_follow = follow;
    m_inspector.setFollowing(follow);
    if (follow) {
        showTime(m_playback.clock().time());
    }
}

void SelectionDisplay::goToBirth() {
    const auto all = fragments();
    if (all.empty() || data().fe == nullptr) {
        return;
    }
    const auto& list = data().fragments->list;
    const FragmentId first = *std::min_element(
        all.begin(), all.end(), [&](FragmentId a, FragmentId b) { return list[at(a)].birthTime < list[at(b)].birthTime; });
    m_playback.clock().pause();
    m_playback.scrub(list[at(first)].handOverTime);
    m_area.views().centreOn(list[at(first)].centre);
}

void SelectionDisplay::growToClusters() {
    if (data().clustering == nullptr || data().fragments == nullptr) {
        return;
    }
    std::vector<ElementIndex> grown = selection();
    for (const FragmentId fragment : fragments()) {
        for (const FragmentId member : data().clustering->membersOf(data().clustering->of[at(fragment)])) {
            grown.push_back(data().fragments->list[at(member)].element);
        }
    }
    std::sort(grown.begin(), grown.end());
    grown.erase(std::unique(grown.begin(), grown.end()), grown.end());
    select(std::move(grown));
}

void SelectionDisplay::growToComponents() {
    if (data().components == nullptr) {
        return;
    }
    std::vector<std::uint8_t> wanted(data().components->list.size(), 0);
    for (const ElementIndex element : selection()) {
        wanted[at(data().components->of[at(element)])] = 1;
    }
    std::vector<ElementIndex> grown;
    for (std::size_t c = 0; c < wanted.size(); ++c) {
        if (wanted[c] != 0) {
            const auto& own = data().components->list[c].elements;
            grown.insert(grown.end(), own.begin(), own.end());
        }
    }
    std::sort(grown.begin(), grown.end());
    select(std::move(grown));
}

void SelectionDisplay::selectBy(const widgets::SelectForm::Criteria& criteria) {
    if (data().fe == nullptr || data().components == nullptr) {
        return;
    }
    indexFragments();
    const Vec3 origin = originOf(*data().fe);
    const bool byRegion = std::any_of(criteria.low.begin(), criteria.low.end(), [](const auto& v) { return v.has_value(); }) ||
                          std::any_of(criteria.high.begin(), criteria.high.end(), [](const auto& v) { return v.has_value(); });
    std::vector<std::uint8_t> inRegion;
    if (byRegion) {
        inRegion.assign(data().fe->mesh().elementCount(), 0);
        for (const ElementIndex element : m_area.views().elementsWhere([&](const Vec3& centre) {
                 const Vec3 p = centre + origin;
                 return within(p.x(), criteria.low[0], criteria.high[0]) && within(p.y(), criteria.low[1], criteria.high[1]) &&
                        within(p.z(), criteria.low[2], criteria.high[2]);
             })) {
            inRegion[at(element)] = 1;
        }
    }
    const bool needsFragment = criteria.bornFrom || criteria.bornTo || criteria.cluster;
    std::vector<ElementIndex> found;
    for (std::size_t e = 0; e < data().fe->mesh().elementCount(); ++e) {
        const ElementIndex element = idAt<ElementIndex>(e);
        const auto fragment = fragmentOf(element);
        const Component& component = data().components->list[at(data().components->of[e])];
        bool fits = (criteria.component.empty() || component.name == criteria.component) && (!byRegion || inRegion[e] != 0);
        if (fits && needsFragment) {
            fits = fragment && within(data().fragments->list[at(*fragment)].birthTime, criteria.bornFrom, criteria.bornTo) &&
                   (!criteria.cluster ||
                    (data().clustering != nullptr && at(data().clustering->of[at(*fragment)]) == *criteria.cluster));
        }
        if (fits) {
            found.push_back(element);
        }
    }
    m_form.setFound(found.size());
    std::vector<ElementIndex> before = selection();
    std::sort(before.begin(), before.end());
    std::vector<ElementIndex> result;
    switch (criteria.how) {
        case widgets::SelectForm::How::Replace:
            result = found;
            break;
        case widgets::SelectForm::How::Add:
            std::set_union(before.begin(), before.end(), found.begin(), found.end(), std::back_inserter(result));
            break;
        case widgets::SelectForm::How::Remove:
            std::set_difference(before.begin(), before.end(), found.begin(), found.end(), std::back_inserter(result));
            break;
    }
    select(std::move(result));
}

void SelectionDisplay::hide() {
    render::View view = m_area.views().view();
    view.hidden.insert(view.hidden.end(), view.selection.begin(), view.selection.end());
    std::sort(view.hidden.begin(), view.hidden.end());
    view.hidden.erase(std::unique(view.hidden.begin(), view.hidden.end()), view.hidden.end());
    view.selection.clear();
    m_area.views().setView(view);
}

void SelectionDisplay::isolate() {
    if (selection().empty() || data().fe == nullptr) {
        return;
    }
    render::View view = m_area.views().view();
    std::vector<std::uint8_t> kept(data().fe->mesh().elementCount(), 0);
    for (const ElementIndex element : view.selection) {
        kept[at(element)] = 1;
    }
    view.hidden.clear();
    for (std::size_t e = 0; e < kept.size(); ++e) {
        if (kept[e] == 0) {
            view.hidden.push_back(idAt<ElementIndex>(e));
        }
    }
    m_area.views().setView(view);
}

}  // namespace rubble
