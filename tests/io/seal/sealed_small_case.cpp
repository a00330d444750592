#include "tests/io/seal/sealed_small_case.h"

#include <openssl/evp.h>
#include <openssl/pem.h>
#include <openssl/x509.h>

#include <cstdio>
#include <fstream>
#include <stdexcept>

#include "core/pipeline/pipeline.h"
#include "io/base/files.h"
#include "io/case/case_file.h"
#include "io/case/open_case.h"
#include "io/exports/report_notes.h"
#include "io/run/run_file.h"
#include "io/seal/bag.h"
#include "tests/support/small_collapse.h"

namespace rubble::io {

PackedFiles packedFiles(const std::string& bundle) {
    ZipReader zip(bundle);
    PackedFiles files;
    for (const ZipReader::Entry& entry : zip.entries()) {
        files.emplace_back(entry.name, zip.content(entry));
    }
    return files;
}

void packFiles(const std::string& bundle, const PackedFiles& files) {
    ZipWriter zip(bundle);
    for (const auto& [name, content] : files) {
        zip.add(name, content);
    }
    zip.finish();
}

std::string& contentAt(PackedFiles& files, const std::string& place) {
    for (auto& [name, content] : files) {
        if (name.substr(name.find('/') + 1) == place) {
            return content;
        }
    }
    throw std::runtime_error("not in the bundle: " + place);
}

void listAnew(PackedFiles& files) {
    for (const char* list : {bag::manifest, bag::tagManifest}) {
        Manifest manifest;
        for (const auto& [name, content] : files) {
            const std::string place = name.substr(name.find('/') + 1);
            if (place.starts_with(bag::payload) == (list == std::string(bag::manifest)) && place != bag::tagManifest) {
                manifest[place] = sha256OfText(content);
            }
        }
        contentAt(files, list) = manifestText(manifest);
    }
}

std::string makeKey(const std::string& path) {
    EVP_PKEY* key = EVP_PKEY_Q_keygen(nullptr, nullptr, "ED25519");
    std::FILE* file = std::fopen(path.c_str(), "w");
    PEM_write_PrivateKey(file, key, nullptr, nullptr, 0, nullptr, nullptr);
    std::fclose(file);
    EVP_PKEY_free(key);
    return path;
}

std::string makeCertificate(const std::string& key, const std::string& path, const std::string& name, long from, long to) {
    std::FILE* in = std::fopen(key.c_str(), "r");
    EVP_PKEY* own = PEM_read_PrivateKey(in, nullptr, nullptr, nullptr);
    std::fclose(in);
    X509* certificate = X509_new();
    X509_set_version(certificate, X509_VERSION_3);
    ASN1_INTEGER_set(X509_get_serialNumber(certificate), 7);
    X509_gmtime_adj(X509_getm_notBefore(certificate), from);
    X509_gmtime_adj(X509_getm_notAfter(certificate), to);
    X509_NAME* subject = X509_get_subject_name(certificate);
    X509_NAME_add_entry_by_txt(subject, "CN", MBSTRING_UTF8, reinterpret_cast<const unsigned char*>(name.c_str()), -1, -1, 0);
    X509_set_issuer_name(certificate, subject);
    X509_set_pubkey(certificate, own);
    X509_sign(certificate, own, nullptr);
    std::FILE* out = std::fopen(path.c_str(), "w");
    PEM_write_X509(out, certificate);
    std::fclose(out);
    X509_free(certificate);
    EVP_PKEY_free(own);
    return path;
}

void runSmallCase(const std::string& casePath, const std::string& runPath, const std::string& build) {
    CaseRequest request;
    request.path = casePath;
    const OpenedCase opened = openCase(request, Execution());
    RunOrigin origin = originOf(opened);
    if (!build.empty()) {
        origin.build = build;
    }
    const std::unique_ptr<TrajectorySink> sink = createRun(runPath, origin);
    run(opened.inputs, opened.scenario, Stage::Simulation, {}, sink.get(), Execution());
}

const SealedSmallCase& SealedSmallCase::the() {
    static const SealedSmallCase one;
    return one;
}

SealedSmallCase::SealedSmallCase() {
    cli::writeSmallCollapse(path("small.exo"));
    std::ofstream(path("north.jpg")) << "a view from the north";
    std::ofstream(path("south.jpg")) << "a view from the south";
    Case theCase = caseForFe(path("small.exo"), casePath());
    theCase.title = "Two blocks";
    theCase.inputs.push_back({"north", InputRole::Photograph, "north.jpg", {}});
    theCase.inputs.push_back({"south", InputRole::Photograph, "south.jpg", {}});
    theCase.scenarios[0].scenario.simulation.settleTime = 0.2;
    theCase = saveCase(casePath(), theCase);
    theCase.scenarios[0].scenario.simulation.friction = 0.5;
    theCase = saveCase(casePath(), theCase);
    theCase.scenarios[0].note = "as the witness tells it";
    saveCase(casePath(), theCase);
    writeReportNotes(reportNotesPath(casePath()), {"Where did the deck go?", "A. Engineer", {"from the police", {}, {}, {}}, {}});
    runSmallCase(casePath(), runPath());
    makeKey(key());
    m_report = sealCase(bundle(), request(), Execution());
}

SealRequest SealedSmallCase::request() const {
    SealRequest request;
    request.casePath = casePath();
    request.runs = {runPath()};
    request.by = "A. Engineer";
    request.signer.key = key();
    return request;
}

}  // namespace rubble::io
