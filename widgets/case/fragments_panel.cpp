#include "widgets/case/fragments_panel.h"

#include <QLabel>
#include <QLocale>
#include <algorithm>
#include <map>

#include "widgets/basics/wording.h"
#include "widgets/figures/number_text.h"

namespace rubble::widgets {

FragmentsPanel::FragmentsPanel(QWidget* parent)
    : Panel(tr("Fragments"), tr("What became debris, when, and with which mass."), parent), m_findings(new FindingList) {
    PanelGroup* debris = addGroup(tr("Debris"));
    m_count = debris->addValue(tr("Fragments"), {}, tr("Deactivated elements, each one rigid fragment"));
    m_mass = debris->addValue(tr("Mass"));
    m_smallest = debris->addValue(tr("Mass, from to"));
    m_fastest = debris->addValue(tr("Fastest at hand-over"), tr("m/s"),
                                 tr("One fragment by itself, as the FE result has it. A body moves with the mean momentum of its "
                                    "cluster, so speeds of the run can be lower."));
    m_note = debris->addNote({});
    PanelGroup* births = addGroup(tr("Births"));
    m_births = births->addValue(tr("Birth times"));
    m_first = births->addValue(tr("First"));
    m_last = births->addValue(tr("Last"));
    m_largestBirth = births->addValue(tr("Most at once"), {}, tr("Most fragments with one birth time"));
    addRemaining(Stage::Fragments, tr("How elements become fragments"));
    addWide(m_findings);
    setContent(nullptr, nullptr);
}

void FragmentsPanel::setContent(const std::shared_ptr<const FragmentSet>& fragments, const FeResult* fe) {
    const QString none(QChar(0x2013));
    m_findings->set(fragments != nullptr ? fragments->findings : Findings());
    if (fragments == nullptr || fragments->list.empty()) {
        for (QLabel* label : {m_mass, m_smallest, m_fastest, m_births, m_first, m_last, m_largestBirth}) {
            label->setText(none);
        }
        m_count->setText(fragments != nullptr ? shownCount(0) : none);
        m_note->setText(fragments != nullptr && fe != nullptr
                            ? tr("No element dies in this result: all %1 elements are active at the last state.")
                                  .arg(shownCount(static_cast<std::int64_t>(fe->mesh().elementCount())))
                            : tr("Open a result: its deactivated elements appear here as fragments."));
        m_note->show();
        return;
    }
    double mass = 0.0;
    double speed = 0.0;
    std::map<double, std::int64_t> births;
    const auto [light, heavy] = std::minmax_element(fragments->list.begin(), fragments->list.end(),
                                                    [](const Fragment& a, const Fragment& b) { return a.mass < b.mass; });
    for (const Fragment& fragment : fragments->list) {
        mass += fragment.mass;
        speed = std::max(speed, fragment.velocity.norm());
        ++births[fragment.birthTime];
    }
    const auto most =
        std::max_element(births.begin(), births.end(), [](const auto& a, const auto& b) { return a.second < b.second; });
    m_count->setText(shownCount(static_cast<std::int64_t>(fragments->size())));
    m_mass->setText(shownMass(mass, 4));
    m_smallest->setText(QStringLiteral("%1 – %2").arg(shownMass(light->mass), shownMass(heavy->mass)));
    m_fastest->setText(shownIn(speed, "m/s"));
    m_births->setText(shownCount(static_cast<std::int64_t>(births.size())));
    m_first->setText(figures::timeText(births.begin()->first));
    m_last->setText(figures::timeText(births.rbegin()->first));
    m_largestBirth->setText(tr("%1 at %2").arg(shownCount(most->second), figures::timeText(most->first)));
    m_note->hide();
}

}  // namespace rubble::widgets
