// Copyright (c) 2026 The Anisotropic_hde_remeshing developers.
//
// This file is part of Anisotropic_hde_remeshing, a package in the manner of CGAL (www.cgal.org).
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Anisotropic_hde_remeshing developers

/* ---- what both views show: colours, edges, the overlay, the triangle chosen ---- */

const views = {};  // before, after: canvas, mesh, painter, altitude
const chosen = {view: null, face: null, rank: -1, rankOf: "", isCutFree: false};
let isDrawAsked = false;

const figureShown = () => data.figures[Number(element("colour").value)];
const eachView = action => ["before", "after"].forEach(id => action(views[id], id));

function askForDraw() {
  if (isDrawAsked) return;
  isDrawAsked = true;
  requestAnimationFrame(() => { isDrawAsked = false; draw(); });
}

// The edges of all triangles of a mesh are as dark. They go where most would be nearer than two pixels, and a word tells it.
function darknessOfEdges(view, id) {
  const pixels = view.altitude * camera.zoom * Math.min(view.canvas.clientWidth, view.canvas.clientHeight) / 2;
  const isTooFine = pixels <= 2;
  element(id + "-note").textContent = element("edges").checked && isTooFine ? "edges too close to draw: zoom in" : "";
  return !element("edges").checked || isTooFine ? 0 : 0.75 * Math.min(1, pixels / 6);
}

function draw() {
  const canvas = views.after.canvas;
  if (camera.isWhole) showWhole([views.before.mesh, views.after.mesh], canvas.clientWidth, canvas.clientHeight);
  eachView((view, id) => view.painter.draw({
    figure: figureShown(), low: Number(element("low").value), high: Number(element("high").value),
    logarithmic: element("scale").value === "logarithmic", edges: darknessOfEdges(view, id),
    smooth: element("smooth").checked, creases: element("creases").checked, cut: cutDepth()}));
}

/* the colours */

function drawLegend(context, figure, x, y, width, height) {
  const gradient = context.createLinearGradient(x, 0, x + width, 0);
  stopsOf(figure).forEach((c, i) => gradient.addColorStop(i / 4, "rgb(" + c.join(",") + ")"));
  context.fillStyle = gradient;
  context.fillRect(x, y, width, height);
}

const forInput = x => (x !== 0 && Math.abs(x) < 1e-3 ? x.toExponential(3) : String(Number(x.toPrecision(4))));

function setRange(which) {
  const figure = figureShown();
  if (!figure || which === "own") return;
  const ranges = which === "both" ? [figure.range_before, figure.range_after] : [figure["range_" + which]];
  element("low").value = forInput(Math.min(...ranges.map(r => r[0])));
  element("high").value = forInput(Math.max(...ranges.map(r => r[1])));
  mendRange();
}

// a range that colours can be in: not empty, on both sides of 0 where there is a sign, more than 0 for logarithms
function mendRange() {
  const figure = figureShown(), low = element("low"), high = element("high");
  if (figure.worst === "absolute") {
    if (!(Number(high.value) > 0)) high.value = forInput(Math.abs(Number(high.value)) || 1e-12);
    if (!(Number(low.value) < 0)) low.value = forInput(-Math.abs(Number(low.value)) || -1e-12);
    return;
  }
  const isLogarithmic = element("scale").value === "logarithmic";
  if (isLogarithmic && !(Number(high.value) > 0)) high.value = "1";
  if (isLogarithmic && !(Number(low.value) > 0)) low.value = forInput(Number(high.value) / 1000);
  if (!(Number(high.value) > Number(low.value))) high.value = forInput(Number(low.value) + (Math.abs(Number(low.value)) || 1));
}

function chooseFigure() {
  const figure = figureShown();
  element("legend").hidden = !figure;
  element("legend").style.display = figure ? "" : "none";
  if (figure) {
    element("scale").value = figure.logarithmic ? "logarithmic" : "linear";
    element("scale").disabled = figure.worst === "absolute";
    element("unit").textContent = figure.unit.trim() + " and more" +
      (figure.worst === "absolute" ? "; positive outside" : "");
    drawLegend(element("gradient").getContext("2d"), figure, 0, 0, 180, 1);
    if (element("range").value === "own") element("range").value = "after";
    setRange(element("range").value);
  }
  eachView(view => view.painter.setValues(figure));
  if (chosen.face !== null) tellFace();
  askForDraw();
}

/* the overlay */

function showOverlay() {
  const mode = element("mode").value, share = Number(element("slider").value), top = element("after");
  element("views").dataset.mode = mode;
  element("slider-row").hidden = mode === "side";
  top.style.clipPath = mode === "wipe" ? "inset(0 0 0 " + share + "%)" : "";
  top.style.opacity = mode === "fade" ? share / 100 : "";
  element("divider").style.marginLeft = "calc(" + share + "% - 1px)";
  askForDraw();
}

