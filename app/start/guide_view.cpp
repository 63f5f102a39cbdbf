#include "app/start/guide_view.h"

#include "editor/kit/theme.h"
#include "editor/kit/translation_tag.h"
#include "hmi/view/paint/picture_file.h"

#include <QDesktopServices>
#include <QDir>
#include <QFile>
#include <QLocale>
#include <QScrollBar>

namespace plc::app {

GuideView::GuideView(QWidget* parent) : QTextBrowser(parent) {
    setOpenLinks(false);
    setFrameShape(QFrame::NoFrame);
    setAccessibleName(tr("About this project"));
    document()->setDocumentMargin(12);
    setPlaceholderText(tr("A README.md in the project's folder is shown here."));
    connect(this, &QTextBrowser::anchorClicked, this, [this](const QUrl& link) {
        if (link.scheme() == QLatin1String("http") || link.scheme() == QLatin1String("https"))
            QDesktopServices::openUrl(link);
        else if (!link.path().isEmpty())
            emit fileRequested(QDir::cleanPath(link.path()));
        else
            scrollToAnchor(link.fragment());
    });
    connect(&kit::Theme::current(), &kit::Theme::changed, this, &GuideView::render);
}

QString GuideView::readmeOf(const QString& folder) {
    const QString translated = folder + "/README." + kit::translationTag(QLocale().name()) + ".md";
    return QFile::exists(translated) ? translated : folder + "/README.md";
}

bool GuideView::showProject(const QString& folder) {
    m_folder = folder;
    QFile file(readmeOf(folder));
    m_text = !folder.isEmpty() && file.open(QIODevice::ReadOnly) ? QString::fromUtf8(file.readAll()) : QString();
    render();
    return !m_text.isEmpty();
}

QString GuideView::summaryOf(const QString& folder) {
    QFile file(readmeOf(folder));
    if (!file.open(QIODevice::ReadOnly)) return {};
    QStringList paragraph;
    for (const QString& line : QString::fromUtf8(file.readAll()).split('\n')) {
        const QString text = line.trimmed();
        if (text.isEmpty() && !paragraph.isEmpty()) break;
        if (!text.isEmpty() && !text.startsWith('#') && !text.startsWith('!')) paragraph << text;
    }
    return paragraph.join(' ').remove('`').remove("**");
}

QVariant GuideView::loadResource(int type, const QUrl& name) {
    if (type != QTextDocument::ImageResource || m_folder.isEmpty() || !name.isRelative()) return {};
    const auto picture = hmi::loadPicture({m_folder, false}, name.path(), {800, 600});
    if (!picture) return {};
    const int room = std::max(120, viewport()->width() - 32);
    return picture->width() > room ? picture->scaledToWidth(room, Qt::SmoothTransformation) : *picture;
}

/// Pictures are as wide as the page.
void GuideView::resizeEvent(QResizeEvent* event) {
    const bool isOther = event->oldSize().width() != event->size().width();
    QTextBrowser::resizeEvent(event);
    if (isOther && !m_text.isEmpty()) render();
}

/// By way of a document of its own: read straight into the browser, the format of the first heading goes on through the
/// whole text.
void GuideView::render() {
    const int place = verticalScrollBar()->value();
    QTextDocument page;
    page.setMarkdown(m_text);
    setHtml(page.toHtml());
    verticalScrollBar()->setValue(place);
}

} // namespace plc::app
