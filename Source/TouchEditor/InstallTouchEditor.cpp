#include "InstallTouchEditor.h"

#include "TouchEditor.h"

#include <Editor/EditorPreferences.h>

#include <memory>

namespace antinode
{
void installTouchEditor()
{
    TouchProcessor::makeEditor = [] (TouchProcessor& processor)
    {
        auto editor = std::make_unique<TouchEditor> (processor);
        auto& content = editor->content();
        const auto preferences = readPreferences();
        content.setDark (preferences.isDark);
        editor->setContentScale (preferences.scale);
        content.onTheme = [&content] { keepPreferences ({ content.isDark(), readPreferences().scale }); };
        return editor.release();
    };
}
} // namespace antinode
