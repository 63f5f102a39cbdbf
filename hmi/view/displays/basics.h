// Views of texts, images, symbols, and the placeholder for kinds that this version does not know.
#pragma once
#include "hmi/view/scene/element_view.h"

#include <QPixmap>

namespace plc::hmi {

class TextView final : public ElementView {
public:
    using ElementView::ElementView;
    void collectTexts(const QString& tag, std::vector<TextBox>& out) const override;

protected:
    void setUp() override {}
    bool update() override;
    void draw(QPainter& painter) override;

private:
    TextBox label(const QString& tag) const;
    QString m_shown;
};

class ImageView final : public ElementView {
public:
    using ElementView::ElementView;

protected:
    void setUp() override;
    void draw(QPainter& painter) override;

private:
    QString m_file;
    QPixmap m_picture;
};

class SymbolView final : public ElementView {
public:
    using ElementView::ElementView;
    double overhang() const override { return 6; }
    void collectTexts(const QString& tag, std::vector<TextBox>& out) const override;

protected:
    void setUp() override;
    bool update() override;
    void draw(QPainter& painter) override;
    bool advance(qint64 milliseconds) override;

private:
    QRectF artRect() const;
    TextBox label(const QString& tag) const;
    QColor bodyColor() const;
    void drawAlarmMark(QPainter& painter, const QRectF& art);
    void drawStateMarks(QPainter& painter, const QRectF& art) const;
    /// What the bindings say, after ISA-5.1 and ISA-101: each state has a shape of its own.
    struct State {
        bool running = false, warning = false, fault = false;
        bool closed = false, transit = false, manual = false, service = false;
        bool operator==(const State&) const = default;
    };
    /// Open and closed at once: a limit switch or its wire is broken.
    bool contradicts() const { return m_now.running && m_now.closed; }
    Slot m_state, m_warning, m_fault, m_closed, m_transit, m_manual, m_service, m_level;
    State m_now;
    int m_shownLevel = 0; // percent
    int m_frame = 0;
};

class UnknownView final : public ElementView {
public:
    using ElementView::ElementView;

protected:
    void setUp() override {}
    void draw(QPainter& painter) override;
};

} // namespace plc::hmi
