#!/bin/bash
# Every option in --help is in the completion and the man page, and none else. Usage: options.bash SOURCE FOLDER-OF-BUILD
set -u
source=$1
programs=$2/bin
manual=$2/documents
failed=0
. "$source/Resources/Completion/antinode"

fail()
{
    echo "$*" >&2
    failed=1
}

same()
{
    [[ $2 == "$3" ]] || { fail "$1:"; diff <(echo "$2") <(echo "$3") >&2; }
}

# The long options that --help describes, read otherwise than the completion reads them: by their column.
described()
{
    grep -E '^ {2,}-' | cut -c 3-30 | grep -oE -- '(^|,)--[a-zA-Z_-]+' | tr -d , | sort -u
}

completed()
{
    COMP_WORDS=("$@")
    COMP_CWORD=$(($# - 1))
    _antinode 2>/dev/null
    printf '%s\n' "${COMPREPLY[@]}" | sort -u
}

# The options of a section of a man page, and --help, which stands at its beginning for all.
in_manual()
{
    { echo --help; sed -n "$2" "$manual/$1.1" | sed 's/\\-/-/g' | grep -E '^\.B[IR]* -' | grep -oE -- '--[a-zA-Z_-]+'; } | sort -u
}

program=$programs/antinode
commands=$("$program" --help | sed -n 's/^  \([a-z]\{1,\}\) .*/\1/p')
[[ -n $commands ]] || fail "antinode --help lists no commands"
same "commands, help and completion" "$(sort <<<"$commands")" "$(completed "$program" "")"
same "commands, help and manual" "$commands" "$(sed -n 's/^\.SS antinode \([a-z]*\).*/\1/p' "$manual/antinode.1")"

for command in $commands; do
    wanted=$("$program" "$command" --help | described)
    same "options of $command, help and completion" "$wanted" "$(completed "$program" "$command" --)"
    same "options of $command, help and manual" "$wanted" "$(in_manual antinode "/^\.SS antinode $command\b/,/^\.S[SH] /{/^\.S/d;p}")"
done

# In a folder without files, which would be offered too.
empty=$(mktemp -d)
trap 'rmdir "$empty"' EXIT
cd "$empty" || exit 1

embedded()
{
    find "$source/Resources/$1" -name '*.json' -printf '%f\n' | sed 's/\.json$//' | sort
}

same "devices" "$(embedded Devices)" "$(completed "$program" modes "")"
same "focuses" "$(embedded Focuses)" "$(completed "$program" render "")"
same "formats" "$(printf '%s\n' csv mat tfw wav)" "$(completed "$program" render --format "")"

standalone=$programs/antinode-standalone

if [[ -x $standalone ]]; then
    wanted=$("$standalone" --help | described)
    same "options of the standalone program, help and completion" "$wanted" "$(completed "$standalone" --)"
    same "options of the standalone program, help and manual" "$wanted" \
        "$(in_manual antinode-standalone '/^\.SH OPTIONS/,/^\.SH EXAMPLES/p')"
fi

version=$("$program" version | cut -d ' ' -f 2)

for page in antinode antinode-standalone; do
    grep -q "^\.TH .*\"Antinode $version\"" "$2/documents/$page.1" || fail "$page.1 is not of version $version"
done

exit $failed
