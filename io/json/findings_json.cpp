#include "io/json/findings_json.h"

#include <nlohmann/json.hpp>

namespace rubble::io {

using nlohmann::json;

json messageJson(const Message& message) {
    json arguments = json::array();
    for (const Argument& argument : message.arguments) {
        json value = std::visit(
            [](const auto& v) -> json {
                if constexpr (std::is_same_v<std::decay_t<decltype(v)>, double>) {
                    return {{"number", jsonNumber(v)}};
                } else if constexpr (std::is_same_v<std::decay_t<decltype(v)>, std::int64_t>) {
                    return {{"integer", v}};
                } else {
                    return {{"text", v}};
                }
            },
            argument.value);
        value["unit"] = argument.unit;
        arguments.push_back(std::move(value));
    }
    return {{"id", message.id}, {"pattern", message.pattern}, {"arguments", std::move(arguments)}};
}

Message messageFromJson(const JsonCursor& object) {
    Message message{object["id"].text(), object["pattern"].text(), {}};
    for (const JsonCursor& entry : object["arguments"].elements()) {
        if (entry.has("number")) {
            message.arguments.emplace_back(entry["number"].anyNumber(), entry["unit"].text());
        } else if (entry.has("integer")) {
            message.arguments.emplace_back(entry["integer"].integer());
            message.arguments.back().unit = entry["unit"].text();
        } else {
            message.arguments.emplace_back(entry["text"].text());
            message.arguments.back().unit = entry["unit"].text();
        }
    }
    return message;
}

json findingsJson(const Findings& findings) {
    json list = json::array();
    for (const Finding& finding : findings.list()) {
        list.push_back({{"what", messageJson(finding.what)},
                        {"remedy", messageJson(finding.remedy)},
                        {"count", finding.count},
                        {"example", finding.example}});
    }
    return list;
}

Findings findingsFromJson(const JsonCursor& list) {
    Findings findings;
    for (const JsonCursor& entry : list.elements()) {
        findings.add(messageFromJson(entry["what"]), messageFromJson(entry["remedy"]), entry["example"].text(),
                     entry["count"].integer());
    }
    return findings;
}

}  // namespace rubble::io
