# Guides as Doxygen reads them: each is a page of its file's name, and links between them and to pictures are kept; of links to
# places that are not on its pages, files of the source tree and headings, the words are left.
# Beside a picture stands the same one before a dark page, where DARK, a folder, has it.
#   awk -v dark=DARK -f guide_links.awk GUIDE.md
FNR == 1 {
  name = FILENAME
  gsub(/^.*\/|\.md$/, "", name)
  $0 = $0 " {#" name "}"
}
{
  left = $0
  line = ""
  while (match(left, /\[[^][]*\]\([^()]*\)/)) {
    link = substr(left, RSTART, RLENGTH)
    words = substr(link, 2, index(link, "](") - 2)
    target = substr(link, index(link, "](") + 2)
    if (target ~ /^[A-Za-z_]+\.md[#)]/) {
      sub(/\.md.*/, "", target)
      link = "@ref " target " \"" words "\""
    } else if (target ~ /\.svg\)$/) {
      sub(/\]\(.*\//, "](", link)
      picture = target
      gsub(/^.*\/|\.svg\)$/, "", picture)
      if (FILENAME ~ /gallery\.md$/ && (getline first <(dark "/" picture "_dark.svg")) > 0) {
        link = link " ![" words ", before a dark page](" picture "_dark.svg)"
      }
    } else if (target !~ /^https?:/) {
      link = words
    }
    line = line substr(left, 1, RSTART - 1) link
    left = substr(left, RSTART + RLENGTH)
  }
  print line left
}
