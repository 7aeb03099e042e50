#pragma once

#include <stdexcept>
#include <string>

namespace antinode
{
/** Bad input of any kind: a file, an option, a state. Its text is one sentence, or two, for the user: where it is wrong,
    what is wrong there, what is allowed. The command line prints it on one line and ends with exit code 1.
*/
class InputError : public std::runtime_error
{
public:
    /** @param where  file and place in it, an option or a parameter, for example "my.json: /ceramics/3/x_mm"
        @param wrong  what is wrong there and what is allowed, for example "is -7, allowed is 0 to 200" */
    InputError (const std::string& where, const std::string& wrong)
        : std::runtime_error (where.empty() ? wrong : where + ": " + wrong)
    {
    }
};
} // namespace antinode
