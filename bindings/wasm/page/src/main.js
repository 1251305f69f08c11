// The page: tabs, examples, and the address, in which a system can be shared.
import { byId, make, replace, tell } from "./dom.js";
import { engineReady } from "./engine.js";
import { EXAMPLES } from "./examples.js";
import { startElimination } from "./elimination.js";
import { onAnswer, setSystem, startSystems, systemText } from "./systems.js";
import { startFrames } from "./throwing.js";
import { startMeshes } from "./meshes.js";

const TABS = ["system", "elimination", "frames", "meshes"];
const shown = {}; // what a tab does when it is shown

/* ---- tabs ------------------------------------------------------------------------------------ */

function open(name) {
  for (const tab of TABS) {
    const isOpen = tab === name;
    byId(`tab-${tab}`).setAttribute("aria-selected", String(isOpen));
    byId(`tab-${tab}`).tabIndex = isOpen ? 0 : -1;
    byId(`panel-${tab}`).hidden = !isOpen;
  }
  shown[name]?.();
}

function startTabs() {
  for (const [k, tab] of TABS.entries()) {
    byId(`tab-${tab}`).addEventListener("click", () => go({ tab }));
    byId(`tab-${tab}`).addEventListener("keydown", (e) => {
      const way = { ArrowLeft: -1, ArrowRight: 1 }[e.key];
      if (!way) return;
      const next = TABS[(k + way + TABS.length) % TABS.length];
      go({ tab: next });
      byId(`tab-${next}`).focus();
    });
  }
}

/* ---- the address ----------------------------------------------------------------------------- */

// The state of the page: #example=NAME or #system=TEXT, and &tab=NAME.
function read() {
  const asked = new URLSearchParams(location.hash.slice(1));
  return { example: asked.get("example"), system: asked.get("system"), tab: asked.get("tab") };
}

function write({ example, system, tab }) {
  const asked = new URLSearchParams();
  if (system !== null && system !== undefined) asked.set("system", system);
  else if (example) asked.set("example", example);
  if (tab && tab !== TABS[0]) asked.set("tab", tab);
  history.replaceState(null, "", `#${asked}`);
}

const go = (change) => {
  const next = { ...read(), ...change };
  write(next);
  open(TABS.includes(next.tab) ? next.tab : TABS[0]);
};

function follow() {
  const { example, system, tab } = read();
  const text = system ?? (EXAMPLES[example] ?? EXAMPLES.triangle).text;
  if (text !== systemText()) setSystem(text);
  open(TABS.includes(tab) ? tab : TABS[0]);
}

async function share() {
  write({ ...read(), system: systemText() });
  try {
    await navigator.clipboard.writeText(location.href);
    tell("The link is copied.");
    byId("share").textContent = "Link copied";
  } catch {
    byId("share").textContent = "The link is in the address bar";
  }
  setTimeout(() => (byId("share").textContent = "Share"), 3000);
}

/* ---- begin ----------------------------------------------------------------------------------- */

startTabs();
startSystems(() => write({ ...read(), example: null, system: systemText() }));
shown.elimination = startElimination(systemText);
shown.frames = startFrames();
shown.meshes = startMeshes();
replace(byId("examples"), Object.entries(EXAMPLES).map(([name, { title }]) => make("li", {}, make("a", { href: `#example=${name}` }, title))));
byId("share").addEventListener("click", share);
addEventListener("hashchange", follow);
// For tests: the time of the first answer, and the number of answers.
let answers = 0;
onAnswer(() => {
  const { dataset } = document.documentElement;
  dataset.answered ??= String(Math.round(performance.now()));
  dataset.answers = String(++answers);
});
engineReady().then(
  (version) => (byId("version").textContent = version),
  (error) => {
    byId("verdict").className = "verdict infeasible";
    byId("verdict").textContent = error.message;
  });
follow();
