#!/bin/sh
# Builds the bundle anew and compares it with the one that is committed. For developers: needs `npm ci` before.
set -e
cd "$(dirname "$0")"
kept=$(mktemp -d)
trap 'rm -rf "$kept"' EXIT
cp dist/report.js dist/report.css "$kept"
npm run --silent types
npm run --silent build 2>/dev/null
for file in report.js report.css; do
  if ! cmp -s "dist/$file" "$kept/$file"; then
    echo "web/dist/$file was not made from web/src as it stands: commit the one built just now" >&2
    exit 1
  fi
done
echo "web/dist is up to date"
