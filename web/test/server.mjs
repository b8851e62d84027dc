// A static server for a folder, as small as it gets: right MIME types, gzip like a real host.
// As a program: node server.mjs [port] serves web/dist.

import { createServer } from "node:http";
import { readFile } from "node:fs/promises";
import { extname, join, normalize } from "node:path";
import { fileURLToPath } from "node:url";
import { gzipSync } from "node:zlib";

export const DIST = fileURLToPath(new URL("../dist", import.meta.url));

const TYPES = {
  ".html": "text/html; charset=utf-8",
  ".js": "text/javascript; charset=utf-8",
  ".wasm": "application/wasm",
  ".svg": "image/svg+xml",
};

// `change(path, bytes)` may answer other bytes for a file, or a number: an HTTP status to fail with.
export async function serve({ folder = DIST, port = 0, change = (_path, bytes) => bytes } = {}) {
  const packed = new Map(); // path -> [bytes, gzip of them]
  const server = createServer(async (request, response) => {
    let path = normalize(decodeURIComponent(new URL(request.url, "http://localhost").pathname));
    if (path.endsWith("/")) path += "index.html";
    let bytes = await readFile(join(folder, path)).catch(() => 404);
    if (typeof bytes !== "number") bytes = change(path, bytes);
    if (typeof bytes === "number") return response.writeHead(bytes).end();
    const headers = { "Content-Type": TYPES[extname(path)] ?? "application/octet-stream" };
    if (/\bgzip\b/.test(request.headers["accept-encoding"] ?? "")) {
      if (!packed.get(path)?.[0].equals(bytes)) packed.set(path, [bytes, gzipSync(bytes, { level: 1 })]);
      headers["Content-Encoding"] = "gzip";
      bytes = packed.get(path)[1];
    }
    response.writeHead(200, headers).end(bytes);
  });
  await new Promise((resolve, reject) => server.once("error", reject).listen(port, "localhost", resolve));
  return {
    url: `http://localhost:${server.address().port}/`,
    close() {
      const closed = new Promise((resolve) => server.close(resolve)); // a second time is no error
      server.closeAllConnections();
      return closed;
    },
  };
}

if (process.argv[1] === fileURLToPath(import.meta.url)) {
  await serve({ port: Number(process.argv[2] ?? 8080) });
}
