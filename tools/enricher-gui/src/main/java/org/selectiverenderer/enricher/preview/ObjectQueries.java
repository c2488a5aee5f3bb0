package org.selectiverenderer.enricher.preview;

import java.util.ArrayList;
import java.util.HashMap;
import java.util.HashSet;
import java.util.List;
import java.util.Map;
import java.util.Optional;
import java.util.OptionalDouble;
import java.util.Set;
import org.joml.Matrix4d;
import org.joml.Matrix4dc;
import org.joml.Vector3d;
import org.joml.Vector3dc;
import org.selectiverenderer.browser.collision.RayCaster;
import org.selectiverenderer.browser.instance.GroupInstance;
import org.selectiverenderer.browser.instance.Instance;
import org.selectiverenderer.browser.instance.ShapeInstance;
import org.selectiverenderer.browser.scene.Node;
import org.selectiverenderer.enricher.area.ObjectBox;
import org.selectiverenderer.geometry.BoundingBox;

/**
 * Measures nodes of a running scene: their boxes, the surfaces below points, and what lies in a
 * rectangle. World coordinates, Y up. Confined to the preview's thread.
 */
final class ObjectQueries {
  private static final int MOST_PASSED = 256;
  private static final double PASSED = 1e-5;

  private final PreviewScene scene;

  ObjectQueries(PreviewScene scene) {
    this.scene = scene;
  }

  /** Returns the box of what a node shows; empty if it shows nothing. */
  Optional<ObjectBox> box(SelectedNode of) {
    return instance(of).flatMap(instance -> box(of, instance));
  }

  private Optional<Instance> instance(SelectedNode of) {
    Optional<Node> node = scene.nodes().findItself(of.anchors().get(0));
    List<Instance> places =
        node.map(found -> scene.world().instances().instances(found)).orElse(List.of());
    return of.use() < places.size() ? Optional.of(places.get(of.use())) : Optional.empty();
  }

  private static Optional<ObjectBox> box(SelectedNode of, Instance instance) {
    Matrix4dc place =
        of.inside() && instance instanceof GroupInstance group ? group.content() : instance.world();
    Matrix4d back = place.invert(new Matrix4d());
    Set<ShapeInstance> shapes = new HashSet<>();
    PreviewNodeIndex.gather(instance, shapes);
    BoundingBox own = BoundingBox.EMPTY;
    BoundingBox bounds = BoundingBox.EMPTY;
    for (ShapeInstance shape : shapes) {
      Optional<BoundingBox> mesh =
          shape.mesh().map(each -> BoundingBox.of(each.bounds())).filter(box -> !box.isEmpty());
      if (shape.shown() && mesh.isPresent()) {
        own = own.union(mesh.get().transformed(back.mul(shape.world(), new Matrix4d())));
        bounds = bounds.union(BoundingBox.of(shape.bounds()));
      }
    }
    boolean measured = !own.isEmpty() && back.isFinite();
    return measured
        ? Optional.of(new ObjectBox(of.element(), own, place, bounds))
        : Optional.empty();
  }

  /** Returns the shapes of nodes. */
  Set<ShapeInstance> shapes(List<SelectedNode> nodes) {
    Set<ShapeInstance> shapes = new HashSet<>();
    for (SelectedNode node : nodes) {
      instance(node).ifPresent(instance -> PreviewNodeIndex.gather(instance, shapes));
    }
    return shapes;
  }

  /** Returns the first hit of a ray that passes through some shapes. */
  Optional<RayCaster.Hit> hit(Vector3dc from, Vector3dc direction, Set<ShapeInstance> through) {
    Vector3d start = new Vector3d(from);
    Vector3d unit = direction.normalize(new Vector3d());
    for (int i = 0; i < MOST_PASSED; i++) {
      Optional<RayCaster.Hit> hit = scene.hit(start, unit);
      if (hit.isEmpty() || !through.contains(hit.get().shape())) {
        return hit;
      }
      start.set(hit.get().point()).fma(PASSED * (1 + hit.get().distance()), unit);
    }
    return Optional.empty();
  }

  /** Returns the height of the lowest surface below a box, from its top. */
  OptionalDouble support(BoundingBox box, Set<ShapeInstance> own) {
    double lowest = Double.POSITIVE_INFINITY;
    for (int i = 0; i < 5; i++) {
      double dx = i == 0 ? 0 : (i % 2 == 0 ? 0.4 : -0.4) * box.width();
      double dz = i == 0 ? 0 : (i > 2 ? 0.4 : -0.4) * box.depth();
      Vector3d from =
          new Vector3d(
              (box.minX() + box.maxX()) / 2 + dx, box.maxY(), (box.minZ() + box.maxZ()) / 2 + dz);
      Optional<RayCaster.Hit> hit = hit(from, new Vector3d(0, -1, 0), own);
      if (hit.isPresent()) {
        lowest = Math.min(lowest, hit.get().point().y());
      }
    }
    return Double.isInfinite(lowest) ? OptionalDouble.empty() : OptionalDouble.of(lowest);
  }

  /** Returns the nodes whose shapes, as far as they are below a height, lie in a rectangle. */
  List<Node> within(BoundingBox footprint, Set<ShapeInstance> hidden) {
    Map<Node, Boolean> inside = new HashMap<>();
    List<Node> order = new ArrayList<>();
    for (ShapeInstance shape : scene.world().instances().shapes()) {
      double[] b = shape.bounds();
      if (!shape.shown() || hidden.contains(shape) || b[0] > b[3] || b[1] > footprint.minY()) {
        continue;
      }
      boolean in =
          b[0] >= footprint.minX()
              && b[3] <= footprint.maxX()
              && b[2] >= footprint.minZ()
              && b[5] <= footprint.maxZ();
      scene
          .nodes()
          .meant(shape, false)
          .ifPresent(
              node -> {
                if (inside.merge(node, in, Boolean::logicalAnd) && !order.contains(node)) {
                  order.add(node);
                }
              });
    }
    order.removeIf(node -> !inside.get(node));
    return order;
  }
}
