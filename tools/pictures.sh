#!/bin/sh
# Draws docs/pictures anew: each shipped drill from afar and from near, some seconds after its start by its own motion.
# Run in the source tree after `make build`; needs ImageMagick's convert. Takes some 5 minutes.
set -e
out=docs/pictures
mkdir -p "$out"
work=$(mktemp -d)
trap 'rm -r "$work"' EXIT

# picture DRILL SECONDS VIEW OPTIONS...
picture() {
    drill=$1 seconds=$2 view=$3
    shift 3
    build/carrel render "scenarios/drills/$drill.json" --at "$seconds" "$@" --out "$work/picture.png"
    convert "$work/picture.png" -resize 720x -strip -quality 84 "$out/$drill-$view.jpg"
}

# A drill, seconds of its motion from afar, from near: of its knot or its bites, where it has any.
while read -r drill far near; do
    picture "$drill" "$far" far
    [ "$near" = - ] || picture "$drill" "$near" near --close
done <<END
square-knot 13.5 17.9
granny-knot 10 19
surgeons-knot 11 21
assisted-square-knot 15 30
assisted-granny-knot 15 32
assisted-surgeons-knot 15 37
single-bite 6 12
interrupted-stitch 4.35 4.35
end-to-end-running 4 6
end-to-end-interrupted 13 13
stay-sutures 13 13
first-moves 6.5 -
END
