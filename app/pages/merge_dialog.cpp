#include "app/pages/merge_dialog.h"

#include "editor/kit/icons.h"
#include "editor/kit/theme.h"
#include "editor/text/line_ground.h"
#include "editor/text/st_editor.h"

#include <QDialogButtonBox>
#include <QKeyEvent>
#include <QLabel>
#include <QPushButton>
#include <QScreen>
#include <QSplitter>
#include <QToolBar>
#include <QToolButton>
#include <QVBoxLayout>

namespace plc::app {

using S = QsciScintillaBase;

namespace {
constexpr int kDifferent = 20, kCurrent = 21; // marks of lines
std::string textOf(const QsciScintilla& side) { return side.text().toStdString(); }
} // namespace

MergeDialog::MergeDialog(const QString& file, const std::string& here, const std::string& onDisk, QWidget* parent)
    : QDialog(parent), m_onDisk(onDisk) {
    setWindowTitle(tr("Compare %1").arg(file));
    resize(QSize(1100, 640).boundedTo(screen()->availableSize() - QSize(24, 48))); // with its frame
    auto* bar = new QToolBar(this);
    const auto add = [&](kit::Icon icon, const QString& text, const QKeySequence& keys, auto run) {
        QAction* action = bar->addAction(kit::icon(icon), text);
        action->setShortcut(keys);
        action->setToolTip(QString("%1 (%2)").arg(text, keys.toString(QKeySequence::NativeText)));
        connect(action, &QAction::triggered, this, run);
        auto* button = qobject_cast<QToolButton*>(bar->widgetForAction(action));
        button->setToolButtonStyle(Qt::ToolButtonTextBesideIcon);
        m_buttons.push_back(button);
    };
    add(kit::Icon::Up, tr("Previous"), Qt::ALT | Qt::Key_Up, [this] { goToHunk(m_current - 1); });
    add(kit::Icon::Down, tr("Next"), Qt::ALT | Qt::Key_Down, [this] { goToHunk(m_current + 1); });
    add(kit::Icon::Back, tr("Take Over"), Qt::ALT | Qt::Key_Left, [this] { takeOver(); });
    add(kit::Icon::Back, tr("Take Over All"), Qt::ALT | Qt::SHIFT | Qt::Key_Left, [this] { takeAll(); });
    m_where = new QLabel(this);
    m_where->setContentsMargins(12, 0, 0, 0);
    bar->addWidget(m_where);
    auto* sides = new QSplitter(this);
    m_here = addSide(tr("Here (this text is kept)"), here, sides, file);
    m_disk = addSide(tr("On disk"), onDisk, sides, file);
    m_disk->setReadOnly(true);
    sides->setSizes({550, 550});
    auto* buttons = new QDialogButtonBox(QDialogButtonBox::Cancel, this);
    buttons->addButton(tr("Use the Text on the Left"), QDialogButtonBox::AcceptRole);
    connect(buttons, &QDialogButtonBox::accepted, this, &QDialog::accept);
    connect(buttons, &QDialogButtonBox::rejected, this, &QDialog::reject);
    auto* layout = new QVBoxLayout(this);
    layout->addWidget(bar);
    layout->addWidget(sides, 1);
    layout->addWidget(buttons);
    compare();
    goToHunk(0);
    connect(m_here, &QsciScintilla::textChanged, this, &MergeDialog::compare);
    connect(m_here, &QsciScintillaBase::SCN_UPDATEUI, this, [this](int) { scrollAlong(*m_here, *m_disk, true); });
    connect(m_disk, &QsciScintillaBase::SCN_UPDATEUI, this, [this](int) { scrollAlong(*m_disk, *m_here, false); });
    m_here->installEventFilter(this);
    m_here->setFocus();
}

QsciScintilla* MergeDialog::addSide(const QString& title, const std::string& text, QSplitter* sides,
                                    const QString& file) {
    auto* box = new QWidget(sides);
    auto* layout = new QVBoxLayout(box);
    layout->setContentsMargins(0, 0, 0, 0);
    layout->addWidget(new QLabel(title, box));
    auto* side = new editor::StEditor(box); // its colours and font; what is no ST has no more than words
    if (file.endsWith(".st")) side->setFile(file);
    side->load(text);
    side->setAccessibleName(title);
    const std::pair<int, QColor> marks[] = {{kDifferent, kit::colors().warning}, {kCurrent, kit::colors().accent}};
    for (const auto& [marker, colour] : marks) {
        side->markerDefine(QsciScintilla::Background, marker);
        side->setMarkerBackgroundColor(editor::lineGround(kit::colors().base, colour, marker == kCurrent ? 0.4 : 0.2),
                                       marker);
    }
    layout->addWidget(side, 1);
    sides->addWidget(box);
    return side;
}

/// Tab leaves the text, else nobody without a mouse gets to the buttons.
bool MergeDialog::eventFilter(QObject* watched, QEvent* event) {
    if (event->type() == QEvent::KeyPress) {
        const int key = static_cast<QKeyEvent*>(event)->key();
        if (key == Qt::Key_Tab || key == Qt::Key_Backtab) return focusNextPrevChild(key == Qt::Key_Tab);
    }
    return QDialog::eventFilter(watched, event);
}

std::string MergeDialog::merged() const { return textOf(*m_here); }

void MergeDialog::compare() {
    m_hunks = editor::differences(textOf(*m_here), m_onDisk);
    m_current = m_hunks.empty() ? -1 : std::clamp(m_current, 0, static_cast<int>(m_hunks.size()) - 1);
    markHunks();
}

void MergeDialog::markHunks() {
    for (QsciScintilla* side : {m_here, m_disk}) {
        side->markerDeleteAll(kDifferent);
        side->markerDeleteAll(kCurrent);
    }
    for (size_t i = 0; i < m_hunks.size(); ++i) {
        const editor::Hunk& hunk = m_hunks[i];
        const int marker = static_cast<int>(i) == m_current ? kCurrent : kDifferent;
        for (int line = hunk.hereBegin; line < hunk.hereEnd; ++line) m_here->markerAdd(line, marker);
        for (int line = hunk.otherBegin; line < hunk.otherEnd; ++line) m_disk->markerAdd(line, marker);
    }
    m_where->setText(m_hunks.empty() ? tr("No differences")
                                     : tr("Difference %1 of %2").arg(m_current + 1).arg(m_hunks.size()));
    for (QToolButton* button : m_buttons) button->defaultAction()->setEnabled(!m_hunks.empty());
}

void MergeDialog::goToHunk(int index) {
    if (m_hunks.empty()) return;
    const int count = static_cast<int>(m_hunks.size());
    m_current = (index + count) % count;
    markHunks();
    m_isScrolling = true;
    m_here->setCursorPosition(m_hunks[static_cast<size_t>(m_current)].hereBegin, 0);
    m_here->setFirstVisibleLine(std::max(0, m_hunks[static_cast<size_t>(m_current)].hereBegin - 5));
    m_disk->setFirstVisibleLine(std::max(0, m_hunks[static_cast<size_t>(m_current)].otherBegin - 5));
    m_isScrolling = false;
}

void MergeDialog::setLeft(const std::string& text) {
    m_here->SendScintilla(S::SCI_SETTARGETRANGE, 0UL, static_cast<long>(m_here->length()));
    m_here->SendScintilla(S::SCI_REPLACETARGET, static_cast<unsigned long>(text.size()), text.c_str()); // one undo
}

void MergeDialog::takeOver() {
    if (m_current < 0) return;
    const int at = m_current;
    setLeft(editor::withHunk(merged(), m_onDisk, m_hunks[static_cast<size_t>(at)]));
    goToHunk(std::min(at, static_cast<int>(m_hunks.size()) - 1)); // the next one has its number now
}

void MergeDialog::takeAll() { setLeft(m_onDisk); }

/// The other side shows the same place.
void MergeDialog::scrollAlong(QsciScintilla& from, QsciScintilla& to, bool isFromHere) {
    if (m_isScrolling) return;
    int line = from.firstVisibleLine(), shift = 0;
    for (const editor::Hunk& hunk : m_hunks) {
        const int end = isFromHere ? hunk.hereEnd : hunk.otherEnd;
        if (end > line) break;
        shift = isFromHere ? hunk.otherEnd - hunk.hereEnd : hunk.hereEnd - hunk.otherEnd;
    }
    if (to.firstVisibleLine() == line + shift) return;
    m_isScrolling = true;
    to.setFirstVisibleLine(std::max(0, line + shift));
    m_isScrolling = false;
}

} // namespace plc::app
