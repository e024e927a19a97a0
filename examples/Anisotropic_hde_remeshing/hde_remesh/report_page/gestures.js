// Copyright (c) 2026 The Anisotropic_hde_remeshing developers.
//
// This file is part of Anisotropic_hde_remeshing, a package in the manner of CGAL (www.cgal.org).
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Anisotropic_hde_remeshing developers

/* ---- mouse, fingers and keys ---- */

const isFull = () => element("stage").classList.contains("full");

function listenToPointers(id) {
  const canvas = element(id), pointers = new Map();
  let spread = 0, way = 0, first = {...camera};
  canvas.addEventListener("pointerdown", e => {
    canvas.focus({preventScroll: true});
    try { canvas.setPointerCapture(e.pointerId); } catch (error) { /* a pointer that is gone by now */ }
    if (pointers.size === 0) first = {...camera};
    pointers.set(e.pointerId, e);
    spread = 0;
    way = pointers.size > 1 || e.button > 0 ? Infinity : 0;
  });
  canvas.addEventListener("pointermove", e => {
    const last = pointers.get(e.pointerId);
    if (!last) return;
    const size = Math.min(canvas.clientWidth, canvas.clientHeight), dx = e.clientX - last.clientX, dy = e.clientY - last.clientY;
    pointers.set(e.pointerId, e);
    way += Math.hypot(dx, dy);
    if (pointers.size === 2 || e.buttons === 2) {
      const half = pointers.size === 2 ? 0.5 : 1; // both fingers tell
      moveBy(half * 2 * dx / size, -half * 2 * dy / size);
      if (pointers.size === 2) {
        const [a, b] = [...pointers.values()], now = Math.hypot(a.clientX - b.clientX, a.clientY - b.clientY);
        if (spread > 0) zoomBy(now / spread);
        spread = now;
      }
    } else turn(3 * dx / size, 3 * dy / size);
    askForDraw();
  });
  canvas.addEventListener("pointerup", e => {
    if (pointers.delete(e.pointerId) && way < 4) {
      const meant = viewMeant(id), at = canvas.getBoundingClientRect();
      choose(meant, faceAt(views[meant], e.clientX - at.left - canvas.clientLeft, e.clientY - at.top - canvas.clientTop));
    }
    spread = 0;
  });
  canvas.addEventListener("pointercancel", e => { // the page scrolls: its first pixels were no turn
    pointers.delete(e.pointerId);
    Object.assign(camera, first);
    spread = 0;
    askForDraw();
  });
  canvas.addEventListener("touchmove", e => { if (e.touches.length > 1) e.preventDefault(); }, {passive: false});
  canvas.addEventListener("contextmenu", e => e.preventDefault());
  canvas.addEventListener("wheel", e => {
    if (document.activeElement !== canvas && !e.ctrlKey && !isFull()) return; // the page scrolls
    e.preventDefault();
    zoomBy(Math.exp(-0.0015 * e.deltaY));
    askForDraw();
  }, {passive: false});
}

const change = id => element(id).dispatchEvent(new Event("change"));
const toggle = id => { element(id).checked = !element(id).checked; change(id); };

function step(id, by) {
  const options = [...element(id).options].filter(option => !option.hidden), at = options.findIndex(option => option.selected);
  element(id).value = options[(at + by + options.length) % options.length].value;
  change(id);
}

function slide(by) { element("slider").value = Number(element("slider").value) + by; showOverlay(); }

function whole() {
  camera.isWhole = true;
  chosen.isCutFree = false;
  if (chosen.face !== null) tellFace();
  askForDraw();
}

function lookAlong(axis, isFromBehind) {
  camera.rotation = viewsAlong[axis];
  if (isFromBehind) turn(Math.PI, 0);
  whole();
}

function toggleFull() {
  document.body.classList.toggle("full", element("stage").classList.toggle("full"));
  element("full").textContent = isFull() ? "close" : "full window";
  askForDraw();
}

