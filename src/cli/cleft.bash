# Completion of the cleft command in bash. Commands, options and choices come from the help of the command itself.
_cleft()
{
    local current=${COMP_WORDS[COMP_CWORD]} previous=${COMP_WORDS[COMP_CWORD - 1]} command= word help choices
    for word in "${COMP_WORDS[@]:1:COMP_CWORD-1}"; do
        if [[ $word != -* ]]; then
            command=$word
            break
        fi
    done
    help=$("${COMP_WORDS[0]}" ${command:+"$command"} --help 2>/dev/null)

    if [[ $current == -* ]]; then
        choices=$(grep -E '^  -' <<<"$help" | cut -c1-30 | grep -oE -- '-{1,2}[a-z][a-z-]*')
    elif [[ -z $command ]]; then
        choices=$(sed -n '/^Subcommands:/,/^$/s/^  \([a-z]*\) .*/\1/p' <<<"$help")
    elif [[ $previous == -* ]]; then
        # "  --snap quality|safe|none   Rule ...": what is in capitals stands for something else.
        choices=$(sed -nE "s/^  ([^ ]*,)?$previous ([^ ]*\|[^ ]*).*/\2/p" <<<"$help" | tr '|' '\n' | grep -v '[A-Z]')
    fi
    COMPREPLY=($(compgen -W "$choices" -- "$current"))
}
complete -o default -F _cleft cleft
