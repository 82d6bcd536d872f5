#!/usr/bin/env bash
# Checks with other people's readers what vox writes; see check.py. Needs Python 3 and Node with npm, and says so where
# they are missing. Packages go to target/readers, for this check alone.
set -euo pipefail
cd "$(dirname "$0")/../.."
data=${VOX_DATA:-../shared/data}
place=target/readers

for program in python3 node npm; do
    if ! command -v "$program" > /dev/null; then
        echo "skipped: checking files with other readers needs $program"
        exit 0
    fi
done
if ! [ -f "$data/../tools/strict_check.py" ]; then
    echo "skipped: there are no buildings to convert in $data"
    exit 0
fi

mkdir -p "$place"
[ -d "$place/venv" ] || python3 -m venv "$place/venv"
"$place/venv/bin/pip" install --quiet --disable-pip-version-check -r tests/readers/requirements.txt
cp tests/readers/package.json "$place/"
npm install --silent --no-fund --no-audit --prefix "$place"
cargo build --quiet
"$place/venv/bin/python" tests/readers/check.py target/debug/vox "$data" "$place/node_modules"
