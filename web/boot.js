// Loads and starts SteadyCut: downloads the program, showing how far it is, while it looks for a way
// to draw; starts it, starts it again on a fresh canvas when the graphics are lost, and shows a page
// in plain words when any of that fails.
// web/build fills in @BUILD@ (the name of this build); index.html carries the program's size.

const BUILD = "@BUILD@";
// Without them the page speaks English.
const english = { say: (text, values = {}) => text.replace(/\{(\w+)\}/g, (place, name) => values[name] ?? place) };
const { say, tenths = (number) => number.toFixed(1) } = await import(`./texts.js?v=${BUILD}`).catch(() => english);
const ADAPTER_PATIENCE_MS = 3000;
// Graphics that are lost again and again are not worth another try.
const MOST_LOSSES = 3;
const LOSSES_WITHIN_MS = 60_000;
const byId = (id) => document.getElementById(id);

let started = false; // the program draws: later failures are crashes
let graphics = null; // "WebGPU" or "WebGL 2": what the program draws with
let failed = false; // the first failure is shown; what follows from it is not

// --- the error page ---------------------------------------------------------------------------

const OTHER_BROWSER = say(
  "If that does not help, try another browser: current versions of Chrome, Edge, Firefox and Safari can run SteadyCut.",
);

function fail(title, advice, detail) {
  if (failed) return;
  failed = true;
  byId("failed-title").textContent = title;
  byId("failed-advice").textContent = advice;
  byId("failed-detail").textContent = detail ? String(detail?.message ?? detail) : "";
  byId("reload-webgl").hidden = graphics !== "WebGPU";
  byId("loading").hidden = true;
  byId("failed").hidden = false;
  byId("reload").focus();
}

function crashed(detail) {
  fail(
    say("SteadyCut has stopped"),
    `${say("This is a fault in the program. The settings are kept in the page's address: reload the page to go on.")} ${OTHER_BROWSER}`,
    detail,
  );
}

byId("reload").onclick = () => location.reload();
byId("reload-webgl").onclick = () => {
  const address = new URL(location.href);
  address.searchParams.set("graphics", "webgl");
  location.href = address.href;
};

// A link pasted into the open page changes only what stands after #; the program itself writes
// there without this event. Where settings are locked, the program stays and writes its own again.
window.addEventListener("hashchange", () => {
  if (!window.steadycut?.keeps_address()) location.reload();
});

// Rust's panic hook calls this.
window.steadycutPanic = crashed;
// A trap without a panic (out of memory, stack overflow) arrives here only.
const trapped = (error) => {
  if (started && error instanceof WebAssembly.RuntimeError) crashed(error);
};
window.addEventListener("error", (event) => trapped(event.error));
window.addEventListener("unhandledrejection", (event) => trapped(event.reason));

// --- keys -------------------------------------------------------------------------------------

// Each key acts in the page or in the browser, never in both. The browser's own do not reach the
// program, and what the program answers does not reach the browser.
const BROWSERS_WITH_ALT = new Set(["ArrowLeft", "ArrowRight", "ArrowUp", "ArrowDown", "Home"]);
const PROGRAMS_WITH_CTRL = new Set(["z", "y"]);
const PROGRAMS_ALONE = new Set(["Home", "End"]);

function key(event) {
  if (!started || failed) return;
  const ctrl = event.ctrlKey || event.metaKey;
  const leaves = event.key === "Tab" && !ctrl && window.steadycut.tab_leaves();
  if (leaves || (event.altKey && BROWSERS_WITH_ALT.has(event.key))) event.stopImmediatePropagation();
  else if (ctrl ? PROGRAMS_WITH_CTRL.has(event.key.toLowerCase()) : PROGRAMS_ALONE.has(event.key)) {
    // A text that is being written keeps them.
    if (event.target === byId("canvas")) event.preventDefault();
  }
}
window.addEventListener("keydown", key, { capture: true });

// --- what to draw with ------------------------------------------------------------------------

