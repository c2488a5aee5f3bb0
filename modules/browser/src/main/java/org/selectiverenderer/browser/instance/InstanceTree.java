package org.selectiverenderer.browser.instance;

import java.util.ArrayDeque;
import java.util.ArrayList;
import java.util.Comparator;
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
import org.selectiverenderer.browser.nodes.group.Deformer;
import org.selectiverenderer.browser.nodes.group.GroupingNode;
import org.selectiverenderer.browser.nodes.group.ViewerDependentNode;
import org.selectiverenderer.browser.nodes.layout.ViewParameters;
import org.selectiverenderer.browser.nodes.shader.ShaderNode;
import org.selectiverenderer.browser.scene.EventCascade;
import org.selectiverenderer.browser.scene.Node;
import org.selectiverenderer.browser.scene.NodeTemplate;
import org.selectiverenderer.browser.scene.ProceduralShape;

/**
 * The tree of all instances of a scene: one instance for every path from the root to a node,
 * Inlines included. Changes of nodes are collected and applied by {@link #update()}. The cost of a
 * changed Switch is its old and new child, that of a Transform the instances below it, that of
 * added or removed children these children and one pass over the tree, which rebuilds the lists.
 *
 * <p>All versions of an object are in the tree, shown or hidden, so that switching creates no
 * instances.
 */
public final class InstanceTree {
  /**
   * Nesting depth beyond which the scene is cut off: the 1000 nodes that loading allows, plus the
   * groups that hold the scenes of Inlines.
   */
  static final int MAX_DEPTH = 1300;

  /**
   * Number of instances beyond which groups stay empty, since nested USEs multiply without bound.
   */
  private static final long MAX_INSTANCES = 16_000_000;

  /** Bytes of heap required per instance. */
  private static final long BYTES_PER_INSTANCE = 512;

  private final long maxInstances =
      Math.min(MAX_INSTANCES, Runtime.getRuntime().maxMemory() / BYTES_PER_INSTANCE);
  private final AssetProvider assets;
  private final GroupInstance root;

  /** The reading that Shapes of the same template share if they are added at the same time. */
  private final Map<NodeTemplate, ShapeReading> readings = new IdentityHashMap<>();

  private final InstanceIndex lists = new InstanceIndex();
  private final List<GroupInstance> pendingGroups = new ArrayList<>();
  private final List<SharedShapeState> pendingLooks = new ArrayList<>();
  private final ShapeChanges changes = new ShapeChanges();
  private final ShapeTree boxes = new ShapeTree(this);
  private final VersionFades fades = new VersionFades(this);
  private final Set<ShaderNode> judged = new LinkedHashSet<>();
  private final Matrix4d inverse = new Matrix4d();
  private final Vector3d localEye = new Vector3d();
  private final Vector3d localUp = new Vector3d();
  private long structureVersion;
  private long placementVersion;
  private long choiceVersion;
  private long lightVersion;
  private boolean structureChanged = true;
  private Consumer<? super Node> onMoved = node -> {};
  private Runnable onStructure = () -> {};
  private boolean cutOff;
  private ViewParameters sight = ViewParameters.NONE;
  private int instances;
  private long shownPolygons;

  /**
   * @param rootNode the scene's root group
   */
  public InstanceTree(GroupingNode rootNode, AssetProvider assets) {
    this.assets = assets;
    root = (GroupInstance) build(rootNode, null, 0);
    root.show(true, this);
    collect();
  }

  AssetProvider assets() {
    return assets;
  }

  public GroupInstance root() {
    return root;
  }

  /**
   * Returns all shapes, shown or hidden, in document order; the same list object until the
   * structure changes.
   */
  public List<ShapeInstance> shapes() {
    return lists.shapes;
  }

  /** Returns the log of shapes that have moved, changed or come to be shown. */
  public ShapeChanges changes() {
    return changes;
  }

  /** Returns the hierarchy of the boxes of all shapes. */
  public ShapeTree boxes() {
    return boxes;
  }

  /** Returns the cross-fades of Switches, which begin by request only. */
  public VersionFades fades() {
    return fades;
  }

  /** Returns a number that changes when a shape or a light is added or removed. */
  public long structureVersion() {
    return structureVersion;
  }

