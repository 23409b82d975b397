#!/bin/sh
# The script at the top of the repository, tried on a checkout that holds nothing but itself, with a stand-in for the
# program and for every tool that it would call to install or build.
#   sh script.sh PATH/TO/epure
set -u
script=$1
place=$(mktemp -d) || exit 1
trap 'rm -rf "$place"' EXIT
checkout="$place/a check out"
tools="$place/tools"
calls="$place/calls" # one line for each call of a stand-in tool
failures=0

mkdir -p "$checkout/build/bin" "$checkout/geometry" "$checkout/drawings" "$checkout/exercises" "$checkout/words" "$tools" "$place/else where"
cp "$script" "$checkout/epure"
touch "$checkout/CMakeLists.txt" "$checkout/CMakePresets.json" "$checkout/drawings/picture.h"

cat > "$checkout/build/bin/epure" << 'END'
#!/bin/sh
[ "${1-}" = exit ] && exit "$2"
pwd
printf '[%s]' "$@"
END
chmod +x "$checkout/build/bin/epure"

stand_in() { # stand_in NAME COMMAND: notes its call, then does COMMAND
  printf '#!/bin/sh\nprintf "%%s\\n" "%s $*" >> "%s"\n%s\n' "$1" "$calls" "$2" > "$tools/$1"
  chmod +x "$tools/$1"
}
# shellcheck disable=SC2016  # the stand-in expands it
everything_installed='case $2 in *Status*) ;; *Version*) echo "${flint-3.1.3-1}"; exit ;; *) exit ;; esac
for p; do case $p in -*) ;; *) printf "%s=installed " "$p" ;; esac; done'
stand_in dpkg-query "$everything_installed"
stand_in cmake 'echo noise; echo noise >&2'
stand_in ctest 'echo 100% tests passed'
stand_in apt-get ''
stand_in sudo 'exec "$@"'
stand_in id 'echo 1000'
PATH="$tools:$PATH"
export PATH

expect() { # expect WHAT EXPECTED ACTUAL
  if [ "$2" != "$3" ]; then
    printf 'FAILED: %s\n  expected: %s\n  actual:   %s\n' "$1" "$2" "$3"
    failures=$((failures + 1))
  fi
}
forget_calls() { : > "$calls"; }
forget_calls

cd "$place/else where" || exit 1
here=$(pwd)
up_to_date() { printf '%s\n' "$checkout" > "$checkout/build/epure-built"; }

# Everything in place: straight to the program.
up_to_date
expect 'arguments and working directory reach the program' \
  "$here
[draw][two words][][*][it's][--set][r=1/5 m]" "$("$checkout/epure" draw 'two words' '' '*' "it's" --set 'r=1/5 m' 2>&1)"
"$checkout/epure" exit 3
expect 'the exit code is that of the program' 3 $?
ln -s "$checkout/epure" link
expect 'it works through a link' "$here
[list]" "$(./link list 2>&1)"
expect 'it works when a shell is given its name' "$checkout
[list]" "$(cd "$checkout" && sh epure list 2>&1)"
expect 'no tool is called when everything is in place' '' "$(cat "$calls")"

# What others may have put where PATH leads is not run, whatever its name.
planted() { # planted FOLDER: every tool of the script
  for tool in find id readlink cmake ctest dpkg-query apt-get sudo mkdir touch mv nproc flock env; do
    printf '#!/bin/sh\n: > "%s/pwned"\n' "$place" > "$1/$tool"
    chmod +x "$1/$tool"
  done
}
mkdir "$place/open"
planted "$place/open"
chmod 1777 "$place/open"
planted .
for path in "$place/open:$PATH" ".:$PATH" ":$PATH" "$PATH:" "$place/open:.::$PATH"; do
  expect 'the program is run' "$here
[list]" "$(PATH=$path "$checkout/epure" list 2>&1)"
  touch "$checkout/drawings/picture.h"
  expect 'and built' "$here
[list]" "$(PATH=$path "$checkout/epure" list 2> messages)"
  expect 'by nothing that others put there' '' "$(ls "$place/pwned" 2> /dev/null)"
done
expect 'and it is told' 1 \
  "$(grep -cF "epure: left out of PATH, as others may put programs there: \".\" \"\" \"$place/open\"" messages)"
for tool in find id readlink cmake ctest dpkg-query apt-get sudo mkdir touch mv nproc flock env; do rm "$tool"; done
forget_calls

