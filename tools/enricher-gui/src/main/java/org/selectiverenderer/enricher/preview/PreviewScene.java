package org.selectiverenderer.enricher.preview;

import java.util.List;
import java.util.Map;
import java.util.Optional;
import java.util.Set;
import java.util.function.Supplier;
import org.joml.Vector3d;
import org.joml.Vector3dc;
import org.jspecify.annotations.Nullable;
import org.selectiverenderer.app.walk.Walking;
import org.selectiverenderer.control.SelectiveController;
import org.selectiverenderer.geometry.Bounds;
import org.selectiverenderer.runtime.World;
import org.selectiverenderer.runtime.collide.RayCaster;
import org.selectiverenderer.runtime.instance.ShapeInstance;
import org.selectiverenderer.runtime.instance.ShownBounds;
import org.selectiverenderer.runtime.nodes.group.SwitchNode;
import org.selectiverenderer.runtime.nodes.sensor.ProximitySensorNode;
import org.selectiverenderer.runtime.sai.EmbeddedBrowser;
import org.selectiverenderer.runtime.scene.Node;
import org.selectiverenderer.runtime.viewer.Pose;
import org.selectiverenderer.runtime.walk.Controls;

/**
 * One loaded state of the document, running: looked at as if in some schemas, or walked in under
 * the controller. Belongs to the thread that steps it.
 */
final class PreviewScene implements AutoCloseable {
  /** How far a sight must go of the way, as points of a box may lie in a wall's surface. */
  private static final double NEARLY = 0.98;

  private final LoadedPreview loaded;
  private final World world;
  private final PreviewNodes nodes;
  private AreaBoxes areas;
  private AsIf asIf;
  private final RayCaster rays;
  private final EmbeddedBrowser browser;
  private List<String> schemas = List.of();
  private @Nullable SwitchNode versioned;
  private int version = -1;
  private @Nullable SelectiveController controller;
  private @Nullable Walking walking;
  private double time;
  private long counted = -1;
  private long revision;
  private final double startHeight;

  PreviewScene(LoadedPreview loaded) {
    this.loaded = loaded;
    revision = loaded.revision();
    world = loaded.world();
    world.step(0, (viewer, now, dt) -> {}); // The viewer is at the start from here on.
    startHeight = world.viewer().position().y();
    nodes = new PreviewNodes(world);
    areas = new AreaBoxes(world, nodes);
    asIf = new AsIf(nodes.switches(), world.cascade());
    rays = new RayCaster(world.instances(), world.meshes());
    browser = new EmbeddedBrowser(world, loaded.loader(), text -> {}, Map.of());
  }

  World world() {
    return world;
  }

  PreviewNodes nodes() {
    return nodes;
  }

  AreaBoxes areas() {
    return areas;
  }

  long revision() {
    return revision;
  }

  /**
   * Becomes another state of the document; not while somebody walks.
   *
   * @return false, and nothing is changed, if it cannot
   */
  boolean patch(ScenePatch patch) {
    if (patch.from() != revision) {
      return false;
    }
    Optional<RunningPatch> running = RunningPatch.of(patch, nodes, loaded.loader());
    if (running.isEmpty()) {
      return false;
    }
    asIf.reset(); // What the scene is shown as if is no part of it.
    running.get().apply(world);
    nodes.move(patch.moved());
    revision = patch.revision();
    areas = new AreaBoxes(world, nodes);
    asIf = new AsIf(nodes.switches(), world.cascade());
    asIf(schemas); // The version that is shown in place stays, too.
    counted = -1;
    return true;
  }

  /** Shows the scene under schemas, from now on and after each walk. */
  void asIf(List<String> wanted) {
    schemas = List.copyOf(wanted);
    if (controller == null) {
      asIf.apply(schemas);
      applyVersion();
    }
  }

  /** Shows a version of one object instead, from now on; -1 for what the schemas say. */
  void version(@Nullable SwitchNode node, int choice) {
    versioned = choice < 0 ? null : node;
    version = choice;
    asIf(schemas);
  }

  private void applyVersion() {
    if (versioned != null) {
      asIf.version(versioned, version);
    }
  }

  /** The object of which a version is shown, if there is one. */
  Optional<SwitchNode> versioned() {
    return Optional.ofNullable(controller == null ? versioned : null);
  }

