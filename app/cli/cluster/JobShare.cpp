#include "JobShare.h"

#include <QStringList>

namespace bolster::cli {

JobShare jobShare(const Arguments& arguments)
{
    if (!arguments.has("--part"))
        return {};
    const QStringList words = arguments.path("--part").split('/');
    bool whichIs = false, ofIs = false;
    const JobShare share =
        words.size() == 2 ? JobShare{words[0].toInt(&whichIs), words[1].toInt(&ofIs)} : JobShare{};
    if (!whichIs || !ofIs || share.of < 1 || share.which < 0 || share.which >= share.of)
        throw UsageError("--part is I/N with I from 0 to N-1");
    return share;
}

} // namespace bolster::cli
