package org.selectiverenderer.enricher.preview;

import java.util.List;
import java.util.Map;
import java.util.Optional;
import java.util.OptionalDouble;
import java.util.Set;
import java.util.function.Supplier;
import org.joml.AxisAngle4d;
import org.joml.Quaterniondc;
import org.joml.Vector3d;
import org.joml.Vector3dc;
import org.jspecify.annotations.Nullable;
import org.selectiverenderer.authoring.placement.TransformPose;
import org.selectiverenderer.browser.World;
import org.selectiverenderer.browser.collision.RayCaster;
import org.selectiverenderer.browser.instance.ShapeInstance;
import org.selectiverenderer.browser.instance.VisibleBoundsCalculator;
import org.selectiverenderer.browser.navigation.KeyboardMouseControls;
import org.selectiverenderer.browser.nodes.group.SwitchNode;
import org.selectiverenderer.browser.nodes.sensor.ProximitySensorNode;
import org.selectiverenderer.browser.sai.EmbeddedBrowser;
import org.selectiverenderer.browser.scene.Node;
import org.selectiverenderer.browser.viewer.Pose;
import org.selectiverenderer.control.SelectiveController;
import org.selectiverenderer.geometry.BoundingBox;
import org.selectiverenderer.walkthrough.NavigationController;

/**
 * A running scene of one loaded state of the document, which is either looked at under simulated
 * schemas or walked in under the controller. Confined to the thread that steps it.
 */
final class PreviewScene implements AutoCloseable {
  /**
   * Share of the distance to a point that must be free for it to be visible, as a point of a box
   * may lie in a wall's surface.
   */
  private static final double NEARLY = 0.98;

  private final LoadedPreview loaded;
  private final World world;
  private final PreviewNodeIndex nodes;
  private SensorBoxOverlay areas;
  private SchemaSimulator asIf;
  private final RayCaster rays;
  private final EmbeddedBrowser browser;
  private List<String> schemas = List.of();
  private @Nullable SwitchNode versioned;
  private int version = -1;
  private @Nullable SelectiveController controller;
  private @Nullable NavigationController walking;
  private double time;
  private long counted = -1;
  private long revision;
  private final OptionalDouble startHeight;

  PreviewScene(LoadedPreview loaded) {
    this.loaded = loaded;
    revision = loaded.revision();
    world = loaded.world();
    world.step(0, (viewer, now, dt) -> {}); // This puts the viewer at the start viewpoint.
    startHeight =
        world.bindables().bound("X3DViewpointNode").isPresent()
            ? OptionalDouble.of(world.viewer().position().y())
            : OptionalDouble.empty();
    nodes = new PreviewNodeIndex(world);
    areas = new SensorBoxOverlay(world, nodes);
    asIf = new SchemaSimulator(nodes.switches(), nodes::named, world.cascade());
    rays = new RayCaster(world.instances(), world.meshes());
    browser = new EmbeddedBrowser(world, loaded.loader(), text -> {}, Map.of());
  }

  World world() {
    return world;
  }

  PreviewNodeIndex nodes() {
    return nodes;
  }

  SensorBoxOverlay areas() {
    return areas;
  }

  long revision() {
    return revision;
  }

  LoadedPreview loaded() {
    return loaded;
  }

  /**
   * Updates the scene to another state of the document; not while the author walks.
   *
   * @param added the new nodes of the patch
   * @return false, without a change, if the patch does not apply
   */
  boolean patch(ScenePatch patch, AddedNodes added) {
    if (patch.from() != revision) {
      return false;
    }
    Optional<ResolvedScenePatch> running =
        ResolvedScenePatch.of(patch, nodes, world.scene().root(), loaded.loader(), added);
    if (running.isEmpty()) {
      return false;
    }
    asIf.reset(); // The patch applies to the scene without simulated schemas.
    nodes.move(patch); // Before new nodes come, which are where they are.
    running.get().apply(world);
    if (!patch.children().isEmpty()) {
      world.instances().update();
      nodes.collect();
      versioned = nodes.switches().contains(versioned) ? versioned : null;
    }
    revision = patch.revision();
    areas = new SensorBoxOverlay(world, nodes);
    asIf = new SchemaSimulator(nodes.switches(), nodes::named, world.cascade());
    asIf(schemas); // Also shows the chosen version of an object again.
    counted = -1;
    return true;
  }

  /** Sets the simulated schemas, which are shown now and after each walk. */
  void asIf(List<String> wanted) {
    schemas = List.copyOf(wanted);
    if (controller == null) {
      asIf.apply(schemas);
      applyVersion();
    }
  }

  /** Sets the version that one object shows whatever the schemas select; -1 ends that. */
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

  /** The object whose version the author has chosen; empty for none. */
  Optional<SwitchNode> versioned() {
    return Optional.ofNullable(controller == null ? versioned : null);
  }

