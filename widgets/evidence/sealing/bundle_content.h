#pragma once

#include <QString>
#include <QStringList>
#include <vector>

#include "widgets/evidence/sealing/signer_form.h"

namespace rubble::widgets {

/// Something that was checked in a sealed bundle, and what came of it.
struct BundleRow {
    enum class Standing { Good, Doubtful, Bad, Nothing };
    QString name;
    Standing standing = Standing::Nothing;
    QString verdict;
    QString meaning;
    std::vector<BundleRow> parts = {};  ///< that it is about
};

/// Who received a bundle, or what another expert changed.
struct BundleRecord {
    int number = 0;
    bool isAddendum = false;
    QString when;
    QString by;    ///< who received it, or who made the addendum
    QString from;  ///< of an entry of custody
    QString where;
    QString note;
    QString bundleDigest;  ///< of the bundle as it was received
    QString digest;        ///< of the entry: what the next one names
    bool isSigned = false;
    QStringList differences;  ///< of an addendum
};

/// An input that did not travel.
struct AbsentInput {
    QString id;
    QString path;  ///< as the case names it
    QString digest;
    QString located;  ///< where it is on this machine; empty: nobody has said
};

/// What is known of a bundle.
struct BundleContent {
    QString file;
    QString verdict;
    bool read = false;     ///< it could be checked
    bool altered = false;  ///< something is not as it was sealed: nothing of it is opened
    QString facts;         ///< who sealed it and when, with digests
    std::vector<BundleRow> checks;
    std::vector<BundleRow> runs;  ///< what came of simulating them again; empty: nothing was simulated
    std::vector<AbsentInput> absent;
    std::vector<BundleRecord> records;
    bool stampThere = false;
    QString stampSaid;  ///< what is known of the time of sealing
    QString ownCase;    ///< the saved case that is open, of which an addendum could be made; empty: there is none
};

/// Whom the reader of a bundle trusts, and what they know of it from elsewhere.
struct BundleTrust {
    QString signer;      ///< public key, certificate, or fingerprint
    QString roots;       ///< certificates that vouch for signers
    QString stampRoots;  ///< certificates that vouch for the time-stamping service
    QString digest;      ///< of the statement or an entry
};

/// Who received a bundle from whom.
struct CustodyChoice {
    QString from;
    QString where;
    QString why;
    SignerChoice signer;  ///< who received it; without a key it is not signed
};

}  // namespace rubble::widgets
