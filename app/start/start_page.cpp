#include "app/start/start_page.h"

#include "app/settings/settings.h"
#include "app/start/example_titles.h"
#include "app/start/guide_view.h"
#include "editor/kit/icons.h"
#include "editor/kit/theme.h"

#include <QCoreApplication>
#include <QDateTime>
#include <QDir>
#include <QFile>
#include <QFileInfo>
#include <QGridLayout>
#include <QHash>
#include <QImage>
#include <QJsonDocument>
#include <QJsonObject>
#include <QLabel>
#include <QMenu>
#include <QPainter>
#include <QPainterPath>
#include <QPixmap>
#include <QPushButton>
#include <QStyledItemDelegate>
#include <QVBoxLayout>

#include <functional>
#include <utility>

namespace plc::app {

namespace {

constexpr int kCardWidth = 236, kPictureHeight = 124, kPadding = 6;

/// As high as its picture, its name and three lines about it: what English says in two takes others three.
QSize cardSize(const QFontMetrics& font) {
    return {std::max(kCardWidth, font.averageCharWidth() * 38), kPictureHeight + 4 * font.lineSpacing() + 3 * kPadding};
}

QString titleOf(const QString& folder) {
    QFile file(folder + "/project.json");
    if (file.open(QIODevice::ReadOnly))
        if (const QString name = QJsonDocument::fromJson(file.readAll()).object().value("name").toString();
            !name.isEmpty())
            return name;
    return QDir(folder).dirName();
}

/// What is known of an example; of another project, the first paragraph of its README below the heading.
QString summaryOf(const QString& folder) {
    if (const QString known = exampleSummary(titleOf(folder)); !known.isEmpty()) return known;
    QFile file(GuideView::readmeOf(folder));
    if (!file.open(QIODevice::ReadOnly)) return {};
    for (const QString& line : QString::fromUtf8(file.readAll()).split('\n')) {
        QString text = line.trimmed();
        if (!text.isEmpty() && !text.startsWith('#') && !text.startsWith('!')) return text.remove('`').remove("**");
    }
    return {};
}

/// A line that is as wide as its list and no wider: a long folder is elided instead of scrolled.
class ElidingDelegate : public QStyledItemDelegate {
public:
    using QStyledItemDelegate::QStyledItemDelegate;
    QSize sizeHint(const QStyleOptionViewItem& option, const QModelIndex& index) const override {
        return {0, QStyledItemDelegate::sizeHint(option, index).height()};
    }
};

/// A card: picture, name, one line about it.
class CardDelegate : public QStyledItemDelegate {
public:
    CardDelegate(std::function<void(int row)> wantPicture, QObject* parent)
        : QStyledItemDelegate(parent), m_wantPicture(std::move(wantPicture)) {}
    QSize sizeHint(const QStyleOptionViewItem& option, const QModelIndex&) const override {
        return cardSize(option.fontMetrics) + QSize(14, 14);
    }
    void paint(QPainter* painter, const QStyleOptionViewItem& option, const QModelIndex& index) const override {
        const kit::ThemeColors& c = kit::colors();
        painter->save();
        painter->setRenderHints(QPainter::Antialiasing | QPainter::SmoothPixmapTransform);
        const QRectF card = QRectF(option.rect).adjusted(7, 7, -7, -7);
        const bool hot = option.state & (QStyle::State_MouseOver | QStyle::State_Selected);
        QPainterPath shape;
        shape.addRoundedRect(card, 8, 8);
        painter->fillPath(shape, hot ? c.hover : c.raised);
        painter->setClipPath(shape);
        const QRectF pictureArea(card.left(), card.top(), card.width(), kPictureHeight);
        const QVariant known = index.data(StartPage::kPictureRole);
        const QPixmap picture = known.value<QPixmap>();
        painter->fillRect(pictureArea, c.alternate);
        if (!known.isValid()) {
            m_wantPicture(index.row());
        } else if (!picture.isNull()) {
            const QSizeF scaled = QSizeF(picture.size()).scaled(pictureArea.size(), Qt::KeepAspectRatioByExpanding);
            const QRectF target(pictureArea.center().x() - scaled.width() / 2, pictureArea.top(), scaled.width(),
                                scaled.height());
            painter->setClipRect(pictureArea, Qt::IntersectClip);
            painter->drawPixmap(target, picture, picture.rect());
        } else {
            kit::paintIcon(painter, QRectF(pictureArea.center() - QPointF(22, 22), QSizeF(44, 44)), kit::Icon::Project,
                           true);
        }
        painter->setClipping(false);
        QFont bold = option.font;
        bold.setBold(true);
        painter->setFont(bold);
        painter->setPen(c.text);
        const QRectF name(card.left() + 12, pictureArea.bottom() + kPadding / 2, card.width() - 24,
                          option.fontMetrics.lineSpacing() + kPadding);
        painter->drawText(
            name, Qt::AlignVCenter,
            QFontMetrics(bold).elidedText(index.data().toString(), Qt::ElideRight, static_cast<int>(name.width())));
        painter->setFont(option.font);
        painter->setPen(c.muted);
        const QRectF line(card.left() + 12, name.bottom(), card.width() - 24, 3 * option.fontMetrics.lineSpacing());
        painter->drawText(line, Qt::AlignTop | Qt::TextWordWrap,
                          QFontMetrics(option.font)
                              .elidedText(index.data(Qt::UserRole + 2).toString(), Qt::ElideRight,
                                          static_cast<int>(line.width() * 2.8)));
        painter->setPen(QPen(hot ? c.accent : c.border, hot ? 1.6 : 1));
        painter->drawPath(shape);
        painter->restore();
    }

private:
    std::function<void(int row)> m_wantPicture;
};

QLabel* heading(const QString& text, QWidget* parent) {
    auto* label = new QLabel(text, parent);
    QFont font = label->font();
    font.setPointSizeF(font.pointSizeF() * 1.25);
    font.setBold(true);
    label->setFont(font);
    return label;
}

} // namespace

StartPage::StartPage(Settings& settings, QWidget* parent) : QWidget(parent), m_settings(settings) {
    auto* title = new QLabel("Stepwise", this);
    QFont font = title->font();
    font.setPointSizeF(font.pointSizeF() * 2.4);
    font.setBold(true);
    title->setFont(font);
    auto* subtitle =
        new QLabel(tr("Write, run and watch PLC programs. Every scan is recorded; time runs backwards, too."), this);
    subtitle->setWordWrap(true);
    const auto button = [&](kit::Icon icon, const QString& text, auto signal) {
        auto* b = new QPushButton(kit::icon(icon), text, this);
        b->setIconSize({18, 18});
        b->setMinimumHeight(34);
        connect(b, &QPushButton::clicked, this, signal);
        return b;
    };
    m_recent = new QListWidget(this);
    m_recent->setFrameShape(QFrame::NoFrame);
    m_recent->setObjectName(QStringLiteral("recentProjects"));
    m_recent->setAccessibleName(tr("Recent projects"));
    m_recent->setTextElideMode(Qt::ElideMiddle);
    m_recent->setItemDelegate(new ElidingDelegate(m_recent));
    m_recent->setSpacing(2);
    m_examples = new QListWidget(this);
    m_examples->setFrameShape(QFrame::NoFrame);
    m_examples->setViewMode(QListView::IconMode);
    m_examples->setResizeMode(QListView::Adjust);
    m_examples->setMovement(QListView::Static);
    m_examples->setMouseTracking(true);
    m_examples->setVerticalScrollMode(QAbstractItemView::ScrollPerPixel);
    connect(&m_reading, &QTimer::timeout, this, &StartPage::readNextPicture);
    m_examples->setItemDelegate(new CardDelegate([this](int row) { wantPicture(row); }, m_examples));
    m_examples->setAccessibleName(tr("Examples"));
    for (QListWidget* list : {m_recent, m_examples}) {
        list->viewport()->setAutoFillBackground(false);
        const auto open = [this, list](QListWidgetItem* item) {
            const QString folder = item->data(Qt::UserRole).toString();
            if (list == m_examples)
                emit exampleRequested(folder, false);
            else
                emit projectRequested(folder);
        };
        connect(list, &QListWidget::itemActivated, this, open);
        connect(list, &QListWidget::itemClicked, this, open);
    }
    m_examples->setContextMenuPolicy(Qt::CustomContextMenu);
    connect(m_examples, &QWidget::customContextMenuRequested, this, [this](const QPoint& at) {
        QListWidgetItem* item = m_examples->itemAt(at);
        if (!item) return;
        const QString folder = item->data(Qt::UserRole).toString();
        QMenu menu(this);
        menu.addAction(tr("Open"), this, [this, folder] { emit exampleRequested(folder, false); });
        menu.addAction(tr("Open a Fresh Copy"), this, [this, folder] { emit exampleRequested(folder, true); });
        menu.exec(m_examples->viewport()->mapToGlobal(at));
    });
    auto* left = new QVBoxLayout;
    left->setSpacing(8);
    left->addWidget(title);
    left->addWidget(subtitle);
    left->addSpacing(14);
    left->addWidget(button(kit::Icon::New, tr("New Project…"), &StartPage::newRequested));
    left->addWidget(button(kit::Icon::Open, tr("Open Project…"), &StartPage::openRequested));
    m_tour = button(kit::Icon::Help, tr("Take the Tour"), &StartPage::tourRequested);
    left->addWidget(m_tour);
    left->addSpacing(14);
    left->addWidget(heading(tr("Recent"), this));
    left->addWidget(m_recent, 1);
    m_examplesHeading = heading({}, this);
    m_noExamples = new QLabel(this);
    m_noExamples->setObjectName(QStringLiteral("noExamples"));
    m_noExamples->setWordWrap(true);
    m_noExamples->setTextFormat(Qt::PlainText);
    m_noExamples->setTextInteractionFlags(Qt::TextSelectableByMouse | Qt::TextSelectableByKeyboard);
    auto* right = new QVBoxLayout;
    right->addWidget(m_examplesHeading);
    right->addWidget(m_noExamples);
    right->addWidget(m_examples, 1);
    auto* layout = new QHBoxLayout(this);
    layout->setContentsMargins(28, 24, 20, 16);
    layout->setSpacing(28);
    layout->addLayout(left, 1);
    layout->addLayout(right, 3);
    reload();
}

namespace {

/// Where they may be; a package that keeps them elsewhere names the one folder.
QStringList placesOfExamples() {
    if (const QString wanted = qEnvironmentVariable("STEPWISE_EXAMPLES"); !wanted.isEmpty()) return {wanted};
    const QString beside = QCoreApplication::applicationDirPath();
    return {beside + "/../../../projects/examples", beside + "/../share/stepwise/examples",
            QDir::currentPath() + "/projects/examples"};
}

} // namespace

QString StartPage::examplesFolder() {
    for (const QString& candidate : placesOfExamples())
        if (QDir(candidate).exists()) return QDir(candidate).canonicalPath();
    return {};
}

QStringList StartPage::examplesInstalled() {
    const QString folder = examplesFolder();
    if (folder.isEmpty()) return {};
    QStringList names = QDir(folder).entryList(QDir::Dirs | QDir::NoDotAndDotDot, QDir::Name), out;
    if (names.removeAll("pid_pt1")) names.prepend("pid_pt1"); // the one to begin with
    for (const QString& name : names)
        if (const QString project = folder + "/" + name; QFile::exists(project + "/project.json")) out << project;
    return out;
}

QString StartPage::whyNoExamples() {
    QStringList places;
    for (const QString& place : placesOfExamples()) {
        const QString shown = QDir::toNativeSeparators(QDir::cleanPath(QDir(place).absolutePath()));
        if (!places.contains(shown)) places << shown;
    }
    return tr("No examples were found in:\n%1\n\nInstall the examples, or set the environment variable "
              "STEPWISE_EXAMPLES to the folder that contains them, and start Stepwise again.")
        .arg(places.join('\n'));
}

namespace {

/// Read once in a program, whatever number of windows it opens, and again when its file is another one.
QPixmap pictureOf(const QString& folder) {
    struct Picture {
        QDateTime changed;
        qint64 bytes = -1;
        QImage picture;
    };
    static QHash<QString, Picture> pictures; // by file
    for (const char* name : {"/docs/panel.png", "/panel.png", "/docs/trace.png", "/picture.png"}) {
        const QFileInfo file(folder + name);
        if (!file.exists()) continue;
        Picture& kept = pictures[file.filePath()];
        if (kept.changed != file.lastModified() || kept.bytes != file.size()) {
            QImage whole(file.filePath());
            if (!whole.isNull())
                whole = whole.scaledToWidth(2 * kCardWidth, Qt::SmoothTransformation); // lines stay lines
            kept = {file.lastModified(), file.size(), std::move(whole)};
        }
        if (!kept.picture.isNull()) return QPixmap::fromImage(kept.picture);
    }
    return {};
}

} // namespace

void StartPage::wantPicture(int row) {
    if (!m_wanted.contains(row)) m_wanted << row;
    m_reading.start();
}

void StartPage::readNextPicture() {
    if (m_wanted.isEmpty()) return m_reading.stop();
    if (QListWidgetItem* item = m_examples->item(m_wanted.takeFirst()))
        item->setData(kPictureRole, pictureOf(item->data(Qt::UserRole).toString()));
}

void StartPage::reload() {
    m_recent->clear();
    for (const QString& folder : m_settings.recentProjects()) {
        const QString name = exampleTitle(titleOf(folder)) + QChar::LineSeparator +
                             QDir::toNativeSeparators(folder); // copies of one example have one name
        auto* item = new QListWidgetItem(kit::icon(kit::Icon::Project), name, m_recent);
        item->setToolTip(folder);
        item->setData(Qt::UserRole, folder);
    }
    m_examples->clear();
    m_wanted.clear();
    const QStringList projects = examplesInstalled();
    for (const QString& project : projects) {
        const QString summary = summaryOf(project);
        auto* item = new QListWidgetItem(exampleTitle(titleOf(project)), m_examples);
        item->setData(Qt::UserRole, project);
        item->setData(Qt::UserRole + 2, summary);
        item->setToolTip(summary);
    }
    // Without them nothing is offered that cannot be opened: the tour runs on an example.
    const bool any = !projects.isEmpty();
    m_examplesHeading->setText(any ? tr("Examples: open one and press Run") : tr("Examples"));
    m_noExamples->setText(any ? QString() : whyNoExamples());
    m_noExamples->setHidden(any);
    m_examples->setEnabled(any);
    m_tour->setVisible(any);
}

} // namespace plc::app
