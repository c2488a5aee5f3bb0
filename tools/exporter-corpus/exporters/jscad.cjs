// OpenJSCAD: solids with colours as X3D, OBJ and STL.
const { writeFileSync, mkdirSync } = require("node:fs");
const { join } = require("node:path");

const [modules, folder] = process.argv.slice(2);
const load = (name) => require(join(modules, "node_modules", "@jscad", name));
console.log("exporter JSCAD " + load("x3d-serializer/package.json").version);
mkdirSync(folder, { recursive: true });
const { primitives, colors, transforms } = load("modeling");
const solids = [
  colors.colorize([0.9, 0.5, 0.1], primitives.cuboid({ size: [1, 1, 1], center: [-1.5, 0, 0] })),
  colors.colorize([0.2, 0.6, 0.3], primitives.sphere({ radius: 0.5, segments: 24 })),
  colors.colorize([0.1, 0.3, 0.9, 0.5], transforms.translate([1.5, 0, 0], primitives.cylinder({ radius: 0.4, height: 1 }))),
];
for (const kind of ["x3d", "obj", "stl"]) {
  try {
    const parts = load(kind + "-serializer").serialize({ binary: true }, ...solids);
    writeFileSync(join(folder, "scene." + kind), Buffer.concat(parts.map((part) => Buffer.from(part))));
  } catch (e) {
    console.log("lacks " + kind + ": " + String(e.message).split("\n")[0]);
  }
}
console.log("lacks names, pictures, cameras: solids have none");
