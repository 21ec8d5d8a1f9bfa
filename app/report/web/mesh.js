// The mesh in space: surface, elements below a step through the body, a clip plane, frames.
import {BufferAttribute, BufferGeometry, ColorManagement, LinearSRGBColorSpace, LineBasicMaterial, LineSegments, Mesh,
        MeshBasicMaterial, DoubleSide, PerspectiveCamera, Raycaster, Scene, Vector2, Vector3, WebGLRenderer} from 'three';
import {OrbitControls} from 'three/examples/jsm/controls/OrbitControls.js';
import {arrayOf, fieldValues} from './arrays.js';
import {colourOf, make, number, select, slider, unit} from './dom.js';

// As in surface_picture.cpp.
const stops = [[165, 0, 38], [244, 109, 67], [254, 224, 144], [116, 173, 209], [49, 54, 149]];
const classes = [[116, 173, 209], [254, 224, 144], [165, 0, 38]];
const classNames = {handler: ['not handled', 'handled'], verdict: ['certified', 'not certified', 'above its own critical step']};
const grey = [150, 150, 150];

function scaleColour(share) {
  if (Number.isNaN(share)) return grey;
  const at = Math.min(1, Math.max(0, share)) * (stops.length - 1), low = Math.min(Math.floor(at), stops.length - 2);
  return stops[low].map((c, i) => Math.round(c + (at - low) * (stops[low + 1][i] - c)));
}

/// The range of the colours of a field: no narrower than a part of the numbers in it, so that what differs by rounding alone has
/// nearly one colour. As ColourRange in mesh_pack.h; largest: of all frames.
function colourRange(low, high, logarithmic, largest) {
  if (logarithmic) {
    const least = 1.05, middle = Math.sqrt(low * high);
    return !(low > 0) || high > least * low ? [low, high] : [middle / Math.sqrt(least), middle * Math.sqrt(least)];
  }
  const least = 1e-3 * largest, middle = (low + high) / 2;
  return high - low > least ? [low, high] : [middle - least / 2, middle + least / 2];
}

const edgesUpTo = 40000;  // triangles of a surface that is drawn with its edges

/// What the frames of one mesh share.
async function openGroup(group) {
  const [cells, ids, triangles, owners, solid, solidNodes] =
      await Promise.all(['cells', 'ids', 'triangles', 'owners', 'solid', 'solidNodes'].map(key => arrayOf(group[key])));
  // Of each element that can be shown through the body: where its corners begin, and its type.
  const begin = new Int32Array(solid.length), type = new Uint8Array(solid.length);
  const solidOf = new Int32Array(cells.length).fill(-1);
  let element = 0, at = 0;
  group.types.forEach((t, k) => {
    for (let i = 0; i < t.solids; ++i, ++element, at += t.corners) {
      begin[element] = at;
      type[element] = k;
      solidOf[solid[element]] = element;
    }
  });
  return {...group, cells, ids, triangles, owners, solid, solidNodes, begin, type, solidOf};
}

