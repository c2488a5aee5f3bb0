package org.selectiverenderer.runtime.collide;

import java.util.List;
import java.util.Optional;
import org.joml.Vector2d;
import org.joml.Vector3d;
import org.joml.Vector3dc;
import org.jspecify.annotations.Nullable;
import org.selectiverenderer.runtime.instance.InstanceTree;
import org.selectiverenderer.runtime.instance.ShapeInstance;

/**
 * Says what a ray hits first among the shapes shown. Call it after {@link InstanceTree#update()};
 * what moved, was shown, added or removed by then is where it is drawn. Belongs to the thread that
 * steps the world.
 */
public final class RayCaster {
  /**
   * What a ray hits.
   *
   * @param distance along the ray, in the world's unit
   * @param point in the world
   * @param normal of the surface there, of unit length, in the world; interpolated where the mesh
   *     has normals
   * @param texCoord s, t there, or null when the mesh has none
   */
  public record Hit(
      ShapeInstance shape,
      double distance,
      Vector3dc point,
      Vector3dc normal,
      @Nullable Vector2d texCoord) {}

  /** Surfaces cut off that a ray passes through at most. */
  private static final int MOST_PASSED = 1000;

  private final InstanceTree tree;
  private final MeshTrees meshes;
  private PlacedIndex<PlacedMesh.OfShape> index;
  private long structure;
  private long placement;

  public RayCaster(InstanceTree tree, MeshTrees meshes) {
    this.tree = tree;
    this.meshes = meshes;
    index = build();
  }

  private PlacedIndex<PlacedMesh.OfShape> build() {
    structure = tree.structureVersion();
    placement = tree.placementVersion();
    return new PlacedIndex<>(
        tree.shapes().stream().map(shape -> new PlacedMesh.OfShape(shape, List.of())).toList(),
        meshes);
  }

  private void refresh() {
    if (structure != tree.structureVersion()) {
      index = build();
    } else if (placement != tree.placementVersion()) {
      placement = tree.placementVersion();
      index.refresh();
    }
  }

  /**
   * The nearest shape that a ray hits. Backs of solid geometry are not drawn, so it passes through
   * them; lines and points it never hits.
   *
   * @param origin in the world
   * @param direction of any length but 0
   * @param maxDistance in the world's unit; may be infinite
   */
  public Optional<Hit> cast(Vector3dc origin, Vector3dc direction, double maxDistance) {
    refresh();
    Vector3d unit = direction.normalize(new Vector3d());
    return unit.isFinite() ? cast(origin, unit, maxDistance, 0, 0) : Optional.empty();
  }

  /** Passes through what ClipPlanes have cut off. */
  private Optional<Hit> cast(
      Vector3dc origin, Vector3dc unit, double maxDistance, double from, int passed) {
    Vector3d start = new Vector3d(origin).fma(from, unit);
    Optional<Hit> nearest =
        index.ray(start, unit, maxDistance - from, true).map(hit -> hit(start, unit, hit));
    if (nearest.isEmpty()) {
      return nearest;
    }
    Hit hit = nearest.get();
    double distance = from + hit.distance();
    if (passed < MOST_PASSED && hit.shape().surroundings().cutOff(hit.point())) {
      return cast(origin, unit, maxDistance, distance + 1e-7 * (1 + distance), passed + 1);
    }
    return Optional.of(new Hit(hit.shape(), distance, hit.point(), hit.normal(), hit.texCoord()));
  }

  private Hit hit(
      Vector3dc origin, Vector3dc direction, PlacedIndex.PlacedHit<PlacedMesh.OfShape> hit) {
    double distance = hit.at().distance();
    return new Hit(
        hit.placed().shape(),
        distance,
        new Vector3d(origin).fma(distance, direction),
        SurfaceHit.normal(
            hit.mesh(), meshes.of(hit.mesh()), hit.at(), hit.placed().world(), direction),
        SurfaceHit.texCoord(hit.mesh(), hit.at()));
  }
}
