#pragma once

#include <nlohmann/json.hpp>

#include "io/exports/page/page_export.h"
#include "io/exports/page/page_scene.h"

namespace rubble::io {

/// Everything that a page says in words and figures: titles, chapters, outcome, health, findings, inputs with their SHA-256,
/// settings that depart from those delivered, errors of its places. Texts are {en, zh}.
nlohmann::json pageFacts(const RunReader& run, const FeResult& fe, const PageExtras& extras, const PageScene& scene);

}  // namespace rubble::io
