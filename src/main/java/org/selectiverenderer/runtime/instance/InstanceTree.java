package org.selectiverenderer.runtime.instance;

import java.util.ArrayDeque;
import java.util.ArrayList;
import java.util.Deque;
import java.util.IdentityHashMap;
import java.util.LinkedHashSet;
import java.util.List;
import java.util.Map;
import java.util.Set;
import java.util.function.Consumer;
import org.joml.Matrix4d;
import org.joml.Matrix4dc;
import org.joml.Vector3d;
import org.joml.Vector3dc;
import org.jspecify.annotations.Nullable;
import org.selectiverenderer.runtime.nodes.group.Deforming;
import org.selectiverenderer.runtime.nodes.group.GroupingNode;
import org.selectiverenderer.runtime.nodes.group.ViewerDependent;
import org.selectiverenderer.runtime.nodes.layout.Sight;
import org.selectiverenderer.runtime.nodes.shader.ShaderNode;
import org.selectiverenderer.runtime.scene.Cascade;
import org.selectiverenderer.runtime.scene.Formed;
import org.selectiverenderer.runtime.scene.Node;

/**
 * Every path from the root of a scene to its nodes, Inlines included. Changes of nodes are
 * collected and applied by {@link #update()}: a Switch costs its old and new child, a Transform
 * what is below it, other children what is new or gone (and one pass over the tree that makes the
 * lists anew).
 *
 * <p>All versions of an object are in the tree, shown or not, so that switching makes nothing new.
 */
public final class InstanceTree {
  /**
   * Nesting beyond which a scene is cut off: what loading lets through, 1000 nodes, and the groups
   * that hold the scenes of Inlines.
   */
  static final int MAX_DEPTH = 1300;

  /** Instances above which groups stay empty: nested USEs multiply without bound. */
  private static final long MAX_INSTANCES = 8_000_000;

  /** Bytes of memory that there are to be for each instance. */
  private static final long BYTES_PER_INSTANCE = 512;

  private final long maxInstances =
      Math.min(MAX_INSTANCES, Runtime.getRuntime().maxMemory() / BYTES_PER_INSTANCE);
  private final Assets assets;
  private final GroupInstance root;
  private final Map<Node, ShapeLook> looks = new IdentityHashMap<>();
  private final InstanceLists lists = new InstanceLists();
  private final List<GroupInstance> pendingGroups = new ArrayList<>();
  private final List<ShapeLook> pendingLooks = new ArrayList<>();
  private final Set<ShaderNode> judged = new LinkedHashSet<>();
  private final Matrix4d inverse = new Matrix4d();
  private final Vector3d localEye = new Vector3d();
  private final Vector3d localUp = new Vector3d();
  private long structureVersion;
  private long placementVersion;
  private long choiceVersion;
  private boolean structureChanged = true;
  private Consumer<? super Node> onMoved = node -> {};
  private boolean cutOff;
  private Sight sight = Sight.NONE;
  private int instances;
  private long shownPolygons;

  /**
   * @param rootNode the scene's root group
   */
  public InstanceTree(GroupingNode rootNode, Assets assets) {
    this.assets = assets;
    root = (GroupInstance) build(rootNode, null, 0);
    root.show(true, this);
    collect();
  }

  public GroupInstance root() {
    return root;
  }

  /** All shapes, shown or not, in document order; the same list until the structure changes. */
  public List<ShapeInstance> shapes() {
    return lists.shapes;
  }

  /** Changes when {@link #shapes()} or the lights gain or lose an element. */
  public long structureVersion() {
    return structureVersion;
  }

  /** Changes when a shape may have moved or may have got another mesh. */
  public long placementVersion() {
    return placementVersion;
  }

  /** Changes when a group may let other children be seen or picked. */
  public long choiceVersion() {
    return choiceVersion;
  }

  void chosen() {
    choiceVersion++;
  }

  /** All lights, on or off, in document order. */
  public List<LightInstance> lights() {
    return List.copyOf(lists.lights);
  }

  /** The instances of any node in document order; empty when it is in no part of the scene. */
  public List<Instance> instances(Node node) {
    return lists.instances(node);
  }

  /**
   * {@link Instance#world()} of each instance of a node, in document order: a view that follows the
   * tree and costs nothing to ask for.
   */
  public List<Matrix4dc> places(Node node) {
    return lists.places(node);
  }

  /** All nodes that are neither group, shape nor light, each once, in document order. */
  public List<Node> otherNodes() {
    return List.copyOf(lists.otherNodes);
  }

  /** Triangles of all shapes shown: the polygon count of the scene in its present state. */
  public long shownPolygons() {
    return shownPolygons;
  }

  /**
   * Whether a part of the scene is left out: it contains itself, or is nested or multiplied beyond
   * measure.
   */
  public boolean cutOff() {
    return cutOff;
  }

  /** How many instances there may be; it depends on the memory that there is. */
  public long maxInstances() {
    return maxInstances;
  }

  /**
   * @param listener hears in {@link #update()} of each of the {@link #otherNodes()} whose places
   *     may be others now; the one and only listener
   */
  public void onMoved(Consumer<? super Node> listener) {
    onMoved = listener;
  }

  void plainMoved(Node node) {
    onMoved.accept(node);
  }

  void moved() {
    placementVersion++;
  }

  void polygonsShown(int more) {
    shownPolygons += more;
  }

  void judged(ShaderNode shader) {
    judged.add(shader);
  }

  void pending(GroupInstance group) {
    pendingGroups.add(group);
  }

  void pending(ShapeLook look) {
    pendingLooks.add(look);
  }

  /** The lists of shapes and lights are to be made anew at the end of the update. */
  void structureChanged() {
    structureChanged = true;
  }

