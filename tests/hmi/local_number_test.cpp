// A literal is written for the operator as formatted numbers beside it are: with the same digits and decimal sign.
#include "hmi/texts/format.h"
#include "hmi/texts/local_number.h"

#include <gtest/gtest.h>

namespace plc::hmi {
namespace {

TEST(LocalNumber, ALiteralLooksLikeTheFormattedValueBesideIt) {
    for (const char* tag : {"en", "de", "ar", "ar-u-nu-latn", "ar-u-nu-arab", "fa", "zh-CN"}) {
        const QLocale locale = localeOf(QString::fromLatin1(tag));
        EXPECT_EQ(localNumber(QStringLiteral("90.5"), locale).toStdString(),
                  formatValue(Value::ofReal(90.5), QStringLiteral("%.1f"), locale).toStdString())
            << tag;
    }
    EXPECT_EQ(localNumber(QStringLiteral("30"), localeOf(QStringLiteral("ar"))).toStdString(), "\u0663\u0660");
}

TEST(LocalNumber, WhatIsNoNumberStaysAsItIs) {
    for (const char* literal : {"T#5s", "'rye 3'", "TRUE", "16#FF"})
        EXPECT_EQ(localNumber(QString::fromLatin1(literal), localeOf(QStringLiteral("ar"))).toStdString(), literal);
}

} // namespace
} // namespace plc::hmi