  /** The number of triangles that a node shows at present. */
  long shownPolygons(Node node) {
    return nodes.shapes(node).stream()
        .filter(ShapeInstance::shown)
        .mapToLong(shape -> shape.mesh().map(mesh -> (long) mesh.polygons()).orElse(0L))
        .sum();
  }

  /** Runs work while all objects show their most detailed versions; not while the author walks. */
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

  /** Begins a walk under the controller, with the viewer at the bound viewpoint. */
  void walk(KeyboardMouseControls controls) {
    asIf.reset();
    look(Pose.of(world.viewer()));
    world.bindables().bound("Viewpoint").ifPresent(world.views()::goTo);
    walking = new NavigationController(world, controls);
    controller =
        new SelectiveController(
            browser, SelectiveController.Settings.SELECTIVE, event -> {}, problem -> {});
  }

  /** Ends the walk and shows the simulated schemas again. */
  void stand() {
    if (controller != null) {
      controller.close();
      controller = null;
      walking = null;
      asIf.apply(schemas);
      applyVersion();
    }
  }

  Optional<NavigationController> walking() {
    return Optional.ofNullable(walking);
  }

  /** Steps the walk by a frame. */
  void step(double seconds) {
    if (walking != null) {
      time += seconds;
      world.step(time, walking);
      count();
    }
  }

  /** Where the animation stands; empty for a scene without one. */
  Optional<AnimationPhase> animation() {
    return AnimationPhase.of(nodes.timeSensors(), time);
  }

  /** Lets time pass; the next look or step shows it. */
  void pass(double seconds) {
    time += seconds;
  }

  /** Updates the scene for a pose without passing time. */
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

  /** The active schemas of the walk, else the simulated ones. */
  List<String> schemas() {
    return controller == null ? schemas : controller.activeSchemas();
  }

  /** Returns the nearest hit of a ray in world coordinates. */
  Optional<RayCaster.Hit> hit(Vector3dc from, Vector3dc direction) {
    return rays.cast(from, direction, Double.POSITIVE_INFINITY);
  }

  /** The eye height, world Y, at the start viewpoint; empty if the scene has none. */
  OptionalDouble startHeight() {
    return startHeight;
  }

  /** Changes a sensor's box in the running scene only, until the document is loaded again. */
  void box(List<SourceAnchor> sensor, float[] centre, float[] size) {
    nodes
        .find(sensor)
        .filter(ProximitySensorNode.class::isInstance)
        .ifPresent(
            node -> {
              world.cascade().send(node, node.type().indexOf("center"), centre);
              world.cascade().send(node, node.type().indexOf("size"), size);
            });
  }

  /**
   * Shows a Transform in another pose in the running scene only, until the document is loaded
   * again.
   */
  void pose(SourceAnchor transform, TransformPose pose) {
    nodes
        .findItself(transform)
        .ifPresent(
            node -> {
              send(node, "translation", floats(pose.translation()));
              send(node, "rotation", floats(pose.rotation()));
              send(node, "scale", floats(pose.scale()));
            });
  }

  private void send(Node node, String field, float[] value) {
    if (node.type().field(field).isPresent()) {
      world.cascade().send(node, node.type().indexOf(field), value);
    }
  }

  private static float[] floats(Vector3dc of) {
    return new float[] {(float) of.x(), (float) of.y(), (float) of.z()};
  }

  private static float[] floats(Quaterniondc of) {
    AxisAngle4d turn = new AxisAngle4d(of);
    return new float[] {(float) turn.x, (float) turn.y, (float) turn.z, (float) turn.angle};
  }

  /** Returns the nearest hit of a ray from the viewer; the direction is in the viewer's frame. */
  Optional<RayCaster.Hit> hit(Vector3dc direction) {
    Vector3d inWorld = world.viewer().orientation().transform(direction, new Vector3d());
    return rays.cast(world.viewer().position(), inWorld, Double.POSITIVE_INFINITY);
  }

  /** Returns whether no shape is between the viewer and a world point. */
  boolean sees(Vector3dc point) {
    Vector3d way = point.sub(world.viewer().position(), new Vector3d());
    double distance = way.length();
    return distance == 0
        || rays.cast(world.viewer().position(), way.div(distance), distance * NEARLY).isEmpty();
  }

  /** The bounding box of a node's shown shapes, or of a sensor's boxes. */
  Optional<BoundingBox> bounds(Node node) {
    return areas.bounds(node).or(() -> VisibleBoundsCalculator.of(nodes.shapes(node)));
  }

  /** The bounding box of all shown shapes but sky domes and endless grounds. */
  Optional<BoundingBox> bounds() {
    return PlanShapes.of(world.instances().shapes(), Set.of())
        .extent()
        .or(() -> VisibleBoundsCalculator.of(world.instances().shapes()));
  }

  /** The viewer's pose. */
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
