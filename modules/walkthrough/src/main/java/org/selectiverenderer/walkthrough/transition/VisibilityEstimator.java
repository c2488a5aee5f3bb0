package org.selectiverenderer.walkthrough.transition;

import java.util.IdentityHashMap;
import java.util.LinkedHashSet;
import java.util.List;
import java.util.Map;
import java.util.Optional;
import java.util.Set;
import org.selectiverenderer.browser.LayerView;
import org.selectiverenderer.browser.World;
import org.selectiverenderer.browser.camera.Camera;
import org.selectiverenderer.browser.collision.MeshBvhCache;
import org.selectiverenderer.browser.instance.GroupInstance;
import org.selectiverenderer.browser.instance.Instance;
import org.selectiverenderer.browser.instance.InstanceTree;
import org.selectiverenderer.browser.instance.ShapeInstance;
import org.selectiverenderer.browser.scene.Node;
import org.selectiverenderer.geometry.mesh.Mesh;

/**
 * Estimates whether the viewer sees an object of several versions, and how large, by {@value #RAYS}
 * rays through the part of the picture where it may be. Where hardly any of them meets the object,
 * rays to {@value SurfaceSamples#COUNT} points on the surface of each of the two versions concerned
 * tell whether some thin part is seen. The pixels are those of the eye that sees most.
 *
 * <p>The rays of a frame are limited, so that many objects at once do not hold it up.
 */
final class VisibilityEstimator {
  /** The number of rays of a frame beyond which no further object is looked at. */
  private static final int MOST_RAYS = 1024;

  /** The number of rays through an object's part of the picture. */
  static final int RAYS = 64;

  /** The same, where the first half of a frame's rays has been cast. */
  private static final int FEWER_RAYS = 16;

  /** The number of triangles of a mesh whose hierarchy is built within a fraction of a frame. */
  private static final int LARGE = 500;

  /** The number of triangles whose hierarchies are built before they are needed, for the memory. */
  private static final long MOST_PREPARED = 4_000_000;

  /**
   * What is seen of an object.
   *
   * @param pixels of the version that is shown; of the other one, if none is
   */
  record Estimate(boolean visible, double pixels) {
    static final Estimate NOTHING = new Estimate(false, 0);
  }

  private final World world;
  private final LayerEyes eyes;
  private final SightRays rays;
  private final Map<Instance, VersionSurface> known = new IdentityHashMap<>();
  private List<InstanceTree> seen = List.of();
  private long structure;
  private boolean began;

  VisibilityEstimator(World world) {
    this.world = world;
    eyes = new LayerEyes(world);
    rays = new SightRays(world.meshes());
  }

  /** Promises the hierarchies of large meshes; returns what builds them. */
  List<MeshBvhCache.Task> prepare() {
    Set<Mesh> large = new LinkedHashSet<>();
    long triangles = 0;
    for (LayerView layer : layers()) {
      for (ShapeInstance shape : layer.instances().shapes()) {
        Optional<Mesh> mesh = shape.mesh().filter(of -> of.polygons() > LARGE);
        if (mesh.isPresent() && triangles + mesh.get().polygons() <= MOST_PREPARED) {
          triangles += large.add(mesh.get()) ? mesh.get().polygons() : 0;
        }
      }
    }
    return world.meshes().prepare(large);
  }

  /** Begins a frame, in which as many rays may be cast as in any other. */
  void begin() {
    eyes.begin();
    began = false;
  }

  /** Returns the layers of the frame in which objects may be seen. */
  List<LayerView> layers() {
    return eyes.layers();
  }

  /**
   * Returns what is seen of an object now; empty if too many rays have been cast in this frame.
   *
   * @param shown index of the version that is shown
   * @param other index of the version that is to be shown
   * @param exactly whether the pixels are asked for; otherwise the first ray that meets the object
   *     ends the search
   */
  Optional<Estimate> of(Node switchNode, int shown, int other, boolean exactly) {
    follow();
    Estimate all = Estimate.NOTHING;
    for (LayerView layer : layers()) {
      for (Instance instance : layer.instances().instances(switchNode)) {
        if (!(instance instanceof GroupInstance group) || !group.shown()) {
          continue;
        }
        ShownObject object =
            new ShownObject(
                layer.instances(), group, surface(group, shown), surface(group, other));
        for (Camera eye : eyes.of(layer)) {
          ObjectView view = new ObjectView(eye, object, rays, world.meshes());
          if (!view.enters()) {
            continue;
          }
          if (rays.cast() > MOST_RAYS) {
            return Optional.empty();
          }
          Estimate one = view.look(rays.cast() > MOST_RAYS / 2 ? FEWER_RAYS : RAYS, exactly);
          all = new Estimate(all.visible || one.visible, Math.max(all.pixels, one.pixels));
          if (all.visible && !exactly) {
            return Optional.of(all);
          }
        }
      }
    }
    return Optional.of(all);
  }

  /** Follows the layers and their structure, once in a frame in which anything is asked. */
  private void follow() {
    if (began) {
      return;
    }
    began = true;
    List<InstanceTree> trees = layers().stream().map(LayerView::instances).toList();
    rays.begin(trees);
    long now = trees.stream().mapToLong(InstanceTree::structureVersion).sum();
    if (now != structure || !trees.equals(seen)) {
      structure = now;
      seen = trees;
      known.clear(); // Instances may be gone.
    }
  }

  private VersionSurface surface(GroupInstance group, int version) {
    if (version < 0 || version >= group.children().size()) {
      return VersionSurface.NONE;
    }
    Instance child = group.children().get(version);
    VersionSurface now = VersionSurface.of(child);
    VersionSurface before = known.get(child);
    if (before != null && before.sameAs(now)) {
      return before;
    }
    known.put(child, now);
    return now;
  }
}
