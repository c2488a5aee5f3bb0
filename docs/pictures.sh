#!/usr/bin/env bash
# Takes the pictures of README.md, scenes/README.md and the pages in docs/ anew:
#
#   docs/pictures.sh                  all that this machine can take
#   docs/pictures.sh NAME...          these, by file name: overlay.png enricher-plan.png
#   docs/pictures.sh --list           what there is, and how each is taken
#
# They are written to docs/pictures, or to the folder that PICTURES names. It takes a JDK and Maven as
# the build does, Xvfb, ImageMagick (convert, import) and xdotool. Every picture is taken on a screen
# of its own, with software OpenGL where Mesa has it, so that two machines take the same one but for
# what their fonts and figures differ in. Scene, viewpoint, size, theme and what is selected stand in
# the functions below, which have the pictures' names, and for the enricher in EnricherPictures.
set -euo pipefail
cd "$(dirname "${BASH_SOURCE[0]}")/.."

out=$(realpath -m "${PICTURES:-docs/pictures}")
root=$PWD
program=$root/selective-renderer
export LIBGL_ALWAYS_SOFTWARE=1 LC_ALL=C.UTF-8

# The table: picture, how it is taken. A test holds it against the folder and the pages.
pictures='
anaglyph.jpg                       run
apartment-kitchen.jpg              run
apartment-lounge.jpg               run
apartment-office.jpg               run
apartment.jpg                      run
cornell-box.jpg                    light
dual.jpg                           run
enricher-areas.png                 enricher
enricher-compare.png               enricher
enricher-cost.png                  enricher
enricher-dark.png                  enricher
enricher-diff.png                  dialogs
enricher-fault.png                 enricher
enricher-fields.png                form
enricher-find.png                  enricher
enricher-gaze.png                  dialogs
enricher-handles.png               enricher
enricher-help.png                  enricher
enricher-overview.png              dialogs
enricher-plan.png                  enricher
enricher-preview.png               enricher
enricher-qualities.png             enricher
enricher-ratings.png               dialogs
enricher-schemas.png               enricher
enricher-source.png                enricher
enricher-switch.png                enricher
enricher-versions.png              dialogs
export-web.png                     web
gaze-error.svg                     plots
head-log.svg                       run
headset-questions.png              headset
hmd-check.png                      run
kitchen-reference.jpg              light
openxr-window.jpg                  monado
openxr.jpg                         monado
operator.jpg                       window
overlay.png                        window
performance-budget-apartment.svg   plots
performance-budget-street.svg      plots
performance-frame.svg              plots
performance-frames.svg             plots
performance-growth-inlines.svg     plots
performance-growth-objects.svg     plots
performance-growth-sensors.svg     plots
performance-growth-switches.svg    plots
performance-memory.svg             plots
performance-selective.svg          plots
performance-street-frame.svg       plots
performance-street-load.svg        plots
performance-street-memory.svg      plots
polygons-kitchen.svg               plots
polygons-lounge.svg                plots
polygons-office.svg                plots
qualities.jpg                      run
radiosity-kitchen.jpg              run
radiosity-lounge.jpg               run
radiosity-office.jpg               run
rehearsal-plan.svg                 rehearsal
rehearsal-preview.jpg              rehearsal
replication.png                    page
sculptures.jpg                     run
session-bipolar.png                session
session-consent.png                session
session-controls.png               session
session-kinds.png                  session
session-operator.jpg               window
session-orders.png                 session
session-questionnaire.png          session
session-sliders.png                session
side-by-side.jpg                   run
story-enricher.png                 window
story-kitchen.svg                  report
story-room.jpg                     run
study-plan.png                     study
study-session.png                  study
switch-fade.png                    run
threshold-trial.png                window
tour-polygons.svg                  run
trashcan-versions.png              run
web-study-list.png                 web
web-study-phone.png                web
'

