package org.selectiverenderer.browser;

import java.util.ArrayList;
import java.util.List;
import java.util.Optional;
import java.util.Set;
import org.joml.Quaterniond;
import org.joml.Quaterniondc;
import org.joml.Vector3d;
import org.joml.Vector3dc;
import org.selectiverenderer.browser.instance.Background;
import org.selectiverenderer.browser.instance.BackgroundReader;
import org.selectiverenderer.browser.instance.Fog;
import org.selectiverenderer.browser.instance.InstanceTree;
import org.selectiverenderer.browser.navigation.NavigationMode;
import org.selectiverenderer.browser.navigation.NavigationParameters;
import org.selectiverenderer.browser.nodes.bindable.BindingStacks;
import org.selectiverenderer.browser.nodes.group.GroupingNode;
import org.selectiverenderer.browser.nodes.group.InlineNode;
import org.selectiverenderer.browser.nodes.keyboard.KeyDeviceSensorNode;
import org.selectiverenderer.browser.nodes.script.ScriptNode;
import org.selectiverenderer.browser.nodes.sensor.FrameDrivenNode;
import org.selectiverenderer.browser.nodes.sound.SoundNode;
import org.selectiverenderer.browser.picking.PickSensorEvaluator;
import org.selectiverenderer.browser.scene.EventCascade;
import org.selectiverenderer.browser.scene.Node;
import org.selectiverenderer.browser.scene.Scene;
import org.selectiverenderer.browser.viewer.OrthographicExtent;
import org.selectiverenderer.browser.viewer.Viewer;

/**
 * A layer of a running scene (X3D 4.0, 35.2) with its instances, binding stacks, viewer, pointing
 * device and sensors. Belongs to the thread that steps the world.
 */
final class SceneLayer {
  /**
   * Eye position of a LayoutLayer's viewer: an orthographic view that spans -1 to 1 along the
   * smaller side (X3D 4.0, 36.4.3).
   */
  private static final Vector3dc FLAT_EYE = new Vector3d(0, 0, 10);

  private static final Quaterniondc UPRIGHT = new Quaterniond();

  final GroupingNode root;
  final InstanceTree instances;
  final BindingStacks bindables;
  final ViewpointFollower follower;
  final PointingDeviceHandler pointing;
  final BackgroundReader backdrops;
  private final PickSensorEvaluator picking;
  private Viewer viewer;
  private List<FrameDrivenNode> looking = List.of();
  private List<FrameDrivenNode> chosen = List.of();
  private SensorScheduler round = new SensorScheduler(List.of());
  private long frameNodesOf = -1;
  private List<InlineNode> inlines = List.of();
  private List<ScriptNode> scripts = List.of();
  private List<KeyDeviceSensorNode> keySensors = List.of();
  private List<SoundNode> sounds = List.of();
  private boolean draggable;

  /** Whether this is a LayoutLayer, which no viewpoint and no navigation moves. */
  private final boolean flat;

  /**
   * @param viewer the viewer of the layer
   */
  SceneLayer(GroupingNode root, LayerStack.Parts parts, Viewer viewer) {
    this.root = root;
    this.viewer = viewer;
    flat = root.type().name().equals("LayoutLayer");
    instances = new InstanceTree(root, parts.assets());
    instances.onMoved(node -> round.moved(node));
    backdrops = new BackgroundReader(parts.assets());
    bindables = new BindingStacks(root, parts.cascade());
    instances.onStructure(bindables::structureChanged);
    follower = new ViewpointFollower(instances, bindables, viewer);
    pointing = new PointingDeviceHandler(instances, parts.meshes(), parts.activated());
    picking = new PickSensorEvaluator(instances, parts.assets(), parts.meshes());
  }

  Viewer viewer() {
    return viewer;
  }

  /** Replaces the viewer; the new one takes the old one's position and orientation. */
  void seenBy(Viewer other) {
    other.become(viewer);
    viewer = other;
    follower.lead(other);
  }

  List<InlineNode> inlines() {
    return inlines;
  }

  List<ScriptNode> scripts() {
    return scripts;
  }

  List<KeyDeviceSensorNode> keySensors() {
    return keySensors;
  }

  List<SoundNode> sounds() {
    return sounds;
  }

  /** Returns the frame-driven nodes of the layer, including those that another layer updates. */
  List<FrameDrivenNode> looking() {
    return looking;
  }

  /** Returns whether the layer has a drag sensor. */
  boolean draggable() {
    return draggable;
  }

  Optional<Background> backdrop() {
    return bindables
        .bound("X3DBackgroundNode")
        .map(node -> backdrops.read(node, follower.placeOf(node)));
  }

