/* SPDX-FileCopyrightText: 2026 the linelet authors */
/* SPDX-License-Identifier: BSD-3-Clause */
/* The 3D view: WebGL 2 and nothing else. There is no "smaller than" in it, which
   HTML would take for a tag. */
(function () {
"use strict";
const figure = document.getElementById("space-view");
const canvas = figure.querySelector("canvas");
const gl = canvas.getContext("webgl2", {antialias: true, preserveDrawingBuffer: true});
if (!gl) return; // the still picture stays
const data = JSON.parse(document.getElementById("space-data").textContent);
const bytesOf = text => Uint8Array.from(atob(text), c => c.charCodeAt(0));
const caption = figure.querySelector("figcaption");
figure.querySelector("svg").style.display = "none";
figure.querySelector(".keys").hidden = canvas.hidden = false;

function program(vertex, fragment) {
  const made = gl.createProgram();
  for (const [kind, text] of [[gl.VERTEX_SHADER, vertex], [gl.FRAGMENT_SHADER, fragment]]) {
    const shader = gl.createShader(kind);
    gl.shaderSource(shader, "#version 300 es\nprecision highp float;\n" + text);
    gl.compileShader(shader);
    gl.attachShader(made, shader);
  }
  gl.linkProgram(made);
  if (!gl.getProgramParameter(made, gl.LINK_STATUS)) throw new Error(gl.getProgramInfoLog(made));
  return made;
}
const dots = program(
  "in vec3 place; in float look; uniform mat4 view; uniform float size; uniform vec3 palette[6];" +
  "out vec3 ink; void main() { gl_Position = view * vec4(place, 1.0);" +
  "gl_PointSize = look > 2.5 ? size * 1.5 : size; ink = palette[int(look + 0.5)]; }",
  "in vec3 ink; out vec4 color; void main() { vec2 p = gl_PointCoord - 0.5;" +
  "if (dot(p, p) > 0.25) discard; color = vec4(ink, 1.0); }");
// A segment is two triangles, as wide as said in pixels.
const lines = program(
  "in vec3 from; in vec3 to; in vec2 corner; in vec3 tint; uniform mat4 view;" +
  "uniform vec2 pixels; uniform float width; out vec3 ink; void main() {" +
  "vec4 a = view * vec4(from, 1.0), b = view * vec4(to, 1.0);" +
  "vec2 way = (b.xy / b.w - a.xy / a.w) * pixels;" +
  "vec2 side = length(way) > 0.0 ? normalize(vec2(-way.y, way.x)) : vec2(0.0);" +
  "vec4 p = corner.x > 0.5 ? b : a; p.xy += side * corner.y * width / pixels * p.w;" +
  "p.z -= 0.0005 * p.w; gl_Position = p; ink = tint; }",
  "in vec3 ink; out vec4 color; void main() { color = vec4(ink, 1.0); }");

function feed(of, name, size, type, normalized, stride, offset) {
  const at = gl.getAttribLocation(of, name);
  gl.enableVertexAttribArray(at);
  gl.vertexAttribPointer(at, size, type, normalized, stride, offset);
}
function filled(bytes) {
  gl.bindBuffer(gl.ARRAY_BUFFER, gl.createBuffer());
  gl.bufferData(gl.ARRAY_BUFFER, bytes, gl.STATIC_DRAW);
}
const size = data.size, step = data.step;
const places = new Uint16Array(bytesOf(data.places).buffer);
const meters = new Float32Array(places.length);
places.forEach((value, i) => { meters[i] = value * step; });
const dotArray = gl.createVertexArray();
gl.bindVertexArray(dotArray);
filled(meters);
feed(dots, "place", 3, gl.FLOAT, false, 0, 0);
filled(bytesOf(data.looks));
feed(dots, "look", 1, gl.UNSIGNED_BYTE, false, 0, 0);

function segmentsOf(runs) {
  const out = [];
  for (const run of runs)
    for (let k = 1; run.line.length > k; k++)
      for (const corner of [[0, -1], [0, 1], [1, -1], [1, -1], [0, 1], [1, 1]])
        out.push(...run.line[k - 1], ...run.line[k], ...corner, ...run.tint);
  return new Float32Array(out);
}
function lineArray(runs) {
  const array = gl.createVertexArray(), floats = segmentsOf(runs);
  gl.bindVertexArray(array);
  filled(floats);
  [["from", 3, 0], ["to", 3, 12], ["corner", 2, 24], ["tint", 3, 32]].forEach(
    ([name, count, offset]) => feed(lines, name, count, gl.FLOAT, false, 44, offset));
  return {array, count: floats.length / 11};
}
const lineWords = new Uint16Array(bytesOf(data.lines).buffer), lineRuns = [];
const tints = [[0, 0.36, 0.72], [0.95, 0.55, 0], [0.05, 0.55, 0.45]]; // wire, doubtful, jumper
for (let at = 0; lineWords.length > at;) {
  const count = lineWords[at], tint = tints[lineWords[at + 1]], line = [];
  at += 2;
  for (let k = 0; count > k; k++, at += 3)
    line.push([lineWords[at] * step, lineWords[at + 1] * step, lineWords[at + 2] * step]);
  lineRuns.push({line, tint});
}
const drawn = lineArray(lineRuns);
const red = [0.78, 0.06, 0.18];
const hazards = lineArray(data.hazards.map(h => ({line: [h.from, h.to], tint: red})));
let chosen = lineArray([]);

const eye = {turn: 0.6, rise: 0.5, away: 1, middle: [0, 0, 0]};
const radius = Math.hypot(...size) / 2;
function look(how) {
  eye.middle = size.map(s => s / 2);
  // The long side of the scene lies along the longer side of the picture.
  const wide = canvas.clientWidth > canvas.clientHeight, across = (size[0] > size[1]) === wide;
  eye.away = (how === "above" && !wide ? 2.6 : wide ? 1.25 : 2) * radius;
  eye.turn = (how === "all" ? 0.35 : 0) - (across ? 0 : 1.5708);
  eye.rise = how === "above" ? 1.5707 : how === "side" ? 0.05 : 0.5;
  paint();
}
function basis() {
  const cr = Math.cos(eye.rise), sr = Math.sin(eye.rise), ct = Math.cos(eye.turn), st = Math.sin(eye.turn);
  return {right: [ct, -st, 0], up: [st * sr, ct * sr, cr], back: [-st * cr, -ct * cr, sr]};
}
function matrix() {
  const {right, up, back} = basis(), d = eye.away, f = 2.2;
  const aspect = canvas.width / canvas.height, near = d / 200, far = d + 4 * radius;
  const dot = (a, b) => a[0] * b[0] + a[1] * b[1] + a[2] * b[2];
  const m = [], z = (far + near) / (near - far), w = 2 * far * near / (near - far);
  for (let k = 0; 3 > k; k++) m.push(right[k] * f / aspect, up[k] * f, back[k] * z, -back[k]);
  const e = [-dot(right, eye.middle), -dot(up, eye.middle), -dot(back, eye.middle) - d];
  m.push(e[0] * f / aspect, e[1] * f, e[2] * z + w, -e[2]);
  return new Float32Array(m);
}
let asked = false;
function paint() {
  if (asked) return;
  asked = true;
  requestAnimationFrame(() => {
    asked = false;
    const ratio = window.devicePixelRatio || 1;
    canvas.width = Math.max(1, Math.round(canvas.clientWidth * ratio));
    canvas.height = Math.max(1, Math.round(canvas.clientHeight * ratio));
    gl.viewport(0, 0, canvas.width, canvas.height);
    gl.clearColor(0.97, 0.975, 0.98, 1);
    gl.clear(gl.COLOR_BUFFER_BIT | gl.DEPTH_BUFFER_BIT);
    gl.enable(gl.DEPTH_TEST);
    const view = matrix();
    gl.useProgram(dots);
    gl.uniformMatrix4fv(gl.getUniformLocation(dots, "view"), false, view);
    gl.uniform1f(gl.getUniformLocation(dots, "size"), ratio * Math.min(4, Math.max(1.6, 1.6 * radius / eye.away)));
    gl.uniform3fv(gl.getUniformLocation(dots, "palette"), [
      0.78, 0.72, 0.62, 0.66, 0.74, 0.56, 0.36, 0.55, 0.34, 0.25, 0.25, 0.3, 0.45, 0.6, 0.8,
      0.72, 0.35, 0.1]);
    gl.bindVertexArray(dotArray);
    gl.drawArrays(gl.POINTS, 0, places.length / 3);
    gl.useProgram(lines);
    gl.uniformMatrix4fv(gl.getUniformLocation(lines, "view"), false, view);
    gl.uniform2f(gl.getUniformLocation(lines, "pixels"), canvas.width, canvas.height);
    for (const [what, width] of [[drawn, 2], [hazards, 3], [chosen, 7]]) {
      gl.uniform1f(gl.getUniformLocation(lines, "width"), width * ratio);
      gl.bindVertexArray(what.array);
      gl.drawArrays(gl.TRIANGLES, 0, what.count);
    }
  });
}
function shift(dx, dy) {
  const {right, up} = basis(), scale = eye.away / (1.1 * canvas.clientHeight);
  for (let k = 0; 3 > k; k++) eye.middle[k] += scale * (-dx * right[k] + dy * up[k]);
}
function turn(dx, dy) {
  eye.turn += 0.006 * dx;
  eye.rise = Math.min(1.5707, Math.max(-0.2, eye.rise + 0.006 * dy));
}
const fingers = new Map();
canvas.addEventListener("pointerdown", e => {
  canvas.setPointerCapture(e.pointerId);
  fingers.set(e.pointerId, [e.clientX, e.clientY]);
});
for (const name of ["pointerup", "pointercancel"])
  canvas.addEventListener(name, e => fingers.delete(e.pointerId));
canvas.addEventListener("pointermove", e => {
  const last = fingers.get(e.pointerId);
  if (!last) return;
  const dx = e.clientX - last[0], dy = e.clientY - last[1];
  if (fingers.size === 2) {
    const spread = () => { const [a, b] = [...fingers.values()]; return Math.hypot(a[0] - b[0], a[1] - b[1]); };
    const before = spread();
    fingers.set(e.pointerId, [e.clientX, e.clientY]);
    eye.away *= Math.max(0.5, Math.min(2, before / Math.max(spread(), 1)));
    shift(dx / 2, dy / 2);
  } else {
    fingers.set(e.pointerId, [e.clientX, e.clientY]);
    if (e.shiftKey || (e.buttons & 6) > 0) shift(dx, dy);
    else turn(dx, dy);
  }
  paint();
});
canvas.addEventListener("contextmenu", e => e.preventDefault());
canvas.addEventListener("wheel", e => {
  e.preventDefault();
  eye.away *= Math.exp(0.0012 * Math.max(-200, Math.min(200, e.deltaY)));
  paint();
}, {passive: false});
canvas.addEventListener("keydown", e => {
  const way = {ArrowLeft: [-20, 0], ArrowRight: [20, 0], ArrowUp: [0, -20], ArrowDown: [0, 20]}[e.key];
  if (way) turn(...way);
  else if (e.key === "+" || e.key === "-") eye.away *= e.key === "+" ? 0.85 : 1.18;
  else return;
  e.preventDefault();
  paint();
});
figure.querySelectorAll("button").forEach(b => b.addEventListener("click", () => look(b.dataset.look)));
function showHazard(key) {
  const h = data.hazards.find(one => one.key === key);
  if (!h) return;
  eye.middle = h.from.map((v, k) => (v + h.to[k]) / 2);
  const long = Math.hypot(...h.from.map((v, k) => v - h.to[k]));
  eye.away = Math.max(25, 5 * long);
  eye.rise = 0.25;
  chosen = lineArray([{line: [h.from, h.to], tint: red}]);
  caption.textContent = h.text;
  figure.scrollIntoView({block: "center"});
  paint();
}
const follow = () => {
  const found = /^#space-(\w+)$/.exec(location.hash);
  if (found) showHazard(found[1]);
};
document.addEventListener("click", e => {
  const link = e.target.closest && e.target.closest("a[href^='#space-']");
  if (!link) return;
  e.preventDefault();
  history.replaceState(null, "", link.getAttribute("href"));
  follow();
});
window.addEventListener("hashchange", follow);
window.addEventListener("resize", paint);
look("all");
follow();
})();