explain() {
  case $1 in
    run) echo 'drawn by run --offscreen' ;;
    window) echo 'a window of the program on a screen of its own' ;;
    enricher) echo 'the window of the enricher, driven by EnricherPictures' ;;
    dialogs) echo 'a dialog of the enricher, driven by PicturesTest' ;;
    form) echo 'the form of a node, driven by FormPanelTest' ;;
    session) echo 'a screen of a session, driven by SessionPictures' ;;
    study) echo 'the study window, driven by StudyWindowPictures' ;;
    headset) echo 'what an eye sees of the questions inside a headset, drawn by HeadsetQuestionsTest' ;;
    light) echo 'by tools/compare-light, beside paths of light' ;;
    plots) echo 'written with its page by a test; CONTRIBUTING.md has the command' ;;
    web) echo 'a page that export --to web writes, in Chromium, by web/browser-test' ;;
    monado) echo 'by .ci/openxr with Monado; needs root, and the system that .ci/openxr setup makes' ;;
    rehearsal) echo 'by experiment check, and a window of a session of experiment preview' ;;
    report) echo 'a figure of experiment analyse, of simulated participants' ;;
    page) echo 'a page that experiment replicate writes, in Chromium' ;;
  esac
}

say() { echo "pictures: $*" >&2; }

# Commands on a screen of their own: screen 1280x1024 COMMAND...
screen() {
  local size=$1
  shift
  xvfb-run -a -s "-screen 0 ${size}x24 -noreset" "$@"
}

# shot FILE WxH SCENE OPTIONS...: a picture of a scene.
shot() {
  local file=$1 size=$2
  shift 2
  screen 1280x1024 "$program" run "$@" --offscreen --mute --samples 8 --size "$size" \
    --screenshot "$file" >/dev/null
}

# small IN OUT OPTIONS...: a picture as it is published, without when and where it was taken, and on a
# canvas of its own size. One of a single colour was taken before there was anything to be seen.
small() {
  local in=$1 to=$2
  shift 2
  if [ "$(identify -format %k "$in")" -lt 2 ]; then
    say "there is nothing on $in"
    return 1
  fi
  case $to in
    *.jpg) convert "$in" "$@" +repage -strip -quality 88 "$to" ;;
    *) convert "$in" "$@" +repage -strip -define png:compression-level=9 -define png:exclude-chunk=date,tIME "$to" ;;
  esac
}

# beside LEFT RIGHT OUT GAP: two pictures side by side.
beside() {
  convert "$1" -background white -gravity east -splice "$4x0" "$tmp/left.png"
  convert "$tmp/left.png" "$2" +append "$tmp/both.png"
  small "$tmp/both.png" "$3"
}

# Test classes are run once, whatever pictures are taken of them: tested CLASS SCALE OPTIONS... The
# scale is the screen's, of windows that are drawn so much larger: the letters of a window that was
# laid out at 1 and is drawn at 2 are wider than their places.
tested() {
  local class=$1 scale=$2
  shift 2
  if [ ! -e "$tmp/$class" ]; then
    JAVA_TOOL_OPTIONS=-Dsun.java2d.uiScale=$scale \
      screen "$((1600 * scale))x$((1200 * scale))" mvn -B -ntp -q test -Dspotless.check.skip \
      -Dsurefire.failIfNoSpecifiedTests=false "-Dtest=$class" "$@"
    touch "$tmp/$class"
  fi
}

# A picture that a test has written to target/pictures at twice the size: fromTest CLASS NAME OUT WIDTH
fromTest() {
  tested "$1" 2
  small "target/pictures/$2.png" "$3" -resize "$4" +dither -colors 255
}

apartment() { # ROOM OUT: all polygons on the left, selective on the right
  local view=${1^}View
  shot "$tmp/all.png" 800x450 scenes/apartment-lit.x3d --viewpoint "$view" --condition high
  shot "$tmp/selective.png" 800x450 scenes/apartment-lit.x3d --viewpoint "$view"
  beside "$tmp/all.png" "$tmp/selective.png" "$2" 8
}

radiosity() { # ROOM OUT: X3D's own lights on the left, radiosity on the right
  local view=${1^}View
  shot "$tmp/before.png" 720x480 scenes/apartment.x3d --viewpoint "$view" --condition high
  shot "$tmp/after.png" 720x480 scenes/apartment-lit.x3d --viewpoint "$view" --condition high
  beside "$tmp/before.png" "$tmp/after.png" "$2" 16
}

compared() { # OUT OPTIONS...: light in textures, paths of light, the difference
  local to=$1
  shift
  tools/compare-light "$@" --samples 4096 --quality 99.99 --out "$tmp/compared" >/dev/null
  small "$tmp/compared/compared-textures.png" "$to" -filter point -resize 200%
}

