#include "InstallEditor.h"

#include "Editor.h"

namespace antinode
{
void installEditor()
{
    AntinodeProcessor::makeEditor = [] (AntinodeProcessor& processor)
    {
        auto editor = editorAsLeft<EditorContent> (processor);
        auto& content = editor->content();
        auto& settings = content.settingsPanel();
        settings.setScale (readPreferences().scale);
        settings.onScale = [&content, shown = editor.get()] (double scale)
        {
            shown->setContentScale (scale);
            keepPreferences ({ content.isDark(), scale });
        };
        return editor.release();
    };
}
} // namespace antinode
