#include "PartNames.h"

#include <QStringDecoder>

#include <map>

namespace bolster {

std::string cleanName(const std::string& name)
{
    QStringDecoder utf8(QStringDecoder::Utf8, QStringDecoder::Flag::Stateless);
    const QString decoded = utf8(QByteArrayView(name.data(), static_cast<qsizetype>(name.size())));
    return (utf8.hasError() ? QString::fromLatin1(name.data(), static_cast<qsizetype>(name.size())) : decoded)
        .toStdString();
}

void namePartsApart(Assembly& assembly)
{
    std::map<std::string, std::uint32_t> met; // how often, so that many of one name take no longer
    for (Assembly::Part& part : assembly.parts) {
        part.name = QString::fromStdString(cleanName(part.name)).simplified().toStdString();
        if (part.triangles.empty())
            continue;
        if (part.name.empty())
            part.name = part.parent ? assembly.parts[*part.parent].name : std::string();
        if (part.name.empty())
            part.name = "Part";
        const std::string name = part.name;
        for (auto [at, isNew] = met.try_emplace(name, 1); !isNew; isNew = met.try_emplace(part.name, 1).second)
            part.name = name + " (" + std::to_string(++at->second) + ")";
    }
}

} // namespace bolster
