#include "hmi/designer/canvas/palette.h"

#include "editor/kit/fuzzy.h"
#include "editor/kit/theme.h"
#include "hmi/designer/sheet/choice_titles.h"
#include "hmi/model/property_literals.h"
#include "hmi/view/element_factory.h"
#include "hmi/view/paint/symbol_art.h"
#include "hmi/view/scene/panel_scene.h"

#include <QCoreApplication>
#include <QHeaderView>
#include <QLineEdit>
#include <QMimeData>
#include <QVBoxLayout>

namespace plc::hmi {

namespace {

/// The pictures of elements look as the studio does.
const char* themeOfStudio() {
    const kit::ThemeColors& colors = kit::colors();
    return colors.contrast ? "contrast" : colors.dark ? "dark" : "light";
}

constexpr int kFieldsRole = Qt::UserRole, kWordsRole = Qt::UserRole + 1;

class PaletteTree final : public QTreeWidget {
public:
    using QTreeWidget::QTreeWidget;

protected:
    QMimeData* mimeData(const QList<QTreeWidgetItem*>& items) const override {
        if (items.isEmpty()) return nullptr;
        const QByteArray fields = items.front()->data(0, kFieldsRole).toByteArray();
        if (fields.isEmpty()) return nullptr;
        auto* mime = new QMimeData;
        mime->setData(kElementMime, '[' + fields + ']');
        return mime;
    }
    QStringList mimeTypes() const override { return {kElementMime}; }
};

} // namespace

Json newElementFields(ElementKind kind, const QString& symbol) {
    Element element = Element::make(kind, QStringLiteral("new"), QRectF(QPointF(), descriptorOf(kind).size));
    if (!symbol.isEmpty()) element.set("symbol"_field, toUtf8(symbol));
    return element.fields();
}

Json newFaceplateFields(const NamedPanel& panel) {
    Element element =
        Element::make(ElementKind::Faceplate, QStringLiteral("new"), QRectF(QPointF(), QSizeF(panel.panel.size())));
    element.set("panel"_field, toUtf8(panel.name));
    return element.fields();
}

QIcon faceplateIcon(const NamedPanel& panel, const std::vector<NamedPanel>& panels, int side) {
    Panel shown = panel.panel;
    shown.set("theme"_field, themeOfStudio());
    PanelScene scene{makeElementView};
    scene.setDesigning(true);
    scene.setFaceplates(lookupIn(panels));
    scene.setPanel(shown);
    const QSizeF size = shown.size();
    QPixmap pixmap(side * 2, side * 2);
    pixmap.fill(Qt::transparent);
    const double scale = side * 2 / std::max(size.width(), size.height());
    const QImage picture = scene.picture(scale);
    QPainter painter(&pixmap);
    painter.drawImage((pixmap.width() - picture.width()) / 2, (pixmap.height() - picture.height()) / 2, picture);
    painter.end();
    pixmap.setDevicePixelRatio(2);
    return QIcon(pixmap);
}

QIcon elementIcon(const Json& fields, int side) {
    Panel panel;
    Element element{fields};
    const QSizeF size = element.rect().size();
    panel.set("size"_field, Json::array({static_cast<int>(size.width()) + 8, static_cast<int>(size.height()) + 8}));
    panel.set("theme"_field, themeOfStudio());
    panel.set("background"_field, "none");
    element.set("rect"_field, rectToJson(QRectF(QPointF(4, 4), size)));
    panel.elements().push_back(element);
    PanelScene scene{makeElementView};
    scene.setDesigning(true);
    scene.setPanel(panel);
    scene.refresh(0);
    QPixmap pixmap(side * 2, side * 2);
    pixmap.fill(Qt::transparent);
    QPainter painter(&pixmap);
    painter.setRenderHints(QPainter::Antialiasing | QPainter::TextAntialiasing | QPainter::SmoothPixmapTransform);
    const double scale = std::min(2.0, side * 2 / std::max(size.width() + 4, size.height() + 4));
    painter.translate(side, side);
    painter.scale(scale, scale);
    painter.translate(-size.width() / 2, -size.height() / 2);
    scene.views().front()->paint(painter);
    painter.end();
    pixmap.setDevicePixelRatio(2);
    return QIcon(pixmap);
}

Palette::Palette(QWidget* parent) : QWidget(parent), m_search(new QLineEdit), m_tree(new PaletteTree) {
    auto* layout = new QVBoxLayout(this);
    layout->setContentsMargins(4, 4, 4, 4);
    layout->setSpacing(4);
    m_search->setPlaceholderText(tr("Search elements"));
    m_search->setClearButtonEnabled(true);
    m_search->setAccessibleName(m_search->placeholderText());
    m_tree->setAccessibleName(tr("Elements"));
    layout->addWidget(m_search);
    layout->addWidget(m_tree, 1);
    m_tree->setHeaderHidden(true);
    m_tree->setIconSize(QSize(32, 32));
    m_tree->setIndentation(12);
    m_tree->setDragEnabled(true);
    m_tree->setDragDropMode(QAbstractItemView::DragOnly);
    QHash<int, QTreeWidgetItem*> groups;
    const auto add = [&](ElementCategory category, const QString& title, const QString& words, const Json& fields) {
        QTreeWidgetItem*& group = groups[static_cast<int>(category)];
        if (!group) group = addGroup(titleOf(category));
        addItem(group, title, words, fields, elementIcon(fields));
    };
    for (const ElementDescriptor& kind : elementDescriptors()) {
        const QString title = QCoreApplication::translate("Hmi", kind.title), words = QString::fromLatin1(kind.words);
        if (kind.kind != ElementKind::Symbol) {
            add(kind.category, title, words, newElementFields(kind.kind));
            continue;
        }
        for (const QString& symbol : symbolNames())
            add(kind.category, symbolTitle(symbol), words + u' ' + symbol, newElementFields(kind.kind, symbol));
    }
    connect(m_search, &QLineEdit::textChanged, this, &Palette::setFilter);
    connect(m_search, &QLineEdit::returnPressed, this, [this] { choose(m_tree->currentItem()); });
    connect(m_tree, &QTreeWidget::itemActivated, this, &Palette::choose);
}

void Palette::choose(const QTreeWidgetItem* item) {
    const QByteArray fields = item ? item->data(0, kFieldsRole).toByteArray() : QByteArray();
    if (!fields.isEmpty()) emit elementChosen(Json::parse(fields.toStdString()));
}

QTreeWidgetItem* Palette::addGroup(const QString& title) {
    auto* group = new QTreeWidgetItem(m_tree, {title});
    group->setFlags(Qt::ItemIsEnabled);
    QFont bold = m_tree->font();
    bold.setBold(true);
    group->setFont(0, bold);
    group->setExpanded(true);
    return group;
}

void Palette::addItem(QTreeWidgetItem* group, const QString& title, const QString& words, const Json& fields,
                      const QIcon& icon) {
    auto* item = new QTreeWidgetItem(group, {title});
    item->setIcon(0, icon);
    item->setData(0, kFieldsRole, QByteArray::fromStdString(fields.dump()));
    item->setData(0, kWordsRole, QString(title + u' ' + words + u' ' + group->text(0)));
    item->setSizeHint(0, QSize(100, 38));
}

void Palette::setFaceplates(const std::vector<NamedPanel>& panels) {
    if (!m_faceplates) m_faceplates = addGroup(tr("Faceplates"));
    qDeleteAll(m_faceplates->takeChildren());
    const auto add = [&](const NamedPanel& panel) {
        QStringList types;
        for (const Parameter& one : parametersOf(panel.panel)) types += one.type;
        addItem(m_faceplates, panel.name, types.join(u' '), newFaceplateFields(panel), faceplateIcon(panel, panels));
        m_faceplates->child(m_faceplates->childCount() - 1)->setToolTip(0, types.join(QStringLiteral(", ")));
    };
    for (const NamedPanel& panel : panels)
        if (!parametersOf(panel.panel).empty()) add(panel);
    for (const NamedPanel& panel : readyFaceplates()) add(panel);
    setFilter(m_search->text());
}

namespace {
/// How well an element fits what is looked for, 0 not at all: its title counts more than the words that describe it.
int fitOf(const QTreeWidgetItem& item, const QString& wanted) {
    const QString title = item.text(0);
    if (title.startsWith(wanted, Qt::CaseInsensitive)) return 3;
    if (title.contains(wanted, Qt::CaseInsensitive)) return 2;
    return item.data(0, kWordsRole).toString().contains(wanted, Qt::CaseInsensitive) ? 1 : 0;
}
} // namespace

void Palette::setFilter(const QString& text) {
    if (m_search->text() != text) {
        m_search->setText(text);
        return;
    }
    const QString wanted = text.trimmed();
    QTreeWidgetItem* best = nullptr;
    int bestFit = 0;
    for (int i = 0; i < m_tree->topLevelItemCount(); ++i) {
        QTreeWidgetItem* group = m_tree->topLevelItem(i);
        bool any = false;
        for (int j = 0; j < group->childCount(); ++j) {
            const int fit = fitOf(*group->child(j), wanted);
            group->child(j)->setHidden(fit == 0);
            any |= fit > 0;
            if (fit > bestFit) best = group->child(j), bestFit = fit;
        }
        group->setHidden(!any);
        if (any) group->setExpanded(true);
    }
    m_tree->setCurrentItem(wanted.isEmpty() ? nullptr : best); // Enter puts it in
}

QStringList Palette::shownTitles() const {
    QStringList out;
    for (int i = 0; i < m_tree->topLevelItemCount(); ++i)
        for (int j = 0; j < m_tree->topLevelItem(i)->childCount(); ++j)
            if (!m_tree->topLevelItem(i)->child(j)->isHidden()) out += m_tree->topLevelItem(i)->child(j)->text(0);
    return out;
}

} // namespace plc::hmi
