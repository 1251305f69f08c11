#!/bin/sh
# alone.sh FMB CHECKER FILE: a proof by FMB is accepted by CHECKER, and the proof for another system is not.
set -eu
folder=$(mktemp -d)
trap 'rm -r "$folder"' EXIT
"$1" bounds "$3" --proof "$folder/proof" >"$folder/bounds"
"$2" "$3" "$folder/proof"
sed 's/<= 3$/<= 1/' "$3" >"$folder/other.fmb"
if "$2" "$folder/other.fmb" "$folder/proof"; then
    echo "accepted for another system"
    exit 1
fi
