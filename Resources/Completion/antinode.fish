# Completion in fish for antinode and antinode-standalone. It reads the --help of the programs, so it is never out of date.

function __antinode_words
    set -l tokens (commandline -opc)
    set -l word (commandline -ct)
    set -l program (string replace -r '^~' $HOME $tokens[1])
    set -l catalogue (string replace -r -- '-standalone$' '' $program)
    set -l standalone (string match -r -- '-standalone$' $program)
    set -l before $tokens[-1]
    set -l command
    set -l kind

    if test -z "$standalone"
        set command (string match -v -- '-*' $tokens[2..])[1]
    end

    set -l help ($program $command --help 2>/dev/null); or return
    set -l choices (string replace -rf -- "^ *$before [^ ]*\{([^}]*)\}.*" '$1' $help)

    if test -n "$choices"
        string split , $choices
    else if string match -q -- '-*' $word
        string replace -rf -- '^ +(-[^ ]*).*' '$1' $help | string split , | string match -ra -- '^--[a-zA-Z_-]+'
    else if test "$before" = --focus -a -n "$standalone"
        set kind focus
    else if contains -- $before --instrument --plate --show; or test "$before" = --device -a -n "$command"
        set kind device
    else if test "$before" = --type -a -n "$standalone"
        string split ' ' 'ALSA JACK'
    else if string match -q -- '-*' $before; and string match -qr -- "^ *(-[^ ]*,)?$before(,-[^ ]*)? [A-Z]" $help
        __fish_complete_path $word
    else if test -z "$command" -a -z "$standalone"
        string replace -rf '^  ([a-z]+) .*' '$1' $help
    else
        set kind (string replace -rf '^  ([a-z]+) TEXT.*' '$1' $help)
    end

    switch "$kind"
        case device
            $catalogue devices 2>/dev/null | string replace -r ' .*' ''
        case focus
            $catalogue devices --focuses 2>/dev/null | string replace -r ' .*' ''
    end

    if test -n "$kind" -a "$before" != --show
        __fish_complete_suffix $word .json
    end
end

complete -c antinode -f -a '(__antinode_words)'
complete -c antinode-standalone -f -a '(__antinode_words)'
