// three.js under Node: its exporters of scenes and meshes.
import { writeFileSync, mkdirSync, readFileSync } from "node:fs";
import { createRequire } from "node:module";
import { pathToFileURL } from "node:url";
import { join } from "node:path";

const modules = process.argv[2], folder = process.argv[3];
const load = (name) => import(pathToFileURL(join(modules, "node_modules", "three", name)));
const THREE = await load("build/three.module.js");
console.log("exporter three.js " + THREE.REVISION);
mkdirSync(folder, { recursive: true });
// The exporters of three.js are for browsers; of these they need a reader of blobs.
globalThis.FileReader = class {
  readAsArrayBuffer(blob) { blob.arrayBuffer().then((data) => { this.result = data; this.onloadend(); }); }
  readAsDataURL(blob) {
    blob.arrayBuffer().then((data) => {
      this.result = "data:application/octet-stream;base64," + Buffer.from(data).toString("base64");
      this.onloadend();
    });
  }
};
const scene = new THREE.Scene();
const room = new THREE.Group();
room.name = "Δωμάτιο";
scene.add(room);
const add = (name, geometry, material, x) => {
  const mesh = new THREE.Mesh(geometry, material);
  mesh.name = name;
  mesh.position.x = x;
  room.add(mesh);
  return mesh;
};
add("Kiste mit Ä", new THREE.BoxGeometry(1, 1, 1), new THREE.MeshStandardMaterial({ color: 0xe6821e }), -1.5);
const ball = new THREE.SphereGeometry(0.5, 24, 12);
ball.setAttribute("color", new THREE.BufferAttribute(ball.attributes.normal.array.map((n) => (n + 1) / 2), 3));
add("球", ball, new THREE.MeshPhongMaterial({ vertexColors: true }), 0);
add("Цилиндр", new THREE.CylinderGeometry(0.4, 0.4, 1, 24),
  new THREE.MeshStandardMaterial({ color: 0x1a4de6, transparent: true, opacity: 0.5 }), 1.5);
const line = new THREE.Line(new THREE.BufferGeometry().setFromPoints(
  [new THREE.Vector3(-2, 1, 0), new THREE.Vector3(2, 1, 0)]), new THREE.LineBasicMaterial({ color: 0xff0000 }));
scene.add(line);
const camera = new THREE.PerspectiveCamera(60, 4 / 3, 0.1, 100);
camera.position.z = 5;
camera.name = "Caméra";
scene.add(camera);
const light = new THREE.PointLight(0xffffff, 30);
light.position.set(2, 4, 3);
scene.add(light);
scene.updateMatrixWorld(true);
const clip = new THREE.AnimationClip("up", 2, [
  new THREE.VectorKeyframeTrack("球.position", [0, 1, 2], [0, 0, 0, 0, 0.5, 0, 0, 0, 0])]);
const attempt = async (name, write) => {
  try {
    const data = await write();
    writeFileSync(join(folder, name), typeof data === "string" ? data : Buffer.from(data.buffer ?? data));
  } catch (e) {
    console.log("lacks " + name + ": " + String(e.message ?? e).split("\n")[0]);
  }
};
const exporters = {};
for (const kind of ["GLTF", "OBJ", "PLY", "STL"]) {
  exporters[kind] = new (await load(`examples/jsm/exporters/${kind}Exporter.js`))[kind + "Exporter"]();
}
await attempt("scene.glb", () => exporters.GLTF.parseAsync(scene, { binary: true, animations: [clip] }));
await attempt("scene.gltf", async () => JSON.stringify(await exporters.GLTF.parseAsync(scene, { animations: [clip] })));
await attempt("scene.obj", () => exporters.OBJ.parse(scene));
await attempt("scene.ply", () => exporters.PLY.parse(room, () => {}, {}));
await attempt("scene.stl", () => exporters.STL.parse(room, {}));
await attempt("binary.stl", () => exporters.STL.parse(room, { binary: true }));
console.log("lacks pictures: under Node there are no canvases");
