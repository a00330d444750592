#pragma once

#include <QString>
#include <vector>

namespace rubble {

/// A case or result that comes with the program.
struct Sample {
    QString path;
    QString name;
    QString words;    ///< what it shows
    QString picture;  ///< a small picture of it; empty if there is none
};

/// Path of the sample that the program opens first, empty if it is not installed.
QString samplePath();

/// Whether a file lies among them: what comes with the program is never written, whoever runs it.
bool isSample(const QString& path);
/// A place for a file that is proposed beside a sample: nothing is saved among those. Others are returned as they are.
QString outsideSamples(const QString& proposed);

/// All that are installed, the first one first; a file that cannot be read is left out.
std::vector<Sample> samples();

}  // namespace rubble
