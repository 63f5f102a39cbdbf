#include "hmi/view/scene/panel_scene.h"

#include "hmi/model/layout.h"
#include "hmi/view/scene/faceplate_view.h"

#include <QTransform>

#include <utility>

namespace plc::hmi {

namespace {
constexpr QPainter::RenderHints kHints =
    QPainter::Antialiasing | QPainter::TextAntialiasing | QPainter::SmoothPixmapTransform;

/// Adding to a region takes a time that grows with it; when that much changed, all around it is painted as fast.
QRegion regionOf(const std::vector<QRect>& rects) {
    constexpr size_t kMost = 400;
    QRegion out;
    QRect around;
    for (const QRect& rect : rects) {
        around |= rect;
        if (rects.size() <= kMost) out += rect;
    }
    return rects.size() <= kMost ? out : QRegion(around);
}
} // namespace

PanelScene::PanelScene(MakeElementView make, QObject* parent)
    : QObject(parent), m_make(make), m_theme(&PanelTheme::of(PanelThemeKind::Light)), m_texts(&m_noTexts),
      m_language(QStringLiteral("en")) {}

PanelScene::~PanelScene() = default;

void PanelScene::setPanel(const Panel& panel) {
    take(panel);
    rebuild();
}

void PanelScene::take(const Panel& panel) {
    m_designed = panel;
    m_panel = laidOut(panel, m_screen.isEmpty() ? QSizeF(panel.size()) : sizeFor(panel, m_screen));
}

void PanelScene::setScreen(QSizeF screen) {
    if (screen == m_screen) return;
    m_screen = screen;
    if (!isAdapting(m_designed)) return;
    take(m_designed);
    rebuild();
}

void PanelScene::setArea(const QString& panel, const Arguments& arguments) {
    m_area = panel;
    m_areaArguments = arguments;
    if (!m_views.empty()) rebuild();
}

void PanelScene::setCurrentPanel(const QString& name) {
    if (name == m_current) return;
    m_current = name;
    for (const auto& view : m_views)
        if (view->element().kind() == ElementKind::NavigationBar) markDirty(*view);
}

void PanelScene::setRecipes(const RecipeFile* recipes) {
    m_recipes = recipes;
    for (const auto& view : m_views)
        if (view->element().kind() == ElementKind::RecipeTable) {
            view->prepare();
            markDirty(*view);
        }
}

void PanelScene::setAccess(AccessCheck check) {
    m_access = std::move(check);
    m_allDirty = true;
    emit dirtied();
}

void PanelScene::setUser(const QString& name) {
    m_user = name;
    m_allDirty = true; // what is locked or hidden is other things now
    emit dirtied();
}

void PanelScene::rebuild() {
    m_theme = &m_themes.named(themeName());
    // A button that is held while its panel goes away must come up.
    if (ElementView* held = std::exchange(m_pressed, nullptr)) held->release(QPointF(-1e6, -1e6), false);
    m_lastRects.clear();
    m_byId.clear();
    m_inner.clear();
    m_views.clear();
    for (const Element& element : m_panel.elements()) {
        addView(element, false);
        if (!element.showsPanel()) continue;
        const bool isArea = element.kind() == ElementKind::PanelArea;
        for (const Element& inner :
             isArea ? contentsOf(element, m_area, m_areaArguments, m_panels) : contentsOf(element, m_panels))
            addView(inner, true);
    }
    prepareAll();
}

void PanelScene::addView(const Element& element, bool isInner) {
    m_views.push_back(m_make(element, *this));
    m_byId.insert(element.id(), m_views.back().get());
    if (isInner) m_inner += m_views.back().get();
}

void PanelScene::setFaceplates(PanelLookup panels) {
    m_panels = std::move(panels);
    if (!m_views.empty()) rebuild();
}

void PanelScene::setThemes(const PanelThemes& themes) {
    m_themes = themes;
    rebuild(); // the old theme is gone
}

void PanelScene::setTheme(const QString& name) {
    if (name == m_themeName) return;
    m_themeName = name;
    rebuild();
}

void PanelScene::setReducedMotion(bool reduced) {
    if (reduced == m_isMotionReduced) return;
    m_isMotionReduced = reduced;
    m_allDirty = true;
    emit dirtied();
}

void PanelScene::prepareAll() {
    for (const auto& view : m_views) view->prepare();
    m_allDirty = true;
    m_revision = 0;
    emit dirtied();
}

void PanelScene::follow(const Panel& panel, const Touched& touched) {
    const auto isFaceplate = [&](const ElementId& id) {
        const Element* element = panel.find(id);
        return element && element->showsPanel();
    };
    if (touched.panel || touched.structure || isAdapting(panel) ||
        std::any_of(touched.elements.begin(), touched.elements.end(), isFaceplate)) {
        setPanel(panel);
        return;
    }
    take(panel);
    for (const ElementId& id : touched.elements) {
        const int index = m_panel.indexOf(id);
        ElementView* old = view(id);
        if (index < 0 || !old) continue;
        addDirty(*old, shownRect(*old));
        m_lastRects.remove(old);
        if (m_pressed == old) {
            m_pressed = nullptr;
            old->release(QPointF(-1e6, -1e6), false);
        }
        const auto at = std::find_if(m_views.begin(), m_views.end(), [&](const auto& one) { return one.get() == old; });
        auto& place = *at;
        place = m_make(m_panel.elements()[static_cast<size_t>(index)], *this);
        m_byId[id] = place.get();
        place->prepare();
        place->refresh();
        // What lies in a group may be hidden or moved by it.
        if (place->element().hasContents())
            m_allDirty = true;
        else
            markDirty(*place);
    }
    m_revision = 0;
    emit dirtied();
}

void PanelScene::setValues(ValueSource* values) {
    m_values = values;
    prepareAll();
}

void PanelScene::setTexts(const TextCatalog* texts) {
    m_texts = texts ? texts : &m_noTexts;
    prepareAll();
}

void PanelScene::setAlarms(AlarmBook* alarms) {
    if (m_alarms) m_alarms->disconnect(this);
    m_alarms = alarms;
    if (m_alarms)
        connect(m_alarms, &AlarmBook::changed, this, [this] {
            for (const auto& view : m_views)
                if (view->element().kind() == ElementKind::AlarmList ||
                    view->element().kind() == ElementKind::AlarmBanner)
                    markDirty(*view);
        });
    prepareAll();
}

void PanelScene::setLanguage(const QString& tag) {
    if (tag == m_language) return;
    m_language = tag;
    prepareAll();
}

void PanelScene::setDesigning(bool designing) {
    if (designing == m_designing) return;
    m_designing = designing;
    prepareAll();
}

void PanelScene::setAlarmPosition(std::optional<quint64> position) {
    if (position == m_alarmPosition) return;
    m_alarmPosition = position;
    for (const auto& view : m_views)
        if (view->element().descriptor().category == ElementCategory::Alarms) markDirty(*view);
}

QRegion PanelScene::refresh(qint64 milliseconds) {
    const quint64 revision = m_values ? m_values->revision() : 1;
    if (revision != m_revision || m_allDirty) {
        m_revision = revision;
        for (const auto& view : m_views) {
            const Appearance before = view->appearance();
            if (!view->refresh()) continue;
            const Appearance& now = view->appearance();
            // A container that moves or hides takes all that lies in it along.
            if (view->element().hasContents() && before != now) m_allDirty = true;
            if (!m_allDirty) markDirty(*view);
        }
    }
    const bool lit = m_isMotionReduced || (milliseconds / 500) % 2 == 0;
    const bool turned = lit != m_lit;
    m_lit = lit;
    m_frame = milliseconds;
    for (const auto& view : m_views)
        if (view->tick(milliseconds) && !m_allDirty) markDirty(*view);
    if (turned)
        for (const auto& view : m_views)
            if (view->m_blinking || view->appearance().blinks) markDirty(*view);
    const std::vector<QRect> dirty = std::exchange(m_dirty, {});
    if (!std::exchange(m_allDirty, false)) return regionOf(dirty);
    for (const auto& view : m_views) {
        view->m_isMarked = true;
        m_lastRects.insert(view.get(), shownRect(*view));
    }
    return QRegion(QRect(QPoint(), size()));
}

bool PanelScene::takeMark(ElementView& view) const { return std::exchange(view.m_isMarked, false); }

QTransform PanelScene::transformOf(const ElementView& view) const {
    QTransform transform;
    QPointF offset = view.rect().topLeft() + QPointF(view.appearance().moveX, view.appearance().moveY);
    const FaceplateView* frame = faceplateOf(view);
    int guard = 0;
    for (const ElementView* outer = this->view(view.element().parent()); outer && outer != frame && guard < 32;
         outer = this->view(outer->element().parent()), ++guard)
        offset += QPointF(outer->appearance().moveX, outer->appearance().moveY);
    transform.translate(offset.x(), offset.y());
    const double angle = view.element().number("angle") + view.appearance().rotation;
    if (angle != 0) {
        transform.translate(view.rect().width() / 2, view.rect().height() / 2);
        transform.rotate(angle);
        transform.translate(-view.rect().width() / 2, -view.rect().height() / 2);
    }
    return frame ? transform * frame->contents() * transformOf(*frame) : transform;
}

const FaceplateView* PanelScene::faceplateOf(const ElementView& view) const {
    if (!isInner(view)) return nullptr;
    int guard = 0;
    for (const ElementView* outer = this->view(view.element().parent()); outer && guard < 32;
         outer = this->view(outer->element().parent()), ++guard)
        if (outer->element().showsPanel()) return static_cast<const FaceplateView*>(outer);
    return nullptr;
}

/// The view, or what it lies in, that is kept for others; null: it may be operated.
const ElementView* PanelScene::refusedAt(const ElementView& view) const {
    if (!m_access || m_designing) return nullptr;
    const ElementView* one = &view;
    for (int guard = 0; one && guard < 32; ++guard, one = this->view(one->element().parent()))
        if (const QString roles = one->element().text("access"); !roles.isEmpty() && !m_access(roles)) return one;
    return nullptr;
}

bool PanelScene::isAllowed(const ElementView& view) const { return !refusedAt(view); }

QString PanelScene::rolesFor(const ElementView& view) const {
    const ElementView* refused = refusedAt(view);
    return refused ? refused->element().text("access") : QString();
}

bool PanelScene::isEnabled(const ElementView& view) const {
    const ElementView* one = &view;
    for (int guard = 0; one && guard < 32; ++guard, one = this->view(one->element().parent()))
        if (!one->appearance().enabled) return false;
    return true;
}

bool PanelScene::isShown(const ElementView& view) const {
    if (!view.appearance().visible && !m_designing) return false;
    if (const ElementView* refused = refusedAt(view);
        refused && refused->element().text("denied") == QStringLiteral("hidden"))
        return false;
    const ElementView* inner = &view;
    for (int guard = 0; guard < 32; ++guard) {
        const ElementView* outer = this->view(inner->element().parent());
        if (!outer) return true;
        if (!outer->appearance().visible && !m_designing) return false;
        if (outer->currentPage() >= 0 && inner->element().integer("page") != outer->currentPage()) return false;
        inner = outer;
    }
    return true;
}

QRectF PanelScene::shownRect(const ElementView& view) const {
    const double over = view.overhang();
    return transformOf(view).mapRect(QRectF(QPointF(), view.rect().size()).adjusted(-over, -over, over, over));
}

void PanelScene::addDirty(const ElementView&, const QRectF& rect) { m_dirty.push_back(rect.toAlignedRect()); }

void PanelScene::markDirty(const ElementView& view) {
    const QRectF now = shownRect(view);
    const auto last = m_lastRects.constFind(&view);
    if (last != m_lastRects.constEnd() && *last != now) addDirty(view, *last);
    addDirty(view, now);
    view.m_isMarked = true;
    m_lastRects.insert(&view, now);
    emit dirtied();
}

void PanelScene::paint(QPainter& painter, const QRectF& clip, const QRegion* region, const QTransform& toDevice) {
    painter.setRenderHints(kHints);
    const QColor ground = m_theme->color(m_panel.text("background"));
    painter.fillRect(clip & QRectF(QPointF(), size()), ground.isValid() ? ground : m_theme->color("background"));
    if (m_underlay) m_underlay(painter);
    for (const auto& view : m_views) {
        const QRectF shown = shownRect(*view);
        if (!shown.intersects(clip) || !isShown(*view)) continue;
        if (region && !region->intersects(toDevice.mapRect(shown).toAlignedRect())) continue;
        paintElement(painter, *view);
    }
}

void PanelScene::paintElement(QPainter& painter, ElementView& view) const {
    if (!isShown(view)) return;
    painter.setRenderHints(kHints);
    painter.save();
    painter.setTransform(transformOf(view), true);
    view.paint(painter);
    painter.restore();
}

QImage PanelScene::picture(double scale) {
    refresh(m_frame < 0 ? 0 : m_frame);
    QImage image((QSizeF(size()) * scale).toSize(), QImage::Format_ARGB32_Premultiplied);
    image.fill(Qt::transparent);
    QPainter painter(&image);
    painter.scale(scale, scale);
    paint(painter, QRectF(QPointF(), size()));
    return image;
}

ElementView* PanelScene::viewAt(QPointF at, bool anyKind) const {
    for (size_t i = m_views.size(); i-- > 0;) {
        ElementView* view = m_views[i].get();
        if (!anyKind && !view->isInteractive()) continue;
        if (!isShown(*view)) continue;
        const QPointF local = transformOf(*view).inverted().map(at);
        if ((anyKind ? QRectF(QPointF(), view->rect().size()) : view->touchArea()).contains(local)) return view;
    }
    return nullptr;
}

ElementView* PanelScene::view(const ElementId& id) const { return id.isEmpty() ? nullptr : m_byId.value(id, nullptr); }

void PanelScene::press(QPointF at) {
    if (m_designing || m_pressed) return;
    ElementView* view = viewAt(at);
    if (!view || !isEnabled(*view)) return;
    if (!isAllowed(*view)) return request(AccessRequest{view->element().id(), rolesFor(*view), false});
    m_pressed = view;
    view->setPressed(true);
    view->press(transformOf(*view).inverted().map(at));
}

void PanelScene::move(QPointF at) {
    if (m_pressed) m_pressed->move(transformOf(*m_pressed).inverted().map(at));
}

void PanelScene::release(QPointF at) {
    ElementView* view = std::exchange(m_pressed, nullptr);
    if (!view) return;
    const QPointF local = transformOf(*view).inverted().map(at);
    view->setPressed(false);
    view->release(local, view->touchArea().contains(local));
}

void PanelScene::wheel(QPointF at, double steps) {
    if (m_designing) return;
    ElementView* view = viewAt(at);
    if (view && isEnabled(*view) && isAllowed(*view)) view->wheel(steps);
}

void PanelScene::request(const WriteRequest& write, const QString& confirm) {
    const ElementView* from = view(write.element);
    const bool isCritical = from && from->element().isSet("critical") && write.kind != WriteKind::Release;
    if (confirm.isEmpty() && !isCritical)
        emit writeRequested(write);
    else
        emit confirmRequested(ConfirmRequest{confirm, write, isCritical});
}

} // namespace plc::hmi
