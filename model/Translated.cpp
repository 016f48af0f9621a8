#include "Translated.h"

#include <QCoreApplication>

namespace bolster {

QString translated(const Message& message)
{
    const QString sentence = QCoreApplication::translate("Message", message.key.c_str());
    return QString::fromStdString(filledIn(sentence.toStdString(), message.args));
}

QString translated(const Problem& problem)
{
    Problem local = problem;
    local.message = {translated(problem.message).toStdString(), {}};
    return QString::fromStdString(local.english());
}

} // namespace bolster
