#include "app/pages/conversion_dialog.h"

#include "editor/text/st_editor.h"

#include <QApplication>
#include <QClipboard>
#include <QDialogButtonBox>
#include <QLabel>
#include <QPushButton>
#include <QScreen>
#include <QSplitter>
#include <QVBoxLayout>

namespace plc::app {

ConversionDialog::ConversionDialog(const std::string& before, const std::string& after,
                                   const analysis::Conversion& conversion, analysis::TextLanguage to, QWidget* parent)
    : QDialog(parent), m_result(after) {
    const bool toSt = to == analysis::TextLanguage::St;
    setWindowTitle(
        (toSt ? tr("%1 as ST") : tr("%1 as an Instruction List")).arg(QString::fromStdString(conversion.unit)));
    resize(QSize(1000, 640).boundedTo(screen()->availableSize() - QSize(24, 48))); // with its frame
    auto* sides = new QSplitter(this);
    const auto add = [&](const std::string& text, const QString& title) {
        auto* side = new QWidget(sides);
        auto* editor = new editor::StEditor(side);
        editor->load(text);
        editor->setReadOnly(true);
        editor->setAccessibleName(title);
        auto* layout = new QVBoxLayout(side);
        layout->setContentsMargins(0, 0, 0, 0);
        layout->addWidget(new QLabel(title, side));
        layout->addWidget(editor);
    };
    add(before, toSt ? tr("Instruction list (current text)") : tr("ST (current text)"));
    add(after, toSt ? tr("The same as ST") : tr("The same as an instruction list"));
    auto* note = new QLabel(tr("Both give the same results. Replacing can be undone in one step; comments are kept, "
                               "each above its statement."),
                            this);
    note->setWordWrap(true);
    auto* buttons = new QDialogButtonBox(this);
    QPushButton* replace = buttons->addButton(tr("Replace the Text"), QDialogButtonBox::AcceptRole);
    replace->setObjectName("replace");
    QPushButton* copy = buttons->addButton(tr("Copy"), QDialogButtonBox::ActionRole);
    QPushButton* close = buttons->addButton(QDialogButtonBox::Close);
    connect(copy, &QPushButton::clicked, this,
            [this] { QApplication::clipboard()->setText(QString::fromStdString(m_result)); });
    connect(buttons, &QDialogButtonBox::accepted, this, [this] {
        emit replaceRequested();
        accept();
    });
    connect(buttons, &QDialogButtonBox::rejected, this, &QDialog::reject);
    auto* layout = new QVBoxLayout(this);
    layout->addWidget(sides, 1);
    layout->addWidget(note);
    layout->addWidget(buttons);
    setTabOrder(replace, copy); // as they are read
    setTabOrder(copy, close);
}

} // namespace plc::app
