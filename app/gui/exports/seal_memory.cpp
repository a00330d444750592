#include "app/gui/exports/seal_memory.h"

#include <QSettings>

#include "app/gui/session/worker.h"

namespace rubble {

namespace {

const QString signerBy = QStringLiteral("seal/by");
const QString signerKey = QStringLiteral("seal/key");
const QString signerCertificate = QStringLiteral("seal/certificate");
const QString trustedRoots = QStringLiteral("seal/roots");
const QString trustedStampRoots = QStringLiteral("seal/stamp_roots");

}  // namespace

widgets::SignerChoice rememberedSigner() {
    const QSettings settings;
    return {settings.value(signerBy).toString(),
            settings.value(signerKey).toString(),
            settings.value(signerCertificate).toString(),
            {}};
}

void rememberSigner(const widgets::SignerChoice& signer) {
    QSettings settings;
    settings.setValue(signerBy, signer.by);
    settings.setValue(signerKey, signer.key);
    settings.setValue(signerCertificate, signer.certificate);
}

widgets::BundleTrust rememberedTrust() {
    const QSettings settings;
    return {{}, settings.value(trustedRoots).toString(), settings.value(trustedStampRoots).toString(), {}};
}

void rememberTrust(const widgets::BundleTrust& trust) {
    QSettings settings;
    settings.setValue(trustedRoots, trust.roots);
    settings.setValue(trustedStampRoots, trust.stampRoots);
}

io::SignerFiles signerFiles(const widgets::SignerChoice& signer) {
    return {signer.key.toStdString(), signer.certificate.toStdString(), signer.passphrase.toStdString()};
}

widgets::SealObjection objectionOf(const std::exception_ptr& thrown) {
    const auto failure = failureOf(thrown);
    return failure ? widgets::SealObjection{failure->what(), failure->remedy()} : widgets::SealObjection();
}

}  // namespace rubble
