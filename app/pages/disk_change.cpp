#include "app/pages/disk_change.h"

#include "app/pages/merge_dialog.h"

#include <QCoreApplication>
#include <QMessageBox>
#include <QPushButton>

namespace plc::app {

namespace {
class DiskChange {
    Q_DECLARE_TR_FUNCTIONS(DiskChange)
};
} // namespace

DiskAnswer askAboutDiskChange(const QString& file, const std::string& here, const std::string& onDisk,
                              QWidget* parent) {
    for (;;) {
        QMessageBox box(QMessageBox::Question, DiskChange::tr("Changed outside"),
                        DiskChange::tr("%1 was changed by another program, and here too.").arg(file),
                        QMessageBox::NoButton, parent);
        box.setInformativeText(
            DiskChange::tr("Compare both side by side, load the file from disk and lose the changes made here, or keep "
                           "what is here and replace the file with the next save?"));
        QPushButton* compare = box.addButton(DiskChange::tr("Compare…"), QMessageBox::ActionRole);
        QPushButton* load = box.addButton(DiskChange::tr("Load from Disk"), QMessageBox::DestructiveRole);
        load->setObjectName("loadFromDisk");
        compare->setObjectName("compare");
        QPushButton* keep = box.addButton(DiskChange::tr("Keep Mine"), QMessageBox::RejectRole);
        keep->setObjectName("keepMine");
        box.setDefaultButton(compare);
        box.setEscapeButton(keep);
        box.exec();
        if (box.clickedButton() == load) return {DiskChoice::LoadFromDisk, onDisk};
        if (box.clickedButton() != compare) return {DiskChoice::KeepHere, here};
        MergeDialog merge(file, here, onDisk, parent);
        if (merge.exec() == QDialog::Accepted) return {DiskChoice::Merged, merge.merged()};
    }
}

} // namespace plc::app
