# awk -v first=N -v list=FILE -v calls='NAME NAME...' -f left-out.awk source.c
#
# Prints a source of the checker in which each check can be left out by its number (left-out.h), and appends to the list,
# for each of them, number, file, line and text, with tabs between.  Checks are
#   calls of the functions named, which become nothing;
#   `return false;', which becomes nothing, or true at the end of a function;
#   what a function of type bool returns, each part of a conjunction by itself, which becomes true.
# The text of `return false;' has the line before it, of the condition.  The sources are formatted by one program: definitions begin their lines, and end with a brace that does.

BEGIN {
    count = split(calls, call, " ")
    number = first
}

function note(text) {
    gsub(/[ \t]+/, " ", text)
    sub(/^ /, "", text)
    printf "%d\t%s\t%d\t%s\n", number, FILENAME, FNR, text >>list
    return number++
}

# Where the call of one of the functions begins in the line, 0 if there is none; its name is in `name'.
function find_call(text,   i, at, before) {
    for (i = 1; i <= count; i++) {
        name = call[i]
        at = index(text, name "(")
        before = at > 1 ? substr(text, at - 1, 1) : ""
        if (at > 0 && before !~ /[A-Za-z0-9_"]/) return at
    }
    return 0
}

# The parts of a conjunction, in part[1..n]; n = 1 if it is none, n = 0 for what can hardly be a condition.
function split_conjunction(text,   i, c, depth, n, begin) {
    depth = 0
    n = 0
    begin = 1
    for (i = 1; i <= length(text); i++) {
        c = substr(text, i, 1)
        if (c == "(" || c == "[") depth++
        else if (c == ")" || c == "]") depth--
        else if (c == "'" || c == "\"") return 1 + ((part[1] = text) == "")
        else if (depth == 0 && (c == "?" || substr(text, i, 2) == "||")) return 1 + ((part[1] = text) == "")
        else if (depth == 0 && substr(text, i, 2) == "&&") {
            part[++n] = substr(text, begin, i - begin)
            begin = i + 2
        }
    }
    part[++n] = substr(text, begin)
    return n
}

function rewrite_return(statement,   head, text, n, i, out) {
    head = statement
    sub(/return .*/, "return ", head)
    text = substr(statement, length(head) + 1)
    sub(/;[ \t]*$/, "", text)
    n = split_conjunction(text)
    out = ""
    for (i = 1; i <= n; i++)
        out = out (i > 1 ? " && " : "") "(left_out(" note("return " part[i]) ") || (" part[i] "))"
    return head out ";"
}

function continue_statement(   next_line) {
    while ($0 !~ /;[ \t]*$/ && (getline next_line) > 0) {
        sub(/^[ \t]+/, " ", next_line)
        $0 = $0 next_line
    }
}

/^[a-z].*\(/ { is_bool = /^(static )?bool [a-z]/ }
/^ *(\*|\/\*|\/\/)/ { print; next }
/^    return false;$/ { # of no condition: the end
    print "    return left_out(" note("end: " $0) ");"
    next
}
/^ +return false;$/ {
    sub(/return false;/, "{ if (!left_out(" note(previous $0) ")) return false; }")
    print
    previous = ""
    next
}
is_bool && /^ +return / && !/^ +return (true|false);/ {
    continue_statement()
    print rewrite_return($0)
    next
}
/^ / && find_call($0) {
    continue_statement()
    at = find_call($0)
    before = substr($0, 1, at - 1)
    after = substr($0, at + length(name) + 1)
    waiting = note($0)
    print before "unless_left_out(" waiting ", " name ", " after
    next
}
{
    print
    previous = $0
}
