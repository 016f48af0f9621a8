#include "PictureSeries.h"

#include "DesignJson.h"

#include <QFileInfo>

#include <algorithm>

namespace bolster::cli {

namespace {

/// Letters and digits of a name; what else it has becomes "-".
QString forFile(const std::string& name)
{
    QString text = QString::fromStdString(name);
    for (QChar& letter : text)
        if (!letter.isLetterOrNumber())
            letter = u'-';
    return text.left(60);
}

} // namespace

PictureSeries::PictureSeries(const RenderOrder& order, const Design& design, const DesignFiles& files)
    : m_folder(order.series->folder, writeDesign(design) + meshesAsText(files) + order.series->options)
{
    const SeriesOrder& series = *order.series;
    std::vector<std::pair<ElementId, std::string>> colours;
    if (const PictureLook& look = order.picture.look; !look.map && !look.checker)
        design.each<Colourway>(
            [&](ElementId id, const Colourway& colourway) { colours.emplace_back(id, colourway.name); });
    const bool one = colours.empty();
    if (one)
        colours.emplace_back(design.settings().colourway, "");
    int number = 0;
    for (const auto& [id, name] : colours) {
        ++number; // names may be alike in what a file's name can hold
        for (const NamedView& view : series.views) {
            QString file = forFile(view.name) + "." + QString::fromStdString(series.format);
            if (!name.empty())
                file.prepend(forFile(name) + "-");
            if (!one)
                file.prepend(QString("%1-").arg(number, 2, 10, QChar('0')));
            if (std::ranges::find(m_pieces, m_folder.file(file), &Piece::path) ==
                m_pieces.end()) // it is asked for twice
                m_pieces.push_back({id, &view, m_folder.file(file)});
        }
    }
}

/// They are written as a whole.
bool PictureSeries::isThere(const Piece& piece)
{
    const QFileInfo file(piece.path);
    return file.isFile() && file.size() > 0;
}

std::vector<PictureSeries::Piece> PictureSeries::missing(const JobShare& share) const
{
    std::vector<Piece> missing;
    for (std::size_t k = 0; k < m_pieces.size(); ++k)
        if (share.has(static_cast<int>(k)) && !isThere(m_pieces[k]))
            missing.push_back(m_pieces[k]);
    return missing;
}

} // namespace bolster::cli
