// Service worker: SteadyCut without a network, after the first visit.
//
// The page itself comes from the network whenever there is one, so a new build is seen at once. It
// names its files with the build's name (?v=...), so those may come from the cache without asking:
// another build has other addresses. web/build fills in the name; a new name makes the browser
// install the new worker, which fills its own cache and deletes the others.

const BUILD = "@BUILD@";
// `steadycut mission pack` puts in what it adds: its name, the page's, and files. Packs lie beside each other on a
// platform: none removes the cache of another, nor that of a page on the same host.
const PACK = null;
const PREFIX = PACK ? `packed-steadycut-${PACK.name}-` : "steadycut-";
const CACHE = PREFIX + BUILD;
const PAGE = PACK ? PACK.page : "./";
const FILES = [PAGE, ...(PACK ? PACK.files : []), `boot.js?v=${BUILD}`, `texts.js?v=${BUILD}`, `mirror.js?v=${BUILD}`, `steadycut.js?v=${BUILD}`, `steadycut_bg.wasm?v=${BUILD}`, "icon.svg"];
const PATIENCE_MS = 4000; // a network that hangs is no network

self.addEventListener("install", (event) => {
  event.waitUntil(
    (async () => {
      const cache = await caches.open(CACHE);
      // no-cache: ask the server, so that no older file gets in; an unchanged one is not sent again.
      await cache.addAll(FILES.map((file) => new Request(file, { cache: "no-cache" })));
      // Published anew in this very moment? Then this is a mixture: give up, the new worker comes.
      const page = await cache.match(PAGE);
      if (!(await page.text()).includes(BUILD)) {
        await caches.delete(CACHE);
        throw new Error("the page is of another build");
      }
      await self.skipWaiting();
    })(),
  );
});

self.addEventListener("activate", (event) => {
  event.waitUntil(
    (async () => {
      for (const name of await caches.keys()) {
        if (name.startsWith(PREFIX) && name !== CACHE) await caches.delete(name);
      }
      await self.clients.claim();
    })(),
  );
});

self.addEventListener("fetch", (event) => {
  const { request } = event;
  if (request.method !== "GET" || new URL(request.url).origin !== location.origin) return;
  event.respondWith(request.mode === "navigate" ? page(request) : file(request));
});

async function page(request) {
  try {
    const response = await fetch(request.url, { cache: "no-cache", signal: AbortSignal.timeout(PATIENCE_MS) });
    if (response.ok) return new Response(await response.blob(), { headers: response.headers });
  } catch {
    // no network
  }
  return (await (await caches.open(CACHE)).match(PAGE)) ?? Response.error();
}

async function file(request) {
  const cache = await caches.open(CACHE);
  return (await cache.match(request)) ?? fetch(request);
}
