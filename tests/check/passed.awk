# Input: FILE.c.gcov, the output of gcov.  Prints FILE.c without functions that were not executed, and "..." for lines
# that were not; nothing if there was no function.  Appends the names of the functions to the file `names`.

function indentation(line) { match(line, /^ */); return RLENGTH }

# A piece is a function with the comment above it, or what stands between blank lines outside of functions.
function end_piece(  i, reached) {
  for (i = 1; i <= size; i++) if (count[i] ~ /^[0-9]/) reached = 1
  if (is_function) {
    if (reached) { any = 1; name_function(); keep() }
  } else {
    for (i = 1; i <= size; i++) out[++length_of_out] = text[i]
  }
  size = is_function = 0
}

function name_function(  i, line) {
  for (i = 1; text[i] !~ /^\{/; i++)
    if (text[i] ~ /^[a-z].*\(/) { line = text[i]; sub(/\(.*/, "", line); sub(/.*[ *]/, "", line); print line >>names }
}

# A statement that was not executed ends where something is not farther to the right than its beginning.
function keep(  i, column, dots) {
  column = -1
  for (i = 1; i <= size; i++) {
    if (count[i] ~ /^[#=]/) { column = indentation(text[i]); dots = 1; continue }
    if (column >= 0 && count[i] == "-" && (indentation(text[i]) > column || text[i] ~ /^ *(break;|\/\*|$)/)) continue
    if (dots) out[++length_of_out] = sprintf("%*s...", column, "")
    out[++length_of_out] = text[i]
    column = -1
    dots = 0
  }
}

{
  here = $0; sub(/:.*/, "", here); gsub(/[ *]/, "", here)
  line = $0; sub(/^[^:]*:/, "", line); number = line + 0; sub(/^[^:]*:/, "", line)
  if (number == 0) next
  size++; text[size] = line; count[size] = here
  if (line ~ /^\{/) is_function = 1
  if (is_function ? line ~ /^\}/ : line == "") end_piece()
}

END {
  end_piece()
  for (i = 1; any && i <= length_of_out; i++)
    if (out[i] != "" || (i > 1 && out[i - 1] != "")) print out[i]
}
