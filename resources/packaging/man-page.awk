# A help text of bolster as a part of its manual page: -v what=program with -v version=..., or -v what=command -v name=...
function plain(text) {
    gsub(/\\/, "\\e", text)
    gsub(/-/, "\\-", text)
    if (text ~ /^[.']/)
        text = "\\&" text
    return text
}
function section(title) {
    print ".SH " title
}
# "  --obj FILE   the cover" and "  0  done" become a tag and what it means; what follows further in belongs to it.
function entry(line,    at) {
    sub(/^  /, "", line)
    at = match(line, /  +/)
    print ".TP"
    if (at == 0) {
        print "\\fB" plain(line) "\\fP"
        return
    }
    print "\\fB" plain(substr(line, 1, at - 1)) "\\fP"
    print plain(substr(line, at + RLENGTH))
}
BEGIN {
    if (what == "program") {
        sub(/^bolster /, "", version)
        print ".\\\" Made by resources/packaging/man-page of the program's help."
        print ".TH BOLSTER 1 \"\" \"Bolster " version "\" \"User Commands\""
        section("NAME")
        print "bolster \\- design upholstery from sewing pattern to cover, live"
        section("SYNOPSIS")
    }
}
NR == 1 || usage && /^ +bolster / || usage && what == "program" && /^            / {
    usage = 1
    sub(/^Usage: /, "")
    if (what == "program") {
        sub(/^       /, "")
        if (NR == 1)
            print ".nf"
        print plain($0)
    } else {
        sub(/^ +/, "")
        if (NR == 1)
            section("BOLSTER " toupper(name))
        else
            print ".br"
        print "\\fB" plain($0) "\\fP"
    }
    next
}
usage && what == "command" && /^ +[^ ]/ {
    sub(/^ +/, "")
    print "\\fB" plain($0) "\\fP"
    next
}
/^$/ {
    if (usage && what == "program") {
        print ".fi"
        section("DESCRIPTION")
    } else
        print ".PP"
    usage = 0
    next
}
/^  [^ ]/ { entry($0); next }
/^[^ ].*:$/ { print ".PP"; print plain($0); next }
{ sub(/^ +/, ""); print plain($0) }
