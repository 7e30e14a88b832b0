#!/usr/bin/env bash
# The paper's figures and tables with this project's data. Installs what is missing, builds, and writes
# docs/gallery.md and docs/pictures/gallery/*.png. Takes a few minutes once built. Safe to run again.
#   Utilities/gallery/gallery.sh                   all of it
#   Utilities/gallery/gallery.sh city graph        pictures of these examples alone, to gallery-output/; figures printed
# The input data of the examples go to gallery-output/ as well, to be opened in ParaView.
set -euo pipefail
cd "$(dirname "$0")/../.."

source Utilities/demo/build_plugin.sh
build_plugin -DSURFACEFLATTENING_BENCHMARKS=ON

if [ $# -gt 0 ]; then
  where=(--pictures gallery-output --inputs gallery-output "$@")
else
  results=$build/Testing/gallery.json
  "$build/Testing/bin/BenchmarkFlattening" --benchmark_filter='^paper: ' --benchmark_out="$results" \
    --benchmark_out_format=json >/dev/null
  tables=$build/Testing/gallery_tables.md
  {
    printf '## Comparison (Table 1)\n\n'
    cat Utilities/gallery/table1.md
    python3 Testing/Benchmarks/markdown_table.py "$results" | sed 's/^| paper: /| /'
  } >"$tables"
  where=(--pictures docs/pictures/gallery --page docs/gallery.md --inputs gallery-output --tables "$tables")
fi
# The server must not start anew when its last client leaves: ParaView tries the screen before it uses it.
LIBGL_ALWAYS_SOFTWARE=1 xvfb-run -a -s "-screen 0 2100x1180x24 -noreset" \
  pvpython --force-offscreen-rendering Utilities/gallery/gallery.py --plugin "$plugin" "${where[@]}"
