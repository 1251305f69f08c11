// The library in a worker, so that the page never waits. The worker is made from a text of this page: no file is
// asked for, and a page from a disk may do so, too.

const PATIENCE = 30_000; // before a worker that says nothing is given up [ms]

let worker, version, begun = 0;
const waiting = new Map();

function start() {
  const code = document.getElementById("engine").textContent;
  const address = URL.createObjectURL(new Blob([code], { type: "text/javascript" }));
  return new Promise((resolve, reject) => {
    worker = new Worker(address);
    worker.onerror = (event) => reject(new Error(`The library does not start: ${event.message}`));
    worker.onmessage = ({ data }) => {
      resolve((version = data.version));
      worker.onmessage = receive;
    };
  });
}

let ready = start();
export const engineReady = () => ready;

function receive({ data: { number, result, error } }) {
  const { resolve, reject, timer } = waiting.get(number);
  waiting.delete(number);
  clearTimeout(timer);
  if (error) reject(Object.assign(new Error(error.message), error));
  else resolve(result);
  if (error?.isFatal) restart("The library stopped, and begins again.");
}

// Cancels all waiting tasks and starts a fresh worker.
function restart(words) {
  worker.terminate();
  for (const { reject, timer } of waiting.values()) {
    clearTimeout(timer);
    reject(new Error(words));
  }
  waiting.clear();
  ready = start();
}

async function send(task, about) {
  await ready;
  return new Promise((resolve, reject) => {
    const number = ++begun, timer = setTimeout(restart, PATIENCE, "This takes too long, and was given up.");
    waiting.set(number, { resolve, reject, timer });
    worker.postMessage({ number, task, about });
  });
}

/* ---- topics ---------------------------------------------------------------------------------- */

const topics = new Map();

async function goOn(topic) {
  if (topic.isBusy || !topic.next) return;
  const { task, about, resolve, reject } = topic.next;
  topic.next = null;
  topic.isBusy = true;
  await send(task, about).then(resolve, reject);
  topic.isBusy = false;
  goOn(topic);
}

// One task of a topic runs at a time; of the tasks that arrive meanwhile only the last one runs, and the others'
// answers are null.
export function ask(task, about, topic = task) {
  return new Promise((resolve, reject) => {
    if (!topics.has(topic)) topics.set(topic, { isBusy: false, next: null });
    const t = topics.get(topic);
    t.next?.resolve(null);
    t.next = { task, about, resolve, reject };
    goOn(t);
  });
}
