#include "hmi/web/panel_stream.h"

#include "hmi/player/keypad.h"

#include <nlohmann/json.hpp>

namespace plc::hmi::web {

namespace {

/// Sections of a frame, as client/panel.js knows them.
enum Section : uint8_t { Glyph = 1, Picture, Element, Reset };
constexpr size_t kStoreLimit = size_t(64) << 20;

bool isSame(const Recording& a, size_t i, const Recording& b, size_t j) { return a.command(i) == b.command(j); }

} // namespace

PanelStream::PanelStream(PaintStore& store, PanelPlayer& player)
    : m_store(store), m_player(player), m_recorder(store, player.scene().size()), m_edition(store.edition()) {}

void PanelStream::restart() {
    m_shown.clear();
    m_needsAll = m_isReset = true;
    m_hadOverlay = false;
    m_recorder.setSize(m_player.scene().size());
}

void PanelStream::setSharpness(int sharpness) {
    m_recorder.setSharpness(sharpness);
    m_needsAll = true;
}

QByteArray PanelStream::frame(qint64 milliseconds) {
    if (m_store.trim(kStoreLimit) || m_edition != m_store.edition()) {
        m_edition = m_store.edition();
        m_sentGlyphs = m_sentPictures = 0;
        restart();
    }
    PanelScene& scene = m_player.scene();
    const QRegion changed = scene.refresh(milliseconds);
    const bool all = std::exchange(m_needsAll, false);
    m_shown.resize(scene.views().size() + 1);
    PaintBytes elements;
    if (all || !changed.isEmpty())
        for (size_t i = 0; i < scene.views().size(); ++i) {
            ElementView& view = *scene.views()[i];
            if (all || !m_shown[i].isKnown || changed.intersects(scene.shownRect(view).toAlignedRect()) ||
                changed.intersects(m_shown[i].bounds.toAlignedRect()))
                element(i, view, elements);
        }
    overlay(elements);
    if (elements.bytes().isEmpty()) return {};
    PaintBytes head;
    head.count(++m_number);
    if (std::exchange(m_isReset, false)) head.byte(Reset);
    return head.bytes() + definitions() + elements.bytes();
}

void PanelStream::element(size_t index, ElementView& view, PaintBytes& out) {
    PanelScene& scene = m_player.scene();
    const bool isShown = scene.isShown(view);
    if (isShown) {
        QPainter painter(&m_recorder);
        scene.paintElement(painter, view);
    }
    send(index, m_recorder.take(), scene.shownRect(view), isShown, out);
}

/// Keypads, lists and questions are widgets: they are recorded as they paint themselves.
void PanelStream::overlay(PaintBytes& out) {
    Overlay* over = m_player.overlay();
    const bool isShown = over && !over->isHidden();
    if (!isShown && !m_hadOverlay) return;
    m_hadOverlay = isShown;
    if (isShown) {
        QPainter painter(&m_recorder);
        over->render(&painter, QPoint(), QRegion(), QWidget::DrawChildren);
    }
    send(m_shown.size() - 1, m_recorder.take(), QRectF(QPointF(), m_player.scene().size()), isShown, out);
}

void PanelStream::send(size_t index, Recording&& now, const QRectF& bounds, bool isShown, PaintBytes& out) {
    Shown& before = m_shown[index];
    const size_t oldSize = before.recording.ends.size(), newSize = now.ends.size();
    size_t same = 0, sameTail = 0;
    while (same < oldSize && same < newSize && isSame(before.recording, same, now, same)) ++same;
    while (same + sameTail < oldSize && same + sameTail < newSize &&
           isSame(before.recording, oldSize - 1 - sameTail, now, newSize - 1 - sameTail))
        ++sameTail;
    const bool moved = !before.isKnown || before.bounds != bounds || before.isShown != isShown;
    const size_t removed = oldSize - same - sameTail, added = newSize - same - sameTail;
    if (!moved && removed == 0 && added == 0) return;
    out.byte(Element);
    out.count(index);
    out.byte(static_cast<uint8_t>((isShown ? 1 : 0) | (moved ? 2 : 0)));
    if (moved) out.rect(bounds);
    out.count(same);
    out.count(removed);
    out.count(added);
    for (size_t i = same; i < same + added; ++i) out.bytes().append(now.command(i));
    before.recording = std::move(now);
    before.bounds = bounds;
    before.isShown = isShown;
    before.isKnown = true;
}

QByteArray PanelStream::definitions() {
    PaintBytes out;
    for (; m_sentGlyphs < m_store.glyphCount(); ++m_sentGlyphs) {
        out.byte(Glyph);
        out.count(m_sentGlyphs);
        out.bytes().append(m_store.glyphPath(static_cast<uint32_t>(m_sentGlyphs)));
    }
    for (; m_sentPictures < m_store.pictureCount(); ++m_sentPictures) {
        out.byte(Picture);
        out.count(m_sentPictures);
        out.blob(m_store.picturePng(static_cast<uint32_t>(m_sentPictures)));
    }
    return out.bytes();
}

QByteArray PanelStream::words() {
    nlohmann::json list = nlohmann::json::array();
    const auto& views = m_player.scene().views();
    for (size_t i = 0; i < views.size() && i < m_shown.size(); ++i) {
        Shown& shown = m_shown[i];
        const bool isLive = views[i]->isInteractive() && shown.isShown;
        QString words = shown.isShown ? shown.recording.words : QString();
        if (isLive && words.isEmpty()) words = views[i]->element().id();
        const QString told = (isLive ? u'+' : u'-') + words;
        if (told == shown.toldWords || (shown.toldWords.isEmpty() && words.isEmpty())) continue;
        shown.toldWords = told;
        const QRectF rect = m_player.scene().shownRect(*views[i]);
        list.push_back({i, words.toStdString(), isLive, std::lround(rect.x()), std::lround(rect.y()),
                        std::lround(rect.width()), std::lround(rect.height())});
    }
    if (list.empty()) return {};
    return QByteArray::fromStdString(
        nlohmann::json{{"t", "words"}, {"list", list}}.dump(-1, ' ', false, nlohmann::json::error_handler_t::replace));
}

} // namespace plc::hmi::web
