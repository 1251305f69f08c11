// A mesh that is dropped on the page: which of its cells meet one another, and how.
import { byId, make, replace, tell } from "./dom.js";
import { ask } from "./engine.js";
import { Space } from "./space.js";

const MOST_LISTED = 200, MOST_DRAWN = 40_000;
const SIDES = { 3: [[0, 1, 2]], 4: [[0, 1, 2], [0, 1, 3], [0, 2, 3], [1, 2, 3]] };
const HOW = { cross: "their interiors meet", coplanar: "they overlap in one plane", touch: "they touch beyond what they share", share: "they share a corner or an edge" };

// Two tetrahedra through each other: the example of the command's documentation.
const EXAMPLE = `OFF
8 8 0
0 0 0
2 0 0
0 2 0
0 0 2
0.5 0.5 0.5
2.5 0.5 0.5
0.5 2.5 0.5
0.5 0.5 2.5
3 0 2 1
3 0 1 3
3 0 3 2
3 1 2 3
3 4 6 5
3 4 5 7
3 4 7 6
3 5 6 7
`;

let space;

function facesOf({ points, cells, corners, hits }) {
  const style = getComputedStyle(document.documentElement), colour = (name) => style.getPropertyValue(name).trim();
  const bad = new Set(hits.flatMap((h) => [h.a, h.b])), faces = [], n = cells.length / corners;
  const step = Math.max(1, Math.ceil(n / MOST_DRAWN));
  for (let c = 0; c < n; c++) {
    if (c % step !== 0 && !bad.has(c)) continue;
    for (const side of SIDES[corners]) {
      const at = side.map((k) => 3 * cells[c * corners + k]);
      faces.push({ points: at.map((i) => [points[i], points[i + 1], points[i + 2]]), fill: colour(bad.has(c) ? "--bad-face" : "--region"), line: n < 3000 ? colour("--edge") : undefined, width: 0.5 });
    }
  }
  return faces;
}

function showHits({ hits, cells, corners, tested, stop, seconds }, name) {
  const n = cells.length / corners, kind = corners === 3 ? "triangles" : "tetrahedra";
  const words = hits.length === 0 ? `No two ${kind} of ${name} meet but where they should.` : `${hits.length} pairs of ${kind} of ${name} meet where they should not.`;
  replace(byId("mesh-verdict"), words, make("small", {}, ` ${n} ${kind}, ${tested} pairs tested, ${(1000 * seconds).toFixed(0)} ms${stop === "done" ? "" : `, cut short (${stop})`}`));
  byId("mesh-verdict").className = `verdict ${hits.length === 0 ? "feasible" : "infeasible"}`;
  replace(byId("hits"), hits.slice(0, MOST_LISTED).map((h) => make("li", {}, make("strong", {}, h.how), ` ${h.a} and ${h.b}: ${HOW[h.how]}${h.shared > 0 ? `, with ${h.shared} common corners` : ""}`)),
    hits.length > MOST_LISTED ? make("li", {}, `and ${hits.length - MOST_LISTED} more`) : null);
  tell(words);
}

async function look(bytes, name) {
  byId("mesh-verdict").textContent = `${name} is looked at ...`;
  try {
    const found = await ask("mesh", { bytes });
    if (!found) return;
    showHits(found, name);
    space.show(facesOf(found));
  } catch (error) {
    byId("mesh-verdict").className = "verdict infeasible";
    byId("mesh-verdict").textContent = `${name}: ${error.message}`;
  }
}

async function take(file) {
  if (file) look(new Uint8Array(await file.arrayBuffer()), file.name);
}

export function startMeshes() {
  space = new Space(byId("mesh"), "The mesh");
  byId("mesh-file").addEventListener("change", (e) => take(e.target.files[0]));
  const target = byId("drop");
  for (const kind of ["dragover", "dragleave", "drop"])
    target.addEventListener(kind, (e) => {
      e.preventDefault();
      target.classList.toggle("over", kind === "dragover");
      if (kind === "drop") take(e.dataTransfer.files[0]);
    });
  const example = () => look(new TextEncoder().encode(EXAMPLE), "the example");
  byId("mesh-example").addEventListener("click", example);
  let isEmpty = true;
  return () => {
    if (isEmpty) example();
    isEmpty = false;
    space.paint();
  };
}
