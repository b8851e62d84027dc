// What `steadycut mission pack` puts into the page for a learning platform: it opens the mission, and hands what
// came of it on, by SCORM 1.2 to the API of the platform's page, or as xAPI statements to its store of records.
// The page's element `pack` says which, and which missions; `?mission=ID` chooses one of several.

(() => {
  const pack = JSON.parse(document.getElementById("pack").textContent);
  const query = new URLSearchParams(location.search);
  const mission = pack.missions.find(({ id }) => id === query.get("mission")) ?? pack.missions[0];
  const opened = Date.now();
  const MOST_STARS = 3;

  // A page that was reloaded within the mission has its cut in the address.
  const start = [pack.embed, mission.link].filter((part) => part !== "").join("&");
  if (!location.hash.slice(1).startsWith(start)) history.replaceState(null, "", `${location.search}#${start}`);

  // Said below the program: the learner has to know that nothing is recorded.
  function tell(text) {
    console.warn(`SteadyCut: ${text}`);
    let line = document.getElementById("pack-told");
    if (!line) {
      line = document.createElement("p");
      line.id = "pack-told";
      line.setAttribute("role", "status");
      line.style.cssText =
        "position: fixed; inset: auto 0 0 0; z-index: 2; max-width: none; padding: .5rem 1rem; background: #7a1f00; color: #fff; text-align: center";
      line.onclick = () => line.remove();
      (document.body ?? document.documentElement).append(line);
    }
    line.textContent = text;
  }

  // --- SCORM 1.2 ------------------------------------------------------------------------------

  // The API is an object `API` of a window around this one, or of the one that opened it.
  function findApi() {
    const around = (win) => {
      for (let depth = 0; win && depth < 500; depth += 1) {
        try {
          if (win.API) return win.API;
        } catch {
          // a window of another origin
        }
        if (win.parent === win) return null;
        win = win.parent;
      }
      return null;
    };
    return around(window) ?? around(window.opener) ?? around(window.top?.opener);
  }

  // SCORM's CMITimespan: hours, minutes, seconds.
  function timespan(ms) {
    const two = (number) => String(Math.floor(number)).padStart(2, "0");
    const s = ms / 1000;
    return `${String(Math.min(9999, Math.floor(s / 3600))).padStart(4, "0")}:${two((s / 60) % 60)}:${two(s % 60)}`;
  }

  // At most 4096 characters are kept: the answer is left out before stars are.
  function suspended(kept) {
    const whole = JSON.stringify(kept);
    return whole.length <= 4096 ? whole : JSON.stringify({ ...kept, answer: undefined });
  }

  function scorm12() {
    const api = findApi();
    if (!api) {
      tell("No learning platform was found around this page: results are not recorded.");
      return () => {};
    }
    const call = (name, ...values) => {
      const answer = String(api[name](...values));
      const code = String(api.LMSGetLastError());
      if (answer === "false" || (code !== "0" && name !== "LMSGetValue")) {
        tell(`The learning platform refuses ${name}(${values.join(", ")}): ${code} ${api.LMSGetErrorString(code)}`);
      }
      return answer;
    };
    if (call("LMSInitialize", "") !== "true") return () => {};
    const get = (name) => call("LMSGetValue", name);
    const set = (name, value) => call("LMSSetValue", name, String(value));
    let kept = { passed: false, stars: 0, tries: 0 };
    try {
      kept = { ...kept, ...JSON.parse(get("cmi.suspend_data") || "{}") };
    } catch {
      // of another program
    }
    const records = !["browse", "review"].includes(get("cmi.core.lesson_mode"));
    if (records && ["", "not attempted", "unknown"].includes(get("cmi.core.lesson_status"))) {
      set("cmi.core.lesson_status", "incomplete");
      call("LMSCommit", "");
    }
    let finished = false;
    window.addEventListener("pagehide", () => {
      if (finished) return;
      finished = true;
      if (records) {
        set("cmi.core.session_time", timespan(Date.now() - opened));
        set("cmi.core.exit", kept.passed ? "" : "suspend");
      }
      call("LMSCommit", "");
      call("LMSFinish", "");
    });
    // A page that comes back from the browser's memory has lost its platform.
    window.addEventListener("pageshow", (event) => event.persisted && location.reload());
    return ({ verdict, answer }) => {
      const { passed, stars } = verdict;
      kept = { passed: kept.passed || passed, stars: Math.max(kept.stars, stars), tries: kept.tries + 1, answer };
      if (!records || finished) return;
      set("cmi.core.score.min", 0);
      set("cmi.core.score.max", 100);
      set("cmi.core.score.raw", Math.round((100 * kept.stars) / MOST_STARS));
      set("cmi.core.lesson_status", kept.passed ? "passed" : "failed");
      set("cmi.core.lesson_location", mission.id);
      set("cmi.suspend_data", suspended(kept));
      set("cmi.core.session_time", timespan(Date.now() - opened));
      call("LMSCommit", "");
    };
  }

  // --- xAPI 1.0.3 -----------------------------------------------------------------------------

  const VERBS = "http://adlnet.gov/expapi/verbs/";
  const TYPES = "http://adlnet.gov/expapi/activities/";
  const RETRY_MS = 30_000;

  function uuid() {
    if (crypto.randomUUID) return crypto.randomUUID();
    const bytes = crypto.getRandomValues(new Uint8Array(16));
    bytes[6] = (bytes[6] & 0x0f) | 0x40;
    bytes[8] = (bytes[8] & 0x3f) | 0x80;
    const hex = [...bytes].map((byte) => byte.toString(16).padStart(2, "0")).join("");
    return hex.replace(/^(.{8})(.{4})(.{4})(.{4})(.{12})$/, "$1-$2-$3-$4-$5");
  }

  function xapi() {
    const endpoint = query.get("endpoint");
    let actor;
    try {
      actor = JSON.parse(query.get("actor"));
    } catch {
      actor = null;
    }
    if (!endpoint || !actor) {
      tell("This page was not opened by a learning platform (endpoint and actor are missing): results are not recorded.");
      return () => {};
    }
    // Some platforms give lists where the standard wants one.
    for (const key of ["name", "mbox", "account"]) if (Array.isArray(actor[key])) [actor[key]] = actor[key];
    const address = `${endpoint.replace(/\/*$/, "/")}statements`;
    const headers = { "Content-Type": "application/json", "X-Experience-API-Version": "1.0.3" };
    if (query.get("auth")) headers.Authorization = query.get("auth");
    const registration = query.get("registration");

    // What was not sent yet outlives the page where the browser lets it.
    const KEY = `steadycut.xapi.${mission.activity}.${query.get("actor")}`;
    let waiting = [];
    try {
      waiting = JSON.parse(localStorage.getItem(KEY) ?? "[]");
    } catch {
      // storage is refused, or holds something else
    }
    const keep = () => {
      try {
        if (waiting.length === 0) localStorage.removeItem(KEY);
        else localStorage.setItem(KEY, JSON.stringify(waiting));
      } catch {
        // then only this page knows them
      }
    };

    let sending = false;
    async function send() {
      if (sending || waiting.length === 0) return;
      sending = true;
      const batch = [...waiting];
      let sent = false;
      try {
        const answer = await fetch(address, { method: "POST", headers, body: JSON.stringify(batch), keepalive: true });
        // 409: they are there already, from a time when the answer got lost.
        if (answer.ok || answer.status === 409) {
          waiting = waiting.filter((one) => !batch.some(({ id }) => id === one.id));
          keep();
          sent = true;
        } else {
          tell(`The learning platform refuses the results: ${answer.status} ${answer.statusText}`);
        }
      } catch {
        // off line: they wait
      }
      sending = false;
      // What has come meanwhile.
      if (sent) send();
    }
    window.addEventListener("online", send);
    window.addEventListener("pagehide", send);
    setInterval(send, RETRY_MS);

    const activity = (id, type, name) => ({
      objectType: "Activity", id, definition: { type: TYPES + type, name: { en: name } },
    });
    const whole = activity(mission.activity, "assessment", mission.title);
    const statement = (verb, object, result) => ({
      id: uuid(),
      actor,
      verb: { id: VERBS + verb, display: { en: verb } },
      object,
      ...(result && { result }),
      context: { platform: "SteadyCut", language: "en", ...(registration && { registration }) },
      timestamp: new Date().toISOString(),
    });
    const add = (...statements) => {
      waiting.push(...statements);
      keep();
      send();
    };
    add(statement("initialized", whole));
    return ({ verdict, answer }) => {
      const { passed, stars } = verdict;
      const given = new Map(answer.predictions.map((prediction) => [prediction.step, prediction]));
      const answered = verdict.predictions.filter((prediction) => prediction.answered).map(({ step, right }) => {
        const { choice, number, curve } = given.get(step) ?? {};
        const asked = activity(`${mission.activity}/step/${step}`, "cmi.interaction", `Step ${step}`);
        asked.definition.interactionType = "other";
        return statement("answered", asked, { response: String(choice ?? number ?? JSON.stringify(curve)), success: right });
      });
      const duration = `PT${((Date.now() - opened) / 1000).toFixed(2)}S`;
      const score = { scaled: stars / MOST_STARS, raw: stars, min: 0, max: MOST_STARS };
      const result = { score, success: passed, completion: passed, duration };
      const judged = [statement(passed ? "passed" : "failed", whole, result)];
      if (passed) judged.push(statement("completed", whole, result));
      add(...answered, ...judged);
    };
  }

  const hand = pack.kind === "xapi" ? xapi() : scorm12();
  // The program calls this with the result of every mission that was marked.
  window.steadycutResult = (text) => {
    const result = JSON.parse(text);
    if (result.mission.id === mission.id && result.mission.digest === mission.digest) hand(result);
  };
})();
