// What lies over the panel while something is entered: keypad for numbers and texts, list of choices, question.
// Touch friendly: every key is at least 44 pixels. Owned by the player; main thread.
#pragma once
#include "hmi/texts/system_texts.h"
#include "hmi/view/paint/panel_theme.h"
#include "hmi/view/scene/requests.h"

#include <QWidget>

class QLabel;
class QLineEdit;
class QPushButton;
class QScrollArea;
class QGridLayout;

namespace plc::hmi {

/// What overlays need of the player: look and language.
struct OverlayLook {
    PanelTheme theme; // not a pointer: theme files are read again while an overlay is in sight
    const TextCatalog* texts = nullptr;
    QString tag;
};

/// A sheet over the whole player with a box in it; a press beside the box cancels.
class Overlay : public QWidget {
    Q_OBJECT
public:
    Overlay(const OverlayLook& look, QWidget* parent);
    QWidget* box() const { return m_box; }

signals:
    void cancelled();

protected:
    void paintEvent(QPaintEvent* event) override;
    void mousePressEvent(QMouseEvent* event) override;
    void keyPressEvent(QKeyEvent* event) override;
    bool eventFilter(QObject* watched, QEvent* event) override;
    void place();
    QPushButton* key(const QString& text, bool isMain = false) const;
    /// Also reached with the arrow keys and pressed with Enter or Space.
    QPushButton* choice(const QString& text, bool isMain = false) const;
    QString words(SystemText text) const { return systemText(*m_look.texts, text, m_look.tag); }

    OverlayLook m_look;
    QWidget* m_box = nullptr;
};

class Keypad final : public Overlay {
    Q_OBJECT
public:
    Keypad(const EntryRequest& request, const OverlayLook& look, QWidget* parent);
    QString entered() const;
    /// As a key of the keypad does.
    void type(const QString& text);
    void accept();
    QString complaint() const;

signals:
    /// The value in the unit and type of the variable.
    void accepted(const plc::hmi::EntryRequest& request, const plc::hmi::Value& value);

protected:
    void keyPressEvent(QKeyEvent* event) override;

private:
    void addNumberKeys(QGridLayout* grid);
    void addLetterKeys(QGridLayout* grid);
    void addKeys(QGridLayout* grid, int row, const QString& letters, bool isShown);
    void addCommands(QGridLayout* grid, int row, int columns);
    void complain(const QString& text);
    std::optional<double> number() const;
    QString limitsText() const;
    EntryRequest m_request;
    QLineEdit* m_edit = nullptr;
    QLabel* m_hint = nullptr;
    std::vector<QPushButton*> m_letters;
    bool m_shift = false, m_untouched = true;
    bool m_wasRefused = false; // the next digit begins another number
};

class ChoiceList final : public Overlay {
    Q_OBJECT
public:
    ChoiceList(const ChoiceRequest& request, const OverlayLook& look, QWidget* parent);

signals:
    void chosen(const plc::hmi::ChoiceRequest& request, int index);

protected:
    bool eventFilter(QObject* watched, QEvent* event) override;

private:
    QScrollArea* m_area = nullptr;
};

class Question final : public Overlay {
    Q_OBJECT
public:
    Question(const ConfirmRequest& request, const OverlayLook& look, QWidget* parent);

signals:
    void confirmed(const plc::hmi::WriteRequest& write);
};

} // namespace plc::hmi
