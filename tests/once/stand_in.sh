#!/bin/sh
# Takes the place of a program, whose name it has: counts, and writes what it was asked for and has read.
LAB=${0%/*}/.. said=${0##*/} text='' out='' files='' code=0
for word; do case $word in --json | --quiet) ;; *) said="$said $word" ;; esac; done
echo "$said" >>"$LAB/ran"
[ -e "$LAB/crash" ] && kill -SEGV $$
[ -e "$LAB/full" ] && echo "the disk is full" >&2 && exit 3
while [ $# -gt 0 ]; do
  case $1 in
    -o | --record) out="$out $2" && shift ;;
    --sleep) sleep "$2" && shift ;;
    --refuse) echo "${0##*/}: it cannot" >&2 && exit "$2" ;;
    --differ) code=1 ;;
    --*=*) [ -f "${1#*=}" ] && text="$text<$(cat "${1#*=}")>" ;;
    *) [ -f "$1" ] && text="$text<$(cat "$1")>" ;;
  esac
  shift
done
for file in $out; do
  printf %s "$said$text" >"$file"
  files="$files,{\"path\":\"$file\",\"checksum\":\"$(cksum <"$file")\"}"
done
case $said in
  analyze*) echo "{\"said\":\"$said\",\"read\":\"$text\"}" && exit $code ;;
  map*) ;;
  *) echo "{\"files\":[${files#,}]}" ;;
esac
