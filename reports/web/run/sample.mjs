// SPDX-License-Identifier: MIT
// A made-up run that fills every section, for the tests of the page and of the charts. Its numbers mean nothing, but
// its certificates are right. Same arguments, same run.

const methods = (
  "intersect decide distance exact seed2008-projection seedbook nlopt-direct-600 nlopt-direct-6000 fcl-libccd " +
  "fcl-libccd-tol1e-10 fcl-indep bullet-cylinder bullet-hull-16 bullet-hull-64 libccd-gjk libccd-mpr ode mujoco " +
  "mujoco-tol1e-10"
).split(" ");
const families = (
  "cases random touching_side_side touching_side_rim touching_rim_rim axes_parallel axes_nearly_parallel " +
  "needles disks segments far tiny_and_huge lattice coins_edge_to_edge touching_cap_rim touching_cap_side " +
  "touching_cap_cap touching_parallel_sides touching_needles touching_disks axes_perpendicular axes_crossing " +
  "needle_and_disk flat_disks points contained coaxial equal mixed_scale lattice_dust raw_axes close_contacts " +
  "close_contacts_by_angle close_rods close_rims range_ends whiskers"
).split(" ");
const own = 4;

/** Numbers in [0, 1), the same each time. */
function stream(seed) {
  let state = seed >>> 0;
  return () => {
    state = (Math.imul(state, 1664525) + 1013904223) >>> 0;
    return state / 2 ** 32;
  };
}

/** Two solids that are `gap` apart along x (negative: overlap), the second turned about x. */
function madeCase(next, gap) {
  const t = next() * Math.PI,
    r = 0.5 + next(),
    h = 1 + next();
  const pair = {
    a: { center: [0, 0, 0], axis: [0, 0, 1], radius: 1, height: 2 },
    b: { center: [1 + r + gap, 0, 0], axis: [0, Math.sin(t), Math.cos(t)], radius: r, height: h },
  };
  const size = 3 + r + h,
    margin = Math.abs(gap) / size;
  const truth =
    gap > 0 ? { verdict: "disjoint", direction: [1, 0, 0] } : { verdict: "intersecting", point: [1 + gap / 2, 0, 0] };
  return {
    pair,
    truth: { ...truth, distance: [gap - 1e-15, gap + 1e-15], stage: "filter" },
    margin: [margin, margin * (1 + 1e-12)],
    note: "a made-up pair",
    direction: [1, 0, 0],
    nearest: { a: [1, 0, 0], b: [1 + gap, 0, 0] },
  };
}

/** Adds wrong distances of a method and of another one; the margin of such a finding. */
function tellWrongDistance({ pair, truth, said }, m, error) {
  const size = pair.a.radius + pair.a.height + pair.b.radius + pair.b.height;
  const answer = { verdict: truth.verdict, distance: truth.distance[1] + error };
  said.push([answer, [m]], [{ ...answer, distance: truth.distance[1] + 1e-15 }, [10]]);
  if (m !== 11) said.push([{ ...answer, distance: truth.distance[0] - 2 * error }, [11]]);
  return [error / size, (error / size) * (1 + 1e-9)];
}

function claimOf(name) {
  if (methods.indexOf(name) < own) return { relative: 1e-13, absolute: 0, source: "derivation", stated: true };
  const stated = !name.startsWith("ode");
  return {
    relative: 0,
    absolute: name.includes("1e-10") ? 1e-10 : 1e-6,
    source: stated ? "its manual, line 12" : "it says nothing; as its likes",
    stated,
  };
}

const decades = Array.from({ length: 16 }, (_, i) => i);
/** The decade from which on a method is wrong more and more. */
const edge = (m) => (m < own ? 15 : 4 + ((m * 7) % 9));