trashcan() { # OUT
  # What is expected in the office is seen from the desk's viewpoint where no area says otherwise.
  sed "s/<ProximitySensor /<ProximitySensor enabled='false' /" scenes/trashcan.x3d >"$office"
  shot "$tmp/office.png" 480x450 "$office" --viewpoint TrashCanView
  shot "$tmp/desk.png" 480x450 scenes/trashcan.x3d --viewpoint TrashCanView
  labelled "$tmp/office.png" 'in the office: 93 polygons'
  labelled "$tmp/desk.png" 'at the desk: 1064 polygons'
  beside "$tmp/office.png" "$tmp/desk.png" "$1" 0
}

qualities() { # OUT
  local jug=docs/examples/qualities/jug.x3d high='--viewpoint Cellar --condition high'
  shot "$tmp/full.png" 300x340 "$jug" $high
  shot "$tmp/quarter.png" 300x340 "$jug" $high --quality textures=low
  shot "$tmp/flat.png" 300x340 "$jug" $high --quality shading=low
  labelled "$tmp/full.png" 'as it is'
  labelled "$tmp/quarter.png" 'texture: 25 percent'
  labelled "$tmp/flat.png" 'shading: flat'
  convert "$tmp/full.png" "$tmp/quarter.png" "$tmp/flat.png" +append "$tmp/three.png"
  small "$tmp/three.png" "$1"
}

switching() { # OUT: at the begin, in the middle and at the end of a cross-fade, pixel by pixel
  local pictures=() n=0 steps
  for steps in '0.05,4.16,-0.246,-0.945' '0.3,4.17,-0.246,-0.92' '0.55,4.17,-0.246,-0.92'; do
    {
      printf 't,x,y,z,yaw,pitch,roll\n0,4.15,-0.246,-0.97,-158,-26,0\n'
      [ $n -eq 0 ] || printf '0.1,4.17,-0.246,-0.92,-158,-26,0\n'
      printf '%s,-158,-26,0\n' "$steps"
    } >"$tmp/fade.csv"
    screen 1280x1024 "$program" run scenes/trashcan.x3d --path "$tmp/fade.csv" --switch fade:500 \
      --offscreen --mute --samples 0 --size 1024x768 --screenshot "$tmp/fade-$n.png" >/dev/null
    convert "$tmp/fade-$n.png" -crop 120x140+505+357 +repage -filter point -resize 300% \
      -bordercolor white -border 6 "$tmp/fade-$n.png"
    pictures+=("$tmp/fade-$n.png")
    n=$((n + 1))
  done
  convert "${pictures[@]}" +append "$tmp/fade.png"
  small "$tmp/fade.png" "$1" -depth 8
}

labelled() { # FILE WORDS: words below a picture
  convert "$1" -gravity south -background '#f2f2f2' -splice 0x23 -font DejaVu-Sans -pointsize 14 \
    -fill black -annotate +0+4 "$2" "$1"
}

stereo() { # OUT WxH OPTIONS...
  local to=$1 size=$2
  shift 2
  shot "$tmp/stereo.png" "$size" scenes/apartment.x3d --viewpoint KitchenView "$@"
  small "$tmp/stereo.png" "$to"
}

dual() { # OUT: both screens, a gap between them
  shot "$tmp/dual.png" 1280x480 scenes/apartment.x3d --viewpoint KitchenView --display side-by-side
  convert "$tmp/dual.png" -crop 640x480 +repage "$tmp/eye-%d.png"
  beside "$tmp/eye-0.png" "$tmp/eye-1.png" "$1" 12
}

headlog() { # OUT
  screen 1280x1024 "$program" run scenes/apartment.x3d --path scenes/paths/apartment-tour.csv \
    --offscreen --mute --size 160x120 --head-log "$tmp/apartment.csv" >/dev/null
  "$program" experiment view "$tmp/apartment.csv" --plot "$1" >/dev/null
}

# What the windows below run: once they are there for so long, a key is pressed and the screen taken.
overlay() { # OUT
  screen 1024x768 bash -c '
    "$1" run scenes/trashcan.x3d --viewpoint DeskView --size 1024x768 --mute &
    timeout 120 xdotool search --sync --onlyvisible --name trashcan >/dev/null
    for ((i = 0; i < 60; i++)); do # Until the scene is drawn.
      sleep 2
      import -window root "$2"
      [ "$(identify -format %k "$2")" -lt 100 ] || break
    done
    xdotool mousemove 512 384 key F1
    sleep 5
    import -window root "$2"
    kill $!
    wait $! || true' overlay "$program" "$tmp/overlay.png"
  small "$tmp/overlay.png" "$1"
}

