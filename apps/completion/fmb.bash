# Bash completion for fmb: what fmb [COMMAND] --list-options tells, from the tables that the program
# reads its options by, and for options that take variables what the file on the line calls them.

# The line $2 of a table, by its option $1: what that takes.
_fmb_takes()
{
    local name letter takes rest
    while IFS= read -r rest; do
        name=${rest%%$'\t'*} rest=${rest#*$'\t'}
        letter=${rest%%$'\t'*} rest=${rest#*$'\t'}
        takes=${rest%%$'\t'*}
        [[ $1 == "$name" || (-n $letter && $1 == "-$letter") ]] && echo "$takes" && return
    done
}

# Variables of the file $2 as the program $1 reads it, unless it is large; those in quotes are left
# out, as a shell would need quotes of its own.
_fmb_variables()
{
    "$1" convert "${@:3}" --to fmb --quiet --max-input 1000000 -- "$2" 2>/dev/null |
        sed -n 's/"\([^"\\]\|\\.\)*"//g; s/^vars: //p; q'
}

# Offer words of $1 that go on from $2, with $3 before them. Not by compgen -W, which would carry out
# what is in them: names come from any file, and what a shell might do something about is left out.
_fmb_offer()
{
    local words word special='[]["'"'"'`$\;&|<>(){}*?!~#]'
    read -ra words <<<"${1//$'\n'/ }"
    for word in "${words[@]}"; do
        [[ $word == "$2"* && ! $word =~ $special ]] && COMPREPLY+=("$3$word")
    done
}

# Offer the words $1 behind the last comma of what is typed, those before it no more.
_fmb_offer_list()
{
    local before= words=$1 word
    [[ $cur == *,* ]] && before=${cur%,*},
    _fmb_offer "$words" "${cur##*,}" "$before"
    for word in "${!COMPREPLY[@]}"; do
        [[ ,$before == *,"${COMPREPLY[word]#"$before"}",* ]] && unset "COMPREPLY[word]"
    done
    compopt -o nospace 2>/dev/null
}

# Offer values of an option that takes $1; false: it takes none in the next word.
_fmb_offer_values()
{
    local words=
    case $1 in
        '') return 1 ;;
        NAMES) _fmb_offer_list "$(_fmb_variables "$program" "$file" "${format[@]}")" ;;
        FORM) _fmb_offer "$(_fmb_variables "$program" "$file" "${format[@]}")" "$cur" ;;
        WHAT) words="feasible infeasible bounds reduced projection= whole= optimum max= min=" ;;
        LIST*)
            [[ $option == --rules ]] &&
                _fmb_offer_list "none duplicate dominated kohler chernikov imbert box lp"
            [[ $option == --presolve ]] &&
                _fmb_offer_list "none equalities components onesided bounds refute"
            ;;
        *'|'*) words=${1//|/ } ;;
    esac
    [[ $1 == *FILE* || $1 == *OUT* ]] && compopt -o default 2>/dev/null
    words=${words//FILE/}
    _fmb_offer "$words" "$cur"
    return 0
}

_fmb()
{
    local program=${COMP_WORDS[0]/#\~/$HOME} cur=${COMP_WORDS[COMP_CWORD]} option= command= file=
    local attached= table commands takes i word format=()
    option=${COMP_WORDS[COMP_CWORD - 1]}
    if [[ $cur == = ]]; then # NAME=VALUE is three words for bash
        cur= attached=1
    elif [[ $option == = ]]; then
        option=${COMP_WORDS[COMP_CWORD - 2]} attached=1
    fi
    COMPREPLY=()
    table=$("$program" --list-options 2>/dev/null)
    commands=$(sed -n 's/^\([a-z]*\)\t.*/\1/p' <<<"$table")
    for ((i = 1; i < ${#COMP_WORDS[@]}; i++)); do
        word=${COMP_WORDS[i]//\\/}
        ((i == COMP_CWORD)) && continue
        if [[ -z $command && $'\n'$commands$'\n' == *$'\n'$word$'\n'* ]]; then
            command=$word
        elif [[ $command && -z $file && $word != -* && -f ${word/#\~/$HOME} ]]; then
            file=${word/#\~/$HOME}
        elif [[ $word == --format || $word == -f ]]; then
            [[ ${COMP_WORDS[i + 1]} == = ]] && ((i++))
            format=(--format "${COMP_WORDS[i + 1]}")
            ((i++))
        fi
    done
    [[ $command ]] && table=$("$program" "$command" --list-options 2>/dev/null)
    takes=$(_fmb_takes "$option" <<<"$table")
    [[ $takes == '['* && -z $attached ]] && takes=
    takes=${takes#[} takes=${takes%]}
    if [[ $option == -* ]] && _fmb_offer_values "$takes"; then
        return
    elif [[ $cur == -* ]]; then
        _fmb_offer "$(sed -n 's/^\(--[a-z-]*\)\t.*/\1/p' <<<"$table")" "$cur"
    elif [[ $command ]]; then
        compopt -o default 2>/dev/null
    else
        _fmb_offer "$commands" "$cur"
    fi
}
complete -F _fmb fmb
