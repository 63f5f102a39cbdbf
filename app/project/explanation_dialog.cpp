#include "app/project/explanation_dialog.h"

#include "editor/kit/message_text.h"
#include "editor/kit/texts.h"
#include "projects/analysis/explanation.h"

#include <QDialogButtonBox>
#include <QFontDatabase>
#include <QScreen>
#include <QTextBrowser>
#include <QVBoxLayout>

namespace plc::app {

namespace {

QString programHtml(const QString& title, std::string_view program) {
    return "<h3>" + title + "</h3><pre>" + kit::fromView(analysis::numbered(program)).toHtmlEscaped() + "</pre>";
}

} // namespace

ExplanationDialog::ExplanationDialog(QWidget* parent) : QDialog(parent), m_page(new QTextBrowser(this)) {
    setObjectName("explanation");
    resize(QSize(620, 620).boundedTo(screen()->availableSize() - QSize(24, 48))); // with its frame
    m_page->setAccessibleName(tr("Explanation"));
    m_page->document()->setDefaultStyleSheet(
        QString("pre { font-family: '%1'; }").arg(QFontDatabase::systemFont(QFontDatabase::FixedFont).family()));
    auto* buttons = new QDialogButtonBox(QDialogButtonBox::Close, this);
    connect(buttons, &QDialogButtonBox::rejected, this, &QDialog::reject);
    auto* layout = new QVBoxLayout(this);
    layout->addWidget(m_page);
    layout->addWidget(buttons);
}

bool ExplanationDialog::show(const QString& code) {
    const auto shown = analysis::explain(code.toStdString());
    if (!shown) return false;
    QString html;
    for (const diagnostics::Diagnostic& finding : shown->findings) {
        const QString text = kit::messageText(finding.message).toHtmlEscaped();
        html += "<p>";
        if (finding.range.file.isValid())
            //: an example's line, then what is wrong there
            html += tr("Line %1: %2")
                        .arg((*shown->checkedWrong.sources)[finding.range.file].lineColumn(finding.range.begin).line)
                        .arg(text);
        else
            html += text;
        html += "</p>";
        for (const diagnostics::Fix& fix : finding.fixes)
            html += "<p>→ " + kit::messageText(fix.title).toHtmlEscaped() + "</p>";
    }
    setWindowTitle(tr("What %1 Means").arg(kit::fromView(diagnostics::codeOf(shown->kind))));
    m_page->setHtml(programHtml(tr("Wrong"), shown->wrong) + html + programHtml(tr("Right"), shown->right));
    QDialog::show();
    raise();
    activateWindow();
    return true;
}

} // namespace plc::app
