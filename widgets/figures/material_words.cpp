#include "widgets/figures/material_words.h"

#include "widgets/figures/translated.h"

namespace rubble::figures {

QString guessedMaterial(const QString& name, bool fits) {
    return (fits ? tr("%1 (assumed)") : tr("as %1, for no material has its density")).arg(name);
}

}  // namespace rubble::figures