function setTheme(theme) {
  document.documentElement.dataset.theme = theme;
  element("dark").textContent = theme === "dark" ? "light" : "dark";
  if (views.after) askForDraw();
}

const toggleTheme = () => setTheme(document.documentElement.dataset.theme === "dark" ? "light" : "dark");

// Esc
function leave() {
  if (chosen.face !== null) choose(null, null);
  else if (isFull()) toggleFull();
  else document.activeElement.blur();
}

const keys = {
  "+": ["zoom in", () => zoomBy(1.2)], "-": ["zoom out", () => zoomBy(1 / 1.2)], "0": ["whole mesh", whole],
  "x": ["look along x; X from the other side", e => lookAlong("x", e.shiftKey)], "y": ["along y", e => lookAlong("y", e.shiftKey)],
  "z": ["along z", e => lookAlong("z", e.shiftKey)], "w": ["worst triangle after; again for the next; W before",
                                                            e => goToWorst(e.shiftKey ? "before" : "after")],
  "n": ["next colour", () => step("colour", 1)], "e": ["edges", () => toggle("edges")],
  "c": ["creases and boundaries", () => toggle("creases")], "s": ["smooth shading", () => toggle("smooth")],
  "m": ["side by side or overlaid", () => step("mode", 1)], ",": ["slider to the left", () => slide(-5)],
  ".": ["slider to the right", () => slide(5)], "f": ["full window", toggleFull], "d": ["dark or light", toggleTheme],
  "p": ["save picture", savePicture], "Escape": ["lets go of the triangle, the full window, the view", leave]};
const arrows = {ArrowLeft: [-1, 0], ArrowRight: [1, 0], ArrowUp: [0, -1], ArrowDown: [0, 1]};

function onKey(e) {
  const isTyping = /^(SELECT|TEXTAREA)$/.test(e.target.tagName) || (e.target.tagName === "INPUT" && e.target.type !== "checkbox");
  if (e.ctrlKey || e.metaKey || e.altKey || (isTyping && e.key !== "Escape")) return;
  const arrow = arrows[e.key], key = keys[e.key === "=" ? "+" : e.key.length === 1 ? e.key.toLowerCase() : e.key];
  if (arrow && (isFull() || document.activeElement.classList.contains("mesh"))) {
    if (e.shiftKey) moveBy(0.1 * arrow[0], -0.1 * arrow[1]);
    else turn(0.1 * arrow[0], 0.1 * arrow[1]);
  } else if (key) key[1](e);
  else return;
  e.preventDefault();
  askForDraw();
}

function listen() {
  listenToPointers("before");
  listenToPointers("after");
  document.addEventListener("keydown", onKey);
  addRow(element("keys"), ["arrows", "turn the view that was clicked; with Shift, move it"]);
  for (const [key, [meaning]] of Object.entries(keys)) addRow(element("keys"), [key === "Escape" ? "Esc" : key, meaning]);
  const on = (id, event, action) => element(id).addEventListener(event, action);
  on("colour", "change", chooseFigure);
  on("range", "change", () => { setRange(element("range").value); askForDraw(); });
  on("scale", "change", () => { mendRange(); askForDraw(); });
  for (const id of ["low", "high"]) on(id, "change", () => { element("range").value = "own"; mendRange(); askForDraw(); });
  for (const id of ["edges", "creases", "smooth"]) on(id, "change", askForDraw);
  on("mode", "change", showOverlay);
  on("slider", "input", showOverlay);
  on("whole", "click", whole);
  on("full", "click", toggleFull);
  on("dark", "click", toggleTheme);
  for (const id of ["before", "after"]) on(id + "-worst", "click", () => goToWorst(id));
  on("save-picture", "click", savePicture);
  for (const format of ["obj", "ply"]) on("save-" + format, "click", () => saveMesh(element("save-which").value, format));
  on("save-which", "change", tellOfSaving);
  window.addEventListener("resize", askForDraw);
  matchMedia("(prefers-color-scheme: dark)").addEventListener("change", e => setTheme(e.matches ? "dark" : "light"));
}