  /** Returns a number that changes when a shape may have moved or got another mesh. */
  public long placementVersion() {
    return placementVersion;
  }

  /** Returns a number that changes when a group may show other children or let others be picked. */
  public long choiceVersion() {
    return choiceVersion;
  }

  /**
   * Returns a number that changes when a light may have changed, moved, or been shown or hidden.
   */
  public long lightVersion() {
    return lightVersion;
  }

  void lightChanged() {
    lightVersion++;
  }

  void chosen() {
    choiceVersion++;
  }

  /** Returns all lights, on or off, in document order. */
  public List<LightInstance> lights() {
    return List.copyOf(lists.lights);
  }

  /** Returns the instances of a node in document order; empty if it is in no part of the scene. */
  public List<Instance> instances(Node node) {
    return lists.instances(node);
  }

  /**
   * Returns the matrices {@link Instance#world()} of a node's instances, in document order; a live
   * view that costs nothing to get.
   */
  public List<Matrix4dc> places(Node node) {
    return lists.places(node);
  }

  /** Returns all nodes that are neither group, shape nor light, each once, in document order. */
  public List<Node> otherNodes() {
    return List.copyOf(lists.otherNodes);
  }

  /**
   * Returns the number of triangles of all shapes shown: the polygon count of the scene in its
   * present state.
   */
  public long shownPolygons() {
    return shownPolygons;
  }

  /**
   * Returns whether a part of the scene is left out, because the scene contains itself, is nested
   * too deeply or has too many instances.
   */
  public boolean cutOff() {
    return cutOff;
  }

  /** Returns the largest number of instances; it depends on the available heap. */
  public long maxInstances() {
    return maxInstances;
  }

  /**
   * @param listener called in {@link #update()} for each of the {@link #otherNodes()} that may have
   *     moved; there is only one listener
   */
  public void onMoved(Consumer<? super Node> listener) {
    onMoved = listener;
  }

  /**
   * Sets the listener for changes of the structure.
   *
   * @param listener called at once when a group of the scene gets other children, before the tree
   *     follows; there is only one listener
   */
  public void onStructure(Runnable listener) {
    onStructure = listener;
  }

  void structureChanges() {
    onStructure.run();
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

  void pending(SharedShapeState look) {
    pendingLooks.add(look);
  }

  /** Requests that the lists of shapes and lights be rebuilt at the end of the update. */
  void structureChanged() {
    structureChanged = true;
  }

  /** Applies the changes since the last call. */
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
   * Adapts LOD and Billboard nodes to the viewer, and tells shader nodes the results of the last
   * picture. A node with two instances follows the first. A node under a scale of 0 stays as it is.
   *
   * @param eye the viewer in world coordinates
   * @param up the viewer's up in world coordinates
   */
  public void view(Vector3dc eye, Vector3dc up, EventCascade cascade) {
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
          ((ViewerDependentNode) group.node()).view(localEye, localUp, cascade);
      if (effect != GroupingNode.Effect.NONE) {
        instances(group.node()).forEach(place -> ((GroupInstance) place).affected(effect));
      }
    }
  }

  /**
   * Returns whether the layout of any node depends on the picture, so that {@link #see} has an
   * effect.
   */
  public boolean dependsOnPicture() {
    return !lists.seenGroups.isEmpty() || !lists.screenShapes.isEmpty();
  }