# A checkout of any name, and by a link to it.
# shellcheck disable=SC2016  # it is to be taken as it is
odd=$place/'it'"'"'s "odd" $(touch pwned) `touch pwned` ;& * -x'
cp -R "$checkout" "$odd"
printf '%s\n' "$odd" > "$odd/build/epure-built"
expect 'a checkout may have any name' "$here
[a b]" "$("$odd/epure" 'a b' 2>&1)"
rm "$odd/build/epure-built"
expect 'and is built there' "$here
[a b]" "$("$odd/epure" 'a b' 2> /dev/null)"
ln -s "$odd" "$place/linked folder"
expect 'and run by a link to its folder' "$here
[a b]" "$("$place/linked folder/epure" 'a b' 2>&1)"
expect 'and nothing of its name is run' '' "$(find "$place" -name pwned)"
forget_calls
up_to_date

# Something changed: build, and keep standard output for the program.
for change in "$checkout/drawings/picture.h" "$checkout/exercises/new.cpp" "$checkout/words/words.h" "$checkout/CMakeLists.txt"; do
  forget_calls
  up_to_date
  sleep 0.02 # longer than a tick of the file system's clock
  touch "$change"
  expect "standard output is the program's own" "$here
[check]" "$("$checkout/epure" check 2> messages)"
  expect "a change of $change is built" 2 "$(grep -c '^cmake' "$calls")"
  expect 'a build that succeeds says one line' 'epure: building' "$(cat messages)"
  forget_calls
  "$checkout/epure" check > /dev/null 2>&1
  expect 'and is not repeated' '' "$(cat "$calls")"
done
sleep 0.02
rm "$checkout/exercises/new.cpp"
"$checkout/epure" check > /dev/null 2>&1
expect 'a deleted file is noticed' 2 "$(grep -c '^cmake' "$calls")"
forget_calls
printf '/another/checkout\n' > "$checkout/build/epure-built"
"$checkout/epure" check > /dev/null 2>&1
expect 'a build made elsewhere is not trusted' 2 "$(grep -c '^cmake' "$calls")"

# Failures.
stand_in cmake 'echo what went wrong; exit 1'
rm "$checkout/build/epure-built"
expect 'a failing build says why, and the program does not run' 'epure: building (a few minutes the first time)
what went wrong
epure: configuring failed, see above' "$("$checkout/epure" check 2>&1 < /dev/null)"
"$checkout/epure" check > /dev/null 2>&1
expect 'a failing build exits with 2' 2 $?
stand_in cmake ''

# Packages.
installs() { sed -n 's/^apt-get .*install -y --no-install-recommends //p' "$calls"; }
stand_in dpkg-query "$everything_installed | sed 's/catch2=installed/catch2=config-files/; s/libfmt-dev=installed//'"
forget_calls
"$checkout/epure" check > /dev/null 2>&1
expect 'what is missing is installed, and nothing for the tests alone' 'libfmt-dev' "$(installs)"
expect 'with sudo' 2 "$(grep -c '^sudo' "$calls")"
expect 'and no tests are asked for' 0 "$(grep -c 'BUILD_TESTING=ON' "$calls")"
forget_calls
"$checkout/epure" test > /dev/null 2>&1
expect 'the tests install what they need' 'libfmt-dev catch2' "$(installs)"
expect 'and are asked for' 1 "$(grep -c '^cmake .*-DBUILD_TESTING=ON' "$calls")"
stand_in dpkg-query "$everything_installed | sed 's/libcalcium-dev=installed//'"
forget_calls
"$checkout/epure" test > /dev/null 2>&1
expect 'FLINT 3 stands alone' '' "$(installs)"
flint=2.9.0-5 "$checkout/epure" test > /dev/null 2>&1
expect 'FLINT 2 needs its companions' 'libcalcium-dev' "$(installs)"
stand_in dpkg-query "$everything_installed | sed 's/libfmt-dev=installed//'"
stand_in apt-get 'exit 100'
rm -f "$checkout/build/epure-built"
"$checkout/epure" check > messages 2>&1
expect 'a failing installation exits with 2' 2 $?
expect 'and names the packages' 'epure: apt-get could not install: libfmt-dev' "$(tail -n 1 messages)"

# Tests.
stand_in dpkg-query "$everything_installed"
forget_calls
"$checkout/epure" test --fuzz soon > messages 2>&1
expect 'fuzzing asks for a time' 'epure: --fuzz takes a time, such as 600s, 10m or 8h, not "soon"' "$(cat messages)"
"$checkout/epure" test -R 'a name' > messages 2>&1
expect 'passing tests exit with 0' 0 $?
expect 'test builds everything' 1 "$(grep -c '^cmake --build .* --target all' "$calls")"
expect 'test hands its options to ctest' 1 "$(grep -c '^ctest .* -R a name$' "$calls")"
stand_in ctest 'exit 8'
"$checkout/epure" test > messages 2>&1
expect 'failing tests exit with 1' 1 $?

[ "$failures" -eq 0 ] && echo 'the script does what it says'
exit "$failures"
