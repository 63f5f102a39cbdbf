// Views of choices among several values: rotary selector, radio group, combo box, language selector.
#pragma once
#include "hmi/view/scene/element_view.h"

namespace plc::hmi {

/// What the choosing elements share: the options come from the element's list, the text list or the target's enum.
class OptionsView : public ElementView {
public:
    using ElementView::ElementView;
    bool isInteractive() const override { return true; }

protected:
    struct Option {
        Value value;
        Slot slot;    // of an option whose value is an expression
        QString text; // reference; empty: index of the text list, then the enum's name
        QString name;
    };
    void setUp() override;
    bool update() override;
    QString optionText(size_t index, const QString& tag) const;
    QByteArray optionPlace(size_t index) const;
    Value optionValue(size_t index) const;
    void choose(size_t index);

    Slot m_target;
    std::vector<Option> m_options;
    int m_selected = -1;
    bool m_fromFacts = false;
};

class RotarySelectorView final : public OptionsView {
public:
    using OptionsView::OptionsView;
    void release(QPointF at, bool inside) override;
    void collectTexts(const QString& tag, std::vector<TextBox>& out) const override;

protected:
    void draw(QPainter& painter) override;

private:
    QPointF center() const;
    double radius() const;
    double angleOf(size_t index) const; // degrees, 0 is up, clockwise
    TextBox label(size_t index, const QString& tag) const;
};

class RadioGroupView final : public OptionsView {
public:
    using OptionsView::OptionsView;
    void release(QPointF at, bool inside) override;
    void collectTexts(const QString& tag, std::vector<TextBox>& out) const override;

protected:
    void draw(QPainter& painter) override;

private:
    QRectF cell(size_t index) const;
    TextBox label(size_t index, const QString& tag) const;
};

class ComboBoxView final : public OptionsView {
public:
    using OptionsView::OptionsView;
    void release(QPointF at, bool inside) override;
    void collectTexts(const QString& tag, std::vector<TextBox>& out) const override;

protected:
    void draw(QPainter& painter) override;

private:
    TextBox label(const QString& words, const QByteArray& place, const QString& tag) const;
};

class LanguageSelectorView final : public ElementView {
public:
    using ElementView::ElementView;
    bool isInteractive() const override { return true; }
    void release(QPointF at, bool inside) override;
    void collectTexts(const QString& tag, std::vector<TextBox>& out) const override;

protected:
    void setUp() override;
    void draw(QPainter& painter) override;

private:
    bool m_short = false;
    QStringList tags() const;
    QString nameOf(const QString& tag) const;
    QRectF cell(qsizetype index) const;
    TextBox label(qsizetype index) const;
};

} // namespace plc::hmi
