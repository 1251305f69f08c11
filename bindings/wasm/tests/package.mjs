// The package as it is installed: npm puts the packed file into a fresh folder, and every question is asked there,
// from an ES module and from CommonJS. usage: node package.mjs PACKAGE.tgz
import assert from "node:assert/strict";
import { execFileSync } from "node:child_process";
import { mkdtempSync, readFileSync, rmSync, writeFileSync } from "node:fs";
import { createRequire } from "node:module";
import { tmpdir } from "node:os";
import { join, resolve } from "node:path";
import { pathToFileURL } from "node:url";

const FRAMES = readFileSync(new URL("../../../docs/examples/frames.jsonl", import.meta.url), "utf8");

const tests = {
  "the first page's example"({ solve }) {
    const answer = solve("x + y <= 3\n2y < x - 4");
    assert.equal(answer.verdict, "feasible");
    assert.deepEqual(JSON.parse(JSON.stringify(answer.point)), { x: "0", y: "-3" });
  },

  "a conflict names its rows"({ solve, check }) {
    const text = "vars: x y\na: x + y <= 1\nb: x >= 1\nc: y > 0\nd: x <= 9";
    const answer = solve(text, { proof: true });
    assert.equal(answer.feasible, false);
    assert.deepEqual(answer.conflict.map((c) => [c.row, c.label, String(c.multiplier)]), [[0, "a", "1"], [1, "b", "1"], [2, "c", "1"]]);
    assert.equal(check(text, answer.proof.text).accepted, true);
    assert.equal(check("x + y <= 2\nx >= 1\ny > 0\nx <= 9", answer.proof.text).accepted, false);
    assert.deepEqual(answer.proof.claims[0].multipliers.map((m) => m.row), [0, 1, 2]);
  },

  "boxes are exact"({ bounds }) {
    const { box } = bounds({ matrix: [[3, 1], [-1, 0], [0, -1]], relations: ["<=", "<=", "<"], right: [1, 0, 0] });
    assert.equal(String(box.x1.upper.value), "1/3");
    assert.equal(Number(box.x1.upper.value), 1 / 3);
    assert.equal(box.x1.upper.attained, false);
    assert.equal(box.x1.lower.attained, true);
    assert.deepEqual(bounds("x >= 1", ["x"]).box.x.upper, { kind: "infinite", attained: false, value: null });
  },

  "numbers of arrays mean what they say"({ system }) {
    const double = system({ matrix: [[0.1, 1]], right: [0.5] }), text = system({ matrix: [["0.1", 1n]], right: ["1/2"], variables: ["a", "b"] });
    assert.equal(String(double.row(0).terms[0].coefficient), "3602879701896397/36028797018963968");
    assert.equal(Number(double.row(0).terms[0].coefficient), 0.1);
    assert.equal(String(text.row(0).terms[0].coefficient), "1/10");
    assert.deepEqual(text.variables, ["a", "b"]);
    assert.equal(text.toText(), "vars: a b\n1/10 a + b <= 1/2\n");
    double.free();
  },

  "projection, reduction, vertices"({ project, reduce, vertices }) {
    const text = "0 <= x <= z\nz <= y\ny <= 4";
    assert.equal(project(text, ["x", "y"]).system.toText(), "vars: x y\n-x <= 0\ny <= 4\nx - y <= 0\n");
    assert.deepEqual(reduce("x <= 1\nx <= 2\nx >= 0").fates, ["kept", "redundant", "kept"]);
    const { generators } = vertices("x >= 0\ny >= 0\n2x + y <= 1");
    assert.deepEqual(generators.map((g) => g.point.join(" ")).sort(), ["0 0", "0 1", "1/2 0"]);
  },

  "optima with the rows that prove them"({ optimize, check }) {
    const text = "x + 2y <= 4\nx >= 0\ny >= 0\nx <= 3";
    const { optimum, proof } = optimize(text, { max: "x + 3y" }, { proof: true });
    assert.equal(String(optimum.value), "6");
    assert.equal(check(text, proof.text).accepted, true);
    assert.equal(optimize(text, { min: [1, 0] }).optimum.value.value, 0);
    assert.equal(optimize("x >= 1\nmax: x").optimum.kind, "infinite");
  },

  "a trace tells of rules and rows"({ solve }) {
    const { trace } = solve("x + y <= 1\nx - y <= 1\n-x + y <= 0\n-x - y <= -9", { method: "fm", rules: "kohler", presolve: "none", trace: "rows" });
    assert.ok(trace.some((e) => e.event === "row" && e.parents.length === 2));
    assert.equal(trace.at(-1).event, "end");
  },

  "frames"({ intersect, exactBox, distance, depth, separate, common }) {
    const train = { type: "cuboid", orig: [0, 0], comp: [[4, 0], [0, 1]] };
    const car = { type: "cuboid", orig: [7, 0.5], comp: [[2, 0], [0, 1]], vel: [-4, 0] };
    const still = { ...car, vel: undefined };
    assert.deepEqual(intersect(train, car).time, [0.75, 1]);
    assert.equal(intersect(train, still).meet, false);
    assert.equal(String(exactBox(train, car).box.t.lower.value), "3/4");
    assert.equal(String(distance(train, still).measure), "9");
    assert.deepEqual(distance(train, still, { norm: "max" }).length, 3);
    assert.equal(separate(train, still).row.terms[0].variable, 0);
    const near = { ...still, orig: [3, 0.5] };
    assert.equal(String(depth(train, near).measure), "1/4");
    assert.equal(common(train, near).vertices.length, 4);
    assert.equal(intersect(train, { ...still, orig: [4, 0] }, { contact: "open" }).meet, false);
    assert.equal(intersect({ type: "triangle", points: [[0, 0], [1, 0], [0, 1]] }, train).meet, true);
  },

  "the README's frames, whose decimals are exact"({ exactBox }) {
    const ends = ({ box }) => box && ["x1", "x2", "t"].filter((name) => name in box).map((name) => `${box[name].lower.value} ${box[name].upper.value}`).join(", ");
    const decimal = (x) => (Array.isArray(x) ? x.map(decimal) : typeof x === "number" ? String(x) : x);
    const exactly = (frame) => Object.fromEntries(Object.entries(frame).map(([name, value]) => [name, decimal(value)]));
    const found = FRAMES.trim().split("\n").map((line) => JSON.parse(line)).map(({ id, A, B }) => [id, ends(exactBox(exactly(A), exactly(B)))]);
    assert.deepEqual(found, [["tile and wedge", "2 131/38, 1 27/11"], ["neighbours", "1 1, 1/2 1"], ["train and car", "3 4, 3/5 1, 3/4 1"], ["ships at night", null]]);
  },

  "meshes"({ mesh, meshMeet }) {
    const text = "OFF\n6 2 0\n0 0 0\n2 0 0\n0 2 0\n0.5 0.5 -1\n0.5 0.5 1\n3 3 0\n3 0 1 2\n3 3 4 5\n";
    const two = mesh(text);
    assert.equal(two.size, 2);
    assert.deepEqual(meshMeet(two).hits, [{ a: 0, b: 1, shared: 0, how: "cross" }]);
    assert.equal(meshMeet({ points: two.points, cells: two.cells }).hits.length, 1);
    two.free();
  },

  "limits and mistakes"({ solve, system, project }) {
    assert.throws(() => solve("x + <= 3"), (e) => e.name === "FmbError" && e.line === 1 && e.column > 0);
    assert.throws(() => solve("x <= 3", { method: "guess" }), /method/);
    assert.throws(() => project("x <= 3", ["y"]), /no variable y/);
    assert.throws(() => system({ matrix: [[1, NaN]], right: [1] }));
    assert.equal(solve("x <= 3").stop, "done");
  },

  "memory is given back"({ solve, system }) {
    const used = () => process.memoryUsage().arrayBuffers, s = system("x + y <= 3\nx >= 1");
    solve(s);
    const before = used();
    for (let i = 0; i < 20000; i++) solve(s, { evidence: "none" });
    assert.ok(used() - before < 1 << 20, `${used() - before} bytes more`);
  },
};

