# Guides as Doxygen reads them: each is a page of its file's name, and links between them and to pictures are kept; of links to
# places that are not on its pages, files of the source tree and headings, the words are left.
#   awk -f guide_links.awk GUIDE.md
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
    } else if (target !~ /^https?:/) {
      link = words
    }
    line = line substr(left, 1, RSTART - 1) link
    left = substr(left, RSTART + RLENGTH)
  }
  print line left
}
