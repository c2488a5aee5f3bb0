package org.selectiverenderer.browser.picking;

import org.joml.Matrix4d;
import org.joml.Matrix4dc;
import org.selectiverenderer.geometry.BoundingBox;
import org.selectiverenderer.geometry.bvh.MeshBvh;
import org.selectiverenderer.geometry.mesh.Mesh;

/**
 * A shape to be tested by a pick sensor.
 *
 * @param mesh the mesh in its local coordinates
 * @param tree the BVH of the mesh
 * @param box the world-space bounding box of the shape
 * @param toSensor the matrix from the mesh's coordinates to the sensor's
 * @param fromSensor the matrix from the sensor's coordinates to the mesh's
 * @param toWorld the matrix from the sensor's coordinates to the world
 */
record PickTarget(
    Mesh mesh,
    MeshBvh tree,
    BoundingBox box,
    Matrix4dc toSensor,
    Matrix4dc fromSensor,
    Matrix4dc toWorld) {

  static PickTarget of(
      Mesh mesh, MeshBvh tree, BoundingBox box, Matrix4dc shape, Matrix4dc sensor) {
    Matrix4d toSensor = sensor.invertAffine(new Matrix4d()).mul(shape);
    return new PickTarget(mesh, tree, box, toSensor, toSensor.invertAffine(new Matrix4d()), sensor);
  }

  /**
   * Returns whether both shape and sensor have an extent: under a scale of 0 nothing can intersect.
   */
  boolean hasExtent() {
    return toSensor.isFinite() && fromSensor.isFinite();
  }
}
