#pragma once

#include "PlateContent.h"

#include <Editor/ContentEditor.h>

namespace antinode
{
/** The window of Antinode Plate. */
using PlateEditor = ContentEditor<PlateContent>;
} // namespace antinode
