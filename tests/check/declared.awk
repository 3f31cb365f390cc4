# Input: a header.  Prints it without the declarations of functions that are not in the file `names`; nothing if it
# declares only such functions, unless there is no source of its name (partner=no) or it has macros with arguments.

BEGIN { while ((getline name <names) > 0) wanted[name] = 1 }

# Lines between blank ones: a comment, and what it is about.
function end_part(  i, name) {
  for (i = 1; i <= size; i++) {
    if (text[i] ~ /^(#|\}|struct [a-z_]+ \{|enum|typedef|static|extern)/) kept = 1
    if (text[i] ~ /^#define [a-z_]+\(/) used = 1
    if (text[i] !~ /^[a-z].*[a-z_0-9]\(/) continue
    declares = 1
    name = text[i]; sub(/\(.*/, "", name); sub(/.*[ *]/, "", name)
    if (name in wanted) kept = used = 1
  }
  for (i = 1; i <= size && (kept || !declares); i++) out[++length_of_out] = text[i]
  size = kept = declares = 0
}

{ text[++size] = $0 }
$0 == "" { end_part() }

END {
  end_part()
  for (i = 1; (used || partner == "no") && i <= length_of_out; i++)
    if (out[i] != "" || (i > 1 && out[i - 1] != "")) print out[i]
}
