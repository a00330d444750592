#include "widgets/views/inspector.h"

#include <QHBoxLayout>
#include <QLabel>
#include <QLocale>
#include <QMenu>
#include <QPushButton>
#include <QToolButton>
#include <QVBoxLayout>
#include <algorithm>
#include <cmath>

#include "widgets/basics/panel.h"
#include "widgets/basics/theme.h"
#include "widgets/basics/wording.h"
#include "widgets/figures/material_words.h"
#include "widgets/figures/number_text.h"
#include "widgets/figures/report/spoken_text.h"

namespace rubble::widgets {

namespace {

constexpr std::size_t mostImpacts = 8;
constexpr std::size_t mostComponents = 6;

/// The number of an instant for a row whose unit is secondsUnit(); of a brief result with its own unit.
QString seconds(double time) {
    return figures::briefSpan() > 0.0 ? figures::timeText(time) : QLocale().toString(time, 'f', 3);
}

QString secondsUnit() {
    return figures::briefSpan() > 0.0 ? QString() : Inspector::tr("s");
}

QString instant(double time) {
    return figures::briefSpan() > 0.0 ? seconds(time) : Inspector::tr("%1 s").arg(seconds(time));
}

QString metres(double value) {
    return shownPlace(value);
}

QString placeText(const Vec3& p) {
    return QStringLiteral("%1, %2, %3").arg(metres(p.x()), metres(p.y()), metres(p.z()));
}

QString countOf(std::size_t count) {
    return shownCount(static_cast<std::int64_t>(count));
}

void addRow(PanelGroup* group, const QString& label, const QString& value, const QString& unit, const QString& tip) {
    QLabel* shown = group->addValue(label, unit, tip);
    shown->setText(value);
    shown->setWordWrap(true);
}

}  // namespace

Inspector::Inspector(QWidget* parent)
    : QScrollArea(parent), m_column(nullptr), m_groups(new QVBoxLayout), m_title(new QLabel), m_subtitle(new QLabel) {
    auto* body = new QWidget;
    body->setObjectName(QStringLiteral("panelBody"));
    m_column = new QVBoxLayout(body);
    m_column->setContentsMargins(14, 12, 14, 12);
    m_column->setSpacing(10);
    m_title->setFont(titleFont());
    m_title->setWordWrap(true);
    m_subtitle->setObjectName(QStringLiteral("muted"));
    m_subtitle->setWordWrap(true);
    m_column->addWidget(m_title);
    m_column->addWidget(m_subtitle);
    auto* first = new QHBoxLayout;
    m_birth =
        addButton(first, tr("Go to birth"), tr("Show the FE view at the last state at which it is active, with it in the middle"));
    m_follow = addButton(first, tr("Follow"), tr("Keep the fragment in the middle of the views while time goes on"));
    m_cluster = addButton(first, tr("Cluster"), tr("Select all fragments that move with it"));
    first->addStretch();
    m_follow->setCheckable(true);
    auto* second = new QHBoxLayout;
    m_isolate = addButton(second, tr("Isolate"), tr("Hide everything that is not selected"));
    m_hide = addButton(second, tr("Hide"), tr("Leave what is selected out of the views; what it covered appears"));
    m_clear = addButton(second, tr("Clear"), tr("Select nothing"));
    second->addStretch();
    m_column->addLayout(first);
    m_column->addLayout(second);
    m_groups->setSpacing(14);
    m_column->addLayout(m_groups);
    m_column->addStretch(1);
    setWidget(body);
    setWidgetResizable(true);
    setFrameShape(QFrame::NoFrame);
    setHorizontalScrollBarPolicy(Qt::ScrollBarAlwaysOff);
    setAccessibleName(tr("Inspector"));
    setMinimumWidth(220);
    connect(m_birth, &QToolButton::clicked, this, &Inspector::birthRequested);
    connect(m_follow, &QToolButton::clicked, this, &Inspector::followRequested);
    connect(m_cluster, &QToolButton::clicked, this, &Inspector::clusterRequested);
    connect(m_isolate, &QToolButton::clicked, this, &Inspector::isolateRequested);
    connect(m_hide, &QToolButton::clicked, this, &Inspector::hideRequested);
    connect(m_clear, &QToolButton::clicked, this, &Inspector::clearRequested);
    showNothing();
}

QToolButton* Inspector::addButton(QLayout* row, const QString& text, const QString& tip) {
    auto* button = new QToolButton;
    button->setText(text);
    button->setToolTip(tip);
    button->setFocusPolicy(Qt::StrongFocus);
    row->addWidget(button);
    return button;
}

QSize Inspector::sizeHint() const {
    return {280, 400};
}

QString Inspector::title() const {
    return m_title->text();
}

void Inspector::setFollowing(bool following) {
    m_follow->setChecked(following);
}

PanelGroup* Inspector::addGroup(const QString& heading) {
    auto* group = new PanelGroup(heading);
    m_groups->addWidget(group);
    return group;
}

void Inspector::restart(const QString& title, const QString& subtitle) {
    while (QLayoutItem* item = m_groups->takeAt(0)) {
        delete item->widget();
        delete item;
    }
    m_title->setText(title);
    m_subtitle->setText(subtitle);
    for (QToolButton* button : {m_isolate, m_hide, m_clear}) {
        button->setEnabled(true);
    }
}

void Inspector::showNothing() {
    restart(tr("Nothing selected"),
            tr("Click an element or a fragment in a view. Ctrl-click adds; dragging with Ctrl adds all in a rectangle."));
    for (QToolButton* button : {m_birth, m_follow, m_cluster, m_isolate, m_hide, m_clear}) {
        button->setEnabled(false);
    }
}

void Inspector::showElement(const ElementFacts& facts) {
    const QString element = QLocale().toString(static_cast<qlonglong>(facts.number));
    const QString component = QString::fromStdString(facts.component);
    if (facts.fragment) {
        restart(tr("Fragment %1").arg(countOf(at(facts.fragment->id))), tr("%1 · element %2").arg(component, element));
    } else {
        restart(tr("Element %1").arg(element), component);
    }
    PanelGroup* solid = addGroup(tr("Element"));
    addRow(solid, tr("mass"), facts.mass < 0.1 ? shownMass(facts.mass) : shownIn(facts.mass, "kg", 4),
           facts.mass < 0.1 ? QString() : tr("kg"), tr("Volume at rest times the density of its component"));
    addRow(solid, tr("volume"), shownIn(facts.volume, "m3", 4), tr("m³"), tr("At rest"));
    addRow(solid, tr("shape"), shownName(facts.shape), {}, tr("Shape of the finite element"));
    addMaterial(*solid, facts);
    if (facts.carriedSince) {
        solid->addNote(tr("Carried by the engine since %1, in a loose island.").arg(figures::timeText(*facts.carriedSince)));
    }
    addDeath(facts);
    if (facts.fragment) {
        addJourney(*facts.fragment);
    }
    m_birth->setEnabled(facts.firstInactive.has_value());
    m_follow->setEnabled(facts.fragment && facts.fragment->path && !facts.fragment->path->points.empty());
    m_cluster->setEnabled(facts.fragment && facts.fragment->cluster);
}

void Inspector::addMaterial(PanelGroup& group, const ElementFacts& facts) {
    const QString name = shownName(facts.material);
    addRow(&group, tr("material"), facts.materialAssumed ? figures::guessedMaterial(name, facts.materialFits) : name, {},
           tr("Of its component; set in the component tree or the Case panel"));
    if (!facts.materialAssumed) {
        return;
    }
    group.addNote(facts.materialFits ? tr("Nobody says what this component is made of: guessed from its density.")
                                     : tr("Nobody says what this component is made of, and no material that is known here has its "
                                          "density."));
    auto* say = new QToolButton;
    say->setObjectName(QStringLiteral("sayMaterial"));
    say->setText(tr("It is made of"));
    say->setToolTip(tr("Say what the component is made of; friction, bounce and break-up follow from it. Ctrl+Z takes it back"));
    say->setPopupMode(QToolButton::InstantPopup);
    say->setFocusPolicy(Qt::StrongFocus);
    auto* menu = new QMenu(say);
    for (std::size_t m = 0; m < materialCount; ++m) {
        const auto material = static_cast<Material>(m);
        if (isBodyMaterial(material)) {
            QAction* action = menu->addAction(shownName(materialName(material)));
            connect(action, &QAction::triggered, this, [this, material, component = QString::fromStdString(facts.component)] {
                emit materialChosen(component, material);
            });
        }
    }
    say->setMenu(menu);
    group.addWide(say);
}

void Inspector::addDeath(const ElementFacts& facts) {
    PanelGroup* death = addGroup(tr("Death"));
    if (!facts.lastActive) {
        death->addNote(tr("Never active."));
    } else if (!facts.firstInactive) {
        death->addNote(tr("It stays active to the end of the FE result."));
    } else {
        addRow(death, tr("last active"), seconds(*facts.lastActive), secondsUnit(),
               tr("The last state at which the file has it active"));
        addRow(death, tr("inactive from"), seconds(*facts.firstInactive), secondsUnit(),
               tr("The first state that reports it inactive: it died in between"));
        if (facts.exactDeath) {
            addRow(death, tr("died at"), seconds(*facts.exactDeath), secondsUnit(), tr("The exact time that the file gives"));
        }
        death->addNote(facts.reportedBy.empty()
                           ? tr("The file gives no cause.")
                           : tr("Reported by %1; the file gives no cause.").arg(figures::spokenText(facts.reportedBy)));
    }
}

void Inspector::addJourney(const FragmentFacts& fragment) {
    PanelGroup* journey = addGroup(tr("Journey"));
    addRow(journey, tr("born at"), seconds(fragment.birthTime), secondsUnit(), tr("When it is shown and reported as a fragment"));
    addRow(journey, tr("speed then"), shownIn(fragment.birthSpeed, "m/s"), tr("m/s"), tr("Of its centre of mass"));
    if (fragment.birthPlace) {
        addRow(journey, tr("birth x, y, z"), placeText(*fragment.birthPlace), tr("m"),
               tr("Centre of mass, as exported tables give it"));
    }
    if (!fragment.finalPlace) {
        journey->addNote(tr("Simulate to see where it goes."));
    } else {
        addRow(journey, tr("final x, y, z"), placeText(*fragment.finalPlace), tr("m"),
               tr("Centre of mass at %1").arg(instant(fragment.finalTime)));
        if (fragment.birthPlace) {
            const Vec3 way = *fragment.finalPlace - *fragment.birthPlace;
            addRow(journey, tr("moved in plan"), metres(std::hypot(way.x(), way.y())), tr("m"),
                   tr("Level distance from birth to the end"));
            if (way.z() > 0.0) {
                addRow(journey, tr("rose"), metres(way.z()), tr("m"), tr("Height of its end above its birth"));
            } else {
                addRow(journey, tr("fell"), metres(-way.z()), tr("m"), tr("Height of its birth above its end"));
            }
        }
    }
    if (fragment.path) {
        addRow(journey, tr("at rest from"), seconds(fragment.path->restTime), secondsUnit(),
               tr("Since then it has stayed within %1 of its last place").arg(shownLength(0.05)));
    }
    if (fragment.cluster) {
        addRow(journey, tr("moved with cluster"), tr("%1 (%2)").arg(countOf(at(*fragment.cluster)), countOf(fragment.clusterSize)),
               {}, tr("Number of the cluster, and of its fragments"));
    }
    if (fragment.pathPending) {
        journey->addNote(tr("Its way is being read …"));
    }
    if (fragment.path) {
        addImpacts(*fragment.path);
    }
    if (fragment.error) {
        PanelGroup* reference = addGroup(tr("Against the reference"));
        addRow(reference, tr("error"), metres(*fragment.error), tr("m"),
               tr("Distance from where the reference has it at %1").arg(instant(fragment.finalTime)));
    }
}

void Inspector::addImpacts(const FragmentPath& path) {
    PanelGroup* group = addGroup(tr("Impacts"));
    if (path.impacts.empty()) {
        group->addNote(tr("Nothing has changed its velocity by more than %1 at once.").arg(shownWith(1.0, "m/s")));
        return;
    }
    // The hardest are listed, in the order of time.
    std::vector<FragmentImpact> listed = path.impacts;
    std::stable_sort(listed.begin(), listed.end(), [](const auto& a, const auto& b) { return a.change > b.change; });
    const std::size_t more = listed.size() - std::min(listed.size(), mostImpacts);
    listed.resize(listed.size() - more);
    std::sort(listed.begin(), listed.end(), [](const auto& a, const auto& b) { return a.time < b.time; });
    for (const FragmentImpact& impact : listed) {
        auto* button = new QPushButton(
            tr("%1   %2   %3").arg(instant(impact.time), shownWith(impact.speed, "m/s"), shownEnergy(impact.energy)));
        button->setFlat(true);
        button->setStyleSheet(QStringLiteral("text-align: left"));
        button->setToolTip(
            tr("Go to this hit: its time, the speed just before, the kinetic energy of the centre just before; the velocity "
               "changed by %1")
                .arg(shownWith(impact.change, "m/s")));
        connect(button, &QPushButton::clicked, this, [this, time = impact.time] { emit timeRequested(time); });
        group->addWide(button);
    }
    if (more > 0) {
        group->addNote(tr("and %1 weaker ones").arg(countOf(more)));
    }
}

void Inspector::showSums(const Sums& sums) {
    restart(tr("%1 elements").arg(countOf(sums.elements)), tr("selected"));
    PanelGroup* all = addGroup(tr("Together"));
    addRow(all, tr("mass"), shownMass(sums.mass), {}, tr("At rest"));
    addRow(all, tr("dead now"), countOf(sums.dead), {}, tr("Inactive in the FE result at the time shown"));
    addRow(all, tr("fragments"), countOf(sums.fragments), {}, tr("Elements that die in the course of the collapse"));
    if (sums.fragments > 0) {
        addRow(all, tr("born"), QStringLiteral("%1–%2").arg(seconds(sums.firstBirth), seconds(sums.lastBirth)), secondsUnit(),
               tr("First and last birth time"));
    }
    PanelGroup* components = addGroup(tr("By component"));
    for (std::size_t i = 0; i < std::min(sums.components.size(), mostComponents); ++i) {
        addRow(components, QString::fromStdString(sums.components[i].first), countOf(sums.components[i].second), {},
               tr("Elements"));
    }
    if (sums.components.size() > mostComponents) {
        components->addNote(tr("and %1 more components").arg(countOf(sums.components.size() - mostComponents)));
    }
    m_birth->setEnabled(sums.fragments > 0);
    m_follow->setEnabled(false);
    m_cluster->setEnabled(sums.fragments > 0);
}

}  // namespace rubble::widgets
