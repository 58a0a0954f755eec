# Shared by scripts/run and scripts/test, which source it: packages, configuring, building, one line per step.
# shellcheck shell=bash
#
# Messages go to stderr, so that stdout carries only what `npsee` or ctest print. Steps with nothing to do say nothing.

# readlink -f: the scripts also work through a symbolic link from elsewhere.
root=$(cd -P -- "$(dirname -- "$(readlink -f -- "${BASH_SOURCE[0]}")")/.." && pwd)
preset=${preset:-release}
build=$root/build/$preset
logs=$root/build/logs

say() { printf '%s\n' "$*" >&2; }
die() {
  say "$@"
  exit 1
}

# The packages of the given groups of packages.txt.
packages_of() {
  local group
  for group in "$@"; do
    awk -v wanted="[$group]" '/^\[/ { inside = ($1 == wanted); next } inside && NF && $1 !~ /^#/ { print $1 }' "$root/scripts/packages.txt"
  done
}

# Those of the given packages that are not installed. One dpkg-query, which takes a few hundredths of a second.
missing_of() {
  printf '%s\n' "$@" | grep -vxFf <(dpkg-query -W -f '${Package} ${db:Status-Status}\n' "$@" 2>/dev/null | sed -n 's/ installed$//p') || true
}

# How far a step has come, in percent, read from its log; nothing while that is unknown.
percent_of() {
  case $1 in
    packages) awk '/newly installed/ { for (i = 2; i <= NF; ++i) if ($i == "newly") total += 2 * $(i - 1) }
                   /^(Unpacking|Setting up) / { ++done } END { if (total) print int(100 * done / total) }' "$2" ;;
    build) tail -n 40 "$2" | awk -F '[][/]' '/^\[[0-9]+\/[0-9]+\]/ { p = 100 * $2 / $3 } END { if (p) print int(p) }' ;;
    test) tail -n 400 "$2" | awk '/^ *[0-9]+\/[0-9]+ Test/ { split($1, f, "/"); p = 100 * f[1] / f[2] } END { if (p) print int(p) }' ;;
  esac
}

# The line of a running step, until the script that shows it ends it or is gone.
progress() {
  local kind=$1 title=$2 log=$3 percent shown=0
  exec 8>&-  # or its last sleep would keep the lock for a moment
  while sleep 0.5 && kill -0 $$ 2>/dev/null; do
    percent=$(percent_of "$kind" "$log")
    if [ -t 2 ]; then
      printf '\r%s ... %s%d s \033[K' "$title" "${percent:+$percent %, }" $((SECONDS - began)) >&2
    elif [ "${percent:-0}" -ge $((shown + 20)) ]; then
      # A log file or a CI page gets a sign of life now and then, still on the same line.
      shown=$((percent / 20 * 20))
      printf ' %d%%' "$shown" >&2
    fi
  done
}

# step KIND TITLE COMMAND...: runs the command with its output in build/logs/KIND.log and shows one line with progress.
# Returns the command's exit code; step_failed shows what the log says.
step() {
  local kind=$1 title=$2 log=$logs/$1.log code=0 began=$SECONDS result="done" shower
  shift 2
  mkdir -p "$logs"
  : >"$log"
  printf '%s ...' "$title" >&2
  # The progress line is the background job and not the command, which so keeps its signals (Ctrl-C ends it).
  progress "$kind" "$title" "$log" &
  shower=$!
  "$@" </dev/null >"$log" 2>&1 || code=$?
  kill "$shower" 2>/dev/null || true
  wait "$shower" 2>/dev/null || true
  [ "$code" -eq 0 ] || result="failed"
  if [ -t 2 ]; then printf '\r%s: %s, %d s\033[K\n' "$title" "$result" $((SECONDS - began)) >&2
  else printf ' %s, %d s\n' "$result" $((SECONDS - began)) >&2; fi
  return "$code"
}

# What went wrong, from the log of a step: the errors of compiler and linker where there are some, else its last lines.
step_failed() {
  local log=$logs/$1.log errors
  errors=$(grep -E -A 2 'error:|Error|undefined reference|multiple definition' "$log" | cut -c 1-240 | head -n 40 || true)
  if [ "$1" != packages ] && [ -n "$errors" ]; then say "$errors"; else tail -n 30 "$log" >&2; fi
  die "The whole log is in $log"
}

