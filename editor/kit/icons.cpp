#include "editor/kit/icons.h"

#include "editor/kit/theme.h"

#include <QIconEngine>
#include <QPainter>
#include <QPixmapCache>
#include <QSvgRenderer>

namespace plc::kit {

namespace {

struct Drawing {
    Icon icon;
    const char* word;
    const char* body;
};

constexpr Drawing Drawings[] = {
#define PLC_ICON(Name, Word, Body) {Icon::Name, Word, Body},
#include "editor/kit/icons.def"
};

const Drawing& drawingOf(Icon which) { return Drawings[static_cast<size_t>(which)]; }

QColor mixed(const QColor& a, const QColor& b, qreal part) {
    return QColor::fromRgbF(static_cast<float>(a.redF() * (1 - part) + b.redF() * part),
                            static_cast<float>(a.greenF() * (1 - part) + b.greenF() * part),
                            static_cast<float>(a.blueF() * (1 - part) + b.blueF() * part));
}

QColor colorOfLetter(char letter, const ThemeColors& c, bool muted, const QColor& ink) {
    const QColor main = muted ? c.disabled : ink.isValid() ? ink : mixed(c.text, c.muted, 0.45);
    if (letter == 's') return mixed(c.base, muted || ink.isValid() ? main : c.accent, c.dark ? 0.30 : 0.20);
    if (muted || ink.isValid()) return main;
    switch (letter) {
    case 'm':
        return c.muted;
    case 'a':
        return c.accent;
    case 'g':
        return c.good;
    case 'r':
        return c.bad;
    case 'y':
        return c.warning;
    case 'o':
        return c.forced;
    case 'p':
        return c.plotTrigger;
    default:
        return main;
    }
}

/// Draws on demand at the asked size; pixmaps are kept in the application's cache under a key that names the theme.
class IconEngine : public QIconEngine {
public:
    IconEngine(Icon which, QColor ink) : m_icon(which), m_ink(std::move(ink)) {}

    void paint(QPainter* painter, const QRect& rect, QIcon::Mode mode, QIcon::State) override {
        QSvgRenderer renderer(iconSvg(m_icon, colors(), mode == QIcon::Disabled, m_ink));
        const int side = std::min(rect.width(), rect.height());
        QRectF square(0, 0, side, side);
        square.moveCenter(QRectF(rect).center());
        painter->save();
        painter->setRenderHint(QPainter::Antialiasing);
        renderer.render(painter, square);
        painter->restore();
    }

    QPixmap pixmap(const QSize& size, QIcon::Mode mode, QIcon::State state) override {
        return scaledPixmap(size, mode, state, 1.0);
    }

    QPixmap scaledPixmap(const QSize& size, QIcon::Mode mode, QIcon::State state, qreal scale) override {
        const QString key = QStringLiteral("stepwise.icon.%1.%2.%3x%4.%5.%6.%7")
                                .arg(static_cast<int>(m_icon))
                                .arg(m_ink.isValid() ? m_ink.name() : QString())
                                .arg(size.width())
                                .arg(size.height())
                                .arg(scale)
                                .arg(mode == QIcon::Disabled)
                                .arg(colors().base.rgb() + colors().dark);
        QPixmap pixmap;
        if (QPixmapCache::find(key, &pixmap)) return pixmap;
        pixmap = QPixmap(size);
        pixmap.fill(Qt::transparent);
        QPainter painter(&pixmap);
        paint(&painter, QRect(QPoint(), size), mode, state);
        painter.end();
        QPixmapCache::insert(key, pixmap);
        return pixmap;
    }

    QIconEngine* clone() const override { return new IconEngine(*this); }
    QString key() const override { return QStringLiteral("stepwise"); }
    bool isNull() override { return false; }

private:
    Icon m_icon;
    QColor m_ink;
};

} // namespace

QIcon icon(Icon which) { return QIcon(new IconEngine(which, QColor())); }

QIcon icon(Icon which, const QColor& ink) { return QIcon(new IconEngine(which, ink)); }

QStringView iconWord(Icon which) {
    static const std::vector<QString> words = [] {
        std::vector<QString> result;
        for (const Drawing& drawing : Drawings) result.push_back(QLatin1String(drawing.word));
        return result;
    }();
    return words[static_cast<size_t>(which)];
}

std::optional<Icon> iconByWord(QStringView word) {
    for (const Drawing& drawing : Drawings)
        if (word == QLatin1String(drawing.word)) return drawing.icon;
    return std::nullopt;
}

const std::vector<Icon>& allIcons() {
    static const std::vector<Icon> all = [] {
        std::vector<Icon> result;
        for (const Drawing& drawing : Drawings) result.push_back(drawing.icon);
        return result;
    }();
    return all;
}

QByteArray iconSvg(Icon which, const ThemeColors& c, bool muted, const QColor& ink) {
    QByteArray svg =
        "<svg xmlns='http://www.w3.org/2000/svg' viewBox='0 0 16 16'><g fill='none' stroke='$f' stroke-width='1.35' "
        "stroke-linecap='round' stroke-linejoin='round'>";
    svg += drawingOf(which).body;
    svg += "</g></svg>";
    for (char letter : {'f', 'm', 'a', 'g', 'r', 'y', 'o', 's', 'p'}) {
        const char token[] = {'$', letter, 0};
        svg.replace(token, colorOfLetter(letter, c, muted, ink).name().toLatin1());
    }
    return svg;
}

void paintIcon(QPainter* painter, const QRectF& rect, Icon which, bool muted) {
    QSvgRenderer renderer(iconSvg(which, colors(), muted));
    renderer.render(painter, rect);
}

} // namespace plc::kit
