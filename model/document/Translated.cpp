#include "Translated.h"

#include <QCoreApplication>
#include <QLocale>
#include <QRegularExpression>

#include <algorithm>
#include <atomic>
#include <iterator>

namespace bolster {

namespace {

std::atomic<QString (*)(double)> lengthTold = nullptr;
std::atomic<QString (*)()> decimalSignTold = nullptr;

QString decimalSign()
{
    const auto told = decimalSignTold.load();
    return told ? told() : QLocale().decimalPoint();
}

/// "at least 5 mm", "is %1 mm long": lengths that are not told in mm take the places of both.
void tellLengths(QString& sentence, std::vector<std::string>& args)
{
    const auto told = lengthTold.load();
    if (!told)
        return;
    static const QRegularExpression lengths(QStringLiteral("(?:%(\\d)|(\\d+)) mm\\b"));
    qsizetype from = 0;
    for (auto found = lengths.match(sentence); found.hasMatch(); found = lengths.match(sentence, from)) {
        QString text = found.captured();
        if (const auto place = static_cast<std::size_t>(found.captured(1).toUInt()); place == 0) {
            text = told(found.captured(2).toDouble());
        } else if (bool good = false; place <= args.size()) {
            const double length = QString::fromStdString(args[place - 1]).toDouble(&good);
            if (good) {
                args.push_back(told(length).toStdString()); // the same number may be there without a unit, too
                text = u'%' + QString::number(args.size());
            }
        }
        sentence.replace(found.capturedStart(), found.capturedLength(), text);
        from = found.capturedStart() + text.size();
    }
}

/// Numbers come with a point, as files have them; numbers of elements in English ("2 patches"), as edits keep them.
std::string localized(const std::string& arg)
{
    static const QRegularExpression fraction(QStringLiteral("^-?\\d+\\.\\d+$"));
    static const QRegularExpression counted(QStringLiteral("^(\\d+)( [a-z ]+)$"));
    QString text = QString::fromStdString(arg);
    if (fraction.match(text).hasMatch())
        return text.replace(u'.', decimalSign()).toStdString();
    if (const auto parts = counted.match(text); parts.hasMatch())
        return QCoreApplication::translate("ElementText", qUtf8Printable(QStringLiteral("%1") + parts.captured(2)))
            .arg(parts.captured(1))
            .toStdString();
    return isolated(text).toStdString();
}

bool mayTurn(QChar c)
{
    switch (c.direction()) {
    case QChar::DirR:
    case QChar::DirAL:
    case QChar::DirAN:
    case QChar::DirLRE:
    case QChar::DirLRO:
    case QChar::DirRLE:
    case QChar::DirRLO:
    case QChar::DirPDF:
    case QChar::DirLRI:
    case QChar::DirRLI:
    case QChar::DirFSI:
    case QChar::DirPDI:
        return true;
    default:
        return false;
    }
}

} // namespace

QString asSentence(const QString& text)
{
    // Names of files stay as they are.
    const QString first = text.section(QRegularExpression(QStringLiteral("[\\s:]")), 0, 0);
    return first.contains(u'.') ? text : text.left(1).toUpper() + text.mid(1);
}

QString isolated(const QString& text)
{
    static constexpr QChar firstStrong(0x2068), pop(0x2069);
    if (!std::ranges::any_of(text, mayTurn))
        return text;
    QString kept = text; // isolates of its own might begin without an end, or end without a beginning
    kept.removeIf([](QChar c) { return c >= QChar(0x2066) && c <= pop; });
    return firstStrong + kept + pop;
}

QString translated(const Message& message)
{
    QString sentence = QCoreApplication::translate("Message", message.key.c_str());
    std::vector<std::string> numbers = message.args, args;
    tellLengths(sentence, numbers);
    std::ranges::transform(numbers, std::back_inserter(args), localized);
    return QString::fromStdString(filledIn(sentence.toStdString(), args));
}

void tellNumbersAs(const NumbersTold& told)
{
    lengthTold = told.length;
    decimalSignTold = told.decimalSign;
}

QString translated(const Problem& problem)
{
    Problem local = problem;
    local.message = {translated(problem.message).toStdString(), {}};
    return QString::fromStdString(local.english());
}

} // namespace bolster
