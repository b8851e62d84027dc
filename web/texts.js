// The texts of the page around the program, by their English words. The program's own are in its catalogues.

const TEXTS = {
  sl: {
    "Controls for screen readers": "Gradniki za bralnike zaslona",
    "SteadyCut: console of a milling machine that keeps its surface finish constant":
      "SteadyCut: pult frezalnega stroja, ki ohranja hrapavost površine",
    "Drawn here. For a screen reader: Escape, then Shift and Tab, to a switch that makes its controls elements of the page.":
      "Narisan je tukaj. Za bralnik zaslona: Escape, nato Shift in Tab do stikala, ki iz njegovih gradnikov naredi elemente strani.",
    "Loading": "Nalaganje",
    "Loading…": "Nalaganje …",
    "Starting…": "Zagon …",
    "Loading: {done} of {all} MB": "Naloženo: {done} od {all} MB",
    "Loading: {done} MB": "Naloženo: {done} MB",
    "This browser is too old": "Ta brskalnik je prestar",
    "SteadyCut needs WebAssembly and WebGL 2 or WebGPU. Please open the page in a current version of Firefox, Chrome, Edge or Safari.":
      "SteadyCut potrebuje WebAssembly in WebGL 2 ali WebGPU. Odprite stran v novejši različici brskalnika Firefox, Chrome, Edge ali Safari.",
    "Reload the page": "Znova naloži stran",
    "Reload with WebGL": "Znova naloži z WebGL",
    "If that does not help, try another browser: current versions of Chrome, Edge, Firefox and Safari can run SteadyCut.":
      "Če to ne pomaga, poskusite z drugim brskalnikom: novejše različice brskalnikov Chrome, Edge, Firefox in Safari poganjajo SteadyCut.",
    "SteadyCut has stopped": "SteadyCut se je ustavil",
    "This is a fault in the program. The settings are kept in the page's address: reload the page to go on.":
      "To je napaka v programu. Nastavitve so shranjene v naslovu strani: za nadaljevanje stran znova naložite.",
    "Text typed into SteadyCut": "Besedilo, vneseno v SteadyCut",
    "The graphics were lost": "Grafika je bila izgubljena",
    "The browser or the graphics driver has taken the graphics away. Scenario and changes are kept in the page's address: reload the page to go on.":
      "Brskalnik ali gonilnik grafike je odvzel grafiko. Scenarij in spremembe so shranjeni v naslovu strani: za nadaljevanje stran znova naložite.",
    "{n} times within a minute": "{n}-krat v eni minuti",
    "SteadyCut can't draw here": "SteadyCut tukaj ne more risati",
    "This browser offers neither WebGPU nor WebGL 2. Turn on hardware acceleration in the browser's settings, update the browser, or open the page in another one: current versions of Chrome, Edge, Firefox and Safari can run SteadyCut.":
      "Ta brskalnik nima ne WebGPU ne WebGL 2. V nastavitvah brskalnika vklopite strojno pospeševanje, posodobite brskalnik ali odprite stran v drugem: novejše različice brskalnikov Chrome, Edge, Firefox in Safari poganjajo SteadyCut.",
    "A part of the program did not arrive or could not be read. Check the connection and reload the page.":
      "Del programa ni prispel ali ga ni bilo mogoče prebrati. Preverite povezavo in stran znova naložite.",
    "There is no connection to the network. Reload the page when there is one.":
      "Povezave z omrežjem ni. Ko bo vzpostavljena, stran znova naložite.",
    "SteadyCut could not be loaded": "SteadyCuta ni bilo mogoče naložiti",
    "SteadyCut could not start": "SteadyCut se ni mogel zagnati",
    "Drawing with {graphics} failed. Reload the page.": "Risanje z {graphics} ni uspelo. Stran znova naložite.",
    "Reload the page.": "Stran znova naložite.",
  },
  de: {
    "Controls for screen readers": "Bedienelemente für Screenreader",
    "SteadyCut: console of a milling machine that keeps its surface finish constant":
      "SteadyCut: Konsole einer Fräsmaschine, die ihre Oberflächenrauheit konstant hält",
    "Drawn here. For a screen reader: Escape, then Shift and Tab, to a switch that makes its controls elements of the page.":
      "Hier gezeichnet. Für einen Screenreader: Escape, dann Umschalt und Tab zu einem Schalter, der aus den Bedienelementen Elemente der Seite macht.",
    "Loading": "Laden",
    "Loading…": "Laden …",
    "Starting…": "Start …",
    "Loading: {done} of {all} MB": "Geladen: {done} von {all} MB",
    "Loading: {done} MB": "Geladen: {done} MB",
    "This browser is too old": "Dieser Browser ist zu alt",
    "SteadyCut needs WebAssembly and WebGL 2 or WebGPU. Please open the page in a current version of Firefox, Chrome, Edge or Safari.":
      "SteadyCut braucht WebAssembly und WebGL 2 oder WebGPU. Bitte die Seite in einer aktuellen Version von Firefox, Chrome, Edge oder Safari öffnen.",
    "Reload the page": "Seite neu laden",
    "Reload with WebGL": "Mit WebGL neu laden",
    "If that does not help, try another browser: current versions of Chrome, Edge, Firefox and Safari can run SteadyCut.":
      "Wenn das nicht hilft, einen anderen Browser versuchen: Aktuelle Versionen von Chrome, Edge, Firefox und Safari können SteadyCut ausführen.",
    "SteadyCut has stopped": "SteadyCut ist stehen geblieben",
    "This is a fault in the program. The settings are kept in the page's address: reload the page to go on.":
      "Das ist ein Fehler im Programm. Die Einstellungen stehen in der Adresse der Seite: Zum Fortfahren die Seite neu laden.",
    "Text typed into SteadyCut": "In SteadyCut eingegebener Text",
    "The graphics were lost": "Die Grafik ging verloren",
    "The browser or the graphics driver has taken the graphics away. Scenario and changes are kept in the page's address: reload the page to go on.":
      "Der Browser oder der Grafiktreiber hat die Grafik entzogen. Szenario und Änderungen stehen in der Adresse der Seite: Zum Fortfahren die Seite neu laden.",
    "{n} times within a minute": "{n}-mal innerhalb einer Minute",
    "SteadyCut can't draw here": "SteadyCut kann hier nicht zeichnen",
    "This browser offers neither WebGPU nor WebGL 2. Turn on hardware acceleration in the browser's settings, update the browser, or open the page in another one: current versions of Chrome, Edge, Firefox and Safari can run SteadyCut.":
      "Dieser Browser bietet weder WebGPU noch WebGL 2. In den Einstellungen des Browsers die Hardwarebeschleunigung einschalten, den Browser aktualisieren oder die Seite in einem anderen öffnen: Aktuelle Versionen von Chrome, Edge, Firefox und Safari können SteadyCut ausführen.",
    "A part of the program did not arrive or could not be read. Check the connection and reload the page.":
      "Ein Teil des Programms kam nicht an oder war nicht lesbar. Die Verbindung prüfen und die Seite neu laden.",
    "There is no connection to the network. Reload the page when there is one.":
      "Es besteht keine Verbindung zum Netz. Die Seite neu laden, sobald es eine gibt.",
    "SteadyCut could not be loaded": "SteadyCut konnte nicht geladen werden",
    "SteadyCut could not start": "SteadyCut konnte nicht starten",
    "Drawing with {graphics} failed. Reload the page.": "Das Zeichnen mit {graphics} ist gescheitert. Die Seite neu laden.",
    "Reload the page.": "Die Seite neu laden.",
  },
};

