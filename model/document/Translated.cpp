#include "Translated.h"

#include <QCoreApplication>
#include <QLocale>
#include <QRegularExpression>

#include <algorithm>
#include <iterator>

namespace bolster {

namespace {

/// Numbers come with a point, as files have them; numbers of elements in English ("2 patches"), as edits keep them.
std::string localized(const std::string& arg)
{
    static const QRegularExpression fraction(QStringLiteral("^-?\\d+\\.\\d+$"));
    static const QRegularExpression counted(QStringLiteral("^(\\d+)( [a-z ]+)$"));
    QString text = QString::fromStdString(arg);
    if (fraction.match(text).hasMatch())
        return text.replace(u'.', QLocale().decimalPoint()).toStdString();
    if (const auto parts = counted.match(text); parts.hasMatch())
        return QCoreApplication::translate("ElementText", qUtf8Printable(QStringLiteral("%1") + parts.captured(2)))
            .arg(parts.captured(1))
            .toStdString();
    return arg;
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
