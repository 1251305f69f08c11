# Completion for fish of fmb, fmb-qualify and fmb-validate: what PROGRAM [COMMAND] --list-options
# tells, from the tables that the programs read their options by, and for options that take variables
# what the file on the line calls them.

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

# What the option takes whose value is being typed, "-" where none is: --name VALUE, -n VALUE,
# --name=VALUE; a value that may be left out, in brackets, stands behind = alone.
function __fmb_takes
    set -l before (commandline -opc)[-1]
    set -l typed (commandline -ct)
    for line in (__fmb_list)
        set -l part (string split \t -- $line)
        if not string match -q -- '--*' $part[1]; or test -z "$part[3]"
            continue
        else if string match -q -- "$part[1]=*" $typed
            string trim -c '[]' -- $part[3]
            return
        else if contains -- "$before" $part[1] "-$part[2]"; and not string match -q '[*' -- $part[3]
            echo $part[3]
            return
        end
    end
    echo -
end

# Variables of the first file on the line, unless it is large; those in quotes are left out.
function __fmb_variables
    set -l words (commandline -opc)
    for word in $words[3..]
        if test -f "$word"
            set -l line ($words[1] convert $word --to fmb --quiet --max-input 1000000 2>/dev/null)[1]
            string match -q 'vars: *' -- $line
            and string split -n ' ' -- (string replace -ra '"([^"\\\\]|\\\\.)*"|^vars: ' '' -- $line)
            return
        end
    end
end

# Words for that value, behind what is typed of it up to the last comma.
function __fmb_values
    set -l typed (string replace -r '^--[a-z-]+=' '' -- (commandline -ct))
    set -l head (string match -r '^--[a-z-]+=' -- (commandline -ct))
    switch $argv[1]
        case NAMES
            set -l before (string match -r '^.*,' -- $typed)
            set -l given (string split ',' -- $before)
            for name in (__fmb_variables)
                contains -- $name $given; or echo "$head$before$name"
            end
        case FORM
            printf "$head%s\n" (__fmb_variables)
        case WHAT
            printf "$head%s\n" feasible infeasible bounds reduced projection= whole= optimum max= min=
        case 'LIST*'
        case '*|*'
            printf "$head%s\n" (string match -v FILE -- (string split '|' -- $argv[1]))
    end
end

# Commands, and options with what they mean; where a value is typed, words for that.
function __fmb_complete
    set -l takes (__fmb_takes)
    if test "$takes" != -
        __fmb_values $takes
        return
    end
    for line in (__fmb_list)
        set -l part (string split \t -- $line)
        printf '%s\t%s\n' $part[1] $part[4]
    end
end

# May a file stand here? Not where a command is missing, nor as a value that is none.
function __fmb_wants_no_file
    set -l takes (__fmb_takes)
    if test "$takes" != -
        not string match -qr 'FILE|OUT|DIR' -- $takes
        return
    end
    string match -q '*fmb' (commandline -opc)[1]; or return
    for line in (__fmb_list)
        string match -q -- '--*' $line; or return 0
    end
    return 1
end

for program in fmb fmb-qualify fmb-validate
    complete -c $program -a '(__fmb_complete)'
    complete -c $program -n __fmb_wants_no_file -f
end
