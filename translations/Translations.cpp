#include "Translations.h"

#include <QCoreApplication>
#include <QLibraryInfo>
#include <QTranslator>

namespace bolster {

void installTranslations(QCoreApplication& application, const QLocale& locale)
{
    const auto install = [&](const QString& name, const QString& folder) {
        auto* translator = new QTranslator(&application);
        if (translator->load(locale, name, "_", folder) || translator->load(name + "_en", folder)) {
            QCoreApplication::installTranslator(translator);
        } else {
            delete translator;
        }
    };
    install("qtbase", QLibraryInfo::path(QLibraryInfo::TranslationsPath));
    install("bolster", ":/translations");
}

} // namespace bolster