export function sample(findings_total = 400) {
  const next = stream(20261122);
  const tallies = methods
    .flatMap((method, m) =>
      families
        .filter((_, f) => (m + f) % 11 !== 10)
        .map((family, f) => {
          const asked = 20000,
            prone = m >= own && (m * f) % 5 !== 0;
          return {
            method,
            family,
            asked,
            declined: m % 6 === 5 ? 900 : 0,
            failed: m === 16 && f % 4 === 1 ? 12 : 0,
            contract: prone && (m + f) % 3 === 0 ? Math.floor(10 ** (1 + 2.6 * next())) : 0,
            resolution: prone ? Math.floor(900 * next()) : 0,
            undecided: m === 1 && f < 5 ? 240 : 0,
            nanoseconds: asked * (30 + 300 * m * next()),
          };
        }),
    )
    .concat(
      ["corpus", "referee", "referee-filter", "referee-wide", "referee-exact"].map((method, i) => ({
        method,
        family: "random",
        asked: 20000,
        declined: 0,
        failed: 0,
        contract: 0,
        resolution: 0,
        undecided: i === 1 ? 2 : 0,
        nanoseconds: 20000 * 900 * (i + 1),
      })),
    );
  const kinds = ["wrong_disjoint", "wrong_intersecting", "distance_outside", "bad_witness", "crash"];
  const cases = [],
    findings = [];
  for (let i = 0; i < findings_total; ++i) {
    if (i % 4 === 0) {
      const gap = (next() < 0.5 ? -1 : 1) * 10 ** (-12 * next()) * 0.3,
        made = madeCase(next, gap);
      const right = { verdict: made.truth.verdict },
        wrong = { verdict: gap > 0 ? "intersecting" : "disjoint", distance: -gap };
      cases.push({
        ...made,
        said: [
          [right, [0, 1, 2, 3, 4]],
          [wrong, [8, 9, 14, 15]],
          [{ failed: "crash", reason: "SIGABRT" }, [16]],
          [{ declined: "" }, [13]],
        ],
      });
    }
    const m = own + ((i * 7) % (methods.length - own)),
      severity = i % 3 === 0 ? "contract" : "resolution";
    const kind = kinds[Math.floor(i / 7) % kinds.length];
    const off = kind === "distance_outside" && tellWrongDistance(cases.at(-1), m, 1e-5 * (1 + i));
    findings.push({
      id: i + 1,
      method: methods[m],
      kind,
      severity,
      family: families[(i * 5) % families.length],
      bucket: i % 2 === 0 ? `${methods[m].split("-")[0]}/${kind}/side-rim/angle` : null,
      margin: off || cases.at(-1).margin,
      case: cases.length - 1,
      ...(kind === "crash" ? { reason: "SIGABRT" } : {}),
    });
  }
  const standings = ["new", "known", "back"];
  const standingOf = (i) =>
    i === 7 ? "new" : i % 9 === 4 ? "back" : i % 11 === 6 ? "rare" : "known";
  const keys = [...new Set(findings.map((f) => f.bucket).filter((b) => b !== null))];
  const whole = (gap, method, kind) => {
    const made = madeCase(next, gap),
      right = { verdict: made.truth.verdict };
    const off = { ...right, distance: gap + 0.01 };
    return {
      ...made,
      answers: {
        intersect: right,
        ...(kind === "distance_outside" ? { "libccd-gjk": off } : {}),
        [method]: kind === "distance_outside" ? off : { verdict: gap > 0 ? "intersecting" : "disjoint" },
      },
      replay: "./daylight replay runs/sample:1",
    };
  };
  const runs = [19, 20, 21, 22].map((day) => ({ run: `202611${day}-220000-4`, started: `2026-11-${day}T22:00:00Z` }));
  const nightsOf = (standing, count) =>
    runs.map((run, n) => {
      const asked = 250000 + 10000 * n,
        seen = { new: n === 3, gone: n < 3, back: n !== 2, rare: n === 1 }[standing] ?? true;
      const found = seen ? Math.max(1, Math.round(count * (0.7 + 0.1 * n))) : 0,
        rate = (found / asked) * 1e6,
        spread = (2 * Math.sqrt(found + 1) * 1e6) / asked;
      return { ...run, count: found, asked, per_million: [rate, Math.max(0, rate - spread), rate + spread] };
    });
  const gone = "panda/wrong_intersecting/cap-rim/scale";
  const buckets = [...keys, gone].map((key, i) => {
    const [library, kind] = key.split("/"),
      of = findings.filter((f) => f.bucket === key),
      ids = of.map((f) => f.id),
      method = of[0]?.method ?? `${library}-gjk`;
    return {
      key,
      method,
      kind,
      severity: i % 3 === 0 || i === 7 ? "contract" : "resolution",
      feature: "side-rim",
      coordinate: "angle",
      labels: i % 2 ? ["iteration cap"] : ["absolute tolerance", "shared algorithm"],
      merged: i % 4 ? [] : [`${library}/${kind}/rim-rim/angle`],
      count: ids.length * 31,
      families: families.slice(0, 1 + (i % 5)),
      first_seen: "20261119-220000-4",
      last_seen: "20261122-060000-7",
      standing: key === gone ? "gone" : standingOf(i),
      chance: i % 2 ? 0.0004 : null,
      pairs: key === gone ? 0 : ids.length * 31,
      nights: nightsOf(key === gone ? "gone" : standingOf(i), key === gone ? 40 : ids.length * 31),
      first_version: "1.1",
      last_version: i % 2 ? "1.2" : "1.1",
      simplified: i % 5 !== 3,
      file: `runs/sample/buckets/${key.replaceAll("/", "_")}.jsonl`,
      cause: "a fixed length in it: right at another scale",
      mechanism: "absolute-length",
      methods: i % 2 ? [method] : [method, ...methods.slice(8, 10 + (i % 5)).filter((m) => m !== method)],
      seen_again: true,
      margin: [10 ** -(3 + (i % 9)), 0.01],
      share: { wrong: 3 + i, asked: 5000 },
      simplest: whole(i % 2 ? 1e-9 : -0.02, method, kind),
      worst: i === 1 ? null : whole(i % 2 ? 0.4 : -0.3, method, kind),
      suppressed: i === 5 ? { reason: "known upstream", link: "issue 1", owner: "me", expires: "2027-01-01" } : null,
      findings: ids,
    };
  });
  const bins = (low, high) => Array.from({ length: high - low + 1 }, (_, i) => `1e${low + i}`);
  const planes = {
    "angle-margin": [
      { title: "angle", labels: ["parallel", ...bins(-12, -1), "generic", "square"] },
      { title: "margin", labels: decades.map((d) => `1e-${d}`) },
    ],
    "aspect-margin": [
      { title: "aspect", labels: bins(0, 9) },
      { title: "margin", labels: decades.map((d) => `1e-${d}`) },
    ],
    "scale-offset": [
      { title: "scale", labels: bins(-9, 9) },
      { title: "offset", labels: bins(-2, 12) },
    ],
  };
  const maps = methods.flatMap((method, m) =>
    Object.entries(planes).map(([plane, [x, y]]) => {
      const cells = [];
      for (let i = 0; i < x.labels.length; ++i)
        for (let j = 0; j < y.labels.length; ++j) {
          if (next() < 0.12) continue;
          const asked = 50 + Math.floor(3000 * next()),
            rate = j < edge(m) ? 0 : Math.min(0.5, 10 ** ((j - edge(m)) / 2 - 3.5 + (i % 5) / 4));
          const wrong_disjoint = Math.floor(asked * rate * next()),
            wrong_intersecting = Math.floor(asked * rate * next());
          cells.push({
            x: i,
            y: j,
            asked,
            wrong_disjoint,
            wrong_intersecting,
            failed: 0,
            undecided: 0,
            declined: m % 6 === 5 ? Math.floor(asked / 10) : 0,
            within_disjoint: j > 12 ? wrong_disjoint : Math.floor(wrong_disjoint / 2),
            within_intersecting: j > 12 ? wrong_intersecting : 0,
            ...(wrong_disjoint + wrong_intersecting > 0 ? { finding: 1 + ((i * 31 + j) % findings_total) } : {}),
          });
        }
      return { method, plane, x, y, cells };
    }),
  );
  const honesty = methods.flatMap((method, m) =>
    [null, "random"].map((family) => ({
      method,
      family,
      bins: decades.map((decade) => {
        const asked = 3000,
          rate = decade < edge(m) ? 0 : Math.min(0.5, 10 ** ((decade - edge(m)) / 2 - 2.5));
        return {
          decade,
          asked,
          wrong_disjoint: Math.floor(asked * rate * next()),
          wrong_intersecting: Math.floor(asked * rate * 0.4),
          undecided: 0,
          declined: m % 6 === 5 ? 300 : 0,
        };
      }),
    })),
  );
  const speed = methods.flatMap((method, m) =>
    ["all", "random", "margin_1e-09"].flatMap((family) =>
      (m < own ? ["verdict", "certificate"] : ["verdict"]).map((query) => {
        const ns = (m < own ? 20 : 300) * (1 + m) ** 1.2 * (query === "certificate" ? 3 : 1),
          digits = m < own ? 14.5 : edge(m) - 0.5;
        const setting = /-(\d+|tol1e-\d+)$/.exec(method)?.[1] ?? "default";
        return {
          method,
          curve: method.replace(/-(\d+|tol1e-\d+)$/, ""),
          setting: setting.replace("tol", ""),
          family,
          query,
          ns,
          p99: ns * (2 + 3 * next()),
          max: ns * 40,
          asked: 20000,
          wrong_disjoint: m < own ? 0 : m * 3,
          wrong_intersecting: m < own ? 0 : (m * m) % 40,
          digits,
          digits_low: digits - 0.8,
        };
      }),
    ),
  );
  const cost = methods
    .filter((_, m) => m % 3 !== 1)
    .flatMap((method, k) =>
      decades.map((decade) => {
        const p50 = 40 * (1 + k * 3) * (1 + decade * 0.15);
        return { method, decade, p50, p99: p50 * (1.5 + decade * 0.2), max: p50 * 20 * (1 + next()) };
      }),
    );
  const paths = methods.slice(0, 12).flatMap((method, m) =>
    ["through touching", "through parallel axes"].map((path, k) => ({
      method,
      path,
      steps: 2001,
      flips: m < own ? 1 : 1 + 2 * ((m * 5) % 7),
      distance_jump: m < 2 ? null : 1e-15 * 10 ** m,
      direction_jump_degrees: m % 2 ? null : 0.01 * m * m,
      ...(m % 2 === 0
        ? {
            trace: Array.from({ length: 81 }, (_, i) => {
              const at = (i - 40) * 1e-9,
                noise = m < own ? 0 : (next() - 0.5) * 2e-8;
              const d = at + noise;
              return {
                at,
                verdict: d > 0 ? "disjoint" : d === 0 ? "touching" : "intersecting",
                distance: k === 0 ? d : null,
              };
            }),
          }
        : {}),
    })),
  );
  return {
    schema: 1,
    run: {
      id: "sample",
      seed: "1",
      pairs: 280000,
      started: "2026-11-22T00:00:00Z",
      status: "complete",
      seconds: 3721.5,
      build: "daylight, made up",
      command: "./daylight campaign --seed 1 --pairs 280000",
      folder: "runs/sample",
    },
    methods: methods.map((name, m) => ({
      name,
      version: "1.2",
      claim: claimOf(name),
      own: m < own,
      share: name.startsWith("nlopt") ? 64 : 1,
    })),
    families: families.map((name) => ({ name, summary: `pairs of ${name}` })),
    tallies,
    changes: {
      ...Object.fromEntries(
        ["new", "back", "gone", "known", "rare"].map((s) => [s, buckets.filter((b) => b.standing === s).length]),
      ),
      against: runs.slice(0, 3).map(({ run }) => run),
    },
    history: {
      runs: 3,
      groups: findings
        .slice(0, 60)
        .map((f, i) => ({
          method: f.method,
          kind: f.kind,
          severity: f.severity,
          family: i % 4 === 3 ? "retired" : f.family,
          count: 3 + i,
          standing: [...standings, "gone"][i % 4],
        })),
    },
    buckets,
    findings,
    findings_total: findings_total * 5,
    cases,
    names: methods,
    maps,
    honesty,
    speed,
    cost,
    paths,
  };
}
