# The blocks of code of a page, each into a file of its own: FOLDER/01.sh, FOLDER/02.c and so on, by the language that stands
# behind the three ticks. Of one section alone, if one is named: awk -v folder=FOLDER [-v section="## Title"] -f page_blocks.awk PAGE
BEGIN { inside = section == "" }
section != "" && /^## / { inside = $0 == section }
!inside { next }
/^```[a-z]+$/ {
  name = sprintf("%s/%02d.%s", folder, ++blocks, substr($0, 4))
  printf "" > name
  open = 1
  next
}
/^```$/ { open = 0; close(name); next }
open { print > name }