operator() { # OUT
  # The window names the tracker's device as it was given; so both run where that is short.
  (
    cd "$tmp"
    "$program" track --emulate intertrax2 --link tracker >/dev/null 2>&1 &
    emulator=$!
    sleep 5
    screen 2240x1400 "$program" run "$root/scenes/apartment.x3d" --viewpoint KitchenMiddle \
      --display side-by-side --tracker intertrax2:tracker --head-log p01.csv --operator --mute \
      --size 1120x420 --duration 17 --operator-screenshot operator.png >/dev/null || true
    kill "$emulator"
  )
  small "$tmp/operator.png" "$1" -resize 1120x
}

study() {
  if [ ! -d "$tmp/study" ]; then
    "$program" experiment new "$tmp/study" --scene scenes/apartment.x3d >/dev/null
    # The kitchen comes first: no practice, and nothing that is asked after it.
    sed -i -e '/^ *"practice":/d' -e '/"when": "after-practice"/d' "$tmp/study/study.json"
  fi
}

# The window of a program whose title has a word, so many seconds later; where a key is to be pressed
# then, as many again: titled WORD SECONDS KEY OUT COMMAND...
titled() {
  local word=$1 seconds=$2 key=$3 file=$4
  shift 4
  screen 1600x1200 bash -c '
    word=$1 seconds=$2 key=$3 file=$4
    shift 4
    "$@" >/dev/null 2>&1 &
    window=$(timeout 180 xdotool search --sync --onlyvisible --name "$word" | head -1)
    if [ -z "$window" ]; then # Else import would wait for a click, for ever.
      echo "pictures: no window named $word came up" >&2
      kill $!
      exit 1
    fi
    sleep "$seconds"
    if [ -n "$key" ]; then
      xdotool mousemove 800 600 key "$key"
      sleep "$seconds"
    fi
    import -window "$window" "$file"
    kill $!
    wait $! || true' titled "$word" "$seconds" "$key" "$file" "$@"
}

rehearsalPlan() { # OUT
  screen 1280x1024 "$program" experiment check docs/examples/quality-and-light \
    --output "$tmp/check.html" >/dev/null
  sed -n '/<svg/,/<\/svg>/p' "$tmp/check.html" >"$1"
}

# The whole screen, as the banner is a window of its own, which without a window manager must be raised.
# The space bar goes on from the instruction.
rehearsalPreview() { # OUT
  screen 1280x800 bash -c '
    "$1" experiment preview docs/examples/change-blindness --from training --speed 1 >/dev/null 2>&1 &
    timeout 180 xdotool search --sync --onlyvisible --name Participant >/dev/null
    sleep 12
    for window in $(xdotool search --onlyvisible --class .); do
      eval "$(xdotool getwindowgeometry --shell "$window")"
      [ "$HEIGHT" -gt 60 ] || xdotool windowraise "$window"
    done
    import -window root "$2/instruction.png"
    xdotool mousemove 400 400 key space
    for ((i = 0; i < 40; i++)); do # Until the scene is seen, not the black between two pictures.
      sleep 0.3
      import -window root "$2/exposure.png"
      [ "$(identify -format %k "$2/exposure.png")" -lt 400 ] || break
    done
    kill $!
    wait $! || true' rehearsalPreview "$program" "$tmp"
  beside "$tmp/instruction.png" "$tmp/exposure.png" "$tmp/preview.png" 12
  small "$tmp/preview.png" "$1" -resize 1200x
}

sessionOperator() { # OUT
  study
  titled 'Operator' 23 '' "$tmp/operator.png" "$program" experiment run "$tmp/study/study.json" \
    --participant 001 --unattended --operator --exposure 60
  small "$tmp/operator.png" "$1" -resize 896x
}

trial() { # OUT
  study
  titled 'differs' 10 space "$tmp/trial.png" "$program" experiment threshold "$tmp/study/pilot" --participant 001
  small "$tmp/trial.png" "$1" -gravity north -crop 100%x60%+0+200 +repage -resize 900x
}

storyRoom() { # What docs/story-author.md makes of the room of the examples.
  local room=$tmp/my-room/room.x3d from=docs/examples/music-room.x3d object
  mkdir -p "$tmp/my-room"
  for object in Vase Trophy FloorLamp; do
    "$program" versions "$from" --object "$object" --vert-percent 8 --output "$room" >/dev/null
    from=$room
  done
  "$program" enrich "$room" --ratings docs/examples/music-room-ratings.csv >/dev/null
  sed -i "s/whichChoice='0'/whichChoice='1'/" "$room"
}

