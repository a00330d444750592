#include "io/seal/seal_case.h"

#include <algorithm>
#include <filesystem>

#include "core/base/build.h"
#include "core/base/error.h"
#include "core/simulation/run/acknowledgement.h"
#include "io/base/files.h"
#include "io/seal/seal_payload.h"
#include "io/seal/seal_readme.h"
#include "io/seal/time_stamp.h"

namespace rubble::io {

namespace {

std::string aboutText(const SealStatement& statement) {
    // One line for each label: a line end within a text would begin another.
    std::string title = statement.title, by = statement.sealedBy;
    for (std::string* text : {&title, &by}) {
        std::replace_if(text->begin(), text->end(), [](char c) { return c == '\n' || c == '\r'; }, ' ');
    }
    return "Bag-Software-Agent: Rubble " + statement.version + "\nBagging-Date: " + statement.sealedAt.substr(0, 10) +
           "\nContact-Name: " + by + "\nExternal-Description: " + title + "\nInternal-Sender-Identifier: " + statement.caseSha256 +
           "\nPayload-Oxum: " + std::to_string(statement.bytes) + "." + std::to_string(statement.files) + "\n";
}

/// Packs one bundle: the texts about it, then the payload.
class BundlePacking {
public:
    BundlePacking(const SealPayload& payload, const std::map<std::string, std::string>& tags, const Execution& execution)
        : m_payload(payload), m_tags(tags), m_execution(execution) {}

    void pack(const std::string& file, const std::string& folder) {
        ZipWriter zip(file);
        // A bag is recognised by its first entry.
        zip.add(folder + bag::declaration, m_tags.at(bag::declaration));
        for (const auto& [place, text] : m_tags) {
            if (place != bag::declaration) {
                zip.add(folder + place, text);
            }
        }
        for (const PayloadFile& each : m_payload.files()) {
            if (each.source.empty()) {
                zip.add(folder + each.place, each.text);
            } else {
                packFile(zip, folder + each.place, each, [&](std::size_t bytes) { advance(each, bytes); });
            }
        }
        zip.finish();
    }

private:
    void advance(const PayloadFile& file, std::size_t bytes) {
        m_done += static_cast<double>(bytes);
        m_execution.report({"io.seal.packing_file", "Packing: {0}", {std::filesystem::path(file.source).filename().string()}},
                           std::min(1.0, m_done / std::max(1.0, static_cast<double>(m_payload.bytes()))));
    }

    const SealPayload& m_payload;
    const std::map<std::string, std::string>& m_tags;
    const Execution& m_execution;
    double m_done = 0.0;
};

SealStatement stated(const SealPayload& payload, const SealRequest& request, const Signer& signer, const std::string& now) {
    SealStatement statement = payload.statement();
    statement.sealedAt = now;
    statement.sealedBy = request.by;
    statement.note = request.note;
    statement.version = std::string(versionText());
    statement.build = std::string(buildText());
    statement.signer = signer.facts().fingerprint;
    statement.subject = signer.facts().subject;
    statement.stampAsked = request.stampRequest || request.service;
    return statement;
}

}  // namespace

SealReport sealCase(const std::string& path, const SealRequest& request, const Execution& execution) {
    const Signer signer(request.signer);
    SealPayload payload(request, execution);
    SealStatement statement = stated(payload, request, signer, utcNow());
    payload.addText("data/build/build.txt", buildReadme(statement));
    const Manifest manifest = payload.manifest();
    std::map<std::string, std::string> tags;
    tags[bag::manifest] = manifestText(manifest);
    statement.manifestSha256 = sha256OfText(tags[bag::manifest]);
    statement.files = static_cast<std::int64_t>(manifest.size());
    statement.bytes = static_cast<std::int64_t>(payload.bytes());
    tags[bag::declaration] = bagDeclaration();
    tags[bag::about] = aboutText(statement);
    tags[bag::readme] = sealReadme(statement);
    for (const char* place : {bag::declaration, bag::about, bag::readme}) {
        statement.tags[place] = sha256OfText(tags[place]);
    }
    tags[bag::statement] = statementText(statement) + "\n";
    tags[bag::signature] = signer.sign(tags[bag::statement]);
    tags[bag::publicKey] = signer.publicKey();
    if (!signer.certificates().empty()) {
        tags[bag::certificates] = signer.certificates();
    }
    SealReport report{statement, sha256OfText(tags[bag::statement]), {}, payload.findings()};
    if (statement.stampAsked) {
        tags[bag::stampRequest] = report.stampRequest = timeStampRequest(tags[bag::signature]);
        if (request.service) {
            tags[bag::stampAnswer] = request.service(report.stampRequest);
            requireStamp(tags[bag::stampAnswer], report.stampRequest, tags[bag::signature]);
        }
    }
    Manifest tagManifest;
    for (const auto& [place, text] : tags) {
        tagManifest[place] = sha256OfText(text);
    }
    tags[bag::tagManifest] = manifestText(tagManifest);
    const std::string folder = bagName(std::filesystem::path(path).stem().string()) + "/";
    writeFileAtomically(path, [&](const std::string& file) { BundlePacking(payload, tags, execution).pack(file, folder); });
    return report;
}

}  // namespace rubble::io
