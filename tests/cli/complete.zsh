# Prints what zsh offers for lines, each behind "line LINE". usage: zsh -f complete.zsh FOLDER LINE...,
# FOLDER with _fmb. An interactive zsh in a terminal of its own is typed to; its compadd tells.
zmodload zsh/zpty
setopt extendedglob
zpty session zsh -f -i
tell() { zpty -w session "$1" }
read_until() {
    local line
    while zpty -r session line; do
        line=${line%%[$'\r\n']##}
        [[ $line == '@@'$1 ]] && return
        [[ $line == '@@offered '* ]] && print -r -- ${line#'@@offered '}
    done
}
tell "PROMPT= ; unsetopt zle_bracketed_paste; unset zle_bracketed_paste; fpath=(${(q)1} \$fpath)"
tell "PATH=${(q)PATH}; autoload -Uz compinit; compinit -D -u; bindkey '^I' complete-word"
tell 'zstyle ":completion:*" verbose no; setopt nolistbeep'
tell 'compadd() {
    if [[ ${@[1,(i)(-|--)]} == *-[OAD]\ * ]]; then
        builtin compadd "$@"
        return
    fi
    local -a found
    builtin compadd -A found "$@"
    print; print -lr -- "@@offered "$^found
}'
tell 'finish() { print; print @@end; BUFFER=; }; zle -N finish; bindkey "^X" finish'
tell 'print; print @@"ready"'
read_until ready
for line in "${@[2,-1]}"; do
    print -r -- "line $line"
    zpty -n -w session "$line"$'\t\x18'
    read_until end
done
zpty -d session
