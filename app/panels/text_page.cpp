#include "app/panels/text_page.h"

#include "editor/kit/theme.h"
#include "editor/text/line_ground.h"
#include "projects/storage/project_file.h"

#include <QFontDatabase>
#include <QLabel>
#include <QVBoxLayout>
#include <Qsci/qsciscintilla.h>

namespace plc::app {

namespace {
constexpr int kWrong = 1, kNumbers = 0;
}

TextPage::TextPage(const QString& path, QWidget* parent)
    : QWidget(parent), m_path(path), m_problem(new QLabel(this)), m_text(new QsciScintilla(this)) {
    const kit::ThemeColors& c = kit::colors();
    m_problem->setWordWrap(true);
    m_problem->setContentsMargins(8, 4, 8, 4);
    m_problem->setStyleSheet(QString("QLabel { background: %1; color: %2; }").arg(c.bad.name(), c.base.name()));
    m_problem->hide();
    m_text->setUtf8(true);
    m_text->setFont(QFontDatabase::systemFont(QFontDatabase::FixedFont));
    m_text->setPaper(c.base);
    m_text->setColor(c.text);
    m_text->setCaretForegroundColor(c.text);
    m_text->setSelectionBackgroundColor(c.selection);
    m_text->setMarginsBackgroundColor(c.window);
    m_text->setMarginsForegroundColor(c.muted);
    m_text->setMarginType(kNumbers, QsciScintilla::NumberMargin);
    m_text->setMarginWidth(kNumbers, " 9999");
    m_text->setBraceMatching(QsciScintilla::SloppyBraceMatch);
    m_text->setAutoIndent(true);
    m_text->setTabWidth(2);
    m_text->setIndentationsUseTabs(false);
    m_text->markerDefine(QsciScintilla::Background, kWrong);
    m_text->setMarkerBackgroundColor(editor::lineGround(c.base, c.bad, 0.27), kWrong);
    m_text->setAccessibleName(path.section('/', -1));
    if (const auto bytes = projects::readFile(path.toStdString())) {
        m_text->setText(QString::fromStdString(*bytes));
        m_disk.taken(path, *bytes);
    }
    m_text->setModified(false);
    auto* layout = new QVBoxLayout(this);
    layout->setContentsMargins(0, 0, 0, 0);
    layout->setSpacing(0);
    layout->addWidget(m_problem);
    layout->addWidget(m_text, 1);
    setFocusProxy(m_text);
    connect(m_text, &QsciScintilla::modificationChanged, this, &TextPage::modifiedChanged);
}

bool TextPage::isModified() const { return m_text->isModified(); }
QString TextPage::shownProblem() const { return m_problem->isHidden() ? QString() : m_problem->text(); }

void TextPage::showProblem(const QString& message, int line) {
    m_text->markerDeleteAll(kWrong);
    m_problem->setVisible(!message.isEmpty());
    m_problem->setText(line > 0 ? tr("Line %1: %2").arg(line).arg(message) : message);
    if (line < 1 || line > m_text->lines()) return;
    m_text->markerAdd(line - 1, kWrong);
    m_text->setCursorPosition(line - 1, 0);
    m_text->ensureLineVisible(line - 1);
}

Result<void> TextPage::save() {
    if (auto written = m_disk.write(m_path, m_text->text().toStdString()); !written) return written;
    m_text->setModified(false);
    emit saved();
    return {};
}

} // namespace plc::app
