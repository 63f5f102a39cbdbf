// A panel ready to be painted and operated: element views over a value source, texts and alarms. No widget, so the same
// scene draws in the designer, the player, a test and a picture file. Owned by its widget or test; main thread.
#pragma once
#include "hmi/alarms/alarm_book.h"
#include "hmi/model/edit.h"
#include "hmi/model/faceplate.h"
#include "hmi/view/paint/picture_file.h"
#include "hmi/view/scene/element_view.h"

#include <QImage>
#include <QObject>
#include <QRegion>
#include <QSet>
#include <QTransform>

namespace plc::hmi {

class FaceplateView;
class RecipeFile;

class PanelScene final : public QObject {
    Q_OBJECT
public:
    /// `make` is makeElementView, which knows all kinds.
    explicit PanelScene(MakeElementView make, QObject* parent = nullptr);
    ~PanelScene() override;

    void setPanel(const Panel& panel);
    /// Follows an edit of the same panel: only what was touched is made again.
    void follow(const Panel& panel, const Touched& touched);
    /// The source must outlive the scene or be replaced before it goes; null: nothing has a value.
    void setValues(ValueSource* values);
    void setTexts(const TextCatalog* texts);
    void setAlarms(AlarmBook* alarms);
    /// Where faceplates are found; before the panel, or the panel is made again.
    void setFaceplates(PanelLookup panels);
    /// What a frame's panel area shows; none: nothing.
    void setArea(const QString& panel, const Arguments& arguments);
    const QString& areaPanel() const { return m_area; }
    /// The name of the panel that the operator is on, for navigation bars.
    void setCurrentPanel(const QString& name);
    const QString& currentPanel() const { return m_current; }
    /// The project's themes besides the built-in ones; before the panel, or the panel is made again.
    void setThemes(const PanelThemes& themes);
    /// Another theme than the panel's own; empty: the panel's.
    void setTheme(const QString& name);
    QString themeName() const { return m_themeName.isEmpty() ? m_panel.text("theme") : m_themeName; }
    /// Flow, rotation and blinking are shown by shape, without movement.
    void setReducedMotion(bool reduced);
    bool isMotionReduced() const { return m_isMotionReduced; }
    /// The screen's size, which panels with anchors take; empty: as designed.
    void setScreen(QSizeF screen);
    /// The project's recipes; they must outlive the scene. Called again when they are others.
    void setRecipes(const RecipeFile* recipes);
    const RecipeFile* recipes() const { return m_recipes; }
    /// Who may operate an element that names roles; none: everybody.
    using AccessCheck = std::function<bool(const QString& roles)>;
    void setAccess(AccessCheck check);
    /// Who is logged in, as user fields show it; empty: nobody.
    void setUser(const QString& name);
    const QString& user() const { return m_user; }
    void setLanguage(const QString& tag);
    /// Folder to which image files are relative (the project's).
    void setFolder(const QString& folder) { m_folder = folder; }
    /// The project allows pictures outside its folder.
    void setPicturesOutside(bool allowed) { m_picturesOutside = allowed; }
    /// Unbound elements show sample values, and nothing reacts to being pressed.
    void setDesigning(bool designing);
    /// Position of the recording that alarm lists show; none: the present.
    void setAlarmPosition(std::optional<quint64> position);

    const Panel& panel() const { return m_panel; }
    QSize size() const { return m_panel.size(); }
    const PanelTheme& theme() const { return *m_theme; }
    ValueSource* values() const { return m_values; }
    const TextCatalog& texts() const { return *m_texts; }
    AlarmBook* alarms() const { return m_alarms; }
    std::optional<quint64> alarmPosition() const { return m_alarmPosition; }
    const QString& language() const { return m_language; }
    const QString& folder() const { return m_folder; }
    PictureFolder pictures() const { return {m_folder, m_picturesOutside}; }
    const Panel* panelNamed(const QString& name) const { return m_panels ? m_panels(name) : nullptr; }
    bool isDesigning() const { return m_designing; }
    /// Placeholders without a value are filled with wide figures, for the check of sizes.
    void setMeasuring(bool measuring) { m_measuring = measuring; }
    bool isMeasuring() const { return m_measuring; }
    bool isLit() const { return m_lit; }

    /// Reads all values at a time in ms (any epoch); returns what must be repainted. At most one repaint per frame.
    QRegion refresh(qint64 milliseconds);
    /// Whether this view was among what had to be painted since it was asked last.
    bool takeMark(ElementView& view) const;
    /// Painted between the background and the elements: the designer's grid.
    void setUnderlay(std::function<void(QPainter&)> underlay) { m_underlay = std::move(underlay); }
    /// Paints what lies in `clip`; with a region (in device coordinates of `toDevice`) only the elements that touch it.
    void paint(QPainter& painter, const QRectF& clip, const QRegion* region = nullptr, const QTransform& toDevice = {});
    /// One element alone, in panel coordinates; nothing when it is not shown.
    void paintElement(QPainter& painter, ElementView& view) const;
    QImage picture(double scale = 1);

