// SPDX-License-Identifier: MIT
// The page of ./lab heat: reads the number of the pixel that is pointed at, and leafs through the levels.
'use strict';
(() => {
const maps = JSON.parse(document.getElementById('data').textContent);
for (const map of Object.values(maps)) {
  const bytes = Uint8Array.from(atob(map.data), c => c.charCodeAt(0));
  map.values = new Uint32Array(bytes.buffer);
}
for (const heat of document.querySelectorAll('.heat')) {
  const map = maps[heat.dataset.name], told = heat.parentElement.querySelector('output');
  heat.addEventListener('pointermove', event => {
    const box = heat.getBoundingClientRect();
    const x = Math.min(map.width - 1, Math.max(0, Math.floor((event.clientX - box.left) / box.width * map.width)));
    const y = Math.min(map.height - 1, Math.max(0, Math.floor((event.clientY - box.top) / box.height * map.height)));
    told.textContent = `Pixel ${x},${y}: ${map.values[y * map.width + x]}`;
  });
}
const level = document.getElementById('level');
if (level) {
  const figures = [...document.querySelectorAll('.level')];
  const show = () => figures.forEach((figure, i) => { figure.hidden = i !== +level.value; });
  const step = by => { level.value = +level.value + by; show(); };
  level.addEventListener('input', show);
  document.getElementById('up').addEventListener('click', () => step(-1));
  document.getElementById('down').addEventListener('click', () => step(1));
}
})();
