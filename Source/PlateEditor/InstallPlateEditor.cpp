#include "InstallPlateEditor.h"

#include "PlateEditor.h"

#include <Editor/EditorPreferences.h>

#include <memory>

namespace antinode
{
void installPlateEditor()
{
    PlateProcessor::makeEditor = [] (PlateProcessor& processor)
    {
        auto editor = std::make_unique<PlateEditor> (processor);
        auto& content = editor->content();
        const auto preferences = readPreferences();
        content.setDark (preferences.isDark);
        editor->setContentScale (preferences.scale);
        content.onTheme = [&content] { keepPreferences ({ content.isDark(), readPreferences().scale }); };
        return editor.release();
    };
}
} // namespace antinode