storyEnricher() { # OUT
  storyRoom
  ( # The window names the file as it was given.
    cd "$tmp"
    titled 'room' 15 '' "$tmp/enricher.png" "$program" enrich my-room/room.x3d
  )
  small "$tmp/enricher.png" "$1" -resize 1100x
}

storyKitchen() { # OUT: a figure of the report in docs/story-researcher.md
  "$program" experiment simulate --participants 54 --d-prime 1.1 --seed 2009 --output "$tmp/simulated.csv"
  "$program" experiment analyse "$tmp/simulated.csv" --figures "$tmp/figures" >/dev/null
  cp "$tmp/figures/kitchen-d_prime-all.svg" "$1"
}

replicationPage() { # OUT: the top of the page of docs/replication.md; needs Chromium
  "$program" experiment replicate "$tmp/replication" --date 2026-01-15 >/dev/null
  chromium --headless --no-sandbox --disable-gpu --hide-scrollbars --window-size=1200,1340 \
    --screenshot="$tmp/replication.png" "file://$tmp/replication/index.html" 2>/dev/null
  small "$tmp/replication.png" "$1" -resize 900x +dither -colors 128
}

webPage() { # OUT: the page of the apartment; needs Chromium, and what npm ci brings
  (cd web && PICTURE=$tmp/web.png npx vitest run --dir browser-test export-picture)
  small "$tmp/web.png" "$1" -resize 900x -colors 200
}

studyPage() { # STEM OUT RESIZE: a page of a study; needs the same
  mkdir -p "$tmp/web-study"
  (cd web && PICTURES=$tmp/web-study npx vitest run --dir browser-test study-layout)
  small "$tmp/web-study/$1.png" "$2" -resize "$3" -colors 64
}

take() { # NAME HOW
  local name=$1 how=$2 to=$out/$1 stem=${1%.*}
  case $name in
    apartment.jpg)
      shot "$tmp/above.png" 1920x800 scenes/apartment-lit.x3d --viewpoint OverviewView --condition high
      small "$tmp/above.png" "$to" -resize 960x400
      ;;
    apartment-*) apartment "${stem#*-}" "$to" ;;
    cornell-box.jpg) compared "$to" docs/examples/cornell-box.x3d --viewpoint Camera --size 128x128 --rays 256 ;;
    kitchen-reference.jpg) # Takes hours.
      compared "$to" scenes/apartment-unlit.x3d --viewpoint KitchenView --size 150x100 --rays 1024
      ;;
    radiosity-*) radiosity "${stem#*-}" "$to" ;;
    qualities.jpg) qualities "$to" ;;
    switch-fade.png) switching "$to" ;;
    trashcan-versions.png) trashcan "$to" ;;
    sculptures.jpg)
      shot "$tmp/sculptures.png" 1400x654 docs/examples/sculptures.x3dv
      small "$tmp/sculptures.png" "$to" -resize 700x327
      ;;
    story-room.jpg)
      shot "$tmp/room.png" 1920x960 docs/examples/music-room.x3d
      small "$tmp/room.png" "$to" -resize 960x480
      ;;
    story-enricher.png) storyEnricher "$to" ;;
    story-kitchen.svg) storyKitchen "$to" ;;
    side-by-side.jpg) stereo "$to" 1280x480 --display side-by-side ;;
    anaglyph.jpg) stereo "$to" 1024x768 --display anaglyph ;;
    hmd-check.png) stereo "$to" 1280x480 --hmd-check ;;
    dual.jpg) dual "$to" ;;
    head-log.svg) headlog "$to" ;;
    replication.png) replicationPage "$to" ;;
    tour-polygons.svg)
      "$program" simulate scenes/apartment.x3d --path scenes/paths/apartment-tour.csv --chart "$to" >/dev/null
      ;;
    overlay.png) overlay "$to" ;;
    operator.jpg) operator "$to" ;;
    rehearsal-plan.svg) rehearsalPlan "$to" ;;
    rehearsal-preview.jpg) rehearsalPreview "$to" ;;
    session-operator.jpg) sessionOperator "$to" ;;
    threshold-trial.png) trial "$to" ;;
    session-controls.png) fromTest SessionPictures "$stem" "$to" 534x ;;
    session-*) fromTest SessionPictures "$stem" "$to" 980x ;;
    study-*) fromTest StudyWindowPictures "$stem" "$to" 1000x ;;
    headset-questions.png)
      tested HeadsetQuestionsTest 1
      convert target/pictures/headset-questions-en.png target/pictures/headset-questions-el.png +append "$tmp/questions.png"
      small "$tmp/questions.png" "$to" -resize 1200x +dither -colors 255
      ;;
    enricher-fields.png)
      tested FormPanelTest 1
      small target/form-fields.png "$to" -gravity northwest -crop 384x612+0+0 +repage
      ;;
    enricher-areas.png | enricher-plan.png) driven "$stem" "$to" 1280x ;;
    enricher-find.png) driven "$stem" "$to" 1200x ;;
    enricher-cost.png) driven "$stem" "$to" 900x ;;
    enricher-compare.png) driven "$stem" "$to" 800x ;;
    enricher-handles.png) driven "$stem" "$to" 680x ;;
    enricher-qualities.png) driven "$stem" "$to" 438x -gravity north -crop 100%x85%+0+0 +repage ;;
    enricher-switch.png) driven "$stem" "$to" 438x ;;
    enricher-*)
      if [ "$how" = dialogs ]; then
        fromTest org.selectiverenderer.enricher.robot.PicturesTest "${stem#*-}-light-200" "$to" 1100x
      else
        driven "$stem" "$to" 1100x
      fi
      ;;
    export-web.png) webPage "$to" ;;
    web-study-list.png) studyPage "$stem" "$to" 900x ;;
    web-study-phone.png) studyPage "$stem" "$to" 390x ;;
    polygons-*) plotted PolygonsPageTest -Dpolygons.update=true "$name" ;;
    gaze-error.svg) plotted GazeFigureTest -Dplots.update=true "$name" ;;
    performance-*) plotted PerformancePlotsTest -Dplots.update=true "$name" ;;
    openxr.jpg)
      monado check
      small target/openxr.png "$to" -resize 1200x
      ;;
    openxr-window.jpg)
      monado window
      small target/openxr-window.png "$to" -resize 640x
      ;;
    *)
      say "$name: no recipe"
      return 1
      ;;
  esac
}

