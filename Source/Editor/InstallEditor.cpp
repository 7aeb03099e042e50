#include "InstallEditor.h"

#include "Editor.h"
#include "EditorPreferences.h"

#include <memory>

namespace antinode
{
void installEditor()
{
    AntinodeProcessor::makeEditor = [] (AntinodeProcessor& processor)
    {
        auto editor = std::make_unique<Editor> (processor);
        auto& content = editor->content();
        auto& settings = content.settingsPanel();
        const auto preferences = readPreferences();
        content.setDark (preferences.isDark);
        settings.setScale (preferences.scale);
        editor->setContentScale (preferences.scale);
        content.onTheme = [&content] { keepPreferences ({ content.isDark(), readPreferences().scale }); };
        settings.onScale = [&content, shown = editor.get()] (double scale)
        {
            shown->setContentScale (scale);
            keepPreferences ({ content.isDark(), scale });
        };
        return editor.release();
    };
}
} // namespace antinode