    void press(QPointF at);
    void move(QPointF at);
    void release(QPointF at);
    void wheel(QPointF at, double steps);
    /// The element drawn at a point, or null; `anyKind` also finds what does not react.
    ElementView* viewAt(QPointF at, bool anyKind = false) const;
    ElementView* view(const ElementId& id) const;
    const std::vector<std::unique_ptr<ElementView>>& views() const { return m_views; }
    ElementView* pressedView() const { return m_pressed; }
    /// Where the element is drawn now, motion included.
    QRectF shownRect(const ElementView& view) const;
    bool isShown(const ElementView& view) const;
    bool isEnabled(const ElementView& view) const;
    /// What it and what it lies in may be operated by who is logged in.
    bool isAllowed(const ElementView& view) const;
    /// The roles that the view, or the first around it that is refused, is kept for.
    QString rolesFor(const ElementView& view) const;
    /// The faceplate in which a view is drawn, or null for an element of the panel itself.
    const FaceplateView* faceplateOf(const ElementView& view) const;
    /// A view of what a placed faceplate contains: no element of the panel.
    bool isInner(const ElementView& view) const { return m_inner.contains(&view); }

    // Called by element views.
    void markDirty(const ElementView& view);
    void request(const WriteRequest& write, const QString& confirm);
    void request(const EntryRequest& entry) { emit entryRequested(entry); }
    void request(const ChoiceRequest& choice) { emit choiceRequested(choice); }
    void request(const AcknowledgeRequest& acknowledge) { emit acknowledgeRequested(acknowledge); }
    void request(const NavigationRequest& navigation) { emit navigationRequested(navigation); }
    void request(const AlarmDetailRequest& alarm) { emit alarmDetailRequested(alarm); }
    void request(const RecipeRequest& recipe) { emit recipeRequested(recipe); }
    void request(const AccessRequest& access) { emit accessRequested(access); }
    void requestPanel(const QString& name) { emit panelRequested(name); }
    void requestLanguage(const QString& tag) { emit languageRequested(tag); }
    void requestTheme(const QString& name) { emit themeRequested(name); }

signals:
    void writeRequested(const plc::hmi::WriteRequest& write);
    void confirmRequested(const plc::hmi::ConfirmRequest& confirm);
    void entryRequested(const plc::hmi::EntryRequest& entry);
    void choiceRequested(const plc::hmi::ChoiceRequest& choice);
    void acknowledgeRequested(const plc::hmi::AcknowledgeRequest& acknowledge);
    void navigationRequested(const plc::hmi::NavigationRequest& navigation);
    void alarmDetailRequested(const plc::hmi::AlarmDetailRequest& alarm);
    void recipeRequested(const plc::hmi::RecipeRequest& recipe);
    void accessRequested(const plc::hmi::AccessRequest& access);
    void panelRequested(const QString& name);
    void languageRequested(const QString& tag);
    void themeRequested(const QString& name);
    void dirtied();

private:
    void rebuild();
    void addView(const Element& element, bool isInner);
    void prepareAll();
    QTransform transformOf(const ElementView& view) const;
    void addDirty(const ElementView& view, const QRectF& before);

    void take(const Panel& panel);
    const ElementView* refusedAt(const ElementView& view) const;

    MakeElementView m_make;
    Panel m_designed; // as its file has it
    Panel m_panel;    // as the screen shows it
    QSizeF m_screen;
    QString m_area, m_current, m_user;
    Arguments m_areaArguments;
    AccessCheck m_access;
    const RecipeFile* m_recipes = nullptr;
    PanelThemes m_themes;
    QString m_themeName; // in place of the panel's own
    const PanelTheme* m_theme;
    ValueSource* m_values = nullptr;
    TextCatalog m_noTexts;
    const TextCatalog* m_texts;
    AlarmBook* m_alarms = nullptr;
    PanelLookup m_panels;
    QString m_language, m_folder;
    bool m_picturesOutside = false;
    bool m_designing = false, m_measuring = false, m_isMotionReduced = false, m_lit = true, m_allDirty = true;
    std::optional<quint64> m_alarmPosition;
    std::vector<std::unique_ptr<ElementView>> m_views;
    QHash<ElementId, ElementView*> m_byId;
    QSet<const ElementView*> m_inner;
    ElementView* m_pressed = nullptr;
    std::vector<QRect> m_dirty;
    std::function<void(QPainter&)> m_underlay;
    QHash<const ElementView*, QRectF> m_lastRects; // of those that move
    qint64 m_frame = -1;
    quint64 m_revision = 0;
};

} // namespace plc::hmi
