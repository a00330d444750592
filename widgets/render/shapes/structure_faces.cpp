#include "widgets/render/shapes/structure_faces.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <tuple>

namespace rubble::render {
namespace {

constexpr double infinity = std::numeric_limits<double>::infinity();

/// Takes `cut` out of every span of a list.
void subtract(std::vector<TimeSpan>& spans, const TimeSpan& cut) {
    std::vector<TimeSpan> left;
    for (const TimeSpan& span : spans) {
        if (cut.to <= span.from || cut.from >= span.to) {
            left.push_back(span);
            continue;
        }
        if (span.from < cut.from) {
            left.push_back({span.from, cut.from});
        }
        if (cut.to < span.to) {
            left.push_back({cut.to, span.to});
        }
    }
    spans = std::move(left);
}

std::vector<TimeSpan> activeSpans(const FeResult& fe, ElementIndex e) {
    std::vector<TimeSpan> spans;
    const std::vector<double>& times = fe.times();
    for (std::size_t k = 0; k < times.size(); ++k) {
        if (!fe.activity().active(k, e)) {
            continue;
        }
        const double from = k == 0 ? -infinity : times[k];
        const double to = k + 1 < times.size() ? times[k + 1] : infinity;
        if (!spans.empty() && spans.back().to == from) {
            spans.back().to = to;
        } else {
            spans.push_back({from, to});
        }
    }
    return spans;
}

/// One side of an element, with the key that the two sides of a shared face have in common.
struct Side {
    std::array<std::uint32_t, 4> key{};    ///< nodes ascending
    std::array<std::uint32_t, 4> nodes{};  ///< as seen from outside
    ElementIndex element{};
    bool shell = false;
};

/// Nodes of a face without repetitions (collapsed elements have them); fewer than three mean there is no face.
std::array<std::uint32_t, 4> distinctNodes(std::span<const std::uint32_t> corners, const std::array<std::int8_t, 4>& local,
                                           int& count) {
    std::array<std::uint32_t, 4> nodes;
    nodes.fill(StructureFaces::none);
    count = 0;
    for (const std::int8_t corner : local) {
        if (corner < 0) {
            continue;
        }
        const std::uint32_t node = corners[static_cast<std::size_t>(corner)];
        if (std::find(nodes.begin(), nodes.begin() + count, node) == nodes.begin() + count) {
            nodes[static_cast<std::size_t>(count++)] = node;
        }
    }
    return nodes;
}

std::vector<Side> sidesOf(const Mesh& mesh) {
    std::vector<Side> sides;
    sides.reserve(mesh.elementCount() * 6);
    for (std::size_t i = 0; i < mesh.elementCount(); ++i) {
        const ElementIndex e = idAt<ElementIndex>(i);
        const auto corners = mesh.cornersOf(e);
        for (const auto& local : facesOf(mesh.shapes[i])) {
            int count = 0;
            Side side{{}, distinctNodes(corners, local, count), e, isShell(mesh.shapes[i])};
            if (count < 3) {
                continue;
            }
            side.key = side.nodes;
            std::sort(side.key.begin(), side.key.end());
            sides.push_back(side);
            if (side.shell) {
                // A sheet is seen from both sides, and culling shows each once.
                std::reverse(side.nodes.begin(), side.nodes.begin() + count);
                sides.push_back(side);
            }
        }
    }
    return sides;
}

/// True if b runs through the same nodes as a the other way round, as the two sides of a shared face do.
bool opposite(const Side& a, const Side& b) {
    const int n = a.nodes[3] == StructureFaces::none ? 3 : 4;
    int start = 0;
    while (start < n && b.nodes[static_cast<std::size_t>(start)] != a.nodes[0]) {
        ++start;
    }
    if (start == n) {
        return false;
    }
    for (int i = 1; i < n; ++i) {
        if (a.nodes[static_cast<std::size_t>(i)] != b.nodes[static_cast<std::size_t>((start - i + n) % n)]) {
            return false;
        }
    }
    return true;
}

}  // namespace

ShowTimes showTimes(const FeResult& fe) {
    ShowTimes times;
    times.offsets.push_back(0);
    for (std::size_t i = 0; i < fe.mesh().elementCount(); ++i) {
        const auto spans = activeSpans(fe, idAt<ElementIndex>(i));
        times.spans.insert(times.spans.end(), spans.begin(), spans.end());
        times.offsets.push_back(static_cast<std::uint32_t>(times.spans.size()));
    }
    return times;
}

ShowTimes showTimes(const FeResult& fe, const FragmentSet& fragments, bool carriedFromHandOver) {
    std::vector<std::vector<FragmentId>> of(fe.mesh().elementCount());
    for (std::size_t f = 0; f < fragments.size(); ++f) {
        of[at(fragments.list[f].element)].push_back(idAt<FragmentId>(f));
    }
    ShowTimes times;
    times.offsets.push_back(0);
    for (std::size_t i = 0; i < of.size(); ++i) {
        auto spans = activeSpans(fe, idAt<ElementIndex>(i));
        for (const FragmentId f : of[i]) {
            const Fragment& fragment = fragments.list[at(f)];
            subtract(spans, {carriedFromHandOver ? fragment.handOverTime : fragment.birthTime, fragment.endTime});
        }
        times.spans.insert(times.spans.end(), spans.begin(), spans.end());
        times.offsets.push_back(static_cast<std::uint32_t>(times.spans.size()));
    }
    return times;
}

StructureFaces::StructureFaces(const Mesh& mesh, const ShowTimes& times, bool hideInner) {
    for (const TimeSpan& span : times.spans) {
        for (const double end : {span.from, span.to}) {
            if (std::abs(end) < infinity) {
                m_events.push_back(end);
            }
        }
    }
    std::sort(m_events.begin(), m_events.end());
    m_events.erase(std::unique(m_events.begin(), m_events.end()), m_events.end());

    const std::vector<Side> sides = sidesOf(mesh);
    std::vector<std::uint32_t> order(sides.size());
    for (std::size_t i = 0; i < order.size(); ++i) {
        order[i] = static_cast<std::uint32_t>(i);
    }
    if (hideInner) {
        std::sort(order.begin(), order.end(), [&](std::uint32_t a, std::uint32_t b) {
            return sides[a].key != sides[b].key ? sides[a].key < sides[b].key : a < b;
        });
    }
    std::vector<TimeSpan> spans;
    for (std::size_t begin = 0; begin < order.size();) {
        std::size_t end = begin + 1;
        while (hideInner && end < order.size() && sides[order[end]].key == sides[order[begin]].key) {
            ++end;
        }
        for (std::size_t i = begin; i < end; ++i) {
            const Side& side = sides[order[i]];
            const auto own = times.of(side.element);
            spans.assign(own.begin(), own.end());
            for (std::size_t j = begin; j < end && !side.shell; ++j) {
                const Side& other = sides[order[j]];
                if (j == i || other.shell || other.element == side.element || !opposite(side, other)) {
                    continue;
                }
                for (const TimeSpan& cut : times.of(other.element)) {
                    subtract(spans, cut);
                }
            }
            for (const TimeSpan& span : spans) {
                m_faces.push_back({side.nodes, side.element, slotFrom(span.from), slotFrom(span.to)});
            }
        }
        begin = end;
    }
    for (std::size_t i = 0; i < mesh.elementCount(); ++i) {
        if (mesh.shapes[i] == ElementShape::Beam) {
            const auto corners = mesh.cornersOf(idAt<ElementIndex>(i));
            for (const TimeSpan& span : times.of(idAt<ElementIndex>(i))) {
                m_faces.push_back(
                    {{corners[0], corners[1], none, none}, idAt<ElementIndex>(i), slotFrom(span.from), slotFrom(span.to)});
            }
        }
    }
    // In element order, so that neighbours in memory are neighbours in the model.
    std::sort(m_faces.begin(), m_faces.end(), [](const Face& a, const Face& b) {
        return std::tie(a.element, a.nodes, a.fromSlot) < std::tie(b.element, b.nodes, b.fromSlot);
    });
    m_beginning = sorted([](const Face& face) { return face.fromSlot; });
    m_ending = sorted([](const Face& face) { return face.toSlot; });
}

template <class SlotOf>
StructureFaces::BySlot StructureFaces::sorted(SlotOf slotOf) const {
    BySlot by;
    by.offsets.assign(slotCount() + 2, 0);
    for (const Face& face : m_faces) {
        ++by.offsets[slotOf(face) + 1];
    }
    for (std::size_t slot = 1; slot < by.offsets.size(); ++slot) {
        by.offsets[slot] += by.offsets[slot - 1];
    }
    std::vector<std::uint32_t> next(by.offsets.begin(), by.offsets.end() - 1);
    by.faces.resize(m_faces.size());
    for (std::size_t i = 0; i < m_faces.size(); ++i) {
        by.faces[next[slotOf(m_faces[i])]++] = static_cast<std::uint32_t>(i);
    }
    return by;
}

std::uint32_t StructureFaces::slotFrom(double time) const {
    if (time == infinity) {
        return static_cast<std::uint32_t>(m_events.size() + 1);
    }
    return static_cast<std::uint32_t>(std::upper_bound(m_events.begin(), m_events.end(), time) - m_events.begin());
}

std::size_t StructureFaces::slotAt(double time) const {
    return static_cast<std::size_t>(std::upper_bound(m_events.begin(), m_events.end(), time) - m_events.begin());
}

std::vector<std::uint32_t> StructureFaces::visible(std::size_t slot) const {
    std::vector<std::uint32_t> indices;
    for (std::size_t i = 0; i < m_faces.size(); ++i) {
        if (m_faces[i].fromSlot <= slot && slot < m_faces[i].toSlot) {
            indices.push_back(static_cast<std::uint32_t>(i));
        }
    }
    return indices;
}

void StructureFaces::follow(std::vector<std::uint32_t>& visible, std::size_t from, std::size_t to) const {
    const auto seen = [&](std::uint32_t index) { return m_faces[index].fromSlot <= to && to < m_faces[index].toSlot; };
    std::erase_if(visible, [&](std::uint32_t index) { return !seen(index); });
    // Forwards what begins on the way comes in, backwards what ends there.
    const BySlot& entering = from < to ? m_beginning : m_ending;
    const std::size_t first = entering.offsets[std::min(from, to) + 1];
    const std::size_t last = entering.offsets[std::max(from, to) + 1];
    const auto middle = static_cast<std::ptrdiff_t>(visible.size());
    for (std::size_t i = first; i < last; ++i) {
        if (seen(entering.faces[i])) {
            visible.push_back(entering.faces[i]);
        }
    }
    std::sort(visible.begin() + middle, visible.end());
    std::inplace_merge(visible.begin(), visible.begin() + middle, visible.end());
}

}  // namespace rubble::render