// faded, the clearer one is meant
const viewMeant = id => (element("mode").value !== "fade" ? id : Number(element("slider").value) < 50 ? "before" : "after");

/* a triangle */

// The depth, to the eye, in front of which nothing is drawn: so is seen what lies behind other parts of the mesh.
function cutDepth() {
  if (!chosen.isCutFree) return 10;
  const {mesh} = views[chosen.view];
  const depths = mesh.corners(chosen.face).map(p => rotated(camera.rotation, p)[2]);
  return Math.max(...depths) + Math.max(...mesh.lengths(chosen.face)) / 100;
}

// the nearest to the eye at a point of the canvas, in pixels of the page from its corner
function faceAt(view, x, y) {
  const {clientWidth: w, clientHeight: h} = view.canvas, half = Math.min(w, h) / 2;
  const {points, faces} = view.mesh, r = camera.rotation;
  const px = ((x - w / 2) / half - camera.x) / camera.zoom, py = ((h / 2 - y) / half - camera.y) / camera.zoom;
  const q = new Float64Array(points.length);
  for (let i = 0; i < points.length; i += 3)
    for (let k = 0; k < 3; ++k) q[i + k] = r[3 * k] * points[i] + r[3 * k + 1] * points[i + 1] + r[3 * k + 2] * points[i + 2];
  const cut = cutDepth();
  let found = null, depth = -Infinity;
  for (let f = 0; f < view.mesh.numberOfFaces; ++f) {
    const a = 3 * faces[3 * f], b = 3 * faces[3 * f + 1], c = 3 * faces[3 * f + 2];
    const u = (q[b] - px) * (q[c + 1] - py) - (q[c] - px) * (q[b + 1] - py);
    const v = (q[c] - px) * (q[a + 1] - py) - (q[a] - px) * (q[c + 1] - py);
    const t = (q[a] - px) * (q[b + 1] - py) - (q[b] - px) * (q[a + 1] - py), sum = u + v + t;
    if (sum === 0 || u * sum < 0 || v * sum < 0 || t * sum < 0) continue;
    const z = (u * q[a + 2] + v * q[b + 2] + t * q[c + 2]) / sum;
    if (z > depth && z < cut) { depth = z; found = f; }
  }
  return found;
}

function choose(id, face, rank = -1, rankOf = "") {
  Object.assign(chosen, {view: face === null ? null : id, face, rank, rankOf, isCutFree: false});
  eachView((view, name) => view.painter.select(name === chosen.view ? face : null));
  tellFace();
  askForDraw();
}

const figureText = (figure, value) => figure.title + " " + (value === Infinity ? "infinite" : text(value, 4)) + figure.unit;

function tellFace() {
  if (chosen.face === null) { element("selected").textContent = ""; return; }
  const mesh = views[chosen.view].mesh, f = chosen.face, toD = box.radius / data.report.diagonal, p = mesh.corners(f);
  const centre = [0, 1, 2].map(k => text(fromView((p[0][k] + p[1][k] + p[2][k]) / 3, k), 6));
  const rank = chosen.rank < 0 ? "" : (chosen.rank === 0 ? "the worst" : "number " + (chosen.rank + 1) + " of the worst") +
    " by " + chosen.rankOf + ": ";
  element("selected").textContent = chosen.view + ", " + rank + "triangle " + text(f + 1) + " of " + text(mesh.numberOfFaces) +
    (mesh.isSimplified ? " of the mesh as shown" : "") + "; " +
    data.figures.map(figure => figureText(figure, mesh.figures[figure.key][f])).join(", ") +
    "; edges " + mesh.lengths(f).map(l => text(l * toD)).join(", ") + " D; centroid at (" + centre.join(", ") + ") in the file" +
    (chosen.isCutFree ? "; what is in front of it is cut away" : "");
}

// from the front, and free of what is in front of it
function showFace(id, face, rank, rankOf) {
  const view = views[id];
  lookAt(view.mesh, face);
  choose(id, face, rank, rankOf);
  chosen.isCutFree = faceAt(view, view.canvas.clientWidth / 2, view.canvas.clientHeight / 2) !== face;
  tellFace();
}

// again, and the next one follows
function goToWorst(id) {
  const figure = figureShown() || data.figures[0], mesh = views[id].mesh, order = mesh.order(figure);
  const isNext = chosen.view === id && chosen.rankOf === figure.title && chosen.rank >= 0;
  const rank = isNext ? (chosen.rank + 1) % order.length : 0;
  if (element("mode").value !== "side") { element("slider").value = id === "before" ? 100 : 0; }
  if (element("mode").value === "fade") element("slider").value = id === "before" ? 0 : 100;
  showOverlay();
  showFace(id, order[rank], rank, figure.title);
}

