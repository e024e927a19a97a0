// Copyright (c) 2026 The Anisotropic_hde_remeshing developers.
//
// This file is part of Anisotropic_hde_remeshing, a package in the manner of CGAL (www.cgal.org).
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Anisotropic_hde_remeshing developers

// What a user does with the page of --report: test_report.sh puts this at its end. Each check is a line, told to the frame around.

"use strict";
(async () => {
  const results = [];
  const check = (name, holds, what = "") => results.push((holds ? "ok: " : "FAILED: ") + name + (holds ? "" : " " + what));
  const frame = () => new Promise(done => setTimeout(done, 20)); // without a screen there may be no frames
  const words = () => element("selected").textContent;

  const pixels = id => {
    draw();
    const source = element(id), copy = document.createElement("canvas");
    copy.width = source.width;
    copy.height = source.height;
    copy.getContext("2d").drawImage(source, 0, 0);
    return copy.getContext("2d").getImageData(0, 0, copy.width, copy.height);
  };
  const differs = (a, b) => a.width !== b.width || a.height !== b.height || a.data.some((x, i) => x !== b.data[i]);

  // the part of the view, from 0 to 1, that is not background
  const extent = image => {
    const at = (x, y) => image.data.slice(4 * (y * image.width + x), 4 * (y * image.width + x) + 3).join();
    const background = at(0, 0);
    let left = image.width, right = -1, top = image.height, bottom = -1;
    for (let y = 0; y < image.height; ++y)
      for (let x = 0; x < image.width; ++x)
        if (at(x, y) !== background) {
          left = Math.min(left, x); right = Math.max(right, x);
          top = Math.min(top, y); bottom = Math.max(bottom, y);
        }
    return {left: left / image.width, right: (right + 1) / image.width,
            top: top / image.height, bottom: (bottom + 1) / image.height};
  };

  const pointer = (id, type, x, y, more = {}) => {
    const canvas = element(id), box = canvas.getBoundingClientRect();
    const buttons = type === "pointerup" ? 0 : 1;
    canvas.dispatchEvent(new PointerEvent(type, {bubbles: true, cancelable: true, pointerId: 1, buttons,
      clientX: box.left + x * box.width, clientY: box.top + y * box.height, ...more}));
  };
  const click = (id, x, y) => { pointer(id, "pointerdown", x, y); pointer(id, "pointerup", x, y); };
  const press = (key, more = {}) => document.activeElement.dispatchEvent(
    new KeyboardEvent("keydown", {key, bubbles: true, cancelable: true, ...more}));
  const set = (id, value) => { element(id).value = value; element(id).dispatchEvent(new Event("change")); };
  const wheel = id => {
    const event = new WheelEvent("wheel", {deltaY: -100, bubbles: true, cancelable: true});
    element(id).dispatchEvent(event);
    return event.defaultPrevented;
  };
  // a pixel of the mesh, in parts of the view
  const onMesh = id => {
    const image = pixels(id), background = image.data.slice(0, 3).join();
    for (let i = Math.floor(image.height / 2) * image.width; i < image.width * image.height; ++i)
      if (image.data.slice(4 * i, 4 * i + 3).join() !== background) {
        const x = i % image.width + 8; // not on the outline
        return [x / image.width, Math.floor(i / image.width) / image.height];
      }
    return [0.5, 0.5];
  };

  function checkLayout() {
    check("the title says the meshes", document.title.includes(fileName(data.report.input)) &&
          document.title.includes(fileName(data.report.output)), document.title);
    check("so does the heading", element("title").textContent.includes(fileName(data.report.input)));
    check("nothing is wider than the screen", document.documentElement.scrollWidth <= innerWidth,
          document.documentElement.scrollWidth + " of " + innerWidth);
    for (const id of ["before", "after"]) {
      const e = extent(pixels(id)), size = Math.max(e.right - e.left, e.bottom - e.top);
      check("all of the mesh is in view, " + id, e.left > 0 && e.right < 1 && e.top > 0 && e.bottom < 1, JSON.stringify(e));
      check("and it is large, " + id, size > 0.85, JSON.stringify(e));
    }
    const a = element("before").getBoundingClientRect(), b = element("after").getBoundingClientRect();
    check("side by side, or one above the other on a phone", innerWidth > 700 ? a.right <= b.left : a.bottom <= b.top);
    check("fingers scroll the page", getComputedStyle(element("after")).touchAction === "pan-y");
    const cells = [...document.querySelectorAll("#measures td")].map(td => td.textContent);
    check("the table is there", cells.length >= 30 && cells.every(cell => cell !== ""));
  }

  async function checkMouse() {
    const first = pixels("after"), zoom = camera.zoom;
    check("the wheel scrolls the page at first", !wheel("after") && camera.zoom === zoom);
    pointer("after", "pointerdown", 0.3, 0.5);
    pointer("after", "pointermove", 0.5, 0.6);
    pointer("after", "pointerup", 0.5, 0.6);
    await frame();
    check("a drag turns", differs(first, pixels("after")));
    check("a drag chooses no triangle", words() === "", words());
    check("the wheel zooms after it", wheel("after") && camera.zoom > zoom);
    const x = camera.x;
    pointer("after", "pointerdown", 0.3, 0.5, {button: 2, buttons: 2});
    pointer("after", "pointermove", 0.5, 0.5, {buttons: 2});
    pointer("after", "pointerup", 0.5, 0.5, {button: 2});
    check("the right button moves", camera.x > x);
    const spread = camera.zoom;
    pointer("after", "pointerdown", 0.4, 0.5);
    pointer("after", "pointerdown", 0.6, 0.5, {pointerId: 2});
    pointer("after", "pointermove", 0.3, 0.5);
    pointer("after", "pointermove", 0.2, 0.5);
    pointer("after", "pointerup", 0.2, 0.5);
    pointer("after", "pointerup", 0.6, 0.5, {pointerId: 2});
    check("two fingers zoom", camera.zoom > spread);
    const rotation = camera.rotation.join();
    pointer("after", "pointerdown", 0.5, 0.5);
    pointer("after", "pointermove", 0.5, 0.52);
    pointer("after", "pointercancel", 0.5, 0.52);
    pointer("after", "pointermove", 0.8, 0.5);
    check("a finger that scrolls turns nothing", camera.rotation.join() === rotation && words() === "");
    element("whole").click();
    await frame();
    const e = extent(pixels("after"));
    check("the whole mesh again", e.left > 0 && e.right < 1 && e.top > 0 && e.bottom < 1, JSON.stringify(e));
  }

  // a triangle that other parts of the mesh hide from its front, if there is one
  function checkHiddenTriangle() {
    const view = views.after, [x, y] = [view.canvas.clientWidth / 2, view.canvas.clientHeight / 2];
    const depth = f => Math.max(...view.mesh.corners(f).map(p => rotated(camera.rotation, p)[2]));
    for (let f = 0; f < view.mesh.numberOfFaces; f += 7) {
      choose(null, null);
      lookAt(view.mesh, f);
      const found = faceAt(view, x, y);
      if (found === null || depth(found) < depth(f) + 0.1) continue;
      const before = pixels("after");
      showFace("after", f, -1, "");
      check("what hides a triangle is cut away", faceAt(view, x, y) === f && words().includes("cut away"), words());
      check("and not drawn", differs(before, pixels("after")));
      element("whole").click();
      check("with the whole mesh it is back", chosen.face === f && !words().includes("cut away"), words());
      return;
    }
  }

  async function checkTriangles() {
    for (const id of ["before", "after"]) {
      click(id, ...onMesh(id));
      await frame();
      const form = new RegExp("^" + id + ", triangle [0-9,]+ of [0-9,]+; aspect ratio [0-9.]+");
      check("a click tells a triangle, " + id, form.test(words()), words());
      check("with its lengths in D, " + id, /edges .* D;/.test(words()) && !/NaN|undefined/.test(words()), words());
      const shown = pixels(id);
      click(id, 0.01, 0.01);
      check("a click beside lets go, " + id, words() === "" && differs(shown, pixels(id)), words());
    }
    const row = [...document.querySelectorAll("#measures tr")].find(tr => tr.cells[0].textContent === "aspect ratio, largest");
    ["before", "after"].forEach((id, i) => {
      element(id + "-worst").click();
      const told = Number((words().match(/aspect ratio ([0-9.e+]+)/) || [])[1]), largest = Number(row.cells[i + 1].textContent);
      check("the worst triangle is that of the table, " + id, Math.abs(told / largest - 1) < 2e-3, words() + " / " + largest);
      const centre = faceAt(views[id], element(id).clientWidth / 2, element(id).clientHeight / 2);
      const face = chosen.face;
      check("it is in the middle, " + id, centre === face, centre + " " + face);
      click(id, 0.5, 0.5);
      check("a click finds it there, " + id, chosen.view === id && chosen.face === face, words());
      const n = rotated(camera.rotation, unit(views[id].mesh.areaNormal(chosen.face)));
      check("and seen from the front, " + id, n[2] > 0.999, n.join());
    });
    checkHiddenTriangle();
    for (let i = 0; i < 2; ++i) element("after-worst").click();
    check("the next one", words().includes("number 2 of the worst"), words());
    set("colour", "1");
    element("after-worst").click();
    const least = Math.min(...views.after.mesh.figures[data.figures[1].key]);
    check("the worst by another figure", views.after.mesh.figures[data.figures[1].key][chosen.face] === least, words());
    set("colour", "0");
    press("Escape");
    check("Esc lets go", words() === "");
    for (let i = 0; i < 1000; ++i) lookAt(views.after.mesh, i % views.after.mesh.numberOfFaces);
    const r = camera.rotation, rows = [r.slice(0, 3), r.slice(3, 6), r.slice(6, 9)];
    check("a rotation stays one", rows.every((a, i) => rows.every((b, k) => Math.abs(dot(a, b) - (i === k)) < 1e-12)), r.join());
    element("whole").click();
    await frame();
  }

  async function checkColours() {
    const isShown = image => differs(image, pixels("after"));
    const first = pixels("after"), [low, high] = [element("low").value, element("high").value];
    check("the range is that of the mesh after", element("range").value === "after" &&
          Math.abs(high / data.figures[0].range_after[1] - 1) < 1e-3, high);
    check("the scale has a name", element("scale").value === "logarithmic");
    set("high", "1.2");
    await frame();
    check("another range, other colours", isShown(first) && element("range").value === "own");
    set("range", "after");
    check("back to that of the mesh", element("low").value === low && element("high").value === high && !isShown(first));
    set("range", "before");
    check("that of the mesh before", Math.abs(element("high").value / data.figures[0].range_before[1] - 1) < 1e-3);
    set("range", "after");
    set("scale", "linear");
    check("another scale, other colours", isShown(first));
    set("low", "0");
    set("scale", "logarithmic");
    check("no logarithm of 0", Number(element("low").value) > 0, element("low").value);
    set("high", "-1");
    check("no empty range", Number(element("high").value) > Number(element("low").value));
    for (let i = 0; i < data.figures.length; ++i) {
      set("colour", String(i));
      check("colours by " + data.figures[i].title, i === 0 || isShown(first));
    }
    check("distances have a sign", Number(element("low").value) < 0 && Number(element("high").value) > 0);
    check("lengths are in D", element("unit").textContent.startsWith("D"));
    set("colour", "-1");
    check("no colours", isShown(first) && getComputedStyle(element("legend")).display === "none");
    set("colour", "0");
    set("range", "after");
    await frame();
  }

  async function checkKeys() {
    element("after").focus();
    const changes = async (name, key, back = key) => {
      const first = pixels("after");
      press(key);
      await frame();
      check("key " + key + ": " + name, differs(first, pixels("after")));
      press(back);
      await frame();
    };
    await changes("turns", "ArrowLeft", "ArrowRight");
    press("0");
    await changes("zooms", "+", "0");
    await changes("edges", "e");
    await changes("smooth shading", "s");
    if (views.after.mesh.curves.length > 0) await changes("creases and boundaries", "c");
    await changes("looks along x", "x", "z");
    press("n");
    check("key n: next colour", element("colour").value === "1");
    set("colour", "0");
    press("w");
    check("key w: worst triangle", words().startsWith("after, the worst by aspect ratio"), words());
    press("W", {shiftKey: true});
    check("key W: of the mesh before", words().startsWith("before, the worst"), words());
    press("Escape");
    const size = element("after").clientHeight;
    press("f");
    await frame();
    check("key f: full window", getComputedStyle(element("stage")).position === "fixed" &&
          (innerWidth <= 700 || element("after").clientHeight > size) && element("stage").scrollWidth <= innerWidth);
    check("there one finger turns in all directions", getComputedStyle(element("after")).touchAction === "none");
    press("Escape");
    check("Esc leaves it", getComputedStyle(element("stage")).position === "static");
    press("0");
    const paper = getComputedStyle(document.body).color, first = pixels("after");
    press("d");
    check("key d: dark", getComputedStyle(document.body).color !== paper, paper);
    check("the views, too", differs(first, pixels("after")), element("after").width);
    press("d");
    check("key d again", getComputedStyle(document.body).color === paper, paper);
    element("low").focus();
    press("e");
    check("no keys where one types", element("edges").checked);
    element("after").focus();
    press("0");
    await frame();
  }

  async function checkOverlay() {
    press("m");
    const a = element("before").getBoundingClientRect(), b = element("after").getBoundingClientRect();
    check("overlaid: in the same place", a.left === b.left && a.top === b.top && a.width === b.width);
    check("as wide as the page", b.width > 0.9 * element("views").clientWidth);
    element("slider").value = 30;
    element("slider").dispatchEvent(new Event("input"));
    check("the slider moves the border", element("after").style.clipPath.includes("30%"), element("after").style.clipPath);
    element("after").scrollIntoView({block: "center"});
    const c = element("after").getBoundingClientRect();
    check("left of it is before", document.elementFromPoint(c.left + 0.2 * c.width, c.top + 0.5 * c.height) === element("before"));
    check("right of it is after", document.elementFromPoint(c.left + 0.6 * c.width, c.top + 0.5 * c.height) === element("after"));
    press("m");
    element("slider").value = 30;
    element("slider").dispatchEvent(new Event("input"));
    check("faded", Number(element("after").style.opacity) === 0.3);
    press("0");
    await frame();
    click("after", ...onMesh("before"));
    check("a click is for the clearer one", words().startsWith("before, triangle"), words());
    element("after-worst").click();
    check("the worst one is shown clearly", Number(element("after").style.opacity) === 1 && words().startsWith("after, the worst"));
    press("Escape");
    press("m");
    check("side by side again", element("mode").value === "side" && element("after").style.opacity === "");
    press("0");
    await frame();
  }

  function checkFiles() {
    const obj = meshText("after", "obj").trim().split("\n"), mesh = views.after.mesh;
    const points = obj.filter(line => line.startsWith("v ")).map(line => line.slice(2).split(" ").map(Number));
    check("OBJ: all triangles", obj.filter(line => /^f \d+ \d+ \d+$/.test(line)).length === mesh.numberOfFaces);
    check("OBJ: all vertices", points.length === mesh.points.length / 3 && points.flat().every(Number.isFinite));
    check("OBJ: in the box", points.every(p => p.every((x, k) => x > data.box.low[k] - 1e-6 * data.report.diagonal &&
                                                                  x < data.box.high[k] + 1e-6 * data.report.diagonal)));
    const ply = meshText("before", "ply").trim().split("\n"), end = ply.indexOf("end_header");
    const {points: steps, numberOfFaces} = views.before.mesh;
    check("PLY: as many lines as it says", ply.length - end - 1 === steps.length / 3 + numberOfFaces, ply.length);
    check("PLY: with figures", ply.includes("property float aspect_ratio") && ply.includes("property float signed_distance") &&
          ply[ply.length - 1].split(" ").length === 4 + data.figures.length);
    const names = [], click = HTMLAnchorElement.prototype.click;
    HTMLAnchorElement.prototype.click = function () { names.push(this.download + " " + this.protocol); };
    element("save-obj").click();
    element("save-ply").click();
    HTMLAnchorElement.prototype.click = click;
    check("both are saved", /_after\.obj blob:;.*_after\.ply blob:$/.test(names.join(";")), names.join(";"));
    const canvas = picture(), bytes = canvas.getContext("2d").getImageData(0, 0, canvas.width, canvas.height).data;
    check("a picture of both", canvas.width > 2 * element("after").clientWidth &&
          new Set(bytes.filter((_, i) => i % 4 === 2)).size > 20, canvas.width);
  }

  try {
    check("the meshes are shown", document.documentElement.dataset.state === "shown", element("problem").textContent);
    checkLayout();
    await checkMouse();
    await checkTriangles();
    await checkColours();
    await checkKeys();
    await checkOverlay();
    checkFiles();
  } catch (error) {
    results.push("FAILED: the checks end early: " + error.message + " " + error.stack);
  }
  results.push("end of the checks");
  parent.postMessage({results: results.join("\n"), obj: meshText("after", "obj")}, "*");
})();
