# SPDX-License-Identifier: MIT
# same_run RUN RUN : whether two runs hold the same findings, groups and counts; times and hangs, which are of the
# machine, apart. Prints what differs.
content() {
  python3 - "$1" <<'PY'
import sqlite3
import sys
db = sqlite3.connect(sys.argv[1] + '/run.sqlite')
HANGS = ("(SELECT coalesce(sum(count), 0) FROM finding_group g WHERE kind='hang' AND g.method=t.method "
         "AND g.family=t.family)")
for query in ("SELECT 'finding', * FROM finding WHERE kind<>'hang' ORDER BY id",
              "SELECT 'group', * FROM finding_group WHERE kind<>'hang' ORDER BY 2, 3, 4, 5",
              f"SELECT 'tally', method, family, asked, declined, failed - {HANGS}, contract, resolution, undecided "
              "FROM tally t ORDER BY 2, 3"):
    for row in db.execute(query):
        print(row[0], *row[2 if row[0] == 'finding' else 1:], sep='|')  # a hang before it takes an id
PY
}
same_run() {
  [[ -n $(content "$1") ]] && diff <(content "$1") <(content "$2") | head -20
  return "${PIPESTATUS[0]}"
}

# done_of RUN : "indices milliseconds" that its store holds.
done_of() {
  python3 -c 'import sqlite3, sys
db = sqlite3.connect(f"file:{sys.argv[1]}/run.sqlite?mode=rw", uri=True)
print(*db.execute("SELECT next, milliseconds FROM progress").fetchone())' "$1"
}

# kill_shard OUT I : waits until shard I in OUT has stored something, then kills it. It stands still while its store is
# looked at, so that it cannot end meanwhile.
kill_shard() {
  local pid stored
  for _ in {1..12000}; do # ten minutes and more
    if pid=$(pgrep -o -f -- "--resume $1/shard-$2 ") && kill -STOP "$pid" 2>/dev/null; then
      if stored=$(done_of "$1/shard-$2" 2>/dev/null) && [[ $stored != '0 '* ]]; then
        kill -KILL "$pid"
        return
      fi
      kill -CONT "$pid"
    fi
    sleep 0.05
  done
  echo "shard $2 never stored anything"
  return 1
}
