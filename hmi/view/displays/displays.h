// Views that show one value: number, date and time, lamp, multi-state indicator, 7-segment display, progress.
#pragma once
#include "hmi/view/scene/element_view.h"

namespace plc::hmi {

class NumericDisplayView final : public ElementView {
public:
    using ElementView::ElementView;
    void collectTexts(const QString& tag, std::vector<TextBox>& out) const override;

protected:
    void setUp() override;
    bool update() override;
    void draw(QPainter& painter) override;

private:
    TextBox caption(const QString& tag) const;
    TextBox number(const QString& words, const QString& tag) const;
    Slot m_value;
    QString m_shown, m_caption;
    int m_priority = 0;
};

class DateTimeView final : public ElementView {
public:
    using ElementView::ElementView;
    void collectTexts(const QString& tag, std::vector<TextBox>& out) const override;

protected:
    void setUp() override;
    bool update() override;
    void draw(QPainter& painter) override;
    bool advance(qint64 milliseconds) override;

private:
    QString words(qint64 nanoseconds, ValueKind kind, const QString& tag) const;
    TextBox label(const QString& words, const QString& tag) const;
    Slot m_value;
    QString m_shown;
};

class LampView final : public ElementView {
public:
    using ElementView::ElementView;
    void collectTexts(const QString& tag, std::vector<TextBox>& out) const override;

protected:
    void setUp() override;
    bool update() override;
    void draw(QPainter& painter) override;

private:
    QRectF lens() const;
    TextBox label(const QString& tag) const;
    Slot m_value;
    bool m_on = false, m_isKnown = false;
    QString m_shown;
};

class MultiStateView final : public ElementView {
public:
    using ElementView::ElementView;
    void collectTexts(const QString& tag, std::vector<TextBox>& out) const override;

protected:
    void setUp() override;
    bool update() override;
    void draw(QPainter& painter) override;

private:
    QString stateText(int state, const QString& tag) const;
    TextBox label(const QString& words, const QByteArray& place, const QString& tag) const;
    Slot m_value;
    std::vector<BoundState> m_states;
    int m_present = -1;
    QString m_shown;
};

class SevenSegmentView final : public ElementView {
public:
    using ElementView::ElementView;

protected:
    void setUp() override;
    bool update() override;
    void draw(QPainter& painter) override;

private:
    Slot m_value;
    QString m_digits;
};

class ProgressView final : public ElementView {
public:
    using ElementView::ElementView;
    void collectTexts(const QString& tag, std::vector<TextBox>& out) const override;

protected:
    void setUp() override;
    bool update() override;
    void draw(QPainter& painter) override;

private:
    QString words(double share, const QString& tag) const;
    TextBox label(const QString& words, const QString& tag) const;
    Slot m_value;
    double m_share = 0;
    bool m_isKnown = false;
    QString m_shown;
};

} // namespace plc::hmi
