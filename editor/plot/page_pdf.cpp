#include "editor/plot/page_pdf.h"

#include "editor/plot/plot_export.h"

#include <QPageLayout>
#include <QPainter>
#include <QPdfWriter>
#include <QSaveFile>
#include <QSvgRenderer>
#include <QTextDocument>
#include <QUrl>

namespace plc::plot {

namespace {

/// What stands in the place of a chart: a text document knows pictures by their address only.
QString placeOf(int chart) { return QStringLiteral("chart:%1").arg(chart); }

QImage imageOf(const QByteArray& svg, double width) {
    constexpr double kFine = 3; // pixels per unit, for print
    QSvgRenderer renderer(svg);
    QSizeF size = renderer.defaultSize();
    if (size.isEmpty()) return {};
    size *= width / size.width();
    QImage image((size * kFine).toSize(), QImage::Format_RGB32);
    image.fill(Qt::white);
    QPainter painter(&image);
    renderer.render(&painter);
    painter.end();
    image.setDevicePixelRatio(kFine);
    return image;
}

/// Takes the charts out of the page and hands them to the document as pictures.
QString withPictures(const QString& html, QTextDocument& document, double width) {
    QString out;
    int chart = 0;
    qsizetype at = 0;
    for (;;) {
        const qsizetype begin = html.indexOf(QLatin1String("<svg"), at);
        const qsizetype end = begin < 0 ? -1 : html.indexOf(QLatin1String("</svg>"), begin);
        if (end < 0) return out + html.mid(at);
        const qsizetype behind = end + 6;
        out += html.mid(at, begin - at);
        const QImage image = imageOf(html.mid(begin, behind - begin).toUtf8(), width);
        document.addResource(QTextDocument::ImageResource, QUrl(placeOf(chart)), image);
        out += QStringLiteral("<p><img src=\"%1\" width=\"%2\"></p>").arg(placeOf(chart)).arg(static_cast<int>(width));
        ++chart;
        at = behind;
    }
}

} // namespace

Result<void> exportPage(const std::string& html, const std::string& title, const std::string& path) {
    QSaveFile file(QString::fromStdString(path));
    if (!file.open(QIODevice::WriteOnly)) return cannotWrite(file.fileName(), file.errorString());
    {
        QPdfWriter writer(&file);
        writer.setResolution(96);
        writer.setPageSize(QPageSize(QPageSize::A4));
        writer.setPageMargins(QMarginsF(15, 15, 15, 15), QPageLayout::Millimeter);
        writer.setTitle(QString::fromStdString(title));
        const QSizeF page = writer.pageLayout().paintRectPixels(96).size();
        QTextDocument document;
        document.setDocumentMargin(0);
        document.setDefaultStyleSheet(QStringLiteral("pre{font-size:7pt} td,th{font-size:8pt}"));
        QFont font = document.defaultFont();
        font.setPointSizeF(9);
        document.setDefaultFont(font);
        document.setPageSize(page);
        document.setHtml(withPictures(QString::fromStdString(html), document, page.width()));
        document.print(&writer);
    }
    if (!file.commit()) return cannotWrite(file.fileName(), file.errorString());
    return {};
}

} // namespace plc::plot
