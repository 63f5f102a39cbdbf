#include "editor/trace/channel_panel.h"

#include "editor/kit/icons.h"
#include "editor/kit/inputs/property_grid.h"
#include "editor/kit/inputs/variable_picker.h"
#include "editor/kit/post.h"
#include "editor/kit/theme.h"

#include <QDropEvent>
#include <QHeaderView>
#include <QKeyEvent>
#include <QMimeData>
#include <QPainter>
#include <QSplitter>
#include <QToolButton>
#include <QTreeWidget>
#include <QVBoxLayout>

namespace plc::trace {

namespace {

constexpr int ChartRole = Qt::UserRole + 1, ChannelRole = Qt::UserRole + 2;

QIcon swatch(const QColor& color) {
    QPixmap pixmap(32, 32);
    pixmap.setDevicePixelRatio(2);
    pixmap.fill(Qt::transparent);
    QPainter painter(&pixmap);
    painter.setRenderHint(QPainter::Antialiasing);
    painter.setPen(Qt::NoPen);
    painter.setBrush(color);
    painter.drawRoundedRect(QRectF(2, 3, 12, 10), 3, 3);
    QIcon icon(pixmap);
    icon.addPixmap(pixmap, QIcon::Selected);
    return icon;
}

std::string utf8(const QVariant& v) { return v.toString().toStdString(); }

std::vector<kit::PropertyChoice> choices(const QStringList& labels) {
    std::vector<kit::PropertyChoice> out;
    for (int i = 0; i < labels.size(); ++i) out.push_back({i, labels[i], {}});
    return out;
}

kit::PropertyDescriptor describe(const char* id, const QString& group, const QString& label, kit::PropertyKind kind,
                                 const QVariant& standard = {}) {
    kit::PropertyDescriptor d;
    d.id = QLatin1String(id);
    d.group = group;
    d.label = label;
    d.kind = kind;
    d.defaultValue = standard;
    return d;
}

} // namespace

ChannelPanel::ChannelPanel(QWidget* parent) : QWidget(parent) {
    setMinimumWidth(fontMetrics().averageCharWidth() * 26); // the names of channels, not their beginnings
    m_entry = new kit::ExpressionEdit(this);
    m_entry->setPlaceholderText(tr("Variable or expression"));
    m_entry->setAccessibleName(tr("Add a channel"));
    m_entry->setClearButtonEnabled(true);
    auto* add = new QToolButton(this);
    add->setIcon(kit::icon(kit::Icon::Add));
    add->setToolTip(tr("Add as a channel"));
    add->setAccessibleName(add->toolTip());
    add->setAutoRaise(true);
    m_list = new QTreeWidget(this);
    m_list->setColumnCount(2);
    m_list->setHeaderLabels({tr("Channel"), tr("Value")});
    m_list->setAccessibleName(tr("Channels"));
    m_list->setRootIsDecorated(true);
    m_list->setIndentation(12);
    m_list->setAcceptDrops(true);
    m_list->setDragEnabled(true);
    m_list->setDragDropMode(QAbstractItemView::DragDrop);
    m_list->setSelectionMode(QAbstractItemView::SingleSelection);
    m_list->header()->setStretchLastSection(false);
    m_list->header()->setSectionResizeMode(0, QHeaderView::Stretch);
    m_list->header()->setSectionResizeMode(1, QHeaderView::Fixed); // shareWidth()
    m_list->viewport()->installEventFilter(this);
    m_list->installEventFilter(this);
    m_grid = new kit::PropertyGrid(this);
    m_grid->header()->resizeSection(0, 110);
    auto* entryRow = new QHBoxLayout;
    entryRow->setContentsMargins(6, 6, 6, 2);
    entryRow->setSpacing(4);
    entryRow->addWidget(m_entry);
    entryRow->addWidget(add);
    auto* upper = new QWidget(this);
    auto* upperLayout = new QVBoxLayout(upper);
    upperLayout->setContentsMargins(0, 0, 0, 0);
    upperLayout->setSpacing(2);
    upperLayout->addLayout(entryRow);
    upperLayout->addWidget(m_list);
    auto* splitter = new QSplitter(Qt::Vertical, this);
    splitter->addWidget(upper);
    splitter->addWidget(m_grid);
    splitter->setStretchFactor(0, 3);
    splitter->setStretchFactor(1, 2);
    auto* layout = new QVBoxLayout(this);
    layout->setContentsMargins(0, 0, 0, 0);
    layout->addWidget(splitter);
    auto want = [this] {
        const QString text = m_entry->text().trimmed();
        if (text.isEmpty()) return;
        m_entry->clear();
        emit channelWanted(text, std::max(0, selectedChart()));
    };
    connect(m_entry, &QLineEdit::returnPressed, this, want);
    connect(add, &QToolButton::clicked, this, want);
    connect(m_list, &QTreeWidget::itemSelectionChanged, this, [this] {
        showProperties();
        if (!m_filling) emit channelSelected(selectedChannel());
    });
    connect(m_list, &QTreeWidget::itemChanged, this, [this](QTreeWidgetItem* item, int column) {
        if (m_filling || column != 0 || !item->parent()) return;
        const int channel = item->data(0, ChannelRole).toInt();
        const bool visible = item->checkState(0) == Qt::Checked;
        if (m_setup.channels[static_cast<size_t>(channel)].isVisible == visible) return;
        m_isTicked = true;
        emit changeRequested(visible ? tr("Show channel") : tr("Hide channel"), [channel, visible](TraceSetup& s) {
            s.channels[static_cast<size_t>(channel)].isVisible = visible;
        });
        m_isTicked = false;
    });
    connect(m_grid, &kit::PropertyGrid::committed, this, &ChannelPanel::commit);
}

void ChannelPanel::setCompletionSource(kit::CompletionSource source) {
    m_entry->setCompletionSource(source);
    m_grid->setCompletionSource(std::move(source));
}

void ChannelPanel::setCheck(kit::TextCheck check) {
    m_entry->setCheck(check);
    m_grid->setCheck([check](const QString&, const QString& text) { return check(text); });
}

void ChannelPanel::setPicker(std::function<std::optional<QString>(const QString&)> picker) {
    m_grid->setPicker(std::move(picker));
}

int ChannelPanel::selectedChannel() const {
    const QTreeWidgetItem* item = m_list->currentItem();
    return item && item->parent() ? item->data(0, ChannelRole).toInt() : -1;
}

int ChannelPanel::selectedChart() const {
    const QTreeWidgetItem* item = m_list->currentItem();
    return item ? item->data(0, ChartRole).toInt() : -1;
}

void ChannelPanel::selectChannel(int channel) {
    for (int i = 0; i < m_list->topLevelItemCount(); ++i)
        for (int j = 0; j < m_list->topLevelItem(i)->childCount(); ++j)
            if (m_list->topLevelItem(i)->child(j)->data(0, ChannelRole).toInt() == channel)
                m_list->setCurrentItem(m_list->topLevelItem(i)->child(j));
}

void ChannelPanel::showSetup(const TraceSetup& setup, const plot::PlotModel& model) {
    m_setup = setup;
    if (m_isTicked)
        kit::post(this, [this] { rebuild(); });
    else
        rebuild();
    showValues(model);
}

void ChannelPanel::rebuild() {
    const int chart = selectedChart(), channel = selectedChannel();
    m_filling = true;
    m_list->clear();
    for (size_t c = 0; c < m_setup.charts.size(); ++c) {
        const std::string& title = m_setup.charts[c].title;
        auto* chartItem =
            new QTreeWidgetItem(m_list, {title.empty() ? tr("Chart %1").arg(c + 1) : QString::fromStdString(title)});
        chartItem->setData(0, ChartRole, static_cast<int>(c));
        chartItem->setIcon(0, kit::icon(kit::Icon::Trace));
        chartItem->setFlags(Qt::ItemIsEnabled | Qt::ItemIsSelectable | Qt::ItemIsDropEnabled);
        for (size_t i = 0; i < m_setup.channels.size(); ++i) {
            const ChannelSetup& s = m_setup.channels[i];
            if (s.chart != static_cast<int>(c)) continue;
            auto* item =
                new QTreeWidgetItem(chartItem, {QString::fromStdString(s.label.empty() ? s.expression : s.label)});
            item->setData(0, ChartRole, static_cast<int>(c));
            item->setData(0, ChannelRole, static_cast<int>(i));
            item->setIcon(0, swatch(drawnColor(m_setup, i)));
            item->setCheckState(0, s.isVisible ? Qt::Checked : Qt::Unchecked);
            item->setFlags(Qt::ItemIsEnabled | Qt::ItemIsSelectable | Qt::ItemIsUserCheckable | Qt::ItemIsDragEnabled);
            item->setTextAlignment(1, Qt::AlignRight | Qt::AlignVCenter);
            if (channel == static_cast<int>(i)) m_list->setCurrentItem(item);
        }
        chartItem->setExpanded(true);
        if (channel < 0 && chart == static_cast<int>(c)) m_list->setCurrentItem(chartItem);
    }
    m_filling = false;
    showProperties();
}

void ChannelPanel::showValues(const plot::PlotModel& model) {
    m_filling = true;
    for (int i = 0; i < m_list->topLevelItemCount(); ++i)
        for (int j = 0; j < m_list->topLevelItem(i)->childCount(); ++j) {
            QTreeWidgetItem* item = m_list->topLevelItem(i)->child(j);
            const auto index = static_cast<size_t>(item->data(0, ChannelRole).toInt());
            if (index >= model.curves.size()) continue;
            const plot::PlotCurve& curve = model.curves[index];
            QString text;
            if (curve.source) {
                const int64_t at = model.cursorA ? *model.cursorA : model.present.value_or(INT64_MAX);
                if (curve.source->inForceAt(at)) text = plot::curveTextAt(curve, at);
            }
            const QString shown = curve.problem.isEmpty() ? text : tr("error");
            if (item->text(1) == shown) continue;
            item->setText(1, shown);
            item->setToolTip(1, shown); // it may be cut off
            item->setForeground(1, curve.problem.isEmpty() ? kit::colors().online : kit::colors().bad);
            item->setToolTip(0, curve.problem.isEmpty() ? QString::fromStdString(m_setup.channels[index].expression)
                                                        : curve.problem);
        }
    m_filling = false;
    shareWidth();
}

/// The values get what the names leave, but always room for the first digits.
void ChannelPanel::shareWidth() {
    const QAbstractItemView& list = *m_list; // the tree hides the sizes of its columns
    const int least = fontMetrics().averageCharWidth() * 9;
    const int left = std::max(least, m_list->viewport()->width() - list.sizeHintForColumn(0));
    const int wanted = std::max(list.sizeHintForColumn(1), m_list->header()->sectionSizeHint(1));
    if (const int width = std::min(wanted, left); width != m_list->columnWidth(1))
        m_list->header()->resizeSection(1, width);
}

void ChannelPanel::showProperties() {
    if (m_filling) return;
    if (m_shown != std::pair(selectedChannel(), selectedChart())) m_grid->endEditing();
    m_shown = {selectedChannel(), selectedChart()};
    if (const int channel = selectedChannel(); channel >= 0 && channel < static_cast<int>(m_setup.channels.size()))
        describeChannel(channel);
    else if (const int chart = selectedChart(); chart >= 0 && chart < static_cast<int>(m_setup.charts.size()))
        describeChart(chart);
    else
        describeTrace();
}

void ChannelPanel::describeChannel(int channel) {
    using kit::PropertyKind;
    const ChannelSetup& c = m_setup.channels[static_cast<size_t>(channel)];
    const QString group = tr("Channel");
    std::vector<kit::PropertyDescriptor> d;
    d.push_back(describe("expression", group, tr("Expression"), PropertyKind::Expression));
    d.push_back(describe("label", group, tr("Name"), PropertyKind::Text, QString()));
    d.back().placeholder = QString::fromStdString(c.expression);
    d.push_back(describe("unit", group, tr("Unit"), PropertyKind::Text, QString()));
    d.push_back(describe("style", group, tr("Style"), PropertyKind::Enumeration, 0));
    d.back().choices = choices({tr("Automatic"), tr("Line"), tr("Hold"), tr("Digital")});
    d.push_back(describe("color", group, tr("Colour"), PropertyKind::Color));
    d.push_back(describe("width", group, tr("Line width"), PropertyKind::Number, 1.6));
    d.back().minimum = 0.5;
    d.back().maximum = 8;
    d.back().step = 0.2;
    d.push_back(describe("scale", group, tr("Scale"), PropertyKind::Number, 1.0));
    d.push_back(describe("offset", group, tr("Offset"), PropertyKind::Number, 0.0));
    d[d.size() - 2].decimals = d.back().decimals = 9;
    d.push_back(describe("chart", group, tr("Chart"), PropertyKind::Enumeration));
    QStringList charts, axes;
    for (size_t i = 0; i < m_setup.charts.size(); ++i)
        charts += m_setup.charts[i].title.empty() ? tr("Chart %1").arg(i + 1)
                                                  : QString::fromStdString(m_setup.charts[i].title);
    charts += tr("New chart");
    d.back().choices = choices(charts);
    d.push_back(describe("axis", group, tr("Axis"), PropertyKind::Enumeration));
    const ChartSetup& chart = m_setup.charts[static_cast<size_t>(c.chart)];
    for (size_t i = 0; i < chart.axes.size(); ++i)
        axes += chart.axes[i].title.empty() ? tr("Axis %1").arg(i + 1) : QString::fromStdString(chart.axes[i].title);
    axes += tr("New axis");
    d.back().choices = choices(axes);
    m_grid->setDescriptors(std::move(d));
    m_grid->setValues({{"expression", QString::fromStdString(c.expression)},
                       {"label", QString::fromStdString(c.label)},
                       {"unit", QString::fromStdString(c.unit)},
                       {"style", static_cast<int>(c.style)},
                       {"color", channelColor(m_setup, static_cast<size_t>(channel))},
                       {"width", c.width},
                       {"scale", c.scale},
                       {"offset", c.offset},
                       {"chart", c.chart},
                       {"axis", c.axis}});
}

void ChannelPanel::describeChart(int chart) {
    using kit::PropertyKind;
    const ChartSetup& c = m_setup.charts[static_cast<size_t>(chart)];
    std::vector<kit::PropertyDescriptor> d;
    d.push_back(describe("title", tr("Chart"), tr("Title"), PropertyKind::Text, QString()));
    d.push_back(describe("weight", tr("Chart"), tr("Share of height"), PropertyKind::Number, 1.0));
    d.back().minimum = 0.1;
    d.back().maximum = 20;
    d.back().step = 0.5;
    std::map<QString, QVariant> values = {{"title", QString::fromStdString(c.title)}, {"weight", c.weight}};
    for (size_t i = 0; i < c.axes.size(); ++i) {
        const QString group = c.axes.size() == 1 ? tr("Axis") : tr("Axis %1").arg(i + 1);
        const QString prefix = QStringLiteral("axis%1.").arg(i);
        auto add = [&](const char* id, const QString& label, PropertyKind kind, const QVariant& value,
                       const QVariant& standard) {
            d.push_back(describe(id, group, label, kind, standard));
            d.back().id = prefix + QLatin1String(id);
            d.back().decimals = 9;
            values[d.back().id] = value;
        };
        add("title", tr("Title"), PropertyKind::Text, QString::fromStdString(c.axes[i].title), QString());
        add("unit", tr("Unit"), PropertyKind::Text, QString::fromStdString(c.axes[i].unit), QString());
        add("mode", tr("Scaling"), PropertyKind::Enumeration, static_cast<int>(c.axes[i].mode), 0);
        d.back().choices = choices({tr("Automatic"), tr("Fit to view"), tr("Fixed")});
        add("min", tr("Minimum"), PropertyKind::Number, c.axes[i].minimum, 0.0);
        d.back().isReadOnly = c.axes[i].mode != ScaleMode::Fixed;
        add("max", tr("Maximum"), PropertyKind::Number, c.axes[i].maximum, 100.0);
        d.back().isReadOnly = c.axes[i].mode != ScaleMode::Fixed;
        add("right", tr("On the right"), PropertyKind::Bool, c.axes[i].isOnRight, false);
    }
    m_grid->setDescriptors(std::move(d));
    m_grid->setValues(values);
}

void ChannelPanel::describeTrace() {
    using kit::PropertyKind;
    std::vector<kit::PropertyDescriptor> d;
    d.push_back(describe("title", tr("Trace"), tr("Title"), PropertyKind::Text, QString()));
    d.push_back(describe("every", tr("Trace"), tr("Every n-th scan"), PropertyKind::Integer, 1));
    d.back().minimum = 1;
    d.back().maximum = 1e9;
    d.push_back(describe("condition", tr("Trace"), tr("Record while"), PropertyKind::Expression, QString()));
    d.push_back(describe("trigger", tr("Trigger"), tr("Expression"), PropertyKind::Expression, QString()));
    d.push_back(describe("edge", tr("Trigger"), tr("Edge"), PropertyKind::Enumeration, 0));
    d.back().choices = choices({tr("Rising"), tr("Falling"), tr("Both"), tr("Level")});
    d.push_back(describe("mode", tr("Trigger"), tr("Mode"), PropertyKind::Enumeration, 0));
    d.back().choices = choices({tr("Off"), tr("Single"), tr("Repeated")});
    d.push_back(describe("before", tr("Trigger"), tr("Shown before"), PropertyKind::Number, 1.0));
    d.push_back(describe("after", tr("Trigger"), tr("Shown after"), PropertyKind::Number, 1.0));
    for (size_t i = d.size() - 2; i < d.size(); ++i) {
        d[i].minimum = 0;
        d[i].maximum = 1e6;
        d[i].step = 0.1;
        d[i].decimals = 9;
        d[i].suffix = QStringLiteral(" s");
    }
    if (!m_setup.compareWith.empty()) {
        d.push_back(describe("shift", tr("Compared recording"), tr("Offset in time"), PropertyKind::Number, 0.0));
        d.back().decimals = 9;
        d.back().step = 0.1;
        d.back().suffix = QStringLiteral(" s");
    }
    m_grid->setDescriptors(std::move(d));
    const TriggerSetup& t = m_setup.trigger;
    m_grid->setValues({{"shift", static_cast<double>(m_setup.compareShift) / 1e9},
                       {"title", QString::fromStdString(m_setup.title)},
                       {"every", static_cast<int>(m_setup.every)},
                       {"condition", QString::fromStdString(m_setup.condition)},
                       {"trigger", QString::fromStdString(t.expression)},
                       {"edge", static_cast<int>(t.edge)},
                       {"mode", static_cast<int>(t.mode)},
                       {"before", static_cast<double>(t.before) / 1e9},
                       {"after", static_cast<double>(t.after) / 1e9}});
}

void ChannelPanel::commit(const QString& id, const QVariant& value) {
    const auto [channel, chart] = m_shown;
    if (channel >= static_cast<int>(m_setup.channels.size()) || chart >= static_cast<int>(m_setup.charts.size()))
        return; // gone meanwhile
    if (channel >= 0)
        commitChannel(channel, id, value);
    else if (chart >= 0)
        commitChart(chart, id, value);
    else
        commitTrace(id, value);
}

void ChannelPanel::commitChannel(int channel, const QString& id, const QVariant& value) {
    emit changeRequested(tr("Change channel"), [channel, id, value](TraceSetup& s) {
        ChannelSetup& c = s.channels[static_cast<size_t>(channel)];
        if (id == QLatin1String("expression") && !value.toString().trimmed().isEmpty())
            c.expression = value.toString().trimmed().toStdString();
        else if (id == QLatin1String("label"))
            c.label = utf8(value);
        else if (id == QLatin1String("unit"))
            c.unit = utf8(value);
        else if (id == QLatin1String("style"))
            c.style = static_cast<ChannelStyle>(value.toInt());
        else if (id == QLatin1String("color"))
            c.color = value.value<QColor>().isValid() ? value.value<QColor>().name().toStdString() : std::string();
        else if (id == QLatin1String("width"))
            c.width = value.toDouble();
        else if (id == QLatin1String("scale"))
            c.scale = value.toDouble();
        else if (id == QLatin1String("offset"))
            c.offset = value.toDouble();
        else if (id == QLatin1String("chart")) {
            c.chart = value.toInt();
            c.axis = 0;
            if (c.chart >= static_cast<int>(s.charts.size())) s.charts.resize(static_cast<size_t>(c.chart) + 1);
        } else if (id == QLatin1String("axis")) {
            c.axis = value.toInt();
            auto& axes = s.charts[static_cast<size_t>(c.chart)].axes;
            if (c.axis >= static_cast<int>(axes.size())) {
                axes.resize(static_cast<size_t>(c.axis) + 1);
                axes.back().isOnRight = axes.size() == 2;
            }
        }
    });
}

void ChannelPanel::commitChart(int chart, const QString& id, const QVariant& value) {
    emit changeRequested(tr("Change chart"), [chart, id, value](TraceSetup& s) {
        ChartSetup& c = s.charts[static_cast<size_t>(chart)];
        if (id == QLatin1String("title"))
            c.title = utf8(value);
        else if (id == QLatin1String("weight"))
            c.weight = value.toDouble();
        if (!id.startsWith(QLatin1String("axis"))) return;
        const auto axis = static_cast<size_t>(id.mid(4, id.indexOf(QLatin1Char('.')) - 4).toInt());
        if (axis >= c.axes.size()) return;
        const QString part = id.section(QLatin1Char('.'), 1);
        AxisSetup& a = c.axes[axis];
        if (part == QLatin1String("title"))
            a.title = utf8(value);
        else if (part == QLatin1String("unit"))
            a.unit = utf8(value);
        else if (part == QLatin1String("mode"))
            a.mode = static_cast<ScaleMode>(value.toInt());
        else if (part == QLatin1String("min"))
            a.minimum = value.toDouble();
        else if (part == QLatin1String("max"))
            a.maximum = value.toDouble();
        else if (part == QLatin1String("right"))
            a.isOnRight = value.toBool();
    });
}

void ChannelPanel::commitTrace(const QString& id, const QVariant& value) {
    emit changeRequested(tr("Change trace"), [id, value](TraceSetup& s) {
        if (id == QLatin1String("title"))
            s.title = utf8(value);
        else if (id == QLatin1String("every"))
            s.every = static_cast<uint32_t>(value.toInt());
        else if (id == QLatin1String("condition"))
            s.condition = utf8(value);
        else if (id == QLatin1String("shift"))
            s.compareShift = std::llround(std::clamp(value.toDouble(), -9e9, 9e9) * 1e9);
        else if (id == QLatin1String("trigger"))
            s.trigger.expression = utf8(value);
        else if (id == QLatin1String("edge"))
            s.trigger.edge = static_cast<TriggerEdge>(value.toInt());
        else if (id == QLatin1String("mode"))
            s.trigger.mode = static_cast<TriggerMode>(value.toInt());
        else if (id == QLatin1String("before"))
            s.trigger.before = std::llround(value.toDouble() * 1e9);
        else if (id == QLatin1String("after"))
            s.trigger.after = std::llround(value.toDouble() * 1e9);
    });
}

void ChannelPanel::removeSelected() {
    const int channel = selectedChannel(), chart = selectedChart();
    if (channel >= 0) {
        emit changeRequested(tr("Remove channel"),
                             [channel](TraceSetup& s) { s.channels.erase(s.channels.begin() + channel); });
    } else if (chart >= 0 && m_setup.charts.size() > 1) {
        emit changeRequested(tr("Remove chart"), [chart](TraceSetup& s) {
            std::erase_if(s.channels, [chart](const ChannelSetup& c) { return c.chart == chart; });
            for (ChannelSetup& c : s.channels)
                if (c.chart > chart) --c.chart;
            s.charts.erase(s.charts.begin() + chart);
        });
    }
}

void ChannelPanel::dropOn(QTreeWidgetItem* target, bool below, const QStringList& paths) {
    const int chart = target ? target->data(0, ChartRole).toInt() : static_cast<int>(m_setup.charts.size()) - 1;
    if (!paths.isEmpty()) {
        for (const QString& path : paths) emit channelWanted(path, chart);
        return;
    }
    const int moved = selectedChannel();
    if (moved < 0) return;
    int before = static_cast<int>(m_setup.channels.size());
    if (target && target->parent()) before = target->data(0, ChannelRole).toInt() + (below ? 1 : 0);
    emit changeRequested(tr("Move channel"), [moved, before, chart](TraceSetup& s) {
        // Colours by order would change with the place: keep what is seen.
        for (size_t i = 0; i < s.channels.size(); ++i)
            if (s.channels[i].color.empty())
                s.channels[i].color = kit::lightColors().curve(static_cast<int>(i)).name().toStdString();
        ChannelSetup channel = s.channels[static_cast<size_t>(moved)];
        if (channel.chart != chart) channel.axis = 0;
        channel.chart = chart;
        s.channels.insert(s.channels.begin() + before, channel);
        s.channels.erase(s.channels.begin() + (moved < before ? moved : moved + 1));
    });
}

bool ChannelPanel::eventFilter(QObject* watched, QEvent* event) {
    if (watched == m_list && event->type() == QEvent::KeyPress &&
        static_cast<QKeyEvent*>(event)->key() == Qt::Key_Delete) {
        removeSelected();
        return true;
    }
    if (watched == m_list->viewport()) {
        switch (event->type()) {
        case QEvent::Resize:
            shareWidth();
            break;
        case QEvent::DragEnter:
        case QEvent::DragMove: {
            auto* drag = static_cast<QDragMoveEvent*>(event);
            const bool known = drag->source() == m_list || drag->mimeData()->hasFormat(kit::VariableMime) ||
                               drag->mimeData()->hasText();
            if (known) drag->acceptProposedAction();
            return known;
        }
        case QEvent::Drop: {
            auto* drop = static_cast<QDropEvent*>(event);
            QTreeWidgetItem* target = m_list->itemAt(drop->position().toPoint());
            const bool below = target && drop->position().y() > m_list->visualItemRect(target).center().y();
            dropOn(target, below, drop->source() == m_list ? QStringList() : kit::variablesOf(drop->mimeData()));
            drop->setDropAction(Qt::CopyAction); // the list is rebuilt from the set-up, nothing is to be taken out
            drop->accept();
            return true;
        }
        case QEvent::MouseButtonPress:
            if (!m_list->itemAt(static_cast<QMouseEvent*>(event)->position().toPoint())) {
                m_list->setCurrentItem(nullptr);
                showProperties();
            }
            break;
        default:
            break;
        }
    }
    return QWidget::eventFilter(watched, event);
}

} // namespace plc::trace
