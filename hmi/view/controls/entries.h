// Views of values that are typed: number, text, masked entry. Pressing one asks the player for a keypad.
#pragma once
#include "hmi/view/scene/element_view.h"

namespace plc::hmi {

class EntryView : public ElementView {
public:
    using ElementView::ElementView;
    bool isInteractive() const override { return true; }
    void release(QPointF at, bool inside) override;
    void collectTexts(const QString& tag, std::vector<TextBox>& out) const override;

protected:
    void setUp() override;
    bool update() override;
    void draw(QPainter& painter) override;
    virtual QString contents(const Value& value, const QString& tag) const = 0;
    virtual void fill(EntryRequest& entry) const = 0;
    virtual QString sample() const = 0;
    TextBox label(const QString& words, const QString& tag) const;

    Slot m_target;
    QString m_shown;
};

class NumericEntryView final : public EntryView {
public:
    using EntryView::EntryView;

protected:
    void setUp() override;
    QString contents(const Value& value, const QString& tag) const override;
    void fill(EntryRequest& entry) const override;
    QString sample() const override { return formatted(42.5, "format", unit()); }

private:
    Slot m_minimum, m_maximum;
};

class TextEntryView final : public EntryView {
public:
    using EntryView::EntryView;

protected:
    QString contents(const Value& value, const QString& tag) const override;
    void fill(EntryRequest& entry) const override;
    QString sample() const override { return QStringLiteral("Abc"); }
};

class MaskedEntryView final : public EntryView {
public:
    using EntryView::EntryView;

protected:
    QString contents(const Value& value, const QString& tag) const override;
    void fill(EntryRequest& entry) const override;
    QString sample() const override;
};

} // namespace plc::hmi
