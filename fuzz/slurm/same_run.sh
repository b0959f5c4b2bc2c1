# SPDX-License-Identifier: MIT
# same_run RUN RUN : whether two runs hold the same findings, groups and counts; times apart. Prints what differs.
content() {
  python3 - "$1" <<'PY'
import sqlite3
import sys
db = sqlite3.connect(sys.argv[1] + '/run.sqlite')
for query in ("SELECT 'finding', * FROM finding ORDER BY id",
              "SELECT 'group', * FROM finding_group ORDER BY 2, 3, 4, 5",
              "SELECT 'tally', method, family, asked, declined, failed, contract, resolution, undecided "
              "FROM tally ORDER BY 2, 3"):
    for row in db.execute(query):
        print(*row, sep='|')
PY
}
same_run() {
  [[ -n $(content "$1") ]] && diff <(content "$1") <(content "$2") | head -20
  return "${PIPESTATUS[0]}"
}

# kill_shard OUT I : waits until shard I in OUT has stored something, then kills it.
kill_shard() {
  local pid
  for _ in {1..300}; do
    if pid=$(pgrep -o -f -- "--resume $1/shard-$2 ") &&
      [[ $(python3 -c 'import sqlite3, sys; print(sqlite3.connect(sys.argv[1]).execute("SELECT next FROM progress").fetchone()[0])' "$1/shard-$2/run.sqlite") != 0 ]]; then
      kill -KILL "$pid"
      return
    fi
    sleep 0.05
  done
  echo "shard $2 never stored anything"
  return 1
}
