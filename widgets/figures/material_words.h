#pragma once

#include <QString>

namespace rubble::figures {

/// A material that was guessed from a density: "concrete (assumed)"; where none fits that density "as concrete, for none fits".
/// @param fits  someMaterialFits()
QString guessedMaterial(const QString& name, bool fits);

}  // namespace rubble::figures