  /**
   * Places the nodes whose layout depends on the picture, each instance separately (X3D 4.0, clause
   * 36). To be called after the viewer has moved, and again for a picture of another size.
   */
  public void see(ViewParameters now) {
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
        changes.add(shape);
      }
    }
  }

  /** Returns the view parameters of the last {@link #see}. */
  ViewParameters sight() {
    return sight;
  }

  private Instance build(Node node, @Nullable GroupInstance parent, int depth) {
    instances++;
    if (node instanceof GroupingNode group) {
      GroupInstance instance = new GroupInstance(group, parent, this);
      group.addObserver(instance);
      instance.children = children(instance, depth, Map.of());
      if (group instanceof Deformer) {
        instance.affected(GroupingNode.Effect.FORM);
      }
      return instance;
    }
    if (node.type().name().equals("Shape") || node instanceof ProceduralShape) {
      SharedShapeState look = SharedShapeState.of(node, this);
      look = look != null ? look : new SharedShapeState(node, this, readings);
      ShapeInstance instance = new ShapeInstance(node, parent, look);
      look.add(instance);
      instance.see(sight);
      return instance;
    }
    if (LightReader.isLight(node)) {
      LightInstance instance = new LightInstance(node, parent, this);
      node.addObserver(instance);
      return instance;
    }
    if (ScopedEffectInstance.isEffect(node)) {
      return new ScopedEffectInstance(node, parent, assets);
    }
    plainMoved(node); // The node may have been elsewhere before.
    return new NonVisualInstance(node, parent);
  }

  /**
   * Returns the instances of a group's present children: existing ones where there are some, else
   * new ones.
   */
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
    if (nodes.size() == 1) {
      return List.of(child(nodes.get(0), group, depth, atHand)); // smaller, and very many are
    }
    List<Instance> children = new ArrayList<>(nodes.size());
    for (Node child : nodes) {
      children.add(child(child, group, depth, atHand));
    }
    return children;
  }

  private Instance child(
      Node node, GroupInstance group, int depth, Map<Node, Deque<Instance>> atHand) {
    Deque<Instance> known = atHand.get(node);
    Instance instance = known == null ? null : known.poll();
    return instance == null ? build(node, group, depth + 1) : instance;
  }

  /**
   * Notes at a group, or null, and at all above it that what is in them has become another.
   *
   * @return how many groups these are
   */
  int markRestructured(@Nullable GroupInstance group) {
    int count = 0;
    for (GroupInstance each = group; each != null; each = each.parent()) {
      each.restructured = structureVersion + 1;
      count++;
    }
    return count;
  }

  /** Rebuilds the instances of a group's children; children that stay keep their instances. */
  void rebuild(GroupInstance group) {
    Map<Node, Deque<Instance>> before = new IdentityHashMap<>();
    for (Instance child : group.children) {
      before.computeIfAbsent(child.node(), node -> new ArrayDeque<>(1)).add(child);
    }
    group.children = children(group, markRestructured(group) - 1, before);
    before.values().forEach(gone -> gone.forEach(this::dispose));
    if (group.elsewhere()) { // The new content of an Inline may have another unit of length.
      group.moved(this);
    }
    group.choose();
    structureChanged = true;
  }

  /** Hides everything and stops observing all nodes. */
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
      shape.look().remove(shape);
      if (shape.look().unused()) {
        shape.look().dispose();
      }
    } else if (instance instanceof LightInstance light) {
      light.node().removeObserver(light);
    } else if (instance instanceof NonVisualInstance) {
      plainMoved(instance.node());
    }
  }

  private void collect() {
    lists.collect(root, instances);
    LightScopeResolver.tell(root, lists);
    changes.forget();
    readings.clear();
    structureVersion++;
    structureChanged = false;
  }

  /**
   * Assigns to every shape the lights that reach it, in document order, and the effects (fog, clip
   * planes, environment lights) whose scope it is in; siblings share both.
   */
  private static final class LightScopeResolver {
    private final Comparator<LightInstance> order;

    private LightScopeResolver(List<LightInstance> lights) {
      Map<LightInstance, Integer> numbers = new IdentityHashMap<>();
      lights.forEach(light -> numbers.put(light, numbers.size()));
      order = Comparator.comparing(numbers::get);
    }

    /**
     * Assigns lights and effects to all shapes of a tree.
     *
     * @param lists the instances of the tree by kind
     */
    static void tell(GroupInstance root, InstanceIndex lists) {
      List<LightInstance> global =
          lists.lights.stream().filter(light -> light.light().global()).toList();
      new LightScopeResolver(lists.lights).tell(root, global, ScopedEffects.of(lists.environments));
    }

    private void tell(GroupInstance group, List<LightInstance> above, ScopedEffects around) {
      List<LightInstance> reaching = group.lit(above, order);
      ScopedEffects within = around.within(group.children);
      for (Instance child : group.children) {
        if (child instanceof GroupInstance below) {
          tell(below, reaching, within);
        } else if (child instanceof ShapeInstance shape) {
          shape.light(reaching);
          shape.surround(within);
        }
      }
    }
  }
}
