#pragma once

#include <QString>

#include <cstdint>
#include <string_view>

namespace rubble::figures {

/// In which units quantities are shown. Everything inside and every file is in SI, whatever is shown.
enum class UnitSet : std::uint8_t { Si, MillimetreTonne, UsCustomary };

/// Chooses the units of everything that is shown from now on; what stands on screen is to be said again.
void chooseUnits(UnitSet set);
UnitSet unitSet();

/// A unit of SI and what is shown in its place.
struct ShownUnit {
    QString name;        ///< "ft"
    double perSi = 1.0;  ///< shown units in one unit of SI: value shown = value x perSi
};

/// What is shown in place of a unit: "m", "m2", "m3", "kg", "t", "kg/m3", "m/s", "m/s2", "Pa", "J" or "N"; "s" as timeUnit();
/// others, and all of them while a file is written, stay as they are, with raised digits.
ShownUnit shownUnit(std::string_view unit);
/// The same for a value of this size, in SI: a time is told in the unit that suits it.
ShownUnit shownUnit(std::string_view unit, double value);

/// A unit as people write it, also within a sentence: "kg/m³" for "kg/m3". The one place where digits are raised.
QString raisedUnits(QString text);

/// While one lives, what this thread draws or says is for a file: SI.
class FileUnits {
public:
    FileUnits();
    ~FileUnits();
    FileUnits(const FileUnits&) = delete;
    FileUnits& operator=(const FileUnits&) = delete;
};

}  // namespace rubble::figures
