#include "Translated.h"

#include <QCoreApplication>
#include <QLocale>
#include <QRegularExpression>

#include <algorithm>
#include <iterator>

namespace bolster {

namespace {

/// Numbers come with a point, as files have them.
std::string localized(const std::string& arg)
{
    static const QRegularExpression fraction(QStringLiteral("^-?\\d+\\.\\d+$"));
    QString text = QString::fromStdString(arg);
    if (!fraction.match(text).hasMatch())
        return arg;
    return text.replace(u'.', QLocale().decimalPoint()).toStdString();
}

} // namespace

QString translated(const Message& message)
{
    const QString sentence = QCoreApplication::translate("Message", message.key.c_str());
    std::vector<std::string> args;
    std::ranges::transform(message.args, std::back_inserter(args), localized);
    return QString::fromStdString(filledIn(sentence.toStdString(), args));
}

QString translated(const Problem& problem)
{
    Problem local = problem;
    local.message = {translated(problem.message).toStdString(), {}};
    return QString::fromStdString(local.english());
}

} // namespace bolster
