// The studio's own icons: line drawings in one style, kept as SVG text, tinted by the theme when painted, crisp at any
// scale. `icon()` is cheap: the icon draws itself on demand and follows a change of theme. GUI thread only.
#pragma once

#include <QColor>
#include <QIcon>
#include <QPixmap>
#include <QStringView>

#include <optional>
#include <vector>

class QPainter;
class QRectF;

namespace plc::kit {

struct ThemeColors;

enum class Icon {
#define PLC_ICON(Name, Word, Drawing) Name,
#include "editor/kit/icons.def"
};

/// An icon that is drawn in the colours of the theme of the moment.
QIcon icon(Icon which);
/// The same with all inks replaced by one colour.
QIcon icon(Icon which, const QColor& ink);

QStringView iconWord(Icon which);
std::optional<Icon> iconByWord(QStringView word);
const std::vector<Icon>& allIcons();

/// Whole SVG document of an icon in given colours; a muted one looks disabled.
QByteArray iconSvg(Icon which, const ThemeColors& colors, bool muted = false, const QColor& ink = QColor());
void paintIcon(QPainter* painter, const QRectF& rect, Icon which, bool muted = false);

} // namespace plc::kit
