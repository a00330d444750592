#include <algorithm>

#include "widgets/figures/report/report_sections.h"

namespace rubble::figures {

void ReportSections::ownWords(const std::string& words) {
    QString paragraph;
    QStringList points;
    const auto end = [&] {
        if (!points.isEmpty()) {
            m_blocks.push_back(ReportList{points});
            points.clear();
        }
        if (!paragraph.isEmpty()) {
            text(paragraph);
            paragraph.clear();
        }
    };
    for (const QString& line : QString::fromStdString(words).split(u'\n')) {
        const QString plain = line.trimmed();
        if (plain.startsWith(QLatin1String("- "))) {
            if (points.isEmpty()) {
                end();
            }
            points << plain.mid(2).toHtmlEscaped();
        } else if (plain.isEmpty()) {
            end();
        } else if (!points.isEmpty()) {
            // A point may go on over several lines.
            points.back() += QLatin1Char(' ') + plain.toHtmlEscaped();
        } else {
            paragraph += (paragraph.isEmpty() ? QString() : QStringLiteral(" ")) + plain.toHtmlEscaped();
        }
    }
    end();
}

void ReportSections::addPlainSummary() {
    if (!m_facts.words.summary.empty()) {
        heading(tr("Summary in plain language"));
        ownWords(m_facts.words.summary);
    }
}

void ReportSections::addAlternatives() {
    heading(tr("Other causes"));
    if (m_facts.words.alternatives.empty() && !m_facts.causes) {
        text(m_facts.fe->contents().looseBodies
                 ? tr("This report is about the bodies of a table and assumes no cause.")
                 : tr("This report is about the cause that the FE result assumes. It does not say which other causes were "
                      "considered."));
        return;
    }
    ownWords(m_facts.words.alternatives);
    if (m_facts.causes) {
        addComparedCauses(*m_facts.causes);
        addFurtherEvidence(*m_facts.causes);
    }
}

namespace {

QString shareShown(double share) {
    return reportNumber(100.0 * share, 2) + QStringLiteral(" %");
}

QString fileNames(const std::vector<std::string>& paths) {
    QStringList names;
    for (const std::string& path : paths) {
        names << QString::fromStdString(path).section(u'/', -1).toHtmlEscaped();
    }
    return names.join(QStringLiteral(", "));
}

}  // namespace

void ReportSections::addComparedCauses(const ReportCauses& causes) {
    const ReportCause& closest = causes.ranked.front();
    text(tr("%1 causes were held against the same evidence (%2), each with an ensemble in which what is not known was varied.")
             .arg(causes.ranked.size())
             .arg(fileNames(causes.evidence)));
    QStringList alike;
    for (std::size_t k = 1; k < causes.ranked.size(); ++k) {
        if (!causes.ranked[k].apart) {
            alike << escaped(causes.ranked[k].name);
        }
    }
    if (causes.unexplained) {
        notice(tr("<b>The evidence lies outside of what the members of %1 do, which comes closest: perhaps none of these is the "
                  "cause.</b>")
                   .arg(escaped(closest.name)));
    }
    QStringList doubts;
    for (const Message& finding : causes.findings) {
        const QString words = said(finding);
        doubts << words.left(1).toUpper() + words.mid(1) + (words.endsWith(QLatin1Char('.')) ? QString() : QStringLiteral("."));
    }
    if (!doubts.isEmpty()) {
        notice(doubts.join(QStringLiteral("<br/>")));
    }
    text(alike.isEmpty() ? tr("%1 comes closest, and the evidence tells it from all others.").arg(escaped(closest.name))
                         : tr("%1 comes closest, but the evidence cannot tell it from %2.")
                               .arg(escaped(closest.name), alike.join(QStringLiteral(", "))));
    ReportTable table;
    table.caption = tr("Supposed causes, the closest to the evidence first; a cause is excluded where at least 70 % is certain");
    table.columns =
        QStringList{tr("cause"), tr("members"), tr("pairs in which the closest is closer"), tr("at least, 95 %"), tr("result")};
    table.words = {true, false, false, false, true};
    table.shares = {0.3, 0.12, 0.23, 0.15, 0.2};
    for (std::size_t k = 0; k < causes.ranked.size(); ++k) {
        const ReportCause& cause = causes.ranked[k];
        const QString dash = QStringLiteral("–");
        table.rows.push_back({escaped(cause.name), QString::number(cause.members),
                              k == 0 ? dash : shareShown(cause.closestOver.share),
                              k == 0 ? dash : shareShown(cause.closestOver.low),
                              k == 0        ? tr("closest")
                              : cause.apart ? tr("excluded")
                                            : tr("not excluded")});
    }
    table.source = tr("From the comparison of causes among the files that this report rests on");
    m_blocks.push_back(std::move(table));
}

void ReportSections::addFurtherEvidence(const ReportCauses& causes) {
    if (causes.further.empty()) {
        return;
    }
    heading(tr("Which evidence would tell"), 2);
    text(tr("Each of %1 members in turn was what happened, seen without error, and its cause was looked for. This is what could be "
            "told at best; the first of %2 pieces that were tried is flattered by chance.")
             .arg(causes.further.front().named.trials)
             .arg(causes.further.size()));
    ReportTable table;
    table.caption = tr("Further evidence, that which names the cause rightly most often first");
    table.columns = QStringList{tr("evidence"), tr("named rightly"), tr("95 %"), tr("named wrongly")};
    table.words = {true, false, false, false};
    table.shares = {0.5, 0.16, 0.18, 0.16};
    const auto add = [&](const QString& name, const BlindShare& named) {
        const double wrong = named.trials > 0 ? static_cast<double>(named.wrong) / static_cast<double>(named.trials) : 0.0;
        table.rows.push_back({name, shareShown(named.share()),
                              tr("%1 to %2").arg(shareShown(named.low()), shareShown(named.high())), shareShown(wrong)});
    };
    if (causes.atHand.trials > 0) {
        add(tr("what is at hand"), causes.atHand);
    }
    constexpr std::size_t shown = 8;
    for (std::size_t k = 0; k < std::min(shown, causes.further.size()); ++k) {
        const QString name = said(causes.further[k].words());
        add(causes.atHand.trials > 0 ? tr("and %1").arg(name) : name, causes.further[k].named);
    }
    table.source = tr("From the comparison of causes among the files that this report rests on");
    m_blocks.push_back(std::move(table));
}

void ReportSections::addChange() {
    if (!m_facts.words.change.empty()) {
        heading(tr("What would change the opinion"));
        ownWords(m_facts.words.change);
    }
}

void ReportSections::addSignature() {
    heading(tr("Who answers for this report"));
    ownWords(m_facts.words.qualification);
    const QString line = QString(40, u'.');
    const QString author = escaped(m_facts.author);
    text(tr("Name: %1").arg(author.isEmpty() ? line : author));
    text(tr("Place and date: %1").arg(line));
    text(tr("Signature: %1").arg(line));
}

}  // namespace rubble::figures
