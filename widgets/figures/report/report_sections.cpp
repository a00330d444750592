#include "widgets/figures/report/report_sections.h"

#include <QCoreApplication>
#include <QRegularExpression>

#include <algorithm>
#include <array>
#include <cmath>
#include <filesystem>
#include <set>

#include "core/scenario/differences.h"
#include "core/scenario/parameters.h"
#include "widgets/figures/number_text.h"

namespace rubble::figures {
namespace {

QString code(const QString& text) {
    return QStringLiteral("<code>") + text.toHtmlEscaped() + QStringLiteral("</code>");
}

QString count(std::int64_t number) {
    return countText(static_cast<std::size_t>(std::max<std::int64_t>(number, 0)));
}

QString tonnes(double kilograms) {
    return reportNumber(kilograms / 1000.0, ledgerDigits);
}

/// A criterion of the self-test, which is plain text for terminals, as print has it.
QString criterionShown(QString text) {
    static const QRegularExpression square(QStringLiteral("\\b([ev])2\\b"));
    static const QRegularExpression power(QStringLiteral("\\^(\\(?[0-9./]+\\)?)"));
    static const QRegularExpression friction(QStringLiteral("\\bmu\\b"));
    text.replace(square, QStringLiteral("\\1²"));
    text.replace(power, QStringLiteral("<sup>\\1</sup>"));
    text.replace(friction, QStringLiteral("µ"));
    return text.replace(QStringLiteral("+-"), QStringLiteral("±")).replace(QStringLiteral(" - "), QStringLiteral(" − "));
}

/// The name of a setting, as it stands beside its field.
QString labelOf(const Parameter& row) {
    return QCoreApplication::translate("parameters", std::string(row.label).c_str()).toHtmlEscaped();
}

QString nameOf(Material material) {
    std::string words(materialName(material));
    std::replace(words.begin(), words.end(), '_', ' ');
    return QCoreApplication::translate("choices", words.c_str()).toHtmlEscaped();
}

/// Switches and choices are words of the language; numbers and texts stand as in the case.
QString valueOf(const Parameter& row, const ParameterValue& value) {
    if (std::holds_alternative<std::monostate>(value)) {
        return ReportSections::tr("auto");
    }
    if (const auto* on = std::get_if<bool>(&value)) {
        return *on ? ReportSections::tr("on") : ReportSections::tr("off");
    }
    const std::string text = valueText(value);
    if (row.kind == ParameterKind::Choice) {
        std::string words = text;
        std::replace(words.begin(), words.end(), '_', ' ');
        const QString said = QCoreApplication::translate("choices", words.c_str());
        if (said != QString::fromStdString(words)) {
            return said.toHtmlEscaped();
        }
    }
    return text.empty() ? QStringLiteral("–") : code(QString::fromStdString(text));
}

QString unitOf(const Parameter& row) {
    return unitShown(QCoreApplication::translate("parameters", std::string(row.unit).c_str()));
}

constexpr std::size_t mostSubjects = 60;  // named where a setting is the same for many

QString namesOf(const std::vector<std::string>& subjects) {
    QString all;
    for (std::size_t i = 0; i < std::min(subjects.size(), mostSubjects); ++i) {
        const QString name = escaped(subjects[i]);
        all = i == 0 ? name : QCoreApplication::translate("rubble", "%1, %2", "names of a list").arg(all, name);
    }
    return subjects.size() > mostSubjects
               ? QCoreApplication::translate("rubble", "%1 and %2 more").arg(all, QString::number(subjects.size() - mostSubjects))
               : all;
}

}  // namespace

ReportSections::ReportSections(const ReportFacts& facts, const ReportPictures& pictures) : m_facts(facts), m_pictures(pictures) {}

QString ReportSections::said(const Message& message) const {
    static const QRegularExpression raised(QStringLiteral("\\b(m|s)([23])\\b"));
    QString words = m_pictures.say ? m_pictures.say(message) : QString::fromStdString(englishText(message));
    // Messages have plain units; a lone sign before a number is a minus.
    for (QRegularExpressionMatchIterator each = raised.globalMatch(words); each.hasNext();) {
        const QRegularExpressionMatch unit = each.next();
        words.replace(unit.capturedStart(2), 1, unit.captured(2) == QLatin1String("2") ? QStringLiteral("²") : QStringLiteral("³"));
    }
    static const QRegularExpression minus(QStringLiteral("(?<![\\w.-])-(?=\\d)"));
    return words.replace(minus, QStringLiteral("−")).toHtmlEscaped();
}

QString ReportSections::source() const {
    return tr("From run %1, trajectory %2")
        .arg(shortDigest(m_facts.fingerprint), shortDigest(m_facts.result->trajectoryHash.hex()));
}

void ReportSections::addSummary() {
    heading(tr("Question and answer"));
    text(m_facts.question.empty() ? tr("Where did the debris of this collapse go, and how sure is that?")
                                  : escaped(m_facts.question));
    const auto photographs = std::count_if(m_facts.photographs.begin(), m_facts.photographs.end(),
                                           [](const ReportPhoto& photo) { return photo.comparison.has_value(); });
    const auto surveys = std::count_if(m_facts.surveys.begin(), m_facts.surveys.end(),
                                       [](const ReportSurvey& survey) { return survey.comparison.has_value(); });
    if (photographs + surveys == 0) {
        text(
            tr("<b>The evidence was not asked</b>: no photograph and no survey was held against this run. What follows is what the "
               "simulation says, under the assumptions of this report."));
    } else {
        text(tr("The evidence was asked: photographs held against this run: %1, surveys: %2 (see section Evidence).")
                 .arg(photographs)
                 .arg(surveys));
        for (const ReportPhoto& photo : m_facts.photographs) {
            if (photo.comparison) {
                addEvidenceCautions(photo.name, photo.cautions);
            }
        }
        for (const ReportSurvey& survey : m_facts.surveys) {
            addEvidenceCautions(survey.name, survey.cautions);
        }
    }
    if (!m_facts.scenarioNote.empty()) {
        text(tr("Scenario <i>%1</i>: %2").arg(escaped(m_facts.scenarioName), escaped(m_facts.scenarioNote)));
    }
    const SimulationResult& run = *m_facts.result;
    const bool varied = m_facts.ensemble != nullptr && m_facts.ensemble->done().size() > 1;
    const QString unknowns =
        varied ? ensembleWords()
               : tr("What is not known of friction, restitution and births was not varied: what it does to these figures is not "
                    "known.");
    const QString spread = m_facts.floor
                               ? tr("Ranges are those over the run and its %1 repeats.").arg(m_facts.floor->repeats.size())
                               : tr("No repeats were made: the spread of these figures is not known.");
    m_blocks.push_back(ReportList{
        {(m_facts.fe->contents().looseBodies ? tr("%1 elements of %2 of the table's bodies were let go, of together %3 t.")
                                             : tr("%1 elements of %2 were deactivated and became fragments of together %3 t."))
             .arg(count(static_cast<std::int64_t>(m_facts.fragments->size())),
                  count(static_cast<std::int64_t>(m_facts.fe->mesh().elementCount())), tonnes(m_facts.atRest.mass)),
         tr("At the end, %1 s on the clock of the FE result, the debris covers %2 m² in cells of 1 m; 95 % of its mass "
            "lies within %3 m of the plan of what collapsed.")
             .arg(reportSeconds(run.endTime),
                  rangedNumber(m_facts.atRest.footprintArea, rangeOver(m_facts, &DebrisFigures::footprintArea)),
                  rangedNumber(m_facts.atRest.runOut, rangeOver(m_facts, &DebrisFigures::runOut))),
         tr("The highest of these cells lies %1 m above the ground in the mean; %2 % of the bodies are at rest.")
                 .arg(rangedNumber(m_facts.atRest.pileHeight, rangeOver(m_facts, &DebrisFigures::pileHeight)),
                      reportNumber(100.0 * run.asleepAtEnd)) +
             (m_facts.map.map.ledger.highestStands
                  ? u' ' + tr("The highest debris lies on structure that still stands; where none stands within 1 m, the highest "
                              "cell of "
                              "%1 m lies %2 m above the ground.")
                               .arg(reportNumber(m_facts.map.map.cell), reportNumber(m_facts.map.map.ledger.pileHeight))
                  : QString()),
         spread, unknowns}});
    text(source());
    addCautions();
}

void ReportSections::addCautions() {
    if (m_facts.cautions.empty()) {
        return;
    }
    QStringList list;
    for (const Caution& caution : m_facts.cautions) {
        const QString words = said(caution.what);
        const QString sentence = words.left(1).toUpper() + words.mid(1) + QLatin1Char('.');
        list << (caution.grade == HealthGrade::Notice ? sentence : QStringLiteral("<b>%1</b>").arg(sentence));
        if (caution.key == "tainted") {
            list.back() += QLatin1Char(' ') + tr("Its figures should not be relied on (see section Health).");
        }
    }
    if (m_facts.acknowledged) {
        list << tr("%1 vouches for its use: %2 (see section Health).")
                    .arg(escaped(m_facts.acknowledged->by), escaped(m_facts.acknowledged->note));
    }
    if (std::any_of(m_facts.cautions.begin(), m_facts.cautions.end(),
                    [](const Caution& caution) { return caution.grade != HealthGrade::Notice; })) {
        notice(list.join(QStringLiteral("<br/>")));
    } else {
        text(list.join(QLatin1Char(' ')));
    }
}

void ReportSections::addInputs() {
    heading(tr("Inputs, settings and assumptions"));
    addComponents();
    addContacts();
    const std::vector<SettingDifference> differences = differencesBetween(Scenario{}, m_facts.scenario);
    if (differences.empty()) {
        text(tr("All settings are those that the program is delivered with; the appendix lists them."));
    } else {
        ReportTable table;
        table.caption = tr("Settings that depart from those delivered");
        table.columns = QStringList{tr("setting"), tr("key"), tr("delivered"), tr("in this run"), tr("unit")};
        table.words = {true, true, false, false, true};
        table.shares = {0.26, 0.37, 0.14, 0.14, 0.09};
        for (const SharedDifference& shared : sharedDifferences(differences)) {
            const SettingDifference& difference = shared.change;
            const QString label = labelOf(*difference.row);
            const std::size_t many = shared.subjects.size();
            table.rows.push_back(
                {many == 1 ? label : tr("%1, set alike for %2: %3").arg(label, QString::number(many), namesOf(shared.subjects)),
                 code(QString::fromStdString(shared.key())), valueOf(*difference.row, difference.first),
                 valueOf(*difference.row, difference.second), unitOf(*difference.row)});
        }
        table.source = source();
        m_blocks.push_back(std::move(table));
    }
    addAssumptions();
}

void ReportSections::addComponents() {
    ReportTable table;
    table.caption = tr("Components of the structure and what became fragments");
    table.columns = QStringList{tr("component"), tr("material"),  tr("density [kg/m³]"), tr("elements"),
                                tr("mass [t]"),  tr("fragments"), tr("their mass [t]")};
    table.words = {true, true, false, false, false, false, false};
    std::vector<std::int64_t> born(m_facts.components->list.size(), 0);
    std::vector<double> mass(born.size(), 0.0);
    for (const Fragment& fragment : m_facts.fragments->list) {
        ++born[at(fragment.component)];
        mass[at(fragment.component)] += fragment.mass;
    }
    std::size_t guessed = 0;
    for (std::size_t c = 0; c < born.size(); ++c) {
        const Component& component = m_facts.components->list[c];
        const auto own = m_facts.scenario.components.find(component.name);
        const bool isSaid = own != m_facts.scenario.components.end() && own->second.material;
        guessed += isSaid ? 0 : 1;
        const QString material = nameOf(component.material);
        const bool fits = someMaterialFits(component.density);
        const bool given = own != m_facts.scenario.components.end() && own->second.density;
        const std::vector<double>& inFile = m_facts.fe->mesh().density;
        const bool assumed = !given && std::any_of(component.elements.begin(), component.elements.end(),
                                                   [&](ElementIndex element) { return !(inFile[at(element)] > 0.0); });
        const QString guess = assumed ? tr("as %1, its density assumed").arg(material)
                              : fits  ? tr("%1, by its density").arg(material)
                                      : tr("as %1, for no material has its density").arg(material);
        table.rows.push_back({escaped(component.name), isSaid ? material : guess, reportNumber(component.density, 4),
                              count(static_cast<std::int64_t>(component.elements.size())), tonnes(component.mass), count(born[c]),
                              tonnes(mass[c])});
    }
    table.source = source();
    m_blocks.push_back(std::move(table));
    if (guessed > 0) {
        text(tr("What is a material <i>by its density</i> was guessed: nobody said what the component is made of."));
    }
    if (!m_facts.scenarioNote.empty()) {
        text(tr("The case says of this scenario: %1").arg(escaped(m_facts.scenarioNote)));
    }
}

void ReportSections::addContacts() {
    std::set<Material> materials{m_facts.scenario.effects.groundMaterial};
    for (const Component& component : m_facts.components->list) {
        materials.insert(component.material);
    }
    const PairTable acting = actingPairs(m_facts.scenario);
    ReportTable table;
    table.caption = tr("Friction and restitution of the materials that can meet, and what is known of them");
    table.columns = QStringList{tr("pair"), tr("coefficient"), tr("in this run"), tr("range"), tr("source")};
    table.words = {true, true, false, true, true};
    table.shares = {0.18, 0.14, 0.1, 0.2, 0.38};
    for (const PairSource& row : pairSources()) {
        const auto [a, b] = row.pair;
        if (!materials.contains(a) || !materials.contains(b)) {
            continue;
        }
        const QString pair = tr("%1 on %2").arg(nameOf(a), nameOf(b));
        table.rows.push_back({pair, tr("friction"), reportNumber(acting.of(a, b).friction), said(rangeText(row.frictionRange)),
                              said({"", std::string(row.friction), {}})});
        table.rows.push_back({pair, tr("restitution"), reportNumber(acting.of(a, b).restitution),
                              said(rangeText(row.restitutionRange)), said({"", std::string(row.restitution), {}})});
    }
    table.source = source();
    m_blocks.push_back(std::move(table));
    text(tr("An ensemble draws from these ranges. <i>Assumed</i> are those that no source gives for the pair itself."));
}

void ReportSections::addAssumptions() {
    heading(tr("Assumptions and findings"), 2);
    if (m_facts.findings.empty()) {
        text(tr("Nothing had to be assumed or worked around."));
        return;
    }
    ReportTable table;
    table.caption = tr("What was assumed or worked around, how often, and what would settle it");
    table.columns = QStringList{tr("times"), tr("finding"), tr("what to do about it")};
    table.words = {false, true, true};
    table.shares = {0.1, 0.5, 0.4};
    for (const Finding& finding : m_facts.findings.list()) {
        QString what = said(finding.what);
        if (!finding.example.empty()) {
            const std::filesystem::path file(finding.example);
            what +=
                u' ' + tr("(first: %1)").arg(said({"", "{0}", {file.is_absolute() ? file.filename().string() : finding.example}}));
        }
        table.rows.push_back({count(finding.count), what, said(finding.remedy)});
    }
    table.source = source();
    m_blocks.push_back(std::move(table));
}

void ReportSections::addEffects() {
    heading(tr("Effects"));
    text(
        tr("Only what the scene calls for is simulated. An effect that is off costs nothing and leaves the run as if it did not "
           "exist."));
    ReportTable table;
    table.caption = tr("Effects, whether they took part, and why");
    table.columns = QStringList{tr("effect"), tr("state"), tr("asked for"), tr("reason"), tr("ms per step")};
    table.words = {true, true, true, true, false};
    table.shares = {0.18, 0.08, 0.12, 0.48, 0.14};
    const std::array<QString, 3> asked{tr("off"), tr("on"), tr("auto")};
    for (const EffectReport& effect : m_facts.result->effects) {
        table.rows.push_back({labelOf(*findParameter(effectName(effect.decision.kind)).first),
                              effect.decision.on ? tr("on") : tr("off"), asked[static_cast<std::size_t>(effect.decision.asked)],
                              said(effect.decision.reason),
                              effect.decision.on ? reportNumber(effect.msPerStep, 2) : QStringLiteral("–")});
    }
    table.source = source();
    m_blocks.push_back(std::move(table));
}

namespace {

QString gradeShown(HealthGrade grade) {
    return grade == HealthGrade::Notice    ? ReportSections::tr("notice")
           : grade == HealthGrade::Finding ? ReportSections::tr("finding")
                                           : ReportSections::tr("tainted");
}

}  // namespace

void ReportSections::addHealth() {
    heading(tr("Health of the run"));
    addConservation();
    const HealthReport& health = m_facts.result->health;
    if (health.breaches.empty()) {
        text(
            tr("No limit of health was passed: energy, overlap, speeds and places stayed within their limits at every step, and no "
               "pile woke that had come to rest."));
        return;
    }
    ReportTable table;
    table.caption = tr("Limits of health that were passed");
    table.columns =
        QStringList{tr("when [s]"), tr("grade"), tr("what, and why this grade"), tr("worst"), tr("limit"), tr("bodies at worst")};
    table.words = {true, true, true, false, false, false};
    table.shares = {0.17, 0.1, 0.41, 0.12, 0.1, 0.1};
    for (const PassedLimit& limit : passedLimits(health.breaches)) {
        const HealthBreach& breach = health.breaches[limit.worst];
        QStringList times;
        for (const std::size_t i : limit.breaches) {
            const HealthBreach& each = health.breaches[i];
            times << (each.to > each.from ? QStringLiteral("%1–%2").arg(reportSeconds(each.from), reportSeconds(each.to))
                                          : reportSeconds(each.from));
        }
        table.rows.push_back({times.join(QStringLiteral(", ")), gradeShown(limit.grade),
                              QStringLiteral("%1<br/><i>%2</i>").arg(said(breach.what), said(gradeReason(breach))),
                              said(healthMeasure(breach.check, breach.worst)), said(healthMeasure(breach.check, breach.limit)),
                              breach.bodies > 0 ? count(breach.bodies) : QStringLiteral("–")});
    }
    table.source = source();
    m_blocks.push_back(std::move(table));
    if (m_facts.acknowledged) {
        text(tr("Acknowledged by %1 on %2: %3")
                 .arg(escaped(m_facts.acknowledged->by), escaped(m_facts.acknowledged->when), escaped(m_facts.acknowledged->note)));
    }
}

void ReportSections::addSelfTest() {
    heading(tr("Self-test of this machine"));
    if (m_facts.selfTest.empty()) {
        text(tr("The self-test was not run for this report."));
        return;
    }
    const auto passed =
        std::count_if(m_facts.selfTest.begin(), m_facts.selfTest.end(), [](const ReportCheck& check) { return check.passed; });
    text(tr("The hard cases of the simulation (%1) were run on this machine with the program that made this report: %2 of %3 "
            "passed.")
             .arg(escaped(m_facts.selfTestScope))
             .arg(passed)
             .arg(m_facts.selfTest.size()));
    if (m_facts.selfTestLeft > 0) {
        text(tr("Cases of this kind that were left out, since they take minutes: %1. The whole self-test runs them.")
                 .arg(m_facts.selfTestLeft));
    }
    ReportTable table;
    table.caption = tr("Cases of the self-test, each with the number closest to its limit");
    table.columns = QStringList{tr("case"), tr("must hold"), tr("measured"), tr("limit"), tr("result")};
    table.words = {true, true, false, false, true};
    table.shares = {0.2, 0.42, 0.15, 0.13, 0.1};
    table.small = true;
    for (const ReportCheck& check : m_facts.selfTest) {
        const QString unit = QLatin1Char(' ') + unitShown(escaped(check.unit));
        const QString criterion = QCoreApplication::translate("selftest", std::string(check.criterion).c_str());
        table.rows.push_back({escaped(check.id), criterionShown(criterion.toHtmlEscaped()), reportNumber(check.measured, 2) + unit,
                              reportNumber(check.limit, 2) + unit, check.passed ? tr("passed") : tr("<b>failed</b>")});
    }
    m_blocks.push_back(std::move(table));
}

void ReportSections::addLimits() {
    heading(tr("Limits"));
    m_blocks.push_back(ReportList{
        {tr("The size of fragments is the size of the elements: a finer mesh gives smaller debris, and nothing breaks below it. On "
            "a "
            "stone arch, elements of 6.1 t instead of 1.3 t moved 25 % of the mass map, where a repeat moves 10 %; run-out fell "
            "from "
            "10.4 m to 6.3 m, and the mean height rose from 3.0 m to 3.5 m. Part of that is the FE analysis of the other mesh."),
         tr("Fragments do not load the structure back: what still stands moves as the FE result says, whatever falls on it."),
         tr("Energy that the FE solver lost when it deleted elements is not returned."),
         tr("Live elements that fell are debris as well. They are no fragments: maps and comparisons carry them as a layer of "
            "their own "
            "beyond a displacement of %1 m.")
             .arg(reportNumber(m_facts.map.map.liveThreshold)),
         tr("Rigid piles are chaotic: a change of a micrometre moves single fragments by metres. Only what exceeds the spread of "
            "repeats "
            "means anything, and single fragments are never evidence."),
         tr("A cluster is a device of computation and no piece of debris."),
         tr("%1 bodies still moved at the end of the simulation.").arg(count(m_facts.result->stillMoving))}});
}

void ReportSections::addParameters() {
    m_blocks.push_back(ReportHeading{1, tr("All settings of the run"), true});
    ReportTable table;
    table.caption = tr("Settings by key, with their unit and the value as delivered");
    table.columns = QStringList{tr("key"), tr("value"), tr("unit"), tr("delivered")};
    table.words = {true, false, true, false};
    table.shares = {0.46, 0.22, 0.12, 0.2};
    table.small = true;
    const Scenario delivered;
    for (const Parameter& row : parameterTable()) {
        for (const std::string& subject : row.subjectsIn(m_facts.scenario)) {
            table.rows.push_back({code(QString::fromStdString(row.keyFor(subject))),
                                  valueOf(row, row.get(m_facts.scenario, subject)), unitOf(row),
                                  valueOf(row, row.get(delivered, subject))});
        }
    }
    table.source = source();
    m_blocks.push_back(std::move(table));
}

void ReportSections::addJournal() {
    m_blocks.push_back(ReportHeading{1, tr("Journal of the case"), true});
    if (m_facts.journal.empty()) {
        text(m_facts.casePath.empty() ? tr("The report was made from a run alone, without its case.")
                                      : tr("The journal of the case is empty: no change of it was saved with its author."));
        return;
    }
    ReportTable table;
    table.caption = tr("When the case was saved, by whom, and what had changed");
    table.columns = QStringList{tr("saved (UTC)"), tr("by"), tr("changes"), tr("digest")};
    table.words = {true, true, true, true};
    table.shares = {0.2, 0.14, 0.42, 0.24};
    table.small = true;
    constexpr std::size_t named = 6;
    for (const JournalEntry& entry : m_facts.journal) {
        QStringList places;
        for (std::size_t i = 0; i < std::min(named, entry.changes.size()); ++i) {
            places << escaped(entry.changes[i].place);
        }
        if (entry.changes.size() > named) {
            places << tr("%1 more").arg(entry.changes.size() - named);
        }
        table.rows.push_back({entry.outside ? tr("outside Rubble") : escaped(entry.when), escaped(entry.who),
                              places.join(QStringLiteral(", ")), shortDigest(entry.digest)});
    }
    m_blocks.push_back(std::move(table));
}

}  // namespace rubble::figures
