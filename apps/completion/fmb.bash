# Bash completion for fmb.

_fmb()
{
    local cur prev command i
    cur=${COMP_WORDS[COMP_CWORD]}
    prev=${COMP_WORDS[COMP_CWORD - 1]}
    if [[ $cur == = ]]; then # NAME=VALUE is three words for bash
        cur=
    elif [[ $prev == = ]]; then
        prev=${COMP_WORDS[COMP_CWORD - 2]}
    fi
    COMPREPLY=()
    for ((i = 1; i < COMP_CWORD; i++)); do
        case ${COMP_WORDS[i]} in
            solve | bounds | optimize | project | reduce | vertices | hull | sum | image | check | convert | intersect | mesh) command=${COMP_WORDS[i]} && break ;;
        esac
    done

    local general="--help --usage --version"
    local source="--format --quiet --max-input"
    local solver="--json --decimal --proof --relax --trace --trace-rows --arith --method --order --rules --rule-library --rebase
        --presolve --simd --max-seconds --max-rows --max-bytes --threads --symmetry"
    local words
    case $prev in
        --format)
            words="auto fmb ine ieq smt2 mps lp"
            [[ $command == mesh ]] && words="auto off obj ply stl mesh"
            ;;
        --mirror) words="x y z" ;;
        --to) words="fmb ine smt2 mps lp pairs" ;;
        --arith) words="auto int gmp" ;;
        --method) words="auto dd fm hull lp" ;;
        --order) words="pairs given min fill" ;;
        --rules) words="none duplicate dominated kohler chernikov imbert box lp" ;;
        --rebase) words="auto always never" ;;
        --presolve) words="none equalities components onesided bounds refute" ;;
        --simd) words="auto plain avx2 avx512" ;;
        --symmetry) words="auto none" ;;
        --trace-rows) words="true false" ;;
        --contact) words="closed open" ;;
        --boxes) words="exact outward none" ;;
        --norm) words="euclidean max" ;;
        --max-seconds | --max-rows | --max-bytes | --threads | --max-input | --max | --min | --vars | --keep | --eliminate | --move | --scale | --motion | --within) return ;;
        --proof | --lifted | --trace | --rule-library | --marked)
            compopt -o default
            return
            ;;
        *)
            case $command in
                solve) words="$general $source $solver" ;;
                bounds) words="$general $source $solver --vars" ;;
                optimize) words="$general $source $solver --max --min" ;;
                project) words="$general $source $solver --keep --eliminate --to --classes" ;;
                reduce) words="$general $source $solver --to" ;;
                vertices) words="$general $source $solver" ;;
                hull | sum | image) words="$general $source $solver --to --lifted" ;;
                check) words="$general $source --list --expect --json --decimal --relax --max-seconds --max-bytes" ;;
                convert) words="$general $source --to" ;;
                intersect) words="$general --quiet --json --decimal --contact --boxes --distance --depth --within --norm --separate --common --nearest --threads --max-seconds --max-bytes --max-input" ;;
                mesh) words="$general --quiet --json --decimal --csv --move --scale --mirror --motion --neighbours --where --common --marked --all-pairs --format --threads --max-seconds --max-bytes --max-input" ;;
                *) words="$general solve bounds optimize project reduce vertices hull sum image check convert intersect mesh" ;;
            esac
            if [[ -n $command && $cur != -* ]]; then
                compopt -o default
                return
            fi
            ;;
    esac
    mapfile -t COMPREPLY < <(compgen -W "$words" -- "$cur")
}
complete -F _fmb fmb
