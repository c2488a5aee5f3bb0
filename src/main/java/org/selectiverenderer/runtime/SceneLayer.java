package org.selectiverenderer.runtime;

import java.util.ArrayList;
import java.util.List;
import java.util.Optional;
import java.util.Set;
import org.joml.Quaterniond;
import org.joml.Quaterniondc;
import org.joml.Vector3d;
import org.joml.Vector3dc;
import org.selectiverenderer.runtime.instance.Backdrop;
import org.selectiverenderer.runtime.instance.BackdropReader;
import org.selectiverenderer.runtime.instance.Fog;
import org.selectiverenderer.runtime.instance.InstanceTree;
import org.selectiverenderer.runtime.nodes.bind.BindStacks;
import org.selectiverenderer.runtime.nodes.group.GroupingNode;
import org.selectiverenderer.runtime.nodes.group.InlineNode;
import org.selectiverenderer.runtime.nodes.key.KeyDeviceSensorNode;
import org.selectiverenderer.runtime.nodes.script.ScriptNode;
import org.selectiverenderer.runtime.nodes.sensor.FrameNode;
import org.selectiverenderer.runtime.nodes.sound.SoundNode;
import org.selectiverenderer.runtime.pick.Picking;
import org.selectiverenderer.runtime.scene.Cascade;
import org.selectiverenderer.runtime.scene.Node;
import org.selectiverenderer.runtime.scene.Scene;
import org.selectiverenderer.runtime.viewer.Extent;
import org.selectiverenderer.runtime.viewer.Viewer;
import org.selectiverenderer.runtime.walk.Navigation;
import org.selectiverenderer.runtime.walk.NavigationMode;

/**
 * A layer of a scene with all that a frame does in it: its instances, what is bound in it, who sees
 * it, what is pointed at, its sensors (X3D 4.0, 35.2). Belongs to the thread that steps the world.
 */
final class SceneLayer {
  /** Who sees a LayoutLayer: in parallel, -1 to 1 of the smaller side (X3D 4.0, 36.4.3). */
  private static final Vector3dc FLAT_EYE = new Vector3d(0, 0, 10);

  private static final Quaterniondc UPRIGHT = new Quaterniond();

  final GroupingNode root;
  final InstanceTree instances;
  final BindStacks bindables;
  final ViewpointFollower follower;
  final Pointing pointing;
  final BackdropReader backdrops;
  private final Picking picking;
  private Viewer viewer;
  private List<FrameNode> looking = List.of();
  private List<FrameNode> chosen = List.of();
  private FrameRound round = new FrameRound(List.of());
  private long frameNodesOf = -1;
  private List<InlineNode> inlines = List.of();
  private List<ScriptNode> scripts = List.of();
  private List<KeyDeviceSensorNode> keySensors = List.of();
  private List<SoundNode> sounds = List.of();
  private boolean draggable;

  /** Whether it is a layer of rectangles, which no viewpoint and no walking moves. */
  private final boolean flat;

  /**
   * @param viewer who sees it
   */
  SceneLayer(GroupingNode root, LayerStack.Parts parts, Viewer viewer) {
    this.root = root;
    this.viewer = viewer;
    flat = root.type().name().equals("LayoutLayer");
    instances = new InstanceTree(root, parts.assets());
    instances.onMoved(node -> round.moved(node));
    backdrops = new BackdropReader(parts.assets());
    bindables = new BindStacks(root, parts.cascade());
    follower = new ViewpointFollower(instances, bindables, viewer);
    pointing = new Pointing(instances, parts.meshes(), parts.activated());
    picking = new Picking(instances, parts.assets(), parts.meshes());
  }

  Viewer viewer() {
    return viewer;
  }

  /** Another viewer sees it from now on, who takes the place of the one before. */
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

  /** What looks at frames, also where another layer has it look. */
  List<FrameNode> looking() {
    return looking;
  }

  /** Whether it has a drag sensor. */
  boolean draggable() {
    return draggable;
  }

  Optional<Backdrop> backdrop() {
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
   * Adapts LOD and Billboard nodes to its viewer.
   *
   * @param picture that the scene was last seen in
   */
  void look(Picture picture, LayerView.Part part, Cascade cascade) {
    if (flat) {
      viewer.moveTo(FLAT_EYE);
      viewer.turnTo(UPRIGHT);
      viewer.extent(Optional.of(Extent.DEFAULT));
    }
    see(picture, part);
    Vector3d up = viewer.orientation().transform(new Vector3d(0, 1, 0));
    instances.view(viewer.position(), up, cascade);
    instances.update();
  }

  /** Places what depends on the picture. */
  void see(Picture picture, LayerView.Part part) {
    if (instances.dependsOnPicture()) {
      instances.see(picture.sight(viewer, part));
    }
  }

  /** What is turned about, where the NavigationInfo has the user do that first of all. */
  private Optional<Vector3dc> pivot() {
    return bindables
        .bound("NavigationInfo")
        .map(info -> Navigation.of(info).initial())
        .filter(mode -> mode == NavigationMode.EXAMINE || mode == NavigationMode.LOOKAT)
        .flatMap(mode -> follower.pivot());
  }

  /** Its sensors and clocks look at the frame. */
  void sense(double time, Cascade cascade) {
    round.frame(new WorldFrame(time, viewer, instances, this::pivot), cascade);
    picking.frame(cascade);
  }

  /**
   * Chooses the sensors and clocks that look at frames with it: none that do with another layer,
   * where they stand too.
   *
   * @param taken those of other layers, to which its own are added
   */
  void choose(Set<FrameNode> taken) {
    chosen = looking.stream().filter(taken::add).toList();
    if (!round.isOf(chosen)) {
      round.close();
      round = new FrameRound(List.of());
    }
  }

  /** Has those look that were chosen; after other layers have let go of them. */
  void engage() {
    if (!round.isOf(chosen)) {
      round = new FrameRound(chosen);
    }
  }

  /**
   * Follows the structure with the nodes that look at every frame.
   *
   * @param scene that it is a layer of
   * @param base whether the scene's nodes outside of all groups count with this layer
   * @return whether anything was new
   */
  boolean frameNodes(Scene scene, boolean base) {
    if (frameNodesOf == instances.structureVersion()) {
      return false;
    }
    frameNodesOf = instances.structureVersion();
    FrameNodes walk = FrameNodes.of(scene, base, instances);
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
   * Takes the pointing device to what is in it.
   *
   * @return what it says to the layers below: away where it is over something of this one
   */
  List<Pointer> point(
      List<Pointer> since, LayerView.Part part, boolean pickable, Viewer whole, Cascade cascade) {
    List<Pointer> here = new ArrayList<>(since.size());
    List<Pointer> below = new ArrayList<>(since.size());
    for (Pointer pointer : since) {
      Pointer inside =
          pickable
              ? LayerPointing.in(part, viewer, pointer, whole)
              : new Pointer(Optional.empty(), pointer.pressed());
      here.add(inside);
      below.add(
          pointing.meets(inside, viewer)
              ? new Pointer(Optional.empty(), pointer.pressed(), pointer.aspect())
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