/// before: what view() gave of an earlier page, or undefined.
export async function startMesh(report, place, stepField, before) {
  const frames = [];
  report.mesh.groups.forEach((group, g) => group.frames.forEach(frame => frames.push({...frame, group: g})));
  const canvas = make('canvas', {tabindex: 0, role: 'img', 'aria-label': 'The mesh. Arrow keys turn it, plus and minus bring it closer or farther.'});
  const renderer = new WebGLRenderer({canvas, antialias: true, alpha: true, preserveDrawingBuffer: true});
  ColorManagement.enabled = false;
  renderer.outputColorSpace = LinearSRGBColorSpace;
  renderer.setPixelRatio(Math.min(2, devicePixelRatio));
  const scene = new Scene(), camera = new PerspectiveCamera(35, 1, 0.01, 100);
  camera.up.set(0, 0, 1);
  const material = new MeshBasicMaterial({vertexColors: true, side: DoubleSide});
  const seeThrough = new MeshBasicMaterial({vertexColors: true, side: DoubleSide, transparent: true, opacity: 0.16, depthWrite: false});
  const surface = new Mesh(new BufferGeometry(), material), solids = new Mesh(new BufferGeometry(), material);
  const surfaceEdges = new LineSegments(new BufferGeometry(), new LineBasicMaterial({color: 0x000000, transparent: true, opacity: 0.28}));
  const solidEdges = new LineSegments(new BufferGeometry(), new LineBasicMaterial({color: 0x000000, transparent: true, opacity: 0.45}));
  const found = new LineSegments(new BufferGeometry(), new LineBasicMaterial({color: 0xd400d4, depthTest: false, transparent: true}));
  found.renderOrder = 9;
  scene.add(surface, surfaceEdges, solids, solidEdges, found);
  const orbit = new OrbitControls(camera, canvas);
  orbit.enableZoom = false;  // until the picture has the focus: the wheel belongs to the page

  // ---- what is shown
  let group = null, groupNumber = -1, frame = null, positions = null, values = null, steps = null, centre = new Vector3(), size = 1;
  let fieldName = '', threshold = 0, selected = -1, busy = Promise.resolve();

  const frameSlider = slider('Frame', {min: 0, max: frames.length - 1, step: 1, value: 0}, () => show(Number(frameSlider.input.value)));
  const thresholdSlider = slider('Elements below a step', {min: 0, max: 1000, step: 1, value: 0}, () => setThreshold(thresholdOf(Number(thresholdSlider.input.value))));
  const clipAxis = select('Cut', [['', 'nothing off'], ['0', 'along x'], ['1', 'along y'], ['2', 'along z']], () => draw());
  const clipSlider = slider('Cut at', {min: 0, max: 1000, step: 1, value: 500, disabled: true}, () => draw());
  const fields = [...new Set(frames.flatMap(f => f.fields.map(field => field.name)))];
  const fieldSelect = select('Colour', fields.length ? fields.map(f => [f, f]) : [['', 'none']], () => { fieldName = fieldSelect.input.value; show(Number(frameSlider.input.value)); });
  const sameScale = make('input', {type: 'checkbox', id: 'same-scale', onchange: () => draw()});
  const runsStep = make('button', {type: 'button', onclick: () => setThreshold(frame.h)}, `Below the ${report.stepName}`);
  const noElements = make('button', {type: 'button', onclick: () => { selected = -1; setThreshold(0); }}, 'Whole surface');
  const home = make('button', {type: 'button', onclick: () => { look(); draw(); }}, 'Look at all of it');
  const frameTime = 120;  // ms: motion is seen, and a frame can still be read
  let plays = 0;  // how often the button was pressed: odd while frames follow one another
  const playButton = make('button', {type: 'button', onclick: play}, 'Play');
  const status = make('p', {class: 'readout', role: 'status'}, 'Click an element for its numbers.');
  const legend = make('p', {class: 'legend'});
  const controls = make('div', {class: 'controls'}, fieldSelect.element, clipAxis.element, clipSlider.element);
  if (frames.length > 1) {
    controls.prepend(frameSlider.element);
    controls.append(make('div', {}, sameScale, make('label', {for: 'same-scale', style: 'display:inline'}, ' same colours in all frames')));
  }
  if (stepField) controls.prepend(thresholdSlider.element);
  const view = make('div', {class: 'view'}, canvas);
  place.append(view, legend, make('div', {class: 'buttons'}, ...(frames.length > 1 ? [playButton] : []), ...(stepField && frames.some(f => f.h > 0) ? [runsStep] : []), noElements, home), controls, status);
  fieldName = stepField && fields.includes(stepField) ? stepField : fields[0] || '';
  fieldSelect.input.value = fieldName;

  const fieldOf = (f, name) => f.fields.find(field => field.name === name);

  /// Threshold from the slider's place: logarithmic from just below the least step to where the page has all elements.
  function thresholdRange() {
    const field = fieldOf(frame, stepField);
    if (!field || !(field.max > 0)) return [1, 1];
    const highest = frame.completeBelow === null ? field.max * 1.0001 : Math.max(frame.completeBelow, field.min * 1.0001);
    return [field.min * 0.9999, highest];
  }
  function thresholdOf(at) {
    const [low, high] = thresholdRange();
    return at === 0 ? 0 : low * Math.pow(high / low, at / 1000);
  }
  function setThreshold(h) {
    const [low, high] = thresholdRange();
    threshold = h > 0 ? Math.min(h, high) : 0;
    thresholdSlider.input.value = threshold > low ? Math.round(1000 * Math.log(threshold / low) / Math.log(high / low)) : 0;
    draw();
  }

  function show(index) {
    busy = busy.then(() => showNow(index));
    return busy;
  }
  async function play() {
    const mine = ++plays;
    playButton.textContent = mine % 2 ? 'Pause' : 'Play';
    while (mine % 2 && mine === plays) {
      await show((Number(frameSlider.input.value) + 1) % frames.length);
      await new Promise(done => setTimeout(done, frameTime));
    }
  }
  async function showNow(index) {
    const next = frames[index];
    if (next.group !== groupNumber) {
      group = await openGroup(report.mesh.groups[next.group]);
      groupNumber = next.group;
      selected = -1;
      surfaceEdges.userData.of = -1;
    }
    const codes = await arrayOf(next.positions), n = group.nodes;
    const first = positions === null;
    positions = new Float32Array(3 * n);
    const middle = [0, 1, 2].map(k => (next.min[k] + next.max[k]) / 2);
    for (let k = 0; k < 3; ++k) {
      const scale = (next.max[k] - next.min[k]) / 65535, low = next.min[k] - middle[k];
      for (let i = 0; i < n; ++i) positions[3 * i + k] = low + scale * codes[k * n + i];
    }
    const before = centre.clone();
    centre.set(...middle);
    frame = next;
    const field = fieldOf(frame, fieldName), step = fieldOf(frame, stepField);
    values = field ? await fieldValues(field) : null;
    steps = step ? await fieldValues(step) : null;
    frameSlider.input.value = index;
    frameSlider.output.textContent = `${frame.number}, t = ${number(frame.time, 5)}${unit('s')}`;
    frameSlider.input.setAttribute('aria-valuetext', `frame ${frame.number}, t = ${number(frame.time, 5)}${unit('s')}`);
    runsStep.disabled = !(frame.h > 0);
    if (first) look();
    else {
      // The picture stays where it was in space.
      const moved = before.sub(centre);
      camera.position.add(moved);
      orbit.target.add(moved);
      orbit.update();
    }
    setThreshold(threshold);
  }

  function look() {
    const box = [0, 1, 2].map(k => frame.max[k] - frame.min[k]);
    size = Math.hypot(...box) || 1;
    const turn = 25 * Math.PI / 180, above = 22 * Math.PI / 180;
    let towards = new Vector3(Math.sin(turn) * Math.cos(above), -Math.cos(turn) * Math.cos(above), Math.sin(above));
    if (box[1] > box[0]) towards = new Vector3(-towards.y, towards.x, towards.z);
    orbit.target.set(0, 0, 0);
    // As close as all corners of the box allow.
    const right = new Vector3(0, 0, 1).cross(towards).normalize(), up = towards.clone().cross(right);
    const tangent = Math.tan(camera.fov * Math.PI / 360);
    let away = 0;
    for (let corner = 0; corner < 8; ++corner) {
      const p = new Vector3(...box.map((length, k) => (corner >> k & 1 ? 0.5 : -0.5) * length));
      away = Math.max(away, p.dot(towards) + Math.max(Math.abs(p.dot(up)), Math.abs(p.dot(right)) / camera.aspect) / tangent);
    }
    camera.position.copy(towards.multiplyScalar(1.04 * away || 1));
    camera.near = size / 500;
    camera.far = size * 20;
    camera.updateProjectionMatrix();
    orbit.update();
  }

  // ---- colours
  function colouring() {
    const field = fieldOf(frame, fieldName);
    if (!field || !values) return {of: () => grey, text: ['no field']};
    if (field.kind === 'class') return {of: e => classes[Math.min(2, Math.max(0, values[e]))], classes: true};
    const own = sameScale.checked ? frames.map(f => fieldOf(f, fieldName)).filter(f => f && f.max > f.min) : [field];
    const logarithmic = field.kind === 'logarithmic', everywhere = frames.map(f => fieldOf(f, fieldName)).filter(f => f);
    const [low, high] = colourRange(Math.min(...own.map(f => f.min)), Math.max(...own.map(f => f.max)), logarithmic,
                                    Math.max(...everywhere.map(f => Math.max(Math.abs(f.min), Math.abs(f.max)))));
    const map = logarithmic ? Math.log : v => v;
    const range = map(high) - map(low);
    // Red is what to look at: small steps, large stresses.
    const largeIsRed = field.kind === 'linear';
    const share = v => range > 0 ? (map(v) - map(low)) / range : 0.5;
    const shareOf = v => Number.isFinite(v) ? (largeIsRed ? 1 - share(v) : share(v)) : v > 0 ? 1 : NaN;
    return {low, high, largeIsRed, of: e => scaleColour(shareOf(values[e]))};
  }
  function showLegend(colours) {
    if (colours.classes) {
      const names = classNames[fieldName] || ['0', '1', '2'];
      legend.replaceChildren(...names.map((name, i) => make('span', {}, make('span', {class: 'key', style: `color:rgb(${classes[i]})`}), name)));
    } else if (colours.low === undefined) legend.replaceChildren();
    else {
      legend.replaceChildren(make('span', {}, fieldName), make('span', {}, number(colours.low, 3)), make('span', {class: colours.largeIsRed ? 'scale large-is-red' : 'scale', 'aria-hidden': 'true'}), make('span', {}, number(colours.high, 3)));
    }
  }

  // ---- geometry
  const light = new Vector3(0.3, -0.5, 0.8).normalize();
  function fill(mesh, corners, owners, colours) {
    const count = owners.length, xyz = new Float32Array(9 * count), rgb = new Float32Array(9 * count);
    for (let t = 0; t < count; ++t) {
      for (let k = 0; k < 3; ++k)
        for (let c = 0; c < 3; ++c) xyz[9 * t + 3 * k + c] = positions[3 * corners[3 * t + k] + c];
      const o = 9 * t;
      const ux = xyz[o + 3] - xyz[o], uy = xyz[o + 4] - xyz[o + 1], uz = xyz[o + 5] - xyz[o + 2];
      const vx = xyz[o + 6] - xyz[o], vy = xyz[o + 7] - xyz[o + 1], vz = xyz[o + 8] - xyz[o + 2];
      const nx = uy * vz - uz * vy, ny = uz * vx - ux * vz, nz = ux * vy - uy * vx;
      const length = Math.hypot(nx, ny, nz) || 1;
      const shade = (0.68 + 0.32 * Math.abs((nx * light.x + ny * light.y + nz * light.z) / length)) / 255;
      const colour = colours.of(owners[t]);
      for (let k = 0; k < 3; ++k)
        for (let c = 0; c < 3; ++c) rgb[o + 3 * k + c] = shade * colour[c];
    }
    mesh.geometry.dispose();
    mesh.geometry = new BufferGeometry();
    mesh.geometry.setAttribute('position', new BufferAttribute(xyz, 3));
    mesh.geometry.setAttribute('color', new BufferAttribute(rgb, 3));
    mesh.userData.owners = owners;
    mesh.visible = count > 0;
  }
  function edges(lines, pairs) {
    const xyz = new Float32Array(3 * pairs.length);
    for (let i = 0; i < pairs.length; ++i)
      for (let c = 0; c < 3; ++c) xyz[3 * i + c] = positions[3 * pairs[i] + c];
    lines.geometry.dispose();
    lines.geometry = new BufferGeometry();
    lines.geometry.setAttribute('position', new BufferAttribute(xyz, 3));
    lines.visible = pairs.length > 0;
  }
  function edgesOfTriangles(corners, count) {
    const seen = new Set(), pairs = [], n = group.nodes;
    for (let t = 0; t < count; ++t)
      for (let k = 0; k < 3; ++k) {
        const a = corners[3 * t + k], b = corners[3 * t + (k + 1) % 3], key = Math.min(a, b) * n + Math.max(a, b);
        if (!seen.has(key)) { seen.add(key); pairs.push(a, b); }
      }
    return pairs;
  }
  function trianglesOf(element, corners) {
    const begin = group.begin[element];
    for (const t of group.types[group.type[element]].triangles)
      for (const c of t) corners.push(group.solidNodes[begin + c]);
    return group.types[group.type[element]].triangles.length;
  }
  function middleOf(element) {
    const {corners} = group.types[group.type[element]], middle = [0, 0, 0];
    for (let a = 0; a < corners; ++a)
      for (let c = 0; c < 3; ++c) middle[c] += positions[3 * group.solidNodes[group.begin[element] + a] + c] / corners;
    return middle;
  }

  let shown = 0;
  function draw() {
    if (!frame) return;
    const colours = colouring();
    showLegend(colours);
    const axis = clipAxis.input.value === '' ? -1 : Number(clipAxis.input.value);
    clipSlider.input.disabled = axis < 0;
    let at = 0;
    if (axis >= 0) {
      at = frame.min[axis] + (frame.max[axis] - frame.min[axis]) * Number(clipSlider.input.value) / 1000;
      clipSlider.output.textContent = `${'xyz'[axis]} = ${number(at, 3)}${unit('m')}`;
      at -= centre.getComponent(axis);
    } else clipSlider.output.textContent = 'off';
    const below = threshold > 0 && steps !== null;
    const wholeBody = axis >= 0 && !below && group.solid.length === group.elements;
    shown = 0;
    const corners = [], owners = [];
    if (below || wholeBody)
      for (let e = 0; e < group.solid.length; ++e) {
        const cell = group.solid[e];
        if (below && !(steps[cell] < threshold) && cell !== selected) continue;
        if (below && steps[cell] < threshold) ++shown;
        if (axis >= 0 && middleOf(e)[axis] > at) continue;
        for (let k = trianglesOf(e, corners); k > 0; --k) owners.push(cell);
      }
    else if (selected >= 0 && group.solidOf[selected] >= 0)
      for (let k = trianglesOf(group.solidOf[selected], corners); k > 0; --k) owners.push(selected);
    fill(solids, corners, owners, colours);
    edges(solidEdges, owners.length <= edgesUpTo ? edgesOfTriangles(corners, owners.length) : []);
    let outer = group.triangles, outerOwners = group.owners;
    if (axis >= 0) {
      const kept = [], own = [];
      if (!wholeBody)
        for (let t = 0; t < outerOwners.length; ++t) {
          let middle = 0;
          for (let k = 0; k < 3; ++k) middle += positions[3 * outer[3 * t + k] + axis] / 3;
          if (middle <= at) { kept.push(outer[3 * t], outer[3 * t + 1], outer[3 * t + 2]); own.push(outerOwners[t]); }
        }
      outer = kept;
      outerOwners = own;
    }
    const translucent = below || selected >= 0;
    surface.material = translucent ? seeThrough : material;
    fill(surface, outer, outerOwners, colours);
    const dark = matchMedia('(prefers-color-scheme: dark)').matches;
    surfaceEdges.material.color.set(translucent && dark ? 0xffffff : 0x000000);
    surfaceEdges.material.opacity = translucent ? 0.1 : 0.28;
    edges(surfaceEdges, outerOwners.length <= edgesUpTo ? edgesOfTriangles(outer, outerOwners.length) : []);
    const marked = [];
    if (selected >= 0 && group.solidOf[selected] >= 0) trianglesOf(group.solidOf[selected], marked);
    edges(found, edgesOfTriangles(marked, marked.length / 3));
    if (stepField) {
      thresholdSlider.output.textContent = !steps ? 'this frame has no steps'
          : below ? `h = ${number(threshold, 4)}${unit('s')}: ${shown} of ${group.elements}` : 'none';
      thresholdSlider.input.setAttribute('aria-valuetext', thresholdSlider.output.textContent);
    }
    render();
  }
  function render() { renderer.render(scene, camera); }
  orbit.addEventListener('change', render);

  // ---- elements
  function nameOf(cell) {
    const element = group.cells[cell];
    const block = group.types.findLastIndex ? group.types.findLastIndex(t => t.first <= element) : group.types.reduce((found, t, i) => t.first <= element ? i : found, 0);
    return `${block}:${element - group.types[block].first}`;
  }
  async function tell(cell) {
    const texts = [`element ${nameOf(cell)}, number ${group.ids[cell]} in the mesh`];
    for (const field of frame.fields) {
      const value = (await fieldValues(field))[cell];
      texts.push(`${field.name}: ${field.kind === 'class' && classNames[field.name] ? classNames[field.name][value] : number(value)}`);
    }
    status.textContent = texts.join(' · ');
  }
  function choose(cell) {
    selected = cell;
    draw();
    return tell(cell);
  }
  /// Shows an element, counted through the mesh, in a frame, with a part of the body around it.
  async function showElement(element, number_) {
    await show(Math.max(0, frames.findIndex(f => f.number === number_)));
    const cell = group.cells.indexOf(element);
    if (cell < 0) return;
    if (fieldName !== stepField) { fieldName = fieldSelect.input.value = stepField; await show(Number(frameSlider.input.value)); }
    clipAxis.input.value = '';
    await choose(cell);
    const solid = group.solidOf[cell];
    if (solid >= 0) {
      const middle = new Vector3(...middleOf(solid)), {corners} = group.types[group.type[solid]];
      let extent = 0;
      for (let a = 0; a < corners; ++a) {
        const n = 3 * group.solidNodes[group.begin[solid] + a];
        extent = Math.max(extent, middle.distanceTo(new Vector3(positions[n], positions[n + 1], positions[n + 2])));
      }
      const away = camera.position.clone().sub(orbit.target).normalize();
      orbit.target.copy(middle);
      camera.position.copy(middle).addScaledVector(away, Math.min(size * 1.2, Math.max(12 * extent, size * 0.1)));
      orbit.update();
    }
    render();
    view.scrollIntoView({block: 'center'});
    canvas.focus({preventScroll: true});
  }

  let pressed = null;
  canvas.addEventListener('pointerdown', event => { pressed = [event.clientX, event.clientY]; });
  canvas.addEventListener('pointerup', event => {
    if (!pressed || Math.hypot(event.clientX - pressed[0], event.clientY - pressed[1]) > 4) return;
    const box = canvas.getBoundingClientRect(), ray = new Raycaster();
    ray.setFromCamera(new Vector2(2 * (event.clientX - box.left) / box.width - 1, 1 - 2 * (event.clientY - box.top) / box.height), camera);
    const seen = surface.material === seeThrough ? [solids] : [surface, solids];
    const hit = ray.intersectObjects(seen.filter(m => m.visible))[0];
    if (hit) choose(hit.object.userData.owners[hit.faceIndex]);
    else { selected = -1; status.textContent = 'Click an element for its numbers.'; draw(); }
  });
  canvas.addEventListener('focus', () => { orbit.enableZoom = true; });
  canvas.addEventListener('blur', () => { orbit.enableZoom = false; });
  canvas.addEventListener('keydown', event => {
    const turns = {ArrowLeft: [-0.12, 0], ArrowRight: [0.12, 0], ArrowUp: [0, 0.12], ArrowDown: [0, -0.12]};
    const away = camera.position.clone().sub(orbit.target);
    if (event.key in turns) {
      const [side, up] = turns[event.key], right = new Vector3().crossVectors(camera.up, away).normalize();
      away.applyAxisAngle(camera.up, side);
      const turned = away.clone().applyAxisAngle(right, -up);
      if (Math.abs(turned.clone().normalize().z) < 0.98) away.copy(turned);
    } else if (event.key === '+' || event.key === '=') away.multiplyScalar(0.85);
    else if (event.key === '-') away.multiplyScalar(1 / 0.85);
    else return;
    event.preventDefault();
    camera.position.copy(orbit.target).add(away);
    orbit.update();
    render();
  });
  new ResizeObserver(() => {
    const {clientWidth: w, clientHeight: h} = view;
    if (!w || !h) return;
    renderer.setSize(w, h, false);
    camera.aspect = w / h;
    camera.updateProjectionMatrix();
    render();
  }).observe(view);
  matchMedia('(prefers-color-scheme: dark)').addEventListener('change', draw);

  renderer.setSize(view.clientWidth, view.clientHeight, false);
  camera.aspect = view.clientWidth / view.clientHeight;
  const start = frames.findIndex(f => f.number === report.keyFrame);
  await show(Math.max(0, start));
  if (before) {
    if (fields.includes(before.field)) fieldName = fieldSelect.input.value = before.field;
    clipAxis.input.value = before.axis;
    clipSlider.input.value = before.at;
    sameScale.checked = before.same;
    threshold = before.threshold;
    camera.position.set(...before.camera);
    orbit.target.set(...before.target);
    orbit.update();
    // A reader at the last frame goes on with the newest one.
    const place_ = before.last ? frames.length - 1 : frames.findIndex(f => f.number === before.frame);
    await show(Math.max(0, place_));
  }
  return {
    showElement, setThreshold,
    /// What a page that is loaded again shows as before.
    view: () => ({field: fieldName, axis: clipAxis.input.value, at: clipSlider.input.value, same: sameScale.checked, threshold,
                  camera: camera.position.toArray(), target: orbit.target.toArray(), frame: frame.number,
                  last: frame.number === frames[frames.length - 1].number}),
    /// Of the frame shown: numbers of the elements that the page holds.
    async elements() {
      const all = [];
      for (const field of frame.fields) all.push([field.name, await fieldValues(field)]);
      return {frame, group, fields: all, name: nameOf};
    },
    frames, openGroup: g => openGroup(report.mesh.groups[g]),
    state: () => ({frame: frame.number, threshold, shown, selected: selected < 0 ? -1 : group.cells[selected], field: fieldName,
                   drawnTriangles: (solids.visible ? solids.userData.owners.length : 0), surfaceTriangles: surface.visible ? surface.userData.owners.length : 0}),
    /// Where the middle of an element is drawn, in pixels of the canvas from its lower left, the colour [r, g, b, a]
    /// there as one sees it and without all but the elements through the body, and that of its step.
    pixelOf(element) {
      const solid = group.solidOf[group.cells.indexOf(element)];
      const seen = new Vector3(...middleOf(solid)).project(camera), gl = renderer.getContext();
      const x = Math.round((seen.x + 1) / 2 * gl.drawingBufferWidth), y = Math.round((seen.y + 1) / 2 * gl.drawingBufferHeight);
      const pixel = () => {
        const rgba = new Uint8Array(4);
        render();
        gl.readPixels(x, y, 1, 1, gl.RGBA, gl.UNSIGNED_BYTE, rgba);
        return [...rgba];
      };
      const seenColour = pixel(), others = [surface, surfaceEdges, solidEdges, found], visible = others.map(o => o.visible);
      others.forEach(o => { o.visible = false; });
      const alone = pixel();
      others.forEach((o, i) => { o.visible = visible[i]; });
      render();
      return {x, y, colour: seenColour, alone, expected: colouring().of(group.cells.indexOf(element))};
    },
  };
}
