#pragma once

#include <antinode_base/WordList.h>

namespace antinode
{
/** How files call the editor's two looks. */
inline constexpr WordList<bool, 2> themeWords { { { "dark", true }, { "light", false } } };

/** What a plug-in's window keeps for the user, whatever the host: none of it belongs to a piece, so none is in a host's state. */
struct EditorPreferences
{
    bool isDark = true;
};

/** What is kept in $XDG_CONFIG_HOME/antinode/editor.json; the defaults where there is no such file, or a broken one. Docs/FileFormats.md
    [message thread] */
EditorPreferences readPreferences();

/** Keeps them; where the file cannot be written they last as long as the window. [message thread] */
void keepPreferences (const EditorPreferences&);
} // namespace antinode
