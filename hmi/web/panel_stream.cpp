#include "hmi/web/panel_stream.h"

#include "hmi/player/keypad.h"

#include <nlohmann/json.hpp>

namespace plc::hmi::web {

namespace {

/// Sections of a frame, as client/paint.js knows them.
enum Section : uint8_t { Glyph = 1, Picture, Element, Reset };
constexpr size_t kStoreLimit = size_t(64) << 20;

bool isSame(const Recording& a, size_t i, const Recording& b, size_t j) { return a.command(i) == b.command(j); }

/// After `kept` commands that stay, `removed` ones give way to `added` ones.
struct Stretch {
    size_t kept, removed, added;
};

/// Where as many came as went, each is held against the one in its place: an element that changes in several places
/// keeps what is between them, in the browser too.
std::vector<Stretch> stretchesOf(const Recording& was, const Recording& is) {
    const size_t oldSize = was.ends.size(), newSize = is.ends.size(), least = std::min(oldSize, newSize);
    size_t head = 0, tail = 0;
    while (head < least && isSame(was, head, is, head)) ++head;
    while (head + tail < least && isSame(was, oldSize - 1 - tail, is, newSize - 1 - tail)) ++tail;
    if (head + tail == oldSize && oldSize == newSize) return {};
    if (oldSize != newSize) return {{head, oldSize - head - tail, newSize - head - tail}};
    std::vector<Stretch> out;
    size_t kept = 0;
    for (size_t i = 0; i + tail < newSize; ++i) {
        if (isSame(was, i, is, i)) {
            ++kept;
        } else if (kept > 0 || out.empty()) {
            out.push_back({std::exchange(kept, 0), 1, 1});
        } else {
            ++out.back().removed;
            ++out.back().added;
        }
    }
    return out;
}

PaintBytes differences(const Recording& was, const Recording& is) {
    PaintBytes out;
    const std::vector<Stretch> stretches = stretchesOf(was, is);
    if (!stretches.empty()) out.count(stretches.size());
    size_t at = 0;
    for (const auto& [kept, removed, added] : stretches) {
        for (const size_t count : {kept, removed, added}) out.count(count);
        at += kept;
        for (const size_t end = at + added; at < end; ++at) out.blob(is.command(at));
    }
    return out;
}

} // namespace

PanelStream::PanelStream(PaintStore& store, PanelPlayer& player)
    : m_store(store), m_player(player), m_recorder(store, player.scene().size()), m_edition(store.edition()) {}

void PanelStream::restart() {
    m_own.clear();
    m_shown.clear();
    m_needsAll = m_isReset = true;
    m_hadOverlay = false;
    m_recorder.setSize(m_player.scene().size());
}

void PanelStream::setSharpness(int sharpness) {
    m_recorder.setSharpness(sharpness);
    m_needsAll = true;
}

bool PanelStream::isRecorded(const QString& view, qint64 milliseconds) const {
    const auto found = view.isEmpty() ? m_store.views().cend() : m_store.views().constFind(view);
    return found != m_store.views().cend() && found->at == milliseconds &&
           found->pieces.size() == m_player.scene().views().size();
}

void PanelStream::share(const QString& view, const QString& state, bool isBad) {
    const auto found = view.isEmpty() ? m_store.views().end() : m_store.views().find(view);
    if (found == m_store.views().end()) return;
    found->state = state;
    found->isBad = isBad;
}

QByteArray PanelStream::frame(qint64 milliseconds, const QString& view) {
    if (m_store.trim(kStoreLimit) || m_edition != m_store.edition()) {
        m_edition = m_store.edition();
        m_sentGlyphs = m_sentPictures = 0;
        restart();
    }
    m_shown.resize(m_player.scene().views().size() + 1);
    PaintBytes elements;
    const bool isShared = isRecorded(view, milliseconds);
    if (!isShared) record(milliseconds);
    if (!isShared && !view.isEmpty()) {
        SharedView& shared = m_store.views()[view];
        shared.at = milliseconds;
        shared.pieces = m_own;
    }
    const std::vector<Piece>& now = isShared ? m_store.views()[view].pieces : m_own;
    for (size_t i = 0; i < now.size(); ++i) send(i, now[i], elements);
    overlay(elements);
    if (elements.bytes().isEmpty()) return {};
    PaintBytes head;
    head.count(++m_number);
    if (std::exchange(m_isReset, false)) head.byte(Reset);
    return head.bytes() + definitions() + elements.bytes();
}

void PanelStream::record(qint64 milliseconds) {
    PanelScene& scene = m_player.scene();
    (void)scene.refresh(milliseconds);
    const bool all = std::exchange(m_needsAll, false);
    m_own.resize(scene.views().size());
    for (size_t i = 0; i < scene.views().size(); ++i) {
        ElementView& view = *scene.views()[i];
        if (!scene.takeMark(view) && !all && m_own[i].recording) continue;
        m_own[i].bounds = scene.shownRect(view);
        m_own[i].isShown = scene.isShown(view);
        if (m_own[i].isShown) {
            QPainter painter(&m_recorder);
            scene.paintElement(painter, view);
        }
        m_own[i].recording = std::make_shared<const Recording>(m_recorder.take());
    }
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
    send(m_shown.size() - 1,
         {std::make_shared<const Recording>(m_recorder.take()), QRectF(QPointF(), m_player.scene().size()), isShown},
         out);
}

void PanelStream::send(size_t index, const Piece& now, PaintBytes& out) {
    static const Recording kNothing;
    Shown& before = m_shown[index];
    const bool moved = !before.recording || before.bounds != now.bounds || before.isShown != now.isShown;
    if (!moved && before.recording == now.recording) return;
    const Recording& was = before.recording ? *before.recording : kNothing;
    const Recording& is = *now.recording;
    const PaintBytes changes = differences(was, is);
    if (moved || !changes.bytes().isEmpty()) {
        out.byte(Element);
        out.count(index);
        out.byte(static_cast<uint8_t>((now.isShown ? 1 : 0) | (moved ? 2 : 0)));
        if (moved) out.rect(now.bounds);
        if (changes.bytes().isEmpty())
            out.count(0);
        else
            out.bytes().append(changes.bytes());
    }
    static_cast<Piece&>(before) = now;
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
        QString words = shown.isShown && shown.recording ? shown.recording->words : QString();
        if (isLive && words.isEmpty()) words = views[i]->element().id();
        const QString told = (isLive ? u'+' : u'-') + words;
        if (told == shown.toldWords || (shown.toldWords.isEmpty() && words.isEmpty())) continue;
        shown.toldWords = told;
        const QRectF rect = shown.bounds;
        list.push_back({i, words.toStdString(), isLive, std::lround(rect.x()), std::lround(rect.y()),
                        std::lround(rect.width()), std::lround(rect.height())});
    }
    if (list.empty()) return {};
    return QByteArray::fromStdString(
        nlohmann::json{{"t", "words"}, {"list", list}}.dump(-1, ' ', false, nlohmann::json::error_handler_t::replace));
}

} // namespace plc::hmi::web
