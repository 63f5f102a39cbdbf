// The text editor's way to translators' tools and back.
#include "hmi/designer/editors/text_editor.h"

#include "editor/kit/message_text.h"
#include "hmi/station/text_exchange.h"
#include "projects/storage/project_file.h"

#include <QComboBox>
#include <QDialog>
#include <QDialogButtonBox>
#include <QFileDialog>
#include <QFormLayout>
#include <QMessageBox>

namespace plc::hmi {

void TextEditor::exportXliff(const QString& path, const QString& from, const QString& to, XliffVersion version) const {
    const PanelProject& project = m_context.project();
    const XliffOptions options{version, from, to, project.placeOf(project.textsPath()), placesOfTexts(project)};
    const auto written = projects::writeFileAtomically(path.toStdString(), writeXliff(m_model->table(), options));
    if (!written)
        QMessageBox::warning(const_cast<TextEditor*>(this), tr("Export XLIFF"), kit::messageText(written.error()));
}

std::optional<XliffReport> TextEditor::importXliff(const QString& path) {
    const auto bytes = projects::readFile(path.toStdString());
    const auto file = bytes ? readXliff(*bytes, path) : Result<XliffFile>(bytes.error());
    if (!file) {
        QMessageBox::warning(this, tr("Import XLIFF"), kit::messageText(file.error()));
        return {};
    }
    XliffReport report;
    m_model->edit(tr("Import XLIFF"), [&](TextTable& table) { report = takeXliff(table, *file, path); });
    return report;
}

/// Which languages and which version, then the file.
void TextEditor::askForXliff() {
    QDialog dialog(this);
    dialog.setWindowTitle(tr("Export XLIFF"));
    auto* from = new QComboBox;
    auto* to = new QComboBox;
    for (const QString& tag : m_model->table().tags())
        for (QComboBox* box : {from, to}) box->addItem(QStringLiteral("%1 (%2)").arg(nativeName(tag), tag), tag);
    to->setCurrentIndex(to->count() > 1 ? 1 : 0);
    auto* version = new QComboBox;
    version->addItem(tr("XLIFF %1").arg(QStringLiteral("2.0")));
    version->addItem(tr("XLIFF %1").arg(QStringLiteral("1.2")));
    auto* form = new QFormLayout(&dialog);
    form->addRow(tr("Translated from"), from);
    form->addRow(tr("Translated into"), to);
    form->addRow(tr("Version"), version);
    auto* buttons = new QDialogButtonBox(QDialogButtonBox::Ok | QDialogButtonBox::Cancel);
    connect(buttons, &QDialogButtonBox::accepted, &dialog, &QDialog::accept);
    connect(buttons, &QDialogButtonBox::rejected, &dialog, &QDialog::reject);
    form->addRow(buttons);
    if (dialog.exec() != QDialog::Accepted) return;
    const QString tag = to->currentData().toString();
    const QString path = QFileDialog::getSaveFileName(this, tr("Export XLIFF"), QStringLiteral("texts.%1.xlf").arg(tag),
                                                      tr("Translations (*.xlf *.xliff)"));
    if (!path.isEmpty())
        exportXliff(path, from->currentData().toString(), tag,
                    version->currentIndex() == 0 ? XliffVersion::V20 : XliffVersion::V12);
}

/// What came of an import, with the lines of what did not fit below.
void TextEditor::showReport(const XliffReport& report) {
    QMessageBox box(report.remarks.empty() ? QMessageBox::Information : QMessageBox::Warning, tr("Import XLIFF"),
                    tr("%n text(s) taken.", nullptr, report.taken) + u'\n' +
                        tr("%n text(s) as they were.", nullptr, report.same) + u'\n' +
                        tr("%n text(s) without a translation.", nullptr, report.empty),
                    QMessageBox::Ok, this);
    QStringList lines;
    for (const Error& remark : report.remarks)
        lines += QString::fromStdString(remark.place) + QStringLiteral(": ") + kit::messageText(remark.message);
    box.setDetailedText(lines.join(u'\n'));
    box.exec();
}

} // namespace plc::hmi
