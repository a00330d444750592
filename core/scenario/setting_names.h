#pragma once

#include <functional>
#include <string>
#include <string_view>

namespace rubble {

/// A text of the catalogue in the language that is written. @param context  "parameters", "choices" or "rubble"; @param comment
/// that tells two equal texts apart, or empty
using CatalogueWords = std::function<std::string(std::string_view context, std::string_view english, std::string_view comment)>;

/// A text in which settings have the names that stand beside their fields, in quotation marks, in place of their keys: files and
/// the command line speak keys, readers do not. "raise step_rate or substeps" becomes "raise “Steps per second” or “Substeps”",
/// "auto_remedy = true" becomes "“Halve steps on findings” = on", component[NAME].density becomes "“Density”",
/// component[{0}].density "“Density” of “{0}”". Keys that are words as well (friction, ground) are keys where they have a value,
/// stand alone in brackets, or in one list with another key.
/// @param text  in any language; @param say  unset: English
std::string withSettingNames(const std::string& text, const CatalogueWords& say = {});

}  // namespace rubble
