#!/bin/sh
# usage: installed.sh CMAKE INSTALL_SCRIPT CC SOURCE EXPECTED: installs the C library in an empty folder
# and runs SOURCE, compiled by what pkg-config says, from there. 77: no pkg-config.
cmake=$1 script=$2 cc=$3 source=$4 expected=$5
command -v pkg-config >/dev/null || { echo 'skipped: pkg-config is missing'; exit 77; }
folder=$(mktemp -d)
trap 'rm -rf "$folder"' EXIT
"$cmake" "-DCMAKE_INSTALL_PREFIX=$folder/prefix" -P "$script" >/dev/null || exit 1
mv "$folder/prefix" "$folder/moved" || exit 1
PKG_CONFIG_PATH=$(dirname "$(find "$folder/moved" -name brindle_c.pc)")
export PKG_CONFIG_PATH
# shellcheck disable=SC2046  # words
"$cc" -std=c99 -Werror "$source" -o "$folder/program" $(pkg-config --cflags --libs brindle_c) || exit 1
export LD_LIBRARY_PATH="$(pkg-config --variable=libdir brindle_c)${LD_LIBRARY_PATH:+:$LD_LIBRARY_PATH}"
"$folder/program" >"$folder/output" && "$expected" >"$folder/expected" &&
  diff "$folder/expected" "$folder/output"
