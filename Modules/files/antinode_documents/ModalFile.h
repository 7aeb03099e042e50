#pragma once

#include <antinode_model/ModalModel.h>
#include <antinode_text/JsonReader.h>

namespace antinode
{
/** A device of kind "modal": modes, points and weights as they are given.

    Modes are sorted by frequency; where all points have the same y they are a line, sorted by x. Standard deviations
   and the delay are checked and not kept: the model has no use for them.
    @throws InputError  when sizes do not agree or a number is not allowed [worker] */
ModalModel readModalModel (const JsonValue& device);
} // namespace antinode
