# Completion for fish of fmb, fmb-qualify and fmb-validate: what PROGRAM [COMMAND] --list-options
# tells, from the tables that the programs read their options by.

# The lines of the command that the line being typed names, or of the program.
function __fmb_list
    set -l words (commandline -opc)
    set -l program $words[1]
    for line in ($program --list-options 2>/dev/null)
        set -l command (string split -f 1 \t -- $line)
        if not string match -q -- '--*' $command; and contains -- $command $words[2..]
            $program $command --list-options 2>/dev/null
            return
        end
    end
    $program --list-options 2>/dev/null
    if string match -q '*fmb-qualify' $program # without a study it does all of them
        $program all --list-options 2>/dev/null
    end
end

# Commands, and options with what they mean; behind an option, or as --name=value, its words.
function __fmb_complete
    set -l before (commandline -opc)[-1]
    set -l typed (commandline -ct)
    for line in (__fmb_list)
        set -l part (string split \t -- $line)
        set -l takes (string split -n '|' -- $part[3])
        if test (count $takes) -gt 1
            if test "$before" = $part[1]
                printf '%s\n' $takes
            else if string match -q -- "$part[1]=*" $typed
                printf "$part[1]=%s\n" $takes
            end
        end
        printf '%s\t%s\n' $part[1] $part[4]
    end
end

for program in fmb fmb-qualify fmb-validate
    complete -c $program -a '(__fmb_complete)'
end
