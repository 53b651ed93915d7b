#!/bin/sh
# usage: other_language.sh PROGRAM SOURCE LIBRARY_FOLDER: compiles a program in Rust or C#, and compares
# what it prints with what the C program prints. 77: no compiler.
program=$1 source=$2 library=$3
folder=$(mktemp -d)
trap 'rm -rf "$folder"' EXIT
export LD_LIBRARY_PATH="$library${LD_LIBRARY_PATH:+:$LD_LIBRARY_PATH}"
skip() {
  echo "skipped: $1 is missing"
  exit 77
}
case $source in
*.rs)
  command -v rustc >/dev/null || skip rustc
  rustc -O -L "$library" "$source" -o "$folder/stripes" || exit 1
  "$folder/stripes" >"$folder/output" || exit 1
  ;;
*.cs)
  command -v mcs >/dev/null || skip mcs
  command -v mono >/dev/null || skip mono
  mcs -out:"$folder/stripes.exe" "$source" || exit 1
  mono "$folder/stripes.exe" >"$folder/output" || exit 1
  ;;
esac
"$program" >"$folder/expected" && test -s "$folder/expected" && diff "$folder/expected" "$folder/output"