// WebGPU if the browser hands out an adapter, otherwise WebGL 2: the order of the program's own
// choice (wgpu). Where WebGPU is not to be used, navigator.gpu is hidden, so the program agrees.
async function findGraphics() {
  const forced = new URLSearchParams(location.search).get("graphics") === "webgl";
  if (!forced && (await hasAdapter())) return "WebGPU";
  if (navigator.gpu) Object.defineProperty(navigator, "gpu", { value: undefined, configurable: true });
  const probe = document.createElement("canvas").getContext("webgl2");
  probe?.getExtension("WEBGL_lose_context")?.loseContext(); // contexts are few: give it back
  return probe ? "WebGL 2" : null;
}

// Some browsers offer a WebGPU that never answers.
async function hasAdapter() {
  const tooLong = new Promise((resolve) => setTimeout(resolve, ADAPTER_PATIENCE_MS, null));
  try {
    return Boolean(await Promise.race([navigator.gpu?.requestAdapter(), tooLong]));
  } catch {
    return false;
  }
}

// --- the download -----------------------------------------------------------------------------

const megabytes = (bytes) => tenths(bytes / 1e6);

function showProgress(bytes, total) {
  const bar = byId("progress");
  if (total) {
    bar.value = Math.min(bytes / total, 1);
    byId("phase").textContent = say("Loading: {done} of {all} MB", { done: megabytes(bytes), all: megabytes(total) });
  } else {
    bar.removeAttribute("value"); // a bar that only moves
    byId("phase").textContent = say("Loading: {done} MB", { done: megabytes(bytes) });
  }
}

// The program as a Response, compiled while it comes in. The bytes counted are the unpacked ones,
// so the sum to reach is the size web/build wrote into the page; a Content-Length says it only if
// the transfer is not compressed.
async function download(address) {
  const response = await fetch(address);
  if (!response.ok) throw new Error(`${address.pathname}: the server answers ${response.status} ${response.statusText}`);
  const packed = response.headers.get("Content-Encoding");
  const total = Number(byId("boot").dataset.wasmBytes) || (packed ? 0 : Number(response.headers.get("Content-Length")));
  const reader = response.body.getReader();
  let bytes = 0;
  const counted = new ReadableStream({
    async pull(controller) {
      const { done, value } = await reader.read();
      if (done) {
        showStarting();
        controller.close();
      } else {
        bytes += value.length;
        showProgress(bytes, total);
        controller.enqueue(value);
      }
    },
    cancel: (reason) => reader.cancel(reason),
  });
  return new Response(counted, { headers: { "Content-Type": "application/wasm" } });
}

function showStarting() {
  byId("progress").removeAttribute("value");
  byId("phase").textContent = say("Starting…");
}

const nextFrame = () => new Promise((resolve) => requestAnimationFrame(resolve));

// --- for screen readers -----------------------------------------------------------------------

// The elements of mirror.js cost a little in every frame, and no page can see whether somebody listens: a switch at
// the head of the page makes them. It is remembered.
const REMEMBERED = "steadycut-mirror";
function remembered() {
  try {
    return localStorage.getItem(REMEMBERED) === "on";
  } catch {
    return false; // a page without storage
  }
}

async function offerMirror(program) {
  const [toggle, root] = ["mirror-switch", "mirror"].map(byId);
  let mirror = null;
  const set = async (on) => {
    if (on && !mirror) {
      const { Mirror } = await import(`./mirror.js?v=${BUILD}`);
      mirror = new Mirror(program, root, byId("mirror-said"), PROGRAMS_WITH_CTRL);
      // Later, when the program has returned: what happens here calls it again.
      window.steadycutMirror = (changes) => queueMicrotask(() => mirror.take(JSON.parse(changes)));
    }
    if (!on) mirror?.clear();
    program.mirror(on);
    root.hidden = !on;
    toggle.setAttribute("aria-pressed", String(on));
    // The canvas says nothing that the elements do not say.
    byId("canvas").setAttribute("aria-hidden", String(on));
    byId("canvas").tabIndex = on ? -1 : 0;
    try {
      if (on) localStorage.setItem(REMEMBERED, "on");
      else localStorage.removeItem(REMEMBERED);
    } catch {
      // It is switched on again in the next visit.
    }
  };
  toggle.onclick = () => set(toggle.getAttribute("aria-pressed") !== "true");
  toggle.hidden = false;
  if (remembered()) await set(true);
}