monado() { # WHAT .ci/openxr does; its reason where it cannot
  local status=0
  .ci/openxr "$1" || status=$?
  if [ "$status" -eq 75 ]; then
    say 'needs root and Monado in a system of its own: .ci/openxr setup'
  fi
  return "$status"
}

driven() { # NAME OUT WIDTH OPTIONS...: the enricher's window
  tested EnricherPictures 2 "-Dpictures=$driving"
  small "target/pictures/$1.png" "$2" "${@:4}" -resize "$3" +dither -colors 255
}

plotted() { # CLASS OPTION NAME: written in docs/pictures by a test
  tested "$1" 1 "$2"
  [ "$out" = "$PWD/docs/pictures" ] || cp "docs/pictures/$3" "$out/"
}

list() { echo "$pictures" | grep . ; }

if [ "${1:-}" = --list ]; then
  list | while read -r name how; do printf '%-34s %s\n' "$name" "$(explain "$how")"; done
  exit
fi

for tool in xvfb-run convert import xdotool mvn; do
  command -v "$tool" >/dev/null || {
    say "$tool is not there; Debian: apt-get install xvfb imagemagick xdotool maven"
    exit 2
  }
done

wanted=("$@")
if [ $# -eq 0 ]; then
  mapfile -t wanted < <(list | awk '$2 != "monado" { print $1 }')
fi
tmp=$(mktemp -d)
office=scenes/.pictures-$$.x3d
trap 'rm -rf "$tmp" "$office"' EXIT
mkdir -p "$out"
driving=$(list | awk '$2 == "enricher" { print $1 }' | grep -xF "$(printf '%s\n' "${wanted[@]}")" |
  sed 's/\.png$//' | paste -sd, || true)

failed=0
for name in "${wanted[@]}"; do
  how=$(list | awk -v name="$name" '$1 == name { print $2 }')
  if [ -z "$how" ]; then
    say "$name: no such picture; docs/pictures.sh --list names them"
    failed=2
  else
    set +e # Else the first failure would not end the taking of a picture but all.
    (
      set -e
      take "$name" "$how"
    )
    status=$?
    set -e
    if [ "$status" -eq 0 ]; then
      say "$name"
    else
      say "$name could not be taken; the one that is there stays"
      [ "$failed" -ne 0 ] || failed=1
    fi
  fi
done
exit "$failed"
