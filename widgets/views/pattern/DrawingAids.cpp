#include "DrawingAids.h"

namespace bolster {

void DrawingAids::setGuides(const PatternGuides& guides)
{
    m_guides = guides;
    m_snap.guides = m_guidesShown ? m_guides : PatternGuides();
    emit changed();
}

void DrawingAids::setGuidesShown(bool shown)
{
    m_guidesShown = shown;
    setGuides(m_guides);
}

void DrawingAids::setBackground(const BackgroundPicture& picture)
{
    m_background = picture;
    emit changed();
}

} // namespace bolster