// --- start ------------------------------------------------------------------------------------

// The program's exports, once it has arrived. The glue and the program are asked for at the same time.
async function load() {
  const wasm = new URL(`steadycut_bg.wasm?v=${BUILD}`, import.meta.url);
  const answer = download(wasm);
  answer.catch(() => {}); // where the glue fails first, that is the failure which is told
  const program = await import(`./steadycut.js?v=${BUILD}`);
  await program.default({ module_or_path: answer });
  return program;
}

// Starts the program on the page's canvas: scenario and changes come from the page's address.
async function draw(program) {
  const canvas = byId("canvas");
  canvas.addEventListener("webglcontextlost", () => graphicsLost(program));
  await program.start(canvas);
  await nextFrame(); // the first picture
  await nextFrame();
  // The hidden field through which eframe gets typed text.
  document.querySelector("body > input")?.setAttribute("aria-label", say("Text typed into SteadyCut"));
  canvas.focus();
}

// A driver that is reset or a laptop that wakes takes the graphics away. A canvas whose context is lost
// gives no other one, so a fresh canvas takes its place.
const losses = [];
async function graphicsLost(program) {
  if (failed) return;
  losses.push(performance.now());
  const recent = losses.filter((at) => performance.now() - at < LOSSES_WITHIN_MS);
  const taken = say(
    "The browser or the graphics driver has taken the graphics away. Scenario and changes are kept in the page's address: reload the page to go on.",
  );
  const advice = `${taken} ${OTHER_BROWSER}`;
  const often = say("{n} times within a minute", { n: recent.length });
  if (recent.length > MOST_LOSSES) return fail(say("The graphics were lost"), advice, often);
  try {
    program.stop();
    const canvas = byId("canvas");
    canvas.replaceWith(canvas.cloneNode(true));
    await draw(program);
  } catch (error) {
    fail(say("The graphics were lost"), advice, error);
  }
}

async function boot() {
  if (typeof WebAssembly !== "object") return fail(byId("failed-title").textContent, byId("failed-advice").textContent);

  const loading = load();
  loading.catch(() => {}); // told below, unless there is nothing to draw with
  graphics = await findGraphics();
  if (!graphics) {
    return fail(
      say("SteadyCut can't draw here"),
      say(
        "This browser offers neither WebGPU nor WebGL 2. Turn on hardware acceleration in the browser's settings, update the browser, or open the page in another one: current versions of Chrome, Edge, Firefox and Safari can run SteadyCut.",
      ),
    );
  }

  let program;
  try {
    program = await loading;
  } catch (error) {
    const advice = navigator.onLine
      ? `${say("A part of the program did not arrive or could not be read. Check the connection and reload the page.")} ${OTHER_BROWSER}`
      : say("There is no connection to the network. Reload the page when there is one.");
    return fail(say("SteadyCut could not be loaded"), advice, error);
  }

  try {
    window.steadycutGraphicsLost = () => graphicsLost(program); // WebGPU has no event for it
    await draw(program);
  } catch (error) {
    const advice = `${say("Drawing with {graphics} failed. Reload the page.", { graphics })} ${OTHER_BROWSER}`;
    return fail(say("SteadyCut could not start"), advice, error);
  }
  if (failed) return;
  started = true;
  window.steadycut = program;
  byId("loading").hidden = true;
  byId("canvas").focus();
  await offerMirror(program);

  // For use without a network, once this page is up. Secure pages only (https, localhost).
  navigator.serviceWorker?.register("sw.js").catch((error) => console.warn("SteadyCut works on line only:", error));
}

boot().catch((error) => fail(say("SteadyCut could not start"), `${say("Reload the page.")} ${OTHER_BROWSER}`, error));