  Fog fog() {
    return bindables
        .bound("Fog")
        .map(node -> Fog.read(node, follower.placeOf(node)))
        .orElse(Fog.NONE);
  }

  LayerView view(LayerView.Part part, boolean active) {
    return new LayerView(
        instances,
        viewer,
        backdrop(),
        fog(),
        bound("NavigationInfo"),
        bound("X3DViewpointNode"),
        part,
        active);
  }

  private Optional<Node> bound(String type) {
    return bindables.bound(type).map(Node.class::cast);
  }

  /**
   * Adapts LOD and Billboard nodes to the layer's viewer.
   *
   * @param picture the picture in which the scene was last drawn
   */
  void look(DisplayMetrics picture, LayerView.Part part, EventCascade cascade) {
    if (flat) {
      viewer.moveTo(FLAT_EYE);
      viewer.turnTo(UPRIGHT);
      viewer.extent(Optional.of(OrthographicExtent.DEFAULT));
    }
    see(picture, part);
    Vector3d up = viewer.orientation().transform(new Vector3d(0, 1, 0));
    instances.view(viewer.position(), up, cascade);
    instances.update();
  }

  /** Places the nodes whose layout depends on the size of the picture. */
  void see(DisplayMetrics picture, LayerView.Part part) {
    if (instances.dependsOnPicture()) {
      instances.see(picture.sight(viewer, part));
    }
  }

  /**
   * Returns the centre of rotation, if the first navigation type of the bound NavigationInfo turns
   * about one.
   */
  private Optional<Vector3dc> pivot() {
    return bindables
        .bound("NavigationInfo")
        .map(info -> NavigationParameters.of(info).initial())
        .filter(mode -> mode == NavigationMode.EXAMINE || mode == NavigationMode.LOOKAT)
        .flatMap(mode -> follower.pivot());
  }

  /** Updates the layer's sensors and clocks for a frame. */
  void sense(double time, EventCascade cascade) {
    round.frame(new WorldFrameContext(time, viewer, instances, this::pivot), cascade);
    picking.frame(cascade);
  }

  /**
   * Chooses the sensors and clocks that this layer updates; a node that is USEd in several layers
   * is updated by the first only.
   *
   * @param taken the nodes that other layers update, to which the chosen ones are added
   */
  void choose(Set<FrameDrivenNode> taken) {
    chosen = looking.stream().filter(taken::add).toList();
    if (!round.isOf(chosen)) {
      round.close();
      round = new SensorScheduler(List.of());
    }
  }

  /** Schedules the chosen nodes; called after the other layers have released theirs. */
  void engage() {
    if (!round.isOf(chosen)) {
      round = new SensorScheduler(chosen);
    }
  }

  /**
   * Collects the nodes that are updated per frame, if the structure has changed.
   *
   * @param scene the scene to which the layer belongs
   * @param base whether this is the base layer, which also has the scene's nodes outside all groups
   * @return whether the structure had changed
   */
  boolean frameNodes(Scene scene, boolean base) {
    if (frameNodesOf == instances.structureVersion()) {
      return false;
    }
    frameNodesOf = instances.structureVersion();
    LayerNodeIndex walk = LayerNodeIndex.of(scene, base, instances);
    looking = walk.frameNodes();
    inlines = walk.inlines();
    scripts = walk.scripts();
    keySensors = walk.keySensors();
    sounds = walk.sounds();
    draggable = walk.draggable();
    picking.follow(walk.picks());
    pointing.touchable(walk.touchable());
    return true;
  }

  /**
   * Passes the pointing device to the layer's sensors and Anchors.
   *
   * @return the states for the layers below: {@link PointingDeviceState#AWAY} where the pointer is
   *     over a shape of this layer
   */
  List<PointingDeviceState> point(
      List<PointingDeviceState> since,
      LayerView.Part part,
      boolean pickable,
      Viewer whole,
      EventCascade cascade) {
    List<PointingDeviceState> here = new ArrayList<>(since.size());
    List<PointingDeviceState> below = new ArrayList<>(since.size());
    for (PointingDeviceState pointer : since) {
      PointingDeviceState inside =
          pickable
              ? LayerPointerMapping.in(part, viewer, pointer, whole)
              : new PointingDeviceState(Optional.empty(), pointer.pressed());
      here.add(inside);
      below.add(
          pointing.meets(inside, viewer)
              ? new PointingDeviceState(Optional.empty(), pointer.pressed(), pointer.aspect())
              : pointer);
    }
    pointing.frame(here, viewer, cascade);
    return below;
  }

  void close() {
    round.close();
    picking.follow(List.of());
    bindables.close();
    instances.close();
  }
}
