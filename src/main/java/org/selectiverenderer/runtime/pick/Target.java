package org.selectiverenderer.runtime.pick;

import org.joml.Matrix4d;
import org.joml.Matrix4dc;
import org.selectiverenderer.geometry.Bounds;
import org.selectiverenderer.geometry.mesh.Mesh;
import org.selectiverenderer.geometry.tree.MeshTree;

/**
 * A shape that may be picked, as a sensor sees it.
 *
 * @param mesh in coordinates of its own
 * @param tree of the mesh
 * @param box around the shape, in the world
 * @param toSensor takes the mesh's coordinates to the sensor's
 * @param fromSensor takes the sensor's coordinates to the mesh's
 * @param toWorld takes the sensor's coordinates to the world's
 */
record Target(
    Mesh mesh,
    MeshTree tree,
    Bounds box,
    Matrix4dc toSensor,
    Matrix4dc fromSensor,
    Matrix4dc toWorld) {

  static Target of(Mesh mesh, MeshTree tree, Bounds box, Matrix4dc shape, Matrix4dc sensor) {
    Matrix4d toSensor = sensor.invertAffine(new Matrix4d()).mul(shape);
    return new Target(mesh, tree, box, toSensor, toSensor.invertAffine(new Matrix4d()), sensor);
  }

  /** Whether both have an extent: a scale of 0 above them leaves nothing to meet. */
  boolean hasExtent() {
    return toSensor.isFinite() && fromSensor.isFinite();
  }
}
