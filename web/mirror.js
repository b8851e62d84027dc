// The console as elements of the page, for screen readers: what is drawn on a canvas is closed to them. The program
// tells what of its tree has changed (src/app/mirror), and here it becomes buttons, fields and texts that lie, unseen,
// where the console draws them. What is done with an element goes back to the program.

// Keys that an element answers itself, besides Tab, which is the browser's.
const OWN_KEYS = {
  button: ["Enter", " "],
  list: ["Enter", " "],
  check_box: [" "],
  radio: [" "],
  link: ["Enter"],
  slider: ["Home", "End"],
};
const STEPS = { ArrowUp: 1, ArrowRight: 1, PageUp: 10, ArrowDown: -1, ArrowLeft: -1, PageDown: -10 };
const TYPED = new Set(["number", "text", "lines"]);
const PRESSED = new Set(["button", "list", "check_box", "radio", "link", "picture"]);

const TAGS = {
  button: "button", list: "button", check_box: "input", radio: "input", slider: "input", number: "input",
  text: "input", lines: "textarea", link: "a", label: "span", picture: "div", progress: "progress",
  window: "div", group: "div",
};

function create(kind) {
  const control = document.createElement(TAGS[kind]);
  const set = (name, value) => control.setAttribute(name, value);
  switch (kind) {
    case "button": control.type = "button"; break;
    case "list": control.type = "button"; set("aria-haspopup", "listbox"); break;
    case "check_box": control.type = "checkbox"; break;
    case "radio": control.type = "radio"; break;
    case "slider": control.type = "range"; control.step = "any"; break;
    case "number": control.type = "text"; control.inputMode = "decimal"; set("role", "spinbutton"); break;
    case "text": control.type = "text"; break;
    case "link": set("role", "link"); break;
    case "picture": set("role", "img"); break;
    case "window": set("role", "dialog"); break;
  }
  return control;
}

const attribute = (control, name, value) => {
  if (value === null || value === undefined || value === "" || value === false) control.removeAttribute(name);
  else if (control.getAttribute(name) !== String(value)) control.setAttribute(name, value);
};

export class Mirror {
  #program;
  #root;
  #said;
  #parts = new Map(); // by the node's name: { kind, control, box, told }
  #following = false; // the focus moves because the console has moved it

  #programsWithCtrl;

  // `programsWithCtrl`: keys that are the program's with Ctrl; all others are the browser's.
  constructor(program, root, said, programsWithCtrl) {
    this.#program = program;
    this.#programsWithCtrl = programsWithCtrl;
    this.#root = root;
    this.#said = said;
    const events = { click: "click", change: "change", input: "input", keydown: "key", focusin: "entered", focusout: "left" };
    for (const [event, method] of Object.entries(events)) root.addEventListener(event, (told) => this[method](told));
  }

  // What the program tells: see `Changes`.
  take({ root, changed, removed, focus }) {
    // Said in one place that stays: what is new in the page is read by few readers, whatever it says of itself.
    const news = changed.filter((told) => told.live && told.name && told.name !== this.#parts.get(told.id)?.told.name);
    if (news.length) this.#said.textContent = news.map((told) => told.name).join(" ");
    for (const told of changed) this.#show(told);
    for (const told of changed) this.#fill(this.#parts.get(told.id));
    for (const id of removed) {
      this.#parts.get(id)?.box.remove();
      this.#parts.delete(id);
    }
    const top = this.#parts.get(root);
    if (top && top.box.parentElement !== this.#root) this.#root.replaceChildren(top.box);
    this.#follow(focus);
  }

  clear() {
    this.#parts.clear();
    this.#root.replaceChildren();
    this.#said.textContent = "";
  }

  #show(told) {
    let part = this.#parts.get(told.id);
    if (part?.kind !== told.kind) {
      const control = create(told.kind);
      const holds = told.kind === "group" || told.kind === "window";
      const box = holds ? control : document.createElement("div");
      if (!holds) box.append(control);
      control.dataset.id = told.id;
      part?.box.replaceWith(box);
      part = { kind: told.kind, control, box };
      this.#parts.set(told.id, part);
    }
    part.told = told;
    const { control } = part;
    const named = told.kind === "label" ? null : told.name;
    attribute(control, "aria-label", told.kind === "group" ? null : named);
    if (told.kind === "group" && told.name) {
      attribute(control, "role", "group");
      attribute(control, "aria-label", told.name);
    }
    attribute(control, "aria-description", told.description);
    if ("disabled" in control) control.disabled = told.disabled;
    else attribute(control, "aria-disabled", told.disabled);
    const stops = told.focusable && !told.disabled;
    if (PRESSED.has(told.kind) || TYPED.has(told.kind) || told.kind === "slider") control.tabIndex = stops ? 0 : -1;
    this.#value(part);
    if (told.bounds) {
      const [left, top, width, height] = told.bounds;
      Object.assign(control.style, { left: `${left}px`, top: `${top}px`, width: `${width}px`, height: `${height}px` });
    }
  }

  #value({ kind, control, told }) {
    const editing = control.dataset.editing !== undefined;
    switch (kind) {
      case "label":
        if (control.textContent !== told.name) control.textContent = told.name;
        break;
      case "button":
      case "list":
      case "link": {
        const text = [told.name, told.value].filter(Boolean).join(": ");
        if (control.textContent !== text) control.textContent = text;
        attribute(control, "aria-label", text);
        attribute(control, "aria-pressed", kind === "button" ? told.toggled : null);
        attribute(control, "aria-expanded", told.expanded === null ? null : String(told.expanded));
        break;
      }
      case "picture":
        attribute(control, "aria-label", [told.name, told.value].filter(Boolean).join(": "));
        break;
      case "check_box":
        control.indeterminate = told.toggled === "mixed";
        control.checked = told.toggled === "true";
        break;
      case "radio":
        control.checked = told.toggled === "true";
        break;
      case "slider":
        if (told.range[0] !== null) control.min = told.range[0];
        if (told.range[1] !== null) control.max = told.range[1];
        if (told.number !== null) control.value = told.number;
        attribute(control, "aria-valuetext", told.value ?? String(told.number));
        break;
      case "progress":
        if (told.number !== null) control.value = told.number;
        break;
      case "number":
        attribute(control, "aria-valuenow", told.number);
        attribute(control, "aria-valuemin", told.range[0]);
        attribute(control, "aria-valuemax", told.range[1]);
        attribute(control, "aria-valuetext", told.value);
        if (!editing) control.value = told.value ?? String(told.number ?? "");
        break;
      case "text":
      case "lines":
        if (!editing && control.value !== (told.value ?? "")) control.value = told.value ?? "";
        break;
    }
  }

