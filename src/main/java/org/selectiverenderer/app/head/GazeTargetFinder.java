package org.selectiverenderer.app.head;

import java.util.ArrayList;
import java.util.Comparator;
import java.util.LinkedHashMap;
import java.util.List;
import java.util.Map;
import java.util.Optional;
import org.joml.Quaterniondc;
import org.joml.Vector3d;
import org.joml.Vector3dc;
import org.jspecify.annotations.Nullable;
import org.selectiverenderer.browser.World;
import org.selectiverenderer.browser.collision.RayCaster;
import org.selectiverenderer.browser.instance.InstanceTree;
import org.selectiverenderer.browser.viewer.Viewer;
import org.selectiverenderer.study.headlog.EyeSample;

/**
 * Finds the object in the middle of the viewer's view by a ray along the line of sight, the objects
 * around it by {@value #RAYS} rays in a cone about that ray, and the object under the gaze if a
 * headset tracks the eyes. Belongs to the thread that steps the world.
 */
final class GazeTargetFinder {
  private static final int RINGS = 2;
  private static final int PER_RING = 6;
  private static final int RAYS = 1 + PER_RING + 2 * PER_RING;

  /**
   * The objects in and around the middle of the view.
   *
   * @param object name of the object in the middle; empty for none
   * @param distance to its surface along the line of sight, in the scene's unit; NaN for none
   * @param version whichChoice of the object's Switch; -1 for none
   * @param cone names of the objects that the rays of the cone hit, the most frequent first
   */
  public record Found(String object, double distance, int version, List<String> cone) {}

  private final World world;
  private final List<Vector3dc> rays = new ArrayList<>();
  private @Nullable InstanceTree tree;
  private RayCaster caster;
  private SceneObjectResolver objects;

  /**
   * @param coneDegrees full angle of the cone in degrees, from 0 to 90
   */
  public GazeTargetFinder(World world, double coneDegrees) {
    this.world = world;
    tree = world.instances();
    caster = new RayCaster(tree, world.meshes());
    objects = new SceneObjectResolver(tree);
    rays.add(new Vector3d(0, 0, -1));
    double half = Math.toRadians(coneDegrees) / 2;
    for (int ring = 1; ring <= RINGS; ring++) {
      double off = half * ring / RINGS;
      for (int i = 0; i < ring * PER_RING; i++) {
        double about = 2 * Math.PI * i / (ring * PER_RING);
        rays.add(
            new Vector3d(
                Math.sin(off) * Math.cos(about), Math.sin(off) * Math.sin(about), -Math.cos(off)));
      }
    }
  }

  private void refresh() {
    if (tree != world.instances()) {
      tree = world.instances();
      caster = new RayCaster(tree, world.meshes());
      objects = new SceneObjectResolver(tree);
    }
  }

  /**
   * Finds the object that the eyes look at now.
   *
   * @param direction gaze direction from the viewer's position, in the frame of the viewer: a unit
   *     vector
   */
  public EyeSample eyes(Vector3dc direction) {
    refresh();
    Optional<RayCaster.Hit> hit = cast(world.viewer(), direction);
    Optional<SceneObjectResolver.Named> object = hit.flatMap(found -> objects.of(found.shape()));
    return new EyeSample(
        true,
        Math.toDegrees(Math.atan2(-direction.x(), -direction.z())),
        Math.toDegrees(Math.asin(Math.max(-1, Math.min(1, direction.y())))),
        object.map(SceneObjectResolver.Named::name).orElse(""),
        hit.map(RayCaster.Hit::distance).orElse(Double.NaN),
        object.map(SceneObjectResolver.Named::version).orElse(-1));
  }

  /** Finds the objects in and around the middle of the view now. */
  public Found find() {
    refresh();
    Viewer viewer = world.viewer();
    Optional<RayCaster.Hit> middle = cast(viewer, rays.get(0));
    Map<String, Integer> counts = new LinkedHashMap<>();
    middle.ifPresent(hit -> count(counts, hit));
    for (int i = 1; i < rays.size(); i++) {
      cast(viewer, rays.get(i)).ifPresent(hit -> count(counts, hit));
    }
    List<String> cone =
        counts.entrySet().stream()
            .sorted(Comparator.comparing((Map.Entry<String, Integer> entry) -> -entry.getValue()))
            .map(Map.Entry::getKey)
            .toList();
    return middle.map(hit -> found(hit, cone)).orElseGet(() -> new Found("", Double.NaN, -1, cone));
  }

  private Optional<RayCaster.Hit> cast(Viewer viewer, Vector3dc ray) {
    Quaterniondc turn = viewer.orientation();
    return caster.cast(
        viewer.position(), turn.transform(ray, new Vector3d()), Double.POSITIVE_INFINITY);
  }

  private void count(Map<String, Integer> counts, RayCaster.Hit hit) {
    objects.of(hit.shape()).ifPresent(object -> counts.merge(object.name(), 1, Integer::sum));
  }

  private Found found(RayCaster.Hit hit, List<String> cone) {
    Optional<SceneObjectResolver.Named> object = objects.of(hit.shape());
    return new Found(
        object.map(SceneObjectResolver.Named::name).orElse(""),
        hit.distance(),
        object.map(SceneObjectResolver.Named::version).orElse(-1),
        cone);
  }
}
