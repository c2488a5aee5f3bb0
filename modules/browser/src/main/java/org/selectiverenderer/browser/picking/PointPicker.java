package org.selectiverenderer.browser.picking;

import java.util.ArrayList;
import java.util.List;
import java.util.Optional;
import java.util.function.Predicate;
import org.joml.Vector3d;
import org.joml.Vector3dc;
import org.selectiverenderer.browser.nodes.picking.PickResult;
import org.selectiverenderer.geometry.BoundingBox;
import org.selectiverenderer.geometry.bvh.PointInMesh;
import org.selectiverenderer.geometry.mesh.Mesh;

/** Picks with points: picks the shapes that contain a point (X3D 4.0, PointPickSensor, 38.4.3). */
final class PointPicker implements Picker {
  /** Tolerance for points on a surface, relative to the size of the shape. */
  private static final double TOUCHING = 1e-6;

  private final List<Vector3dc> points = new ArrayList<>();
  private final BoundingBox box;

  PointPicker(Mesh mesh) {
    float[] positions = mesh.positions();
    for (int i = 0; i < positions.length; i += 3) {
      points.add(new Vector3d(positions[i], positions[i + 1], positions[i + 2]));
    }
    box = BoundingBox.around(positions);
  }

  @Override
  public BoundingBox box() {
    return box;
  }

  @Override
  public Optional<Met> bounds(PickTarget target) {
    BoundingBox around = target.box().grown(TOUCHING * target.box().extent());
    return met(p -> around.contains(target.toWorld().transformPosition(p, new Vector3d())));
  }

  @Override
  public Optional<Met> mesh(PickTarget target) {
    BoundingBox around = BoundingBox.of(target.mesh().bounds());
    double touching = TOUCHING * around.extent();
    BoundingBox near = around.grown(touching);
    return met(
        p -> {
          Vector3d local = target.fromSensor().transformPosition(p, new Vector3d());
          return near.contains(local) && PointInMesh.contains(target.tree(), local, touching);
        });
  }

  private Optional<Met> met(Predicate<Vector3dc> inside) {
    List<PickResult.Place> places =
        points.stream().filter(inside).map(p -> new PickResult.Place(p, null, null)).toList();
    return places.isEmpty() ? Optional.empty() : Optional.of(new Met(0, places));
  }
}