// As the program chooses it: by the link, by what was chosen before, by the browser.
function chosen() {
  const known = (tag) => ["en", "sl", "de"].find((code) => tag?.toLowerCase().split(/[-_]/)[0] === code);
  const flags = /[?&#]embed=([^&]*)/.exec(location.href)?.[1] ?? "";
  let kept = "";
  try {
    kept = JSON.parse(localStorage.getItem("steadycut.remembered"))?.language;
  } catch {
    // Nothing is kept, or it may not be read.
  }
  const asked = [/(?:^|,)lang:([a-z]+)/.exec(decodeURIComponent(flags))?.[1], kept, ...navigator.languages];
  return asked.map(known).find(Boolean) ?? "en";
}

const language = chosen();
document.documentElement.lang = language;

// A text in the language of the page, with its values in place.
export function say(english, values = {}) {
  const text = TEXTS[language]?.[english] ?? english;
  return text.replace(/\{(\w+)\}/g, (place, name) => values[name] ?? place);
}

// A number with one digit behind the decimal sign of the language.
export const tenths = (number) => (language === "en" ? number.toFixed(1) : number.toFixed(1).replace(".", ","));

// What stands in the page from its beginning.
for (const element of document.querySelectorAll("[data-say]")) element.textContent = say(element.textContent.trim());
for (const name of ["aria-label", "aria-description"]) {
  for (const element of document.querySelectorAll(`[${name}]`)) element.setAttribute(name, say(element.getAttribute(name)));
}
