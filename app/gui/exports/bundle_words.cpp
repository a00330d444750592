#include "app/gui/exports/bundle_words.h"

#include <QCoreApplication>
#include <QFileInfo>
#include <algorithm>

#include "io/seal/bag.h"
#include "widgets/basics/wording.h"

namespace rubble {

namespace {

using widgets::BundleRow;

/// Texts of what a bundle says.
struct BundleWords {
    Q_DECLARE_TR_FUNCTIONS(BundleWords)
};

BundleRow::Standing standingOf(io::Proof proof) {
    switch (proof) {
        case io::Proof::Holds:
            return BundleRow::Standing::Good;
        case io::Proof::Unproven:
            return BundleRow::Standing::Doubtful;
        case io::Proof::Fails:
            return BundleRow::Standing::Bad;
        case io::Proof::Absent:
            break;
    }
    return BundleRow::Standing::Nothing;
}

BundleRow rowOf(const io::CheckedPart& part) {
    BundleRow row{widgets::worded(part.name), standingOf(part.proof), widgets::worded(io::proofText(part.proof)),
                  widgets::worded(part.meaning)};
    for (std::size_t i = 0; i < part.said.size(); ++i) {
        const io::SealFault& said = part.said[i];
        const io::Proof proof = i < part.faults ? io::Proof::Fails : io::Proof::Unproven;
        row.parts.push_back({said.place.empty() ? BundleWords::tr("container") : QString::fromStdString(said.place),
                             standingOf(proof), widgets::worded(io::proofText(proof)), widgets::worded(said.what)});
    }
    for (const io::SealFault& known : part.known) {
        row.parts.push_back({QString::fromStdString(known.place), BundleRow::Standing::Nothing, BundleWords::tr("to be known"),
                             widgets::worded(known.what)});
    }
    return row;
}

BundleRow rowOf(const io::RepeatedRun& run) {
    const QString place = QString::fromStdString(run.run.place);
    if (run.equal()) {
        return {place, BundleRow::Standing::Good, BundleWords::tr("equal"),
                BundleWords::tr("simulated again, it is the same bit by bit at every recorded instant")};
    }
    const QString difference = widgets::worded(run.difference());
    if (!run.notSimulated.empty()) {
        return {place, BundleRow::Standing::Doubtful, BundleWords::tr("not simulated"),
                QStringLiteral("%1. %2").arg(difference, widgets::worded(run.remedy))};
    }
    return {place, BundleRow::Standing::Bad, BundleWords::tr("not equal"), difference};
}

widgets::BundleRecord recordOf(const io::CheckedRecord& checked) {
    const io::SealRecord& record = checked.record;
    const auto text = [](const std::string& words) { return QString::fromStdString(words); };
    widgets::BundleRecord shown;
    shown.number = static_cast<int>(record.number);
    shown.isAddendum = record.isAddendum;
    shown.when = text(record.when);
    shown.by = text(record.isAddendum ? record.by : record.custody.to);
    shown.from = text(record.custody.from);
    shown.where = text(record.custody.where);
    shown.note = text(record.isAddendum ? record.addendum.note : record.custody.why);
    shown.bundleDigest = text(record.custody.bundleSha256);
    shown.digest = text(checked.sha256);
    shown.isSigned = !record.signer.empty();
    for (const JournalChange& change : record.addendum.differences) {
        shown.differences += differenceText(change);
    }
    return shown;
}

QString factsOf(const io::SealCheck& check) {
    const io::SealStatement& statement = check.statement;
    const QString title = QString::fromStdString(statement.title), when = QString::fromStdString(statement.sealedAt);
    QStringList lines{statement.sealedBy.empty()
                          ? BundleWords::tr("%1, sealed %2").arg(title, when)
                          : BundleWords::tr("%1, sealed %2 by %3").arg(title, when, QString::fromStdString(statement.sealedBy))};
    if (!statement.note.empty()) {
        lines += QString::fromStdString(statement.note);
    }
    lines += BundleWords::tr("SHA-256 of the key: %1").arg(QString::fromStdString(check.signature.signer.fingerprint));
    lines += BundleWords::tr("SHA-256 of the statement: %1").arg(QString::fromStdString(check.sealSha256));
    return lines.join(u'\n');
}

}  // namespace

QString differenceText(const JournalChange& change) {
    const auto value = [](const std::string& text) {
        return text.empty() ? BundleWords::tr("nothing") : QString::fromStdString(text);
    };
    return BundleWords::tr("%1: %2 became %3").arg(QString::fromStdString(change.place), value(change.before), value(change.after));
}

widgets::BundleContent contentOf(const OpenBundle& bundle, const QString& ownCase) {
    widgets::BundleContent content;
    content.file = bundle.path;
    content.ownCase = ownCase;
    if (!bundle.checked) {
        return content;
    }
    const io::SealCheck& check = bundle.check;
    content.read = true;
    content.altered = !check.sound();
    content.verdict =
        BundleWords::tr("The bundle is %1.").arg(widgets::worded(io::bundleVerdict(check, bundle.repeats, bundle.simulated)));
    content.facts = factsOf(check);
    const std::vector<io::CheckedPart> parts = io::checkedParts(check);
    std::transform(parts.begin(), parts.end(), std::back_inserter(content.checks),
                   [](const io::CheckedPart& part) { return rowOf(part); });
    std::transform(bundle.repeats.begin(), bundle.repeats.end(), std::back_inserter(content.runs),
                   [](const io::RepeatedRun& run) { return rowOf(run); });
    for (const io::SealedInput& input : io::inputsOf(check)) {
        if (input.files.empty()) {
            const auto located = bundle.located.find(input.id);
            content.absent.push_back({QString::fromStdString(input.id), QString::fromStdString(input.path),
                                      QString::fromStdString(input.sha256),
                                      located == bundle.located.end() ? QString() : located->second});
        }
    }
    std::transform(check.records.begin(), check.records.end(), std::back_inserter(content.records), recordOf);
    content.stampThere = check.stamp.has_value();
    content.stampSaid = widgets::worded(io::sealedWhen(check));
    for (const std::vector<io::SealFault>* list : {&check.faults, &check.doubts}) {
        for (const io::SealFault& fault : *list) {
            if (fault.place == io::bag::stampAnswer || fault.place == io::bag::stampRequest) {
                content.stampSaid += u'\n' + widgets::worded(fault.what);
            }
        }
    }
    return content;
}

}  // namespace rubble