// Questions as plain functions.
function bound(library) {
  return new Proxy(library, { get: (target, name) => target[name].bind(target) });
}

const folder = mkdtempSync(join(tmpdir(), "libfmb-"));
try {
  writeFileSync(join(folder, "package.json"), "{}");
  execFileSync("npm", ["install", "--offline", "--no-audit", "--no-fund", resolve(process.argv[2])], { cwd: folder, stdio: "pipe" });
  const require = createRequire(join(folder, "program.js"));
  const { load } = await import(pathToFileURL(join(folder, "node_modules/libfmb/dist/libfmb.mjs")));
  const libraries = { "ES module": await load(), CommonJS: require("libfmb").loadNow() };
  for (const [way, library] of Object.entries(libraries))
    for (const [name, test] of Object.entries(tests)) {
      test(bound(library));
      console.log(`ok: ${name} (${way})`);
    }
  writeFileSync(join(folder, "plan.fmb"), "x + y <= 3\n2y < x - 4\n");
  const said = execFileSync(join(folder, "node_modules/.bin/fmb"), ["solve", "plan.fmb"], { cwd: folder, encoding: "utf8" });
  assert.equal(said, "feasible\nx = 0\ny = -3\n");
  console.log("ok: the command");
  const example = /```js\n(.*?)```/s.exec(readFileSync(join(folder, "node_modules/libfmb/README.md"), "utf8"))[1];
  writeFileSync(join(folder, "example.mjs"), example);
  const printed = execFileSync(process.execPath, ["example.mjs"], { cwd: folder, encoding: "utf8" });
  assert.match(printed, /^feasible 0, -3\n1\/3 0\.333\d* false\ntrue \[ 0\.75, 1 \]\n$/);
  console.log("ok: the example of its README");
} finally {
  rmSync(folder, { recursive: true });
}
