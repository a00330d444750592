#pragma once

#include <map>
#include <string>
#include <vector>

#include "io/seal/bundle_verdict.h"
#include "widgets/evidence/sealing/bundle_content.h"

namespace rubble {

/// A sealed bundle as it was checked, and what was done with it since.
struct OpenBundle {
    QString path;
    bool checked = false;
    io::SealCheck check;
    std::vector<io::RepeatedRun> repeats;
    bool simulated = false;
    std::map<std::string, QString> located;  ///< files of inputs that did not travel, by id
};

/// What is shown of it. @param ownCase  the saved case that is open; empty: there is none
widgets::BundleContent contentOf(const OpenBundle& bundle, const QString& ownCase);

/// What somebody assumes otherwise, in one line: "friction: 0.6 became 0.3".
QString differenceText(const JournalChange& change);

}  // namespace rubble
