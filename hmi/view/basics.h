// Views of texts, images, symbols, and the placeholder for kinds that this version does not know.
#pragma once
#include "hmi/view/element_view.h"

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
    Slot m_state, m_warning, m_fault, m_level;
    bool m_running = false, m_isWarning = false, m_isFault = false;
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