  // Puts what a part holds into it, and moves only what stands elsewhere: an element that is moved loses the focus.
  #fill(part) {
    const { box, control, told } = part;
    let before = box === control ? null : control;
    for (const id of told.children) {
      const child = this.#parts.get(id)?.box;
      if (!child) continue;
      const place = before ? before.nextSibling : box.firstChild;
      if (place !== child) box.insertBefore(child, place);
      before = child;
    }
  }

  // The keyboard goes where the console has moved it (a dialogue that opens), if it was in here.
  #follow(focus) {
    const control = this.#parts.get(focus)?.control;
    const now = document.activeElement;
    if (!control || control === now || !this.#root.contains(now)) return;
    this.#following = true;
    control.focus({ preventScroll: true });
    this.#following = false;
  }

  #part(event) {
    return this.#parts.get(event.target.dataset.id);
  }

  #act(deed) {
    try {
      this.#program.mirror_act(JSON.stringify(deed));
      return true;
    } catch (error) {
      this.#said.textContent = String(error?.message ?? error);
      return false;
    }
  }

  click(event) {
    const part = this.#part(event);
    if (part && PRESSED.has(part.kind)) this.#act({ deed: "click", id: part.told.id });
  }

  input(event) {
    const part = this.#part(event);
    if (!part) return;
    if (TYPED.has(part.kind)) part.control.dataset.editing = "";
    if (part.kind === "slider" || part.kind === "text" || part.kind === "lines") this.#write(part);
  }

  change(event) {
    const part = this.#part(event);
    if (part?.kind === "number") this.#write(part);
  }

  #write({ kind, control, told }) {
    const taken = this.#act({ deed: "write", id: told.id, text: control.value });
    if (kind !== "number") return;
    delete control.dataset.editing;
    attribute(control, "aria-invalid", taken ? null : "true");
    if (!taken) control.value = told.value ?? String(told.number ?? "");
  }

  key(event) {
    const part = this.#part(event);
    if (!part || event.key === "Tab" || event.isComposing) return;
    const { kind, told } = part;
    const steps = STEPS[event.key];
    const vertical = event.key === "ArrowUp" || event.key === "ArrowDown";
    if (steps && !event.altKey && !event.ctrlKey && (kind === "slider" || (kind === "number" && vertical))) {
      event.preventDefault();
      this.#act({ deed: "step", id: told.id, by: steps });
      return;
    }
    const ctrl = event.ctrlKey || event.metaKey;
    // The browser has its own: those with Alt, most with Ctrl, and the row of functions.
    if (event.altKey || (ctrl && !this.#programsWithCtrl.has(event.key.toLowerCase())) || /^F\d+$/.test(event.key)) return;
    if (!ctrl && OWN_KEYS[kind]?.includes(event.key)) return;
    // A text that is being written keeps its keys, but for those that end it; a number ends itself.
    const ends = event.key === "Escape" || (event.key === "Enter" && kind !== "number");
    if (TYPED.has(kind) && (ctrl || !ends)) return;
    event.preventDefault();
    this.#act({ deed: "key", key: event.key.length === 1 ? event.key.toUpperCase() : event.key, ctrl, shift: event.shiftKey, alt: false });
  }

  entered(event) {
    const part = this.#part(event);
    this.#program.mirror_hold(true);
    if (part && !this.#following) this.#act({ deed: "focus", id: part.told.id });
  }

  left(event) {
    delete event.target.dataset.editing;
    if (!this.#root.contains(event.relatedTarget)) this.#program.mirror_hold(false);
  }
}
