#include "FormPatternReport.h"

#include "PatternSize.h"
#include "Translated.h"
#include "Units.h"

#include <QLocale>
#include <QStringList>

#include <algorithm>
#include <cmath>
#include <map>
#include <utility>

namespace bolster {

namespace {

constexpr double leastBeside = 15;   // mm, and
constexpr double shareBeside = 0.04; // of the form's size: a cover that lies so far off is not what was wanted
constexpr std::size_t mostNotes = 5; // of pieces that are left out

} // namespace

/// Of those that say the same of several places the first one.
QStringList FormPatternReport::saidOnce(const std::vector<Message>& notes)
{
    std::map<std::string, int> more;
    for (const Message& note : notes)
        ++more[note.key];
    QStringList lines;
    for (const Message& note : notes) {
        const int count = std::exchange(more[note.key], 0);
        if (count > 0)
            lines << translated(note);
        if (count > 1)
            lines.back() += ' ' + tr("(and %n more)", nullptr, count - 1);
    }
    return lines;
}

FormPatternReport::OnForm FormPatternReport::onForm() const
{
    OnForm found;
    const std::vector<ElementId>& patches = made.pattern.patches; // none of what was stopped
    for (std::size_t p = 0; p < patches.size(); ++p) {
        if (patches[p] == noElement)
            continue;
        ++found.pieces;
        const FlatPiece& flat = made.flat[p];
        found.over += flat.strainP99 > limit;
        if (!found.worst || flat.strainP99 > found.worst->strainP99) {
            found.worst = &flat;
            found.name = made.form.pieces[p].name;
        }
    }
    return found;
}

QString FormPatternReport::problemText() const
{
    QStringList lines{asSentence(translated(made.problem))};
    lines << saidOnce(made.form.notes);
    return lines.join('\n');
}

void FormPatternReport::sayPieces(int pieces, QStringList& lines) const
{
    if (pieces == 0)
        return;
    lines << tr("%n pieces", nullptr, pieces);
    const std::vector<FormSeam>& seams = made.pattern.seams;
    if (seams.empty())
        return;
    double widest = 0;
    for (const FormSeam& seam : seams)
        widest = std::max(widest, std::abs(seam.first - seam.second));
    const int count = static_cast<int>(seams.size());
    lines.back() +=
        ", " + (widest < FormPattern::equallyLong
                    ? tr("%n seams, whose sides are equally long", nullptr, count)
                    : tr("%n seams, whose sides differ by %1 at most", nullptr, count).arg(lengthText(widest, 2)));
}

void FormPatternReport::sayBeside(QStringList& lines) const
{
    if (cover->beside <= std::max(leastBeside, shareBeside * made.form.boundingBox().diagonal().norm()))
        return;
    const bool sinks = isFrame && !keepsOutside;
    lines << (sinks ? tr("Its cover at rest lies up to %1 beside the form, where nothing holds it: tick \"Keeps "
                         "the cover outside\" at the frame, or hold it by a fixation.")
                    : tr("Its cover at rest lies up to %1 beside the form, where nothing holds it: hold it by a "
                         "fixation, or give its pieces pressure."))
                 .arg(lengthText(cover->beside, 0));
}

/// Of the two strains that are said, that of the cover counts.
void FormPatternReport::sayCover(int over, QStringList& lines) const
{
    if (isSolved)
        lines << tr("Its cover is being solved \u2026");
    const double area = patternArea(made.pattern.design);
    if (const double vertices = vertexCount(area, edgeLength); vertices > FormPattern::manyVertices)
        lines << tr("Its cover will have about %1 vertices, and is not solved here: with mesh edges of %2 it is.")
                     .arg(QLocale().toString(std::round(vertices / 1000) * 1000, 'f', 0),
                          lengthText(std::ceil(edgeLengthFor(area, FormPattern::manyVertices)), 0));
    if (!cover)
        return;
    sayBeside(lines);
    const std::vector<CoverFinding>& findings = cover->findings;
    if (!cover->atRest)
        lines << tr("Its cover does not come to rest.");
    else if (findings.empty())
        lines << tr("Its cover at rest is strained no more than the fabric may be.");
    else
        lines << tr("What counts is its cover at rest: %1").arg(translated(findings.front().text));
    if (const int more = static_cast<int>(findings.size()) - 1; more > 0)
        lines.back() += ' ' + tr("(and %n more)", nullptr, more);
    const bool isOver = std::ranges::count(findings, CoverFinding::Kind::OverLimit, &CoverFinding::kind) > 0;
    if (isOver && over == 0)
        lines << tr("Laid on the form by itself no piece is strained so much. Narrow tips and steps of a line do "
                    "that, or mesh edges that are long for them.");
}

void FormPatternReport::sayLeftOut(QStringList& lines) const
{
    const std::vector<Message>& notes = made.pattern.notes;
    const std::size_t told = notes.size() > mostNotes ? mostNotes - 1 : notes.size();
    for (std::size_t k = 0; k < told; ++k)
        lines << translated(notes[k]);
    if (told < notes.size())
        lines << tr("and %n more are left out, too", nullptr, static_cast<int>(notes.size() - told));
}

void FormPatternReport::sayStrain(const OnForm& found, QStringList& lines)
{
    if (found.worst && found.worst->strainP99 > 0)
        lines
            << tr("Laid on the form by itself most strained: %1, %2 (rms), %3 within 99 % of its area, %4 where it "
                  "is most")
                   .arg(isolated(QString::fromStdString(found.name)), percentText(found.worst->strainRms),
                        percentText(found.worst->strainP99), percentText(found.worst->strainMost));
    if (found.over > 0)
        lines << tr("%n pieces are strained by more than the fabric may be in more than a hundredth of their area "
                    "(yellow): divide them, or cut them in there.",
                    nullptr, found.over);
}

void FormPatternReport::sayWhatHelps(const OnForm& found, QStringList& lines) const
{
    const bool leavesOut = !made.pattern.notes.empty();
    if (isFrame && !keepsOutside && found.pieces > 0)
        lines << tr(
            "So that the cover does not sink into the frame, tick \"Keeps the cover outside\" at the frame.");
    if (divides && leavesOut)
        lines << tr("With shorter mesh edges smaller pieces are divided, too.");
    if (!divides && (found.over > 0 || leavesOut))
        lines << tr("Tick \"where it would not lie flat\": that finds where to divide them.");
}

QString FormPatternReport::text() const
{
    if (!made.problem.empty())
        return problemText();
    QStringList lines;
    if (made.size)
        lines << tr("The form is taken as %1 large. If that is wrong, import the file as a frame.")
                     .arg(sizesText({made.size->x(), made.size->y(), made.size->z()}, 0));
    const OnForm found = onForm();
    sayPieces(found.pieces, lines);
    sayCover(found.over, lines);
    lines << saidOnce(made.form.undivided);
    sayLeftOut(lines);
    lines << saidOnce(made.form.notes) << saidOnce(made.pattern.advice);
    sayStrain(found, lines);
    sayWhatHelps(found, lines);
    return lines.join('\n');
}

} // namespace bolster
