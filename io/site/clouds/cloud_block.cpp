#include "io/site/clouds/cloud_block.h"

namespace rubble::io {

namespace {

/// Calls visit(a column of one block, the same of the other) for each but the marks.
template <class One, class Other, class Visit>
void forEachColumn(One& one, Other& other, Visit visit) {
    visit(one.places, other.places);
    visit(one.intensity, other.intensity);
    visit(one.colours, other.colours);
    visit(one.classes, other.classes);
    visit(one.returns, other.returns);
    visit(one.returnsOf, other.returnsOf);
    visit(one.times, other.times);
    visit(one.scans, other.scans);
}

}  // namespace

void CloudBlock::resize(std::size_t count, const CloudColumns& columns) {
    const auto entries = [count](bool there) { return there ? count : 0; };
    places.resize(count);
    intensity.resize(entries(columns.intensity));
    colours.resize(entries(columns.colour));
    classes.resize(entries(columns.classes));
    returns.resize(entries(columns.returns));
    returnsOf.resize(entries(columns.returns));
    times.resize(entries(columns.times));
    scans.resize(entries(columns.scans));
    fates.clear();
}

void CloudBlock::clear() {
    resize(0, {});
}

void CloudBlock::keepTaken() {
    if (!fates.empty()) {
        forEachColumn(*this, *this, [this](auto& column, const auto&) {
            if (column.empty()) {
                return;
            }
            std::size_t kept = 0;
            for (std::size_t i = 0; i < fates.size(); ++i) {
                if (fates[i] == PointFate::Taken) {
                    column[kept++] = column[i];
                }
            }
            column.resize(kept);
        });
    }
    fates.clear();
}

void CloudBlock::add(const CloudBlock& other, std::size_t i) {
    forEachColumn(*this, other, [i](auto& column, const auto& from) {
        if (!from.empty()) {
            column.push_back(from[i]);
        }
    });
}

}  // namespace rubble::io
