# Bash completion for fmb-validate and fmb-qualify.

# What is being typed, and the word before it; NAME=VALUE is three words for bash. Sets cur
# and prev of the caller.
_fmb_study_words()
{
    cur=${COMP_WORDS[COMP_CWORD]}
    prev=${COMP_WORDS[COMP_CWORD - 1]}
    if [[ $cur == = ]]; then
        cur=
    elif [[ $prev == = ]]; then
        prev=${COMP_WORDS[COMP_CWORD - 2]}
    fi
}

# Offer the words $1 behind the last comma of what is typed.
_fmb_study_list()
{
    local before=
    [[ $cur == *,* ]] && before=${cur%,*},
    mapfile -t COMPREPLY < <(compgen -P "$before" -W "$1" -- "${cur##*,}")
}

_fmb_study_offer()
{
    mapfile -t COMPREPLY < <(compgen -W "$1" -- "$cur")
}

_fmb_validate()
{
    local cur prev
    _fmb_study_words
    COMPREPLY=()
    case $prev in
        -f | --families)
            _fmb_study_list "article lattice touching near flat degenerate tiny-A tiny-B far
                denormal swept integer scaled spread ragged uneven all"
            ;;
        --simd) _fmb_study_offer "auto plain avx2 avx512" ;;
        -j | --json | --failures) compopt -o default ;;
        -n | --pairs | -s | --seed | --dim | --axes | --sample | --textbook | -t | --threads | --shard) ;;
        *)
            if [[ $cur == -* ]]; then
                _fmb_study_offer "--help --usage --version --pairs --seed --families --dim --axes
                    --sample --textbook --boxes --contact --simd --threads --shard --merge --json --failures --quiet"
            else
                _fmb_study_offer "$(echo {1..16}d-{static,dynamic})"
            fi
            ;;
    esac
}
complete -F _fmb_validate fmb-validate

_fmb_qualify()
{
    local cur prev study=all
    local studies="all table1 article near touching slender mesh faces boxes scaling rules peers bunny benchmark run merge bias plots leaderboard"
    local general="--help --usage --version --pairs --passes --seed --out --json --quiet"
    _fmb_study_words
    COMPREPLY=()
    ((COMP_CWORD > 1)) && [[ ${COMP_WORDS[1]} != -* ]] && study=${COMP_WORDS[1]}
    case $prev in
        --simd) _fmb_study_offer "auto plain avx2 avx512" ;;
        --motion) _fmb_study_list "static dynamic" ;;
        --kinds) _fmb_study_list "CC CT TC TT" ;;
        --meeting) _fmb_study_offer "yes no" ;;
        --family) _fmb_study_offer "small float" ;;
        --orders) _fmb_study_list "pairs given min fill" ;;
        -r | --rules)
            _fmb_study_list "none default duplicate dominated kohler chernikov imbert box lp"
            ;;
        --presolve) _fmb_study_list "none equalities components onesided bounds refute" ;;
        --rule-library) compopt -o default ;;
        -o | --out)
            if [[ $study =~ ^(run|leaderboard)$ ]]; then compopt -o default; else compopt -o dirnames; fi
            ;;
        -n | --pairs | -s | --seed | --passes | --dim | --max-rows | --max-seconds | --shard | -f | --families | --repetitions) ;;
        *)
            if [[ $cur == -* && $study == rules ]]; then
                _fmb_study_offer "$general --dim --motion --kinds --meeting --family --rules
                    --rule-library --orders --shard --merge
                    --presolve --max-rows --max-seconds --detail --counts"
            elif [[ $cur == -* && $study == benchmark ]]; then
                _fmb_study_offer "--help --usage --version --families --quiet"
            elif [[ $cur == -* && $study == run ]]; then
                _fmb_study_offer "--help --usage --version --out --shard --quiet"
            elif [[ $cur == -* && $study == bias ]]; then
                _fmb_study_offer "--help --usage --version --repetitions --passes --quiet"
            elif [[ $cur == -* && $study =~ ^(plots|leaderboard)$ ]]; then
                _fmb_study_offer "--help --usage --version --out"
            elif [[ $cur == -* && $study == merge ]]; then
                _fmb_study_offer "--help --usage --version"
            elif [[ $cur == -* ]]; then
                _fmb_study_offer "$general --simd"
            elif ((COMP_CWORD == 1)); then
                _fmb_study_offer "$studies"
            elif [[ $study =~ ^(rules|bunny|run|merge|plots|leaderboard)$ ]]; then
                compopt -o default
            elif [[ $study == benchmark ]]; then
                compopt -o dirnames
            fi
            ;;
    esac
}
complete -F _fmb_qualify fmb-qualify
