#pragma once

#include <stdexcept>
#include <string>

namespace antinode
{
/** Bad input of any kind: a file, an option, a state. The text is a sentence for the user: where, what is wrong, what
   is allowed. Lower modules name fields ("focus: growth"), the command line turns them into keys and options; exit
   code 1.
*/
class InputError : public std::runtime_error
{
public:
    /** @param where  file and place in it, a field or an option, for example "my.json: /ceramics/3/x_mm"
        @param wrong  what is wrong and what is allowed, for example "is -7; allowed: 0 to 200" */
    InputError (const std::string& where, const std::string& wrong)
        : std::runtime_error (where.empty() ? wrong : where + ": " + wrong)
    {
    }
};
} // namespace antinode
