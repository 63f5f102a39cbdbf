#include "editor/kit/trash.h"

#include <QDir>
#include <QFile>
#include <QTemporaryDir>

#include <gtest/gtest.h>

namespace plc::kit {
namespace {

TEST(Trash, WhatIsDeletedDoesNotGoIntoTheCurrentFolderWhereNobodyHasHadATrash) {
    const QTemporaryDir folder;
    const QString before = QDir::currentPath();
    const QByteArray data = qgetenv("XDG_DATA_HOME");
    qputenv("XDG_DATA_HOME", (folder.path() + "/home/.local/share").toUtf8());
    ASSERT_TRUE(QDir(folder.path()).mkpath("current") && QDir::setCurrent(folder.path() + "/current"));
    QFile file(folder.path() + "/motor.st");
    ASSERT_TRUE(file.open(QIODevice::WriteOnly));
    file.close();
    EXPECT_TRUE(removeToTrash(file.fileName()));
    EXPECT_FALSE(file.exists());
    EXPECT_EQ(QDir().entryList(QDir::AllEntries | QDir::NoDotAndDotDot), QStringList());
    EXPECT_FALSE(removeToTrash(file.fileName())) << "there is none";
    QDir::setCurrent(before);
    data.isNull() ? qunsetenv("XDG_DATA_HOME") : qputenv("XDG_DATA_HOME", data);
}

} // namespace
} // namespace plc::kit
