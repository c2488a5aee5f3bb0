package org.selectiverenderer.browser.collision;

import java.util.List;
import java.util.Optional;
import org.joml.Vector2d;
import org.joml.Vector3d;
import org.joml.Vector3dc;
import org.jspecify.annotations.Nullable;
import org.selectiverenderer.browser.instance.InstanceTree;
import org.selectiverenderer.browser.instance.ShapeInstance;

/**
 * Finds the first visible shape that a ray hits. Call it after {@link InstanceTree#update()}, so
 * that it tests the shapes as they are drawn. Belongs to the thread that steps the world.
 */
public final class RayCaster {
  /**
   * The hit of a ray.
   *
   * @param distance the distance along the ray, in world units
   * @param point the point hit, in world coordinates
   * @param normal the surface normal there, of unit length, in world coordinates; interpolated if
   *     the mesh has normals
   * @param texCoord the texture coordinates s and t there, or null if the mesh has none
   */
  public record Hit(
      ShapeInstance shape,
      double distance,
      Vector3dc point,
      Vector3dc normal,
      @Nullable Vector2d texCoord) {}

  /** Largest number of surfaces cut off by ClipPlanes that a ray passes through. */
  private static final int MOST_PASSED = 1000;

  private final InstanceTree tree;
  private final MeshBvhCache meshes;
  private PlacedMeshIndex<PlacedMesh.OfShape> index;
  private long structure;
  private long placement;

  public RayCaster(InstanceTree tree, MeshBvhCache meshes) {
    this.tree = tree;
    this.meshes = meshes;
    index = build();
  }

  private PlacedMeshIndex<PlacedMesh.OfShape> build() {
    structure = tree.structureVersion();
    placement = tree.placementVersion();
    return new PlacedMeshIndex<>(
        tree.shapes().stream().map(shape -> new PlacedMesh.OfShape(shape, List.of())).toList(),
        tree,
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
   * Returns the nearest shape that a ray hits. The ray passes through back faces of solid geometry,
   * which are not drawn, and never hits lines or points.
   *
   * @param origin the origin, in world coordinates
   * @param direction the direction, of any length but 0
   * @param maxDistance the largest distance in world units; may be infinite
   */
  public Optional<Hit> cast(Vector3dc origin, Vector3dc direction, double maxDistance) {
    refresh();
    Vector3d unit = direction.normalize(new Vector3d());
    return unit.isFinite() ? cast(origin, unit, maxDistance, 0, 0) : Optional.empty();
  }

  /** Casts a ray that passes through surfaces cut off by ClipPlanes. */
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
      Vector3dc origin, Vector3dc direction, PlacedMeshIndex.PlacedHit<PlacedMesh.OfShape> hit) {
    double distance = hit.at().distance();
    return new Hit(
        hit.placed().shape(),
        distance,
        new Vector3d(origin).fma(distance, direction),
        HitAttributes.normal(
            hit.mesh(), meshes.of(hit.mesh()), hit.at(), hit.placed().world(), direction),
        HitAttributes.texCoord(hit.mesh(), hit.at()));
  }
}
