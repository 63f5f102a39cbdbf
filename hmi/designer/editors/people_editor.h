// The users of the project's panels and their roles as two tables, with undo. Passwords are set, never shown. Owned by
// its Qt parent; the context must outlive it. Main thread.
#pragma once
#include "hmi/designer/context/design_context.h"

#include <QUndoStack>
#include <QWidget>

class QLabel;
class QSpinBox;
class QTableWidget;

namespace plc::hmi {

class PeopleEditor final : public QWidget {
    Q_OBJECT
public:
    enum UserColumn { Name, Roles, Language, StartPanel, Password };
    enum RoleColumn { RoleName, RoleTitle, RoleStartPanel };
    explicit PeopleEditor(DesignContext& context, QWidget* parent = nullptr);
    QUndoStack& undoStack() { return m_undo; }
    QTableWidget& users() { return *m_users; }
    QTableWidget& roles() { return *m_roles; }
    QSpinBox& timeout() { return *m_timeout; }
    QString problem() const;

    void addUser();
    void addRole();
    void removeSelectedUser();
    void removeSelectedRole();
    /// Why it is refused is said below the tables.
    bool setPassword(int row, const QString& password);

private:
    void edit(const QString& title, const std::function<void(PeopleFile&)>& change,
              const DesignContext::NamesInPanels& names = {});
    void commitUser(int row, int column, const QString& text);
    void commitRole(int row, int column, const QString& text);
    void renameRole(int row, const QString& name);
    void setRoles(int row, const QString& text);
    void askForPassword();
    void rebuild();
    void offerChoices();
    bool isPanel(const QString& name) const;
    bool isLanguage(const QString& tag) const;
    void refuse(const Message& why);
    void tell(const Message& problem);

    DesignContext& m_context;
    QUndoStack m_undo;
    QTableWidget *m_users, *m_roles;
    QSpinBox* m_timeout;
    QLabel* m_problem;
};

} // namespace plc::hmi
