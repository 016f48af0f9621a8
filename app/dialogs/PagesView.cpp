#include "PagesView.h"

#include <QPaintEvent>
#include <QPainter>
#include <QScrollBar>

#include <algorithm>

namespace bolster {

namespace {

constexpr int aroundPage = 12; // pixels

} // namespace

class PagesView::Sheets : public QWidget {
public:
    std::vector<QImage> pages;
    QString instead;

    int heightFor(int width) const
    {
        int height = aroundPage;
        for (const QImage& page : pages)
            height += pageHeight(page, width) + aroundPage;
        return height;
    }

protected:
    void paintEvent(QPaintEvent* event) override
    {
        QPainter painter(this);
        painter.setRenderHint(QPainter::SmoothPixmapTransform);
        painter.fillRect(event->rect(), palette().mid());
        if (pages.empty())
            painter.drawText(rect(), Qt::AlignCenter, instead);
        int top = aroundPage;
        for (const QImage& page : pages) {
            const QRect place(aroundPage, top, width() - 2 * aroundPage, pageHeight(page, width()));
            if (place.intersects(event->rect()))
                painter.drawImage(place, page);
            top += place.height() + aroundPage;
        }
    }

private:
    static int pageHeight(const QImage& page, int width)
    {
        return std::max(1, (width - 2 * aroundPage) * page.height() / std::max(1, page.width()));
    }
};

PagesView::PagesView(QWidget* parent)
    : QScrollArea(parent)
    , m_sheets(new Sheets)
{
    setWidget(m_sheets);
    setHorizontalScrollBarPolicy(Qt::ScrollBarAlwaysOff);
    setVerticalScrollBarPolicy(Qt::ScrollBarAlwaysOn); // its coming and going would change the width
    setFrameShape(QFrame::NoFrame);
    setAccessibleName(tr("Pages"));
}

void PagesView::showPages(std::vector<QImage> pages, const QString& instead)
{
    m_sheets->pages = std::move(pages);
    m_sheets->instead = instead;
    resizeEvent(nullptr);
    m_sheets->update();
}

int PagesView::count() const
{
    return static_cast<int>(m_sheets->pages.size());
}

void PagesView::resizeEvent(QResizeEvent*)
{
    const int width = viewport()->width();
    m_sheets->resize(width, std::max(viewport()->height(), m_sheets->heightFor(width)));
}

} // namespace bolster