# Commands as root: nothing before them for root, sudo for others.
elevate=()
need_root() {
  [ "$(id -u)" -ne 0 ] || return 0
  local wanted="apt-get install --no-install-recommends $*"
  command -v sudo >/dev/null || die "These Debian packages are missing, and installing them takes root or sudo:" "
  $wanted" "
Let an administrator run this line (as root), then start again."
  # The password is asked here, not behind the progress line. Without a terminal nobody could type one.
  if ! sudo -n true 2>/dev/null; then
    { : </dev/tty; } 2>/dev/null || die "sudo wants a password, and there is no terminal to type it on. Run as root:" "
  $wanted"
    say "Debian packages have to be installed ($*); sudo may ask for your password."
    sudo -v || die "sudo refused. Let an administrator run:" "
  $wanted"
  fi
  elevate=(sudo)
}

apt() {
  "${elevate[@]}" env DEBIAN_FRONTEND=noninteractive apt-get -y -o Acquire::Retries=3 -o DPkg::Lock::Timeout=600 "$@"
}

# Installs; refreshes the lists only if that does not work (none yet, or too old), and gives a bad network three chances.
apt_install() {
  local attempt
  for attempt in 0 3 10; do
    sleep "$attempt"
    apt install --no-install-recommends "$@" && return
    apt update || true
  done
  apt install --no-install-recommends "$@"
}

# install_packages GROUP...: brings the machine to what packages.txt says. NPSEE_PACKAGES=skip trusts what is there.
install_packages() {
  [ "${NPSEE_PACKAGES:-}" != skip ] || return 0
  local packages missing
  mapfile -t packages < <(packages_of "$@")
  if ! command -v apt-get >/dev/null || ! command -v dpkg-query >/dev/null; then
    die "This is not a Debian system (no apt-get). npsee is built with these Debian 12 packages; install what they are called here:" "
  ${packages[*]}" "
and start again with NPSEE_PACKAGES=skip in the environment."
  fi
  mapfile -t missing < <(missing_of "${packages[@]}")
  [ ${#missing[@]} -gt 0 ] || return 0
  need_root "${missing[@]}"
  step packages "Installing ${#missing[@]} Debian packages" apt_install "${missing[@]}" || step_failed packages
}

# A value in CMake's cache; nothing before the first configuring.
cached() { [ ! -f "$build/CMakeCache.txt" ] || sed -n "s/^$1:[^=]*=//p" "$build/CMakeCache.txt"; }

# configure ON|OFF: with or without tests. A tree that has tests keeps them, so that run and test do not take turns in
# configuring. Ninja follows changes of CMakeLists.txt by itself, but does not know the presets.
configure() {
  local tests=$1
  [ "$(cached NPSEE_TESTS)" != ON ] || tests=ON
  # A tree that was moved or copied has the old place in its cache.
  local home
  home=$(cached CMAKE_HOME_DIRECTORY)
  [ -z "$home" ] || [ "$home" = "$root" ] || rm -rf "$build"
  if [ -f "$build/build.ninja" ] && [ ! "$root/CMakePresets.json" -nt "$build/build.ninja" ] && [ "$(cached NPSEE_TESTS)" = "$tests" ]; then return; fi
  step configure "Configuring" cmake -S "$root" --preset "$preset" -DNPSEE_TESTS="$tests" || step_failed configure
  # CMake leaves an unchanged file alone; its new date says that the presets were looked at.
  touch "$build/build.ninja"
}

# build_targets TARGET...: quiet where nothing is to do.
build_targets() {
  local plan
  # Configures again where CMake's files or a folder it lists have changed; nearly always there is nothing to do.
  ninja -C "$build" build.ninja >"$logs/configure.log" 2>&1 || step_failed configure
  # A dry run takes that check for work of its own, but leaves it out for a plan under another name.
  ln -sf build.ninja "$build/plan.ninja"
  plan=$(ninja -C "$build" -f plan.ninja -n "$@" 2>&1) && [[ $plan == *"no work to do"* ]] && return
  step build "Building" ninja -C "$build" "$@" || step_failed build
}

# A tree built by root cannot be built by its user afterwards; say so before anything else does.
writable_build() {
  local folder
  mkdir -p "$logs" 2>/dev/null || true
  for folder in "$root/build" "$logs" "$build"; do
    if [ ! -w "$folder" ] && { [ -e "$folder" ] || [ "$folder" != "$build" ]; }; then
      die "$folder cannot be written. It belongs to another user (built as root?): remove $root/build, or run as that user."
    fi
  done
}

# set_up ON|OFF GROUPS TARGET...: everything from a bare machine to the built targets.
set_up() {
  local tests=$1 groups=$2
  shift 2
  writable_build
  # shellcheck disable=SC2086  # several groups in one word
  install_packages $groups
  # Two builds of one tree at a time would trip over each other.
  exec 8>"$root/build/.lock"
  flock -w 1 8 || { say "Waiting for another build of this tree ..."; flock 8; }
  configure "$tests"
  build_targets "$@"
  exec 8>&-
}
