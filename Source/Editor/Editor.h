#pragma once

#include "ContentEditor.h"
#include "EditorContent.h"

namespace antinode
{
/** The window of Antinode. */
using Editor = ContentEditor<EditorContent>;
} // namespace antinode