  /** Applies what changed since the last call. */
  public void update() {
    for (int i = 0; i < pendingGroups.size(); i++) {
      pendingGroups.get(i).update();
    }
    pendingGroups.clear();
    for (int i = 0; i < pendingLooks.size(); i++) {
      pendingLooks.get(i).update();
      moved();
    }
    pendingLooks.clear();
    if (structureChanged) {
      collect();
    }
  }

  /**
   * Adapts LOD and Billboard nodes to the viewer; what the last picture found out of shaders is
   * told them. A node in two places follows the first. One in a place without extent (a scale of 0)
   * stays as it is.
   *
   * @param eye the viewer in world coordinates
   * @param up the viewer's up in world coordinates
   */
  public void view(Vector3dc eye, Vector3dc up, Cascade cascade) {
    if (!judged.isEmpty()) {
      judged.forEach(shader -> shader.tell(cascade));
      judged.clear();
    }
    for (int i = 0; i < lists.viewerDependent.size(); i++) {
      GroupInstance group = lists.viewerDependent.get(i);
      group.world().invert(inverse);
      inverse.transformPosition(eye, localEye);
      inverse.transformDirection(up, localUp);
      if (!localEye.isFinite() || !localUp.isFinite()) {
        continue;
      }
      GroupingNode.Effect effect =
          ((ViewerDependent) group.node()).view(localEye, localUp, cascade);
      if (effect != GroupingNode.Effect.NONE) {
        instances(group.node()).forEach(place -> ((GroupInstance) place).affected(effect));
      }
    }
  }

  /** Whether anything in it depends on the picture: {@link #see} does something. */
  public boolean dependsOnPicture() {
    return !lists.seenGroups.isEmpty() || !lists.screenShapes.isEmpty();
  }

  /**
   * Places what depends on the picture, each place by itself (X3D 4.0, clause 36). To be called
   * after the viewer has moved, and again where a picture of another size is drawn.
   */
  public void see(Sight now) {
    sight = now;
    for (GroupInstance group : lists.seenGroups) {
      if (group.see()) {
        group.moved(this);
        moved();
      }
    }
    for (ShapeInstance shape : lists.screenShapes) {
      if (shape.see(now)) {
        moved();
      }
    }
  }

  /** As of the last {@link #see}. */
  Sight sight() {
    return sight;
  }

  private Instance build(Node node, @Nullable GroupInstance parent, int depth) {
    instances++;
    if (node instanceof GroupingNode group) {
      GroupInstance instance = new GroupInstance(group, parent, this);
      group.addObserver(instance);
      instance.children = children(instance, depth, Map.of());
      if (group instanceof Deforming) {
        instance.affected(GroupingNode.Effect.FORM);
      }
      return instance;
    }
    if (node.type().name().equals("Shape") || node instanceof Formed) {
      ShapeLook look = looks.computeIfAbsent(node, shape -> new ShapeLook(shape, assets, this));
      ShapeInstance instance = new ShapeInstance(node, parent, look);
      look.instances.add(instance);
      instance.see(sight);
      return instance;
    }
    if (LightReader.isLight(node)) {
      LightInstance instance = new LightInstance(node, parent, this);
      node.addObserver(instance);
      return instance;
    }
    if (EffectInstance.isEffect(node)) {
      return new EffectInstance(node, parent, assets);
    }
    plainMoved(node); // It may have been in other places before.
    return new PlainInstance(node, parent);
  }

  /** Instances of a group's present children: those at hand for the node, and new ones. */
  private List<Instance> children(
      GroupInstance group, int depth, Map<Node, Deque<Instance>> atHand) {
    List<Node> nodes = group.node().children();
    if (nodes.isEmpty()) {
      return List.of();
    }
    if (depth > MAX_DEPTH || instances > maxInstances || group.insideItself()) {
      cutOff = true;
      return List.of();
    }
    List<Instance> children = new ArrayList<>(nodes.size());
    for (Node child : nodes) {
      Deque<Instance> known = atHand.get(child);
      Instance instance = known == null ? null : known.poll();
      children.add(instance == null ? build(child, group, depth + 1) : instance);
    }
    return children;
  }

  /** Gives a group the instances of its present children; those that stay keep theirs. */
  void rebuild(GroupInstance group) {
    Map<Node, Deque<Instance>> before = new IdentityHashMap<>();
    for (Instance child : group.children) {
      before.computeIfAbsent(child.node(), node -> new ArrayDeque<>(1)).add(child);
    }
    int depth = 0;
    for (GroupInstance above = group.parent(); above != null; above = above.parent()) {
      depth++;
    }
    group.children = children(group, depth, before);
    before.values().forEach(gone -> gone.forEach(this::dispose));
    if (group.elsewhere()) { // An Inline whose new content has another unit of length.
      group.moved(this);
    }
    group.choose();
    structureChanged = true;
  }

  /** Nothing is shown any more, and no node has it as an observer. */
  public void close() {
    dispose(root);
  }

  private void dispose(Instance instance) {
    instances--;
    instance.show(false, this);
    if (instance instanceof GroupInstance group) {
      group.disposed = true;
      group.children.forEach(this::dispose);
      group.node().removeObserver(group);
    } else if (instance instanceof ShapeInstance shape) {
      shape.look().instances.remove(shape);
      if (shape.look().instances.isEmpty()) {
        shape.look().dispose();
        looks.remove(shape.node());
      }
    } else if (instance instanceof LightInstance light) {
      light.node().removeObserver(light);
    } else if (instance instanceof PlainInstance) {
      plainMoved(instance.node());
    }
  }

  private void collect() {
    lists.collect(root);
    LightScopes.tell(root, lists);
    structureVersion++;
    structureChanged = false;
  }
}
