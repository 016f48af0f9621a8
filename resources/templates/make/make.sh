#!/bin/sh
# Makes all templates, or those that are named, and their pictures for the start page: make.sh [NAME ...]
# BOLSTER is the program.
cd "$(dirname "$0")/.." || exit 1
view() {
    case $1 in
        headrest) echo 28,10 ;;
        bench | wing-chair) echo 28,14 ;;
        dining-chair) echo 32,16 ;;
        car-seat) echo 32,14 ;;
        *) echo three-quarter ;;
    esac
}
# Drawn four times as large and made smaller by ImageMagick: edges above the shadow stay smooth.
large=$(mktemp --suffix .png) || exit 1
trap 'rm -f "$large"' EXIT
for name in ${@:-cushion bolster headrest bench dining-chair car-seat wing-chair}; do
    python3 "make/$name.py" && "${BOLSTER:-bolster}" check "$name.json" &&
        "${BOLSTER:-bolster}" render "$name.json" --image "$large" --size 1536x1152 --samples 9 --transparent \
            --view "$(view "$name")" && convert "$large" -filter Box -resize 384x288 -strip "$name.png" || exit 1
done