  /** Triangles that a node shows now. */
  long shownPolygons(Node node) {
    return nodes.shapes(node).stream()
        .filter(ShapeInstance::shown)
        .mapToLong(shape -> shape.mesh().map(mesh -> (long) mesh.polygons()).orElse(0L))
        .sum();
  }

  /** Does something while all objects are at their most detailed; nobody must be walking. */
  <T> T inDetail(Supplier<T> work) {
    Pose here = pose();
    asIf.detailed();
    look(here);
    try {
      return work.get();
    } finally {
      asIf(schemas);
      look(here);
    }
  }

  /** Gives the scene to the controller, the viewer at the bound viewpoint. */
  void walk(Controls controls) {
    asIf.reset();
    look(Pose.of(world.viewer()));
    world.bindables().bound("Viewpoint").ifPresent(world.views()::goTo);
    walking = new Walking(world, controls);
    controller =
        new SelectiveController(
            browser, SelectiveController.Settings.SELECTIVE, event -> {}, problem -> {});
  }

  /** Takes the scene back from the controller. */
  void stand() {
    if (controller != null) {
      controller.close();
      controller = null;
      walking = null;
      asIf.apply(schemas);
      applyVersion();
    }
  }

  Optional<Walking> walking() {
    return Optional.ofNullable(walking);
  }

  /** A frame of the walk. */
  void step(double seconds) {
    if (walking != null) {
      time += seconds;
      world.step(time, walking);
      count();
    }
  }

  /** A frame seen from a place; no time passes. */
  void look(Pose pose) {
    world.step(time, (viewer, now, dt) -> pose.applyTo(viewer));
    count();
  }

  private void count() {
    if (counted != world.instances().shownPolygons()) {
      counted = world.instances().shownPolygons();
      areas.count();
    }
  }

  List<String> enteredAreas() {
    return controller == null ? List.of() : controller.enteredAreas();
  }

  /** Those in force by walking, else those looked at as if. */
  List<String> schemas() {
    return controller == null ? schemas : controller.activeSchemas();
  }

  /** The first shape in a direction, seen from a place; both in the world. */
  Optional<RayCaster.Hit> hit(Vector3dc from, Vector3dc direction) {
    return rays.cast(from, direction, Double.POSITIVE_INFINITY);
  }

  /** How high the eye is at the start viewpoint, or now where there is none. */
  double startHeight() {
    return startHeight;
  }

  /** Shows a sensor's box as an edit would make it, until the scene is loaded anew. */
  void box(List<Anchor> sensor, float[] centre, float[] size) {
    nodes
        .find(sensor)
        .filter(ProximitySensorNode.class::isInstance)
        .ifPresent(
            node -> {
              world.cascade().send(node, node.type().indexOf("center"), centre);
              world.cascade().send(node, node.type().indexOf("size"), size);
            });
  }

  /** The first shape in a direction, seen from the viewer. */
  Optional<RayCaster.Hit> hit(Vector3dc direction) {
    Vector3d inWorld = world.viewer().orientation().transform(direction, new Vector3d());
    return rays.cast(world.viewer().position(), inWorld, Double.POSITIVE_INFINITY);
  }

  /** Whether nothing stands between the viewer and a point of the world. */
  boolean sees(Vector3dc point) {
    Vector3d way = point.sub(world.viewer().position(), new Vector3d());
    double distance = way.length();
    return distance == 0
        || rays.cast(world.viewer().position(), way.div(distance), distance * NEARLY).isEmpty();
  }

  /** The box around a node's shapes that are shown, or around a sensor's boxes. */
  Optional<Bounds> bounds(Node node) {
    return areas.bounds(node).or(() -> ShownBounds.of(nodes.shapes(node)));
  }

  /** The box around all that is shown, or if that is nothing around all there is. */
  Optional<Bounds> bounds() {
    return ShownBounds.of(world.instances().shapes());
  }

  /** Where the viewer is. */
  Pose pose() {
    return Pose.of(world.viewer());
  }

  Set<ShapeInstance> shapes(Node node) {
    return nodes.shapes(node);
  }

  @Override
  public void close() {
    if (controller != null) {
      controller.close();
    }
    browser.dispose();
    loaded.close();
  }
}
