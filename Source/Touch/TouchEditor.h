#pragma once

#include "TouchContent.h"

#include <Editor/ContentEditor.h>

namespace antinode
{
/** The window of Antinode Touch. */
using TouchEditor = ContentEditor<TouchContent>;
} // namespace antinode
