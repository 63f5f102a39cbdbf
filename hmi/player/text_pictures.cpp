#include "hmi/player/text_pictures.h"

#include "hmi/model/errors.h"
#include "hmi/model/property_literals.h"
#include "hmi/model/walk.h"
#include "hmi/view/controls/containers.h"
#include "hmi/view/element_factory.h"
#include "projects/storage/project_file.h"

#include <QDir>
#include <QPainter>

#include <algorithm>
#include <cmath>

namespace plc::hmi {

namespace {

constexpr double kAround = 90; // of the panel that is seen around the place

/// A key as a name of a file: nothing that a file system could take for something else.
QString fileNameOf(const QString& key) {
    QString out;
    for (const QChar c : key) out += c.isLetterOrNumber() || c == u'.' || c == u'-' || c == u'_' ? c : QChar(u'_');
    return out.startsWith(u'.') ? u'_' + out : out;
}

/// The pages of tabs that an element is on are turned to the front.
void turnPages(const PanelScene& scene, const Element& element) {
    const Element* one = &element;
    for (int guard = 0; guard < 32; ++guard) {
        ElementView* outer = scene.view(one->parent());
        if (!outer) return;
        if (auto* tab = dynamic_cast<TabView*>(outer)) tab->showPage(one->integer("page"_number));
        one = &outer->element();
    }
}

/// The text as it is drawn in its place, for those that are seen now and then only; null: it has no box of its own.
std::optional<TextBox> boxOf(const ElementView& view, const QString& property, const QString& language) {
    std::vector<TextBox> boxes;
    view.collectTexts(language, boxes);
    for (const TextBox& box : boxes)
        if (box.property == property) return box;
    return {};
}

class PictureWriter {
public:
    PictureWriter(const PanelProject& project, QString folder, QString language)
        : m_project(project), m_folder(std::move(folder)), m_language(std::move(language)) {}

    Result<std::vector<TextPicture>> run() {
        if (!QDir().mkpath(m_folder)) return Error{errors::PictureFolderNotCreated(), toUtf8(m_folder)};
        for (const NamedPanel& panel : m_project.panels)
            if (auto done = panelPictures(panel); !done) return done.error();
        std::stable_sort(m_out.begin(), m_out.end(),
                         [](const TextPicture& a, const TextPicture& b) { return a.key < b.key; });
        if (auto written = projects::writeFileAtomically(toUtf8(m_folder + QStringLiteral("/index.html")), index());
            !written)
            return written.error();
        return std::move(m_out);
    }

private:
    Result<void> panelPictures(const NamedPanel& named) {
        PanelScene scene{makeElementView};
        AlarmBook book;
        book.setFile(m_project.alarms);
        scene.setDesigning(true);
        scene.setFolder(m_project.folder);
        scene.setPicturesOutside(m_project.picturesOutside);
        scene.setTexts(&m_project.texts);
        scene.setAlarms(&book);
        scene.setLanguage(m_language);
        scene.setFaceplates(m_project.panelLookup());
        scene.setThemes(m_project.themes);
        scene.setTheme(m_project.theme);
        scene.setRecipes(&m_project.recipes);
        scene.setPanel(named.panel);
        Result<void> done;
        for (const Element& element : named.panel.elements()) {
            const auto take = [&](const QString& key, const Found& found) {
                if (done) done = onePicture(scene, named.name, element, key, found.place());
            };
            forEachText(element, [&](const Found& found) {
                if (isTextKey(found.text)) take(keyOf(found.text), found);
            });
            forEachTextList(element, [&](const Found& found) {
                const QString prefix = isTextKey(found.text) ? keyOf(found.text) : found.text;
                for (int i = 0, length = m_project.texts.table().listLength(prefix); i < length; ++i)
                    take(prefix + u'.' + QString::number(i), found);
            });
        }
        scene.setAlarms(nullptr); // the book goes first
        return done;
    }

    Result<void> onePicture(PanelScene& scene, const QString& panel, const Element& element, const QString& key,
                            const QString& property) {
        const ElementView* view = scene.view(element.id());
        if (!view) return {};
        turnPages(scene, element);
        const QImage whole = scene.picture(2);
        const QRectF shown = scene.shownRect(*view);
        const QRectF seen = shown.adjusted(-kAround, -kAround, kAround, kAround) & QRectF(QPointF(), scene.size());
        QImage picture = whole.copy(QRectF(seen.topLeft() * 2, seen.size() * 2).toAlignedRect());
        QPainter painter(&picture);
        painter.setRenderHint(QPainter::Antialiasing);
        painter.scale(2, 2);
        painter.translate(-seen.topLeft());
        painter.setBrush(Qt::NoBrush);
        // Two colours: one of them is seen on any panel.
        painter.setPen(QPen(Qt::white, 5));
        painter.drawRect(shown.adjusted(-2, -2, 2, 2));
        painter.setPen(QPen(QColor(0xD0, 0x10, 0x60), 2.5));
        painter.drawRect(shown.adjusted(-2, -2, 2, 2));
        painter.end();
        const std::optional<TextBox> box = boxOf(*view, property, m_language);
        const QString file = QStringLiteral("%1.%2.png").arg(fileNameOf(key)).arg(++m_count[key]);
        if (!picture.save(m_folder + u'/' + file))
            return Error{errors::PictureNotWritten(), toUtf8(m_folder + u'/' + file)};
        m_out.push_back({key, panel + QStringLiteral(": ") + element.id() + u'.' + property, file});
        if (box) m_room[file] = box->rect.size();
        return {};
    }

    std::string index() const {
        QString out =
            QStringLiteral(
                "<!DOCTYPE html>\n<html lang=\"%1\"><head><meta charset=\"utf-8\"><title>hmi/texts.csv</title>"
                "<style>body{font:16px sans-serif;margin:2em;max-width:60em}img{max-width:100%;"
                "height:auto;border:1px solid #888}td{vertical-align:top;padding:.6em}</style>"
                "</head><body><table>\n")
                .arg(m_language.toHtmlEscaped());
        for (const TextPicture& one : m_out) {
            const auto room = m_room.constFind(one.file);
            const QString size =
                room == m_room.constEnd()
                    ? QString()
                    : QStringLiteral("<br>%1 × %2 px").arg(std::lround(room->width())).arg(std::lround(room->height()));
            out += QStringLiteral("<tr><td><b>%1</b><br>%2<br><small>%3%4</small></td><td><img src=\"%5\" alt=\"%2\">"
                                  "</td></tr>\n")
                       .arg(one.key.toHtmlEscaped(), m_project.texts.table().text(one.key, m_language).toHtmlEscaped(),
                            one.place.toHtmlEscaped(), size, one.file.toHtmlEscaped());
        }
        return toUtf8(out + QStringLiteral("</table></body></html>\n"));
    }

    const PanelProject& m_project;
    const QString m_folder, m_language;
    std::vector<TextPicture> m_out;
    QHash<QString, int> m_count;
    QHash<QString, QSizeF> m_room;
};

} // namespace

Result<std::vector<TextPicture>> writeTextPictures(const PanelProject& project, const QString& folder,
                                                   const QString& language) {
    return PictureWriter(project, folder, language).run();
}

} // namespace plc::hmi
