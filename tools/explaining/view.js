// SPDX-License-Identifier: MIT
// The page of ./lab explain: the rays of a pixel as a tree and as a view to turn; what is pointed at in one is lit up in the other.
'use strict';
(() => {
const data = JSON.parse(document.getElementById('data').textContent);
const canvas = document.getElementById('view'), pen = canvas.getContext('2d');
const treeAt = document.getElementById('tree'), detailAt = document.getElementById('detail');
const state = { sample: data.first || 0, others: false, pinned: null, over: null, yaw: 0, pitch: 0, away: 1, target: [0, 0, 0] };

// ---- vectors ----
const add = (a, b) => [a[0] + b[0], a[1] + b[1], a[2] + b[2]];
const sub = (a, b) => [a[0] - b[0], a[1] - b[1], a[2] - b[2]];
const mul = (k, a) => [k * a[0], k * a[1], k * a[2]];
const dot = (a, b) => a[0] * b[0] + a[1] * b[1] + a[2] * b[2];
const cross = (a, b) => [a[1] * b[2] - a[2] * b[1], a[2] * b[0] - a[0] * b[2], a[0] * b[1] - a[1] * b[0]];
const length = a => Math.hypot(a[0], a[1], a[2]);
const unit = a => { const l = length(a); return l > 0 ? mul(1 / l, a) : [0, 0, 1]; };

// ---- words ----
const number = x => x === null || x === undefined ? '∞' : Math.abs(x) >= 1000 ? x.toFixed(0) : Math.abs(x) >= 1e-4 || x === 0 ? String(+x.toPrecision(3)) : x.toExponential(2);
const triple = v => '(' + v.map(x => x === null ? 'not finite' : number(x)).join(', ') + ')';
const amount = v => !v.includes(null) && v.every(x => Math.abs(x) < 1e-6) ? (v.some(x => x) ? '≈ 0' : '0') : new Set(v.map(number)).size === 1 && v[0] !== null ? number(v[0]) : triple(v);
const encoded = x => { x = Math.min(Math.max(x || 0, 0), 1); return Math.floor(255 * (x <= 0.0031308 ? 12.92 * x : 1.055 * Math.pow(x, 1 / 2.4) - 0.055) + 0.5); };
const css = (v, alpha = 1) => `rgba(${encoded(v[0])},${encoded(v[1])},${encoded(v[2])},${alpha})`;
const surface = i => { const s = data.surfaces[i]; return s.name + (s.material ? ` (${s.material})` : ''); };
// Glass may weaken a shadow ray instead of stopping it.
const through = ray => ray.why === 'shadow' && ray.met && ray.brings && ray.brings.some(x => Math.abs(x) > 1e-6);
const stopped = ray => ray.why === 'shadow' && ray.met && !through(ray);
const kind = ray => stopped(ray) ? 'stopped' : ray.why;
const fate = ray => ray.why === 'shadow' ? (ray.met ? (through(ray) ? 'passes through ' : 'is stopped by ') + surface(ray.met.surface) : 'reaches the light')
  : ray.met ? 'meets ' + surface(ray.met.surface) : 'meets nothing: ' + data.beyond;
const rays = () => data.samples[state.sample].rays;
const lit = () => state.over !== null ? state.over : state.pinned;

// ---- the tree ----
const order = { shadow: 0, reflected: 1, bounced: 1, refracted: 2 };
function branch(parent) {
  const below = rays().map((_, i) => i).filter(i => rays()[i].parent === parent);
  below.sort((a, b) => (order[rays()[a].why] || 0) - (order[rays()[b].why] || 0) || a - b);
  if (!below.length) return null;
  const list = document.createElement('ul');
  for (const i of below) {
    const ray = rays()[i], item = document.createElement('li'), button = document.createElement('button');
    button.className = 'ray ' + kind(ray);
    button.dataset.ray = i;
    const name = document.createElement('b'), rest = document.createElement('span'), worth = document.createElement('span');
    name.textContent = ray.why + ' ray';
    rest.textContent = ' ' + fate(ray) + ' ';
    rest.style.color = 'var(--ink)';
    worth.className = 'faint';
    worth.textContent = (ray.weight && ray.why !== 'camera' ? '· weight ' + amount(ray.weight) + ' ' : '') +
      (ray.keeps && !through(ray) ? '· keeps away ' + amount(ray.keeps) : ray.brings ? '· brings ' + amount(ray.brings) : '');
    button.append(name, rest, worth);
    button.addEventListener('pointerenter', () => light(i, null));
    button.addEventListener('pointerleave', () => light(null, null));
    button.addEventListener('focus', () => pin(i));
    button.addEventListener('click', () => pin(i));
    item.append(button);
    const inner = branch(i);
    if (inner) item.append(inner);
    list.append(item);
  }
  return list;
}
function fill() {
  treeAt.replaceChildren(branch(-1) || Object.assign(document.createElement('p'), { textContent: 'No ray is sent: what is here was drawn.' }));
  const sample = document.getElementById('which');
  if (sample) sample.textContent = `sample ${state.sample + 1} of ${data.samples.length}: ` + triple(data.samples[state.sample].color);
  show();
}
function light(i) { if (state.over !== i) { state.over = i; show(); } }
function pin(i) { state.pinned = i; state.over = null; show(); }
function show() {
  for (const button of treeAt.querySelectorAll('.ray')) button.classList.toggle('on', +button.dataset.ray === lit());
  detail();
  draw();
}
function row(table, name, text) {
  const line = table.insertRow(), head = document.createElement('th');
  head.textContent = name;
  line.append(head);
  line.insertCell().textContent = text;
}
function detail() {
  const i = lit();
  detailAt.replaceChildren();
  if (i === null || !rays()[i]) {
    detailAt.textContent = 'Point at a ray, here or in the view.';
    return;
  }
  const ray = rays()[i], table = document.createElement('table');
  row(table, 'this', ray.why + ' ray: ' + fate(ray));
  if (ray.broken) row(table, 'broken', 'its origin or direction is not a number; it is drawn at 0');
  row(table, 'from', triple(ray.origin));
  row(table, 'direction', triple(ray.direction) + ', of length ' + number(length(ray.direction)));
  row(table, 'range of t', number(ray.range[0]) + ' to ' + number(ray.range[1]));
  if (ray.time !== undefined) row(table, 'time', number(ray.time));
  if (ray.met) row(table, 'hit', 't = ' + number(ray.met.t) + ' at ' + triple(ray.met.point) + ', normal ' + triple(ray.met.normal));
  if (ray.weight) row(table, 'weight', amount(ray.weight) + ': so much of what it sees goes into the sample');
  if (ray.brings) row(table, 'brings', amount(ray.brings) + ': so much would be missing without it');
  if (ray.keeps) row(table, 'keeps away', amount(ray.keeps) + ': so much more there would be, were nothing in its way');
  if (ray.parent >= 0 && ray.gap > 1e-5 * Math.max(length(ray.origin), 1)) row(table, 'starts', number(ray.gap) + ' from where the ray before it ended');
  if (ray.boxes) row(table, 'boxes asked', ray.boxes.length + ': ' + ray.boxes.slice(0, 60).map(b => `${b.node}${b.t === null ? ' missed' : ''}`).join(', ') + (ray.boxes.length > 60 ? ' …' : ''));
  if (ray.tests.length) row(table, 'surfaces asked', ray.tests.reduce((sum, test) => sum + test[2], 0) + ': ' + ray.tests.slice(0, 40).map(([s, t]) => data.surfaces[s].name + (t === null ? ', missed' : ', t = ' + number(t))).join('; ') + (ray.tests.length > 40 ? ' …' : ''));
  detailAt.append(table);
}

// ---- the view ----
// A ray that meets nothing is drawn as far as the scene is wide; a shadow ray to the end of its range.
function end(ray) {
  if (ray.met) return ray.met.point;
  const far = ray.range[1] !== null ? ray.range[1] : scene.radius / Math.max(length(ray.direction), 1e-30);
  return add(ray.origin, mul(far, ray.direction));
}
const scene = { center: [0, 0, 0], radius: 1 };
function measure() {
  const points = [];
  for (const sample of data.samples) for (const ray of sample.rays) {
    if (ray.why !== 'camera') points.push(ray.origin);
    if (ray.met) points.push(ray.met.point);
  }
  const met = data.samples.some(sample => sample.rays.some(ray => ray.met));
  for (const s of data.surfaces) if (!met || (s.shape.kind === 'sphere' || s.shape.kind === 'moving') && Math.abs(s.shape.numbers[3]) < 50) points.push(s.shape.numbers.slice(0, 3));
  if (!points.length) points.push(data.eye, add(data.eye, rays()[0] ? rays()[0].direction : [0, 0, -1]));
  const middle = k => { const all = points.map(p => p[k]).sort((a, b) => a - b); return (all[Math.floor(all.length * .05)] + all[Math.ceil(all.length * .95) - 1]) / 2; };
  scene.center = [middle(0), middle(1), middle(2)];
  const reach = points.map(p => length(sub(p, scene.center))).sort((a, b) => a - b);
  scene.radius = Math.max(1.15 * reach[Math.floor((reach.length - 1) * .9)], .2 * length(sub(data.eye, scene.center)), 1e-30);
}
function home() {
  const way = unit(sub(data.eye, scene.center));
  state.yaw = Math.atan2(way[0], way[2]) + .6;
  state.pitch = Math.min(Math.asin(Math.max(-1, Math.min(1, way[1]))) + .3, 1.4);
  state.away = 3.1 * scene.radius;
  state.target = scene.center;
}
function fromTheEye() {
  const camera = rays()[0], way = unit(camera ? mul(-1, camera.direction) : sub(data.eye, scene.center));
  state.yaw = Math.atan2(way[0], way[2]);
  state.pitch = Math.asin(Math.max(-1, Math.min(1, way[1])));
  state.away = camera && camera.met ? length(sub(camera.met.point, data.eye)) : 3 * scene.radius;
  state.target = camera && camera.met ? camera.met.point : scene.center;
}
let frame;
function look() {
  const cp = Math.cos(state.pitch), back = [cp * Math.sin(state.yaw), Math.sin(state.pitch), cp * Math.cos(state.yaw)];
  const right = [Math.cos(state.yaw), 0, -Math.sin(state.yaw)], up = cross(back, right);
  const size = canvas.getBoundingClientRect();
  frame = { back, right, up, from: add(state.target, mul(state.away, back)), w: size.width, h: size.height, f: 1.3 * Math.min(size.width, size.height * 1.3), near: .02 * state.away };
}
function seen(p) {
  const to = sub(p, frame.from);
  return [dot(to, frame.right), dot(to, frame.up), -dot(to, frame.back)];
}
const put = c => [frame.w / 2 + frame.f * c[0] / c[2], frame.h / 2 - frame.f * c[1] / c[2]];
// A segment as far as it lies in front of us; null when it does not.
function segment(a, b) {
  let p = seen(a), q = seen(b);
  if (p[2] < frame.near && q[2] < frame.near) return null;
  const cut = (s, t) => add(s, mul((frame.near - s[2]) / (t[2] - s[2]), sub(t, s)));
  if (p[2] < frame.near) p = cut(p, q); else if (q[2] < frame.near) q = cut(q, p);
  return [put(p), put(q)];
}
function line(a, b, style, width, dash = []) {
  const s = segment(a, b);
  if (!s) return null;
  pen.strokeStyle = style;
  pen.lineWidth = width;
  pen.setLineDash(dash);
  pen.beginPath();
  pen.moveTo(...s[0]);
  pen.lineTo(...s[1]);
  pen.stroke();
  pen.setLineDash([]);
  return s;
}
function polygon(corners, fill, edge) {
  const kept = [], all = corners.map(seen);
  for (let i = 0; i < all.length; ++i) {
    const p = all[i], q = all[(i + 1) % all.length], inP = p[2] >= frame.near, inQ = q[2] >= frame.near;
    if (inP) kept.push(p);
    if (inP !== inQ) kept.push(add(p, mul((frame.near - p[2]) / (q[2] - p[2]), sub(q, p))));
  }
  if (kept.length < 3) return;
  pen.beginPath();
  kept.map(put).forEach((p, i) => i ? pen.lineTo(...p) : pen.moveTo(...p));
  pen.closePath();
  if (fill) { pen.fillStyle = fill; pen.fill(); }
  if (edge) { pen.strokeStyle = edge; pen.lineWidth = 1; pen.stroke(); }
}
function ball(center, radius, color, alpha) {
  const c = seen(center);
  if (c[2] < frame.near + radius) return;
  const p = put(c), r = Math.abs(frame.f * radius / Math.sqrt(Math.max(c[2] * c[2] - radius * radius, 1e-12)));
  if (r > 4000) return;
  const shade = pen.createRadialGradient(p[0] - .35 * r, p[1] - .4 * r, .05 * r, p[0], p[1], r);
  shade.addColorStop(0, css(color.map(x => Math.min(1, 1.6 * x + .1)), alpha));
  shade.addColorStop(1, css(color.map(x => .6 * x), alpha));
  pen.fillStyle = shade;
  pen.beginPath();
  pen.arc(p[0], p[1], Math.max(r, .5), 0, 2 * Math.PI);
  pen.fill();
  pen.strokeStyle = css(color.map(x => .5 * x), Math.min(1, alpha + .3));
  pen.lineWidth = 1;
  pen.stroke();
}
const corners = (low, high) => [0, 1, 2, 3, 4, 5, 6, 7].map(i => [i & 1 ? high[0] : low[0], i & 2 ? high[1] : low[1], i & 4 ? high[2] : low[2]]);
function box(low, high, style, width) {
  const c = corners(low, high);
  for (let i = 0; i < 8; ++i) for (const bit of [1, 2, 4]) if (!(i & bit)) line(c[i], c[i | bit], style, width);
}
function grid(height, style) {
  const step = Math.pow(10, Math.round(Math.log10(scene.radius / 2))), reach = 6;
  const x0 = step * Math.round(scene.center[0] / step), z0 = step * Math.round(scene.center[2] / step);
  for (let i = -reach; i <= reach; ++i) {
    line([x0 + i * step, height, z0 - reach * step], [x0 + i * step, height, z0 + reach * step], style, 1);
    line([x0 - reach * step, height, z0 + i * step], [x0 + reach * step, height, z0 + i * step], style, 1);
  }
}
function solid(s, time) {
  const n = s.shape.numbers, a = n.slice(0, 3), u = n.slice(3, 6), v = n.slice(6, 9);
  switch (s.shape.kind) {
    case 'sphere': return { at: a, draw: () => ball(a, Math.abs(n[3]), s.color, .55) };
    case 'moving': { const c = add(a, mul(time, n.slice(4, 7))); return { at: c, draw: () => { ball(a, n[3], s.color, .12); ball(add(a, n.slice(4, 7)), n[3], s.color, .12); ball(c, n[3], s.color, .55); } }; }
    case 'rectangle': return { at: add(a, mul(.5, add(u, v))), draw: () => polygon([a, add(a, u), add(add(a, u), v), add(a, v)], css(s.color, .3), css(s.color.map(x => .5 * x), .8)) };
    case 'triangle': return { at: a, draw: () => polygon([a, u, v], css(s.color, .3), css(s.color.map(x => .5 * x), .5)) };
    case 'cylinder': return { at: a, draw: () => line(a, u, css(s.color, .7), Math.max(1, 2 * frame.f * n[6] / Math.max(seen(a)[2], frame.near))) };
    case 'box': return { at: a, draw: () => box(a, u, css(s.color, .8), 1) };
    case 'floor': return null;
    case 'plane': return null;
    default: return null;
  }
}
let segments = [];
function draw() {
  const scale = window.devicePixelRatio || 1, size = canvas.getBoundingClientRect();
  if (canvas.width !== Math.round(size.width * scale) || canvas.height !== Math.round(size.height * scale)) {
    canvas.width = Math.round(size.width * scale);
    canvas.height = Math.round(size.height * scale);
  }
  pen.setTransform(scale, 0, 0, scale, 0, 0);
  pen.clearRect(0, 0, size.width, size.height);
  look();
  const tone = getComputedStyle(document.documentElement), of = name => tone.getPropertyValue('--' + name).trim();
  const marked = lit() !== null ? rays()[lit()] : null, time = (marked || rays()[0] || {}).time ?? .5;
  if (data.floor !== null) grid(data.floor, of('line'));
  for (const s of data.surfaces) if (s.shape.kind === 'plane') grid(s.shape.numbers[1], of('line'));
  const solids = data.surfaces.map(s => solid(s, time)).filter(Boolean);
  solids.sort((a, b) => seen(b.at)[2] - seen(a.at)[2]);
  for (const s of solids) s.draw();
  pen.font = '12px system-ui, sans-serif';
  pen.textAlign = 'center';
  for (const lamp of data.lamps) {
    const n = lamp.shape.numbers, at = n.slice(0, 3);
    if (lamp.shape.kind === 'rectangle') polygon([at, add(at, n.slice(3, 6)), add(add(at, n.slice(3, 6)), n.slice(6, 9)), add(at, n.slice(6, 9))], 'rgba(255,200,40,.6)', of('shadow'));
    else if (n[3] > 0) ball(at, n[3], [1, .8, .3], .6);
    const c = seen(at);
    if (c[2] < frame.near) continue;
    const p = put(c);
    pen.fillStyle = of('shadow');
    pen.beginPath(); pen.arc(p[0], p[1], 4, 0, 2 * Math.PI); pen.fill();
    pen.fillText(lamp.name, p[0], p[1] - 8);
  }
  const c = seen(data.eye);
  if (c[2] > frame.near) { const p = put(c); pen.fillStyle = of('camera'); pen.beginPath(); pen.arc(p[0], p[1], 4, 0, 2 * Math.PI); pen.fill(); pen.fillText('the eye', p[0], p[1] - 8); }
  if (marked && marked.boxes) for (const b of marked.boxes) box(b.min, b.max, b.t === null ? of('line') : of('shadow'), b.t === null ? 1 : 1.2);
  if (state.others) data.samples.forEach((sample, k) => { if (k !== state.sample) for (const ray of sample.rays) { pen.globalAlpha = .18; line(ray.origin, end(ray), of(kind(ray)), 1); pen.globalAlpha = 1; } });
  segments = [];
  rays().forEach((ray, i) => {
    const on = i === lit(), worth = Math.max(...(ray.weight || ray.brings || [1]).map(Math.abs));
    pen.globalAlpha = on ? 1 : marked ? .45 : .35 + .65 * Math.min(1, Math.sqrt(worth));
    const s = line(ray.origin, end(ray), of(kind(ray)), on ? 4 : 2, ray.met || ray.range[1] !== null ? [] : [7, 5]);
    if (s) {
      segments.push({ i, a: s[0], b: s[1] });
      const dx = s[1][0] - s[0][0], dy = s[1][1] - s[0][1], l = Math.hypot(dx, dy);
      if (l > 24) {  // an arrow in the middle
        const x = s[0][0] + .55 * dx, y = s[0][1] + .55 * dy, e = on ? 9 : 6, ux = dx / l, uy = dy / l;
        pen.fillStyle = of(kind(ray));
        pen.beginPath(); pen.moveTo(x + e * ux, y + e * uy); pen.lineTo(x - e * ux - .7 * e * uy, y - e * uy + .7 * e * ux); pen.lineTo(x - e * ux + .7 * e * uy, y - e * uy - .7 * e * ux); pen.fill();
      }
    }
    if (ray.met) { const q = seen(ray.met.point); if (q[2] > frame.near) { const p = put(q); pen.fillStyle = of(kind(ray)); pen.beginPath(); pen.arc(p[0], p[1], on ? 5 : 3, 0, 2 * Math.PI); pen.fill(); } }
    pen.globalAlpha = 1;
  });
  if (marked && marked.met) line(marked.met.point, add(marked.met.point, mul(.12 * scene.radius, marked.met.normal)), of('ink'), 1.5, [3, 3]);
}
function nearest(x, y) {
  let best = null, least = 9;
  for (const { i, a, b } of segments) {
    const dx = b[0] - a[0], dy = b[1] - a[1], k = Math.max(0, Math.min(1, ((x - a[0]) * dx + (y - a[1]) * dy) / (dx * dx + dy * dy || 1)));
    const off = Math.hypot(a[0] + k * dx - x, a[1] + k * dy - y);
    if (off < least) { least = off; best = i; }
  }
  return best;
}

// ---- hands ----
const held = new Map();
let moved = 0, spread = 0;
const turn = (dx, dy) => { state.yaw -= .008 * dx; state.pitch = Math.max(-1.55, Math.min(1.55, state.pitch + .008 * dy)); draw(); };
const zoom = k => { state.away = Math.max(.02 * scene.radius, Math.min(60 * scene.radius, state.away * k)); draw(); };
const slide = (dx, dy) => { const k = state.away / frame.f; state.target = add(state.target, add(mul(-k * dx, frame.right), mul(k * dy, frame.up))); draw(); };
const place = event => { const box = canvas.getBoundingClientRect(); return [event.clientX - box.left, event.clientY - box.top]; };
canvas.addEventListener('pointerdown', event => { canvas.setPointerCapture(event.pointerId); held.set(event.pointerId, place(event)); moved = 0; spread = 0; });
canvas.addEventListener('pointermove', event => {
  const p = place(event), before = held.get(event.pointerId);
  if (!before) { light(nearest(...p)); return; }
  held.set(event.pointerId, p);
  const dx = p[0] - before[0], dy = p[1] - before[1];
  moved += Math.abs(dx) + Math.abs(dy);
  if (held.size === 2) {
    const [a, b] = [...held.values()], now = Math.hypot(a[0] - b[0], a[1] - b[1]);
    if (spread > 0 && now > 0) zoom(spread / now);
    spread = now;
  } else if (event.shiftKey || event.buttons === 2) slide(dx, dy);
  else turn(dx, dy);
});
const letGo = event => {
  const p = held.get(event.pointerId);
  held.delete(event.pointerId);
  spread = 0;
  if (!p || moved > 4) return;
  const i = nearest(...p);
  pin(i);
  const button = i === null ? null : treeAt.querySelector(`[data-ray="${i}"]`);
  if (button) button.scrollIntoView({ block: 'nearest' });
};
canvas.addEventListener('pointerup', letGo);
canvas.addEventListener('pointercancel', event => held.delete(event.pointerId));
canvas.addEventListener('pointerleave', () => light(null));
canvas.addEventListener('contextmenu', event => event.preventDefault());
canvas.addEventListener('wheel', event => { event.preventDefault(); zoom(Math.exp(.0012 * event.deltaY)); }, { passive: false });
function choose(k) {
  state.sample = Math.max(0, Math.min(data.samples.length - 1, k));
  state.pinned = rays().length === 1 ? 0 : null;
  state.over = null;
  const slider = document.getElementById('sample');
  if (slider) slider.value = state.sample + 1;
  fill();
}
function step(by) {  // through the tree, as it stands
  const all = [...treeAt.querySelectorAll('.ray')], at = all.findIndex(button => +button.dataset.ray === lit());
  const next = all[Math.max(0, Math.min(all.length - 1, at + by))];
  if (next) { next.focus(); pin(+next.dataset.ray); }
}
document.addEventListener('keydown', event => {
  if (event.ctrlKey || event.metaKey || event.altKey || event.target.tagName === 'INPUT') return;
  const inTree = treeAt.contains(event.target), arrows = { ArrowLeft: [-12, 0], ArrowRight: [12, 0], ArrowUp: [0, -12], ArrowDown: [0, 12] };
  if (inTree && (event.key === 'ArrowUp' || event.key === 'ArrowDown')) step(event.key === 'ArrowUp' ? -1 : 1);
  else if (arrows[event.key] && document.activeElement === canvas) { const [dx, dy] = arrows[event.key]; if (event.shiftKey) slide(-dx, -dy); else turn(dx, dy); }
  else if (event.key === '+' || event.key === '=') zoom(1 / 1.15);
  else if (event.key === '-') zoom(1.15);
  else if (event.key === '0') { home(); draw(); }
  else if (event.key === 'e') { fromTheEye(); draw(); }
  else if (event.key === '[') choose(state.sample - 1);
  else if (event.key === ']') choose(state.sample + 1);
  else if (event.key === 'Escape') pin(null);
  else return;
  event.preventDefault();
});
for (const [name, act] of [['home', () => { home(); draw(); }], ['eye', () => { fromTheEye(); draw(); }], ['nearer', () => zoom(1 / 1.3)], ['farther', () => zoom(1.3)]])
  document.getElementById(name).addEventListener('click', act);
const slider = document.getElementById('sample'), others = document.getElementById('others');
if (slider) slider.addEventListener('input', () => choose(slider.value - 1));
if (others) others.addEventListener('change', () => { state.others = others.checked; draw(); });
new ResizeObserver(() => draw()).observe(canvas);
matchMedia('(prefers-color-scheme: dark)').addEventListener('change', () => draw());
// Where the camera's rays are all there is, they are looked at together.
if (data.samples.length > 1 && data.samples.every(sample => sample.rays.length <= 1)) others.checked = state.others = true;
if (rays().length === 1) state.pinned = 0;
measure();
home();
if (slider) slider.value = state.sample + 1;
fill();
})();
