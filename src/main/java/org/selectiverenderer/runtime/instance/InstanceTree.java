package org.selectiverenderer.runtime.instance;

import java.util.ArrayList;
import java.util.IdentityHashMap;
import java.util.List;
import java.util.Map;
import org.joml.Matrix4d;
import org.joml.Vector3d;
import org.joml.Vector3dc;
import org.jspecify.annotations.Nullable;
import org.selectiverenderer.runtime.nodes.GroupingNode;
import org.selectiverenderer.runtime.nodes.ViewerDependent;
import org.selectiverenderer.runtime.scene.Cascade;
import org.selectiverenderer.runtime.scene.Node;

/**
 * Every path from the root of a scene to its nodes, Inlines included. Changes of nodes are
 * collected and applied by {@link #update()}: a Switch costs its old and new child, a Transform
 * what is below it, other children the group that got them.
 *
 * <p>All versions of an object are in the tree, shown or not, so that switching makes nothing new.
 */
public final class InstanceTree {
  private final Assets assets;
  private final GroupInstance root;
  private final Map<Node, ShapeLook> looks = new IdentityHashMap<>();
  private final Map<Node, List<Occurrence>> occurrences = new IdentityHashMap<>();
  private final List<GroupInstance> viewerDependent = new ArrayList<>();
  private final List<GroupInstance> pendingGroups = new ArrayList<>();
  private final List<ShapeLook> pendingLooks = new ArrayList<>();
  private final List<LightInstance> lights = new ArrayList<>();
  private List<ShapeInstance> shapes = List.of();
  private long structureVersion;
  private long placementVersion;
  private boolean structureChanged = true;
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
    return shapes;
  }

  /** Changes when {@link #shapes()} or the lights gain or lose an element. */
  public long structureVersion() {
    return structureVersion;
  }

  /** Changes when a shape may have moved or may have got another mesh. */
  public long placementVersion() {
    return placementVersion;
  }

  /** All lights, on or off. */
  public List<LightInstance> lights() {
    return List.copyOf(lights);
  }

  /** The places of a node that is neither group, shape nor light. */
  public List<Occurrence> occurrences(Node node) {
    return occurrences.getOrDefault(node, List.of());
  }

  /** All nodes that are neither group, shape nor light. */
  public Iterable<Node> otherNodes() {
    return occurrences.keySet();
  }

  /** Triangles of all shapes shown: the polygon count of the scene in its present state. */
  public long shownPolygons() {
    return shownPolygons;
  }

  void moved() {
    placementVersion++;
  }

  void polygonsShown(int more) {
    shownPolygons += more;
  }

  void pending(GroupInstance group) {
    pendingGroups.add(group);
  }

  void pending(ShapeLook look) {
    pendingLooks.add(look);
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
   * Adapts LOD and Billboard nodes to the viewer. A node in two places follows the first.
   *
   * @param eye the viewer in world coordinates
   */
  public void view(Vector3dc eye, Cascade cascade) {
    for (GroupInstance group : viewerDependent) {
      Vector3d local = group.world().invert(new Matrix4d()).transformPosition(eye, new Vector3d());
      GroupingNode.Effect effect = ((ViewerDependent) group.node()).view(local, cascade);
      if (effect != GroupingNode.Effect.NONE) {
        group.affected(effect);
      }
    }
  }

  private Instance build(Node node, @Nullable GroupInstance parent, int depth) {
    if (node instanceof GroupingNode group) {
      GroupInstance instance = new GroupInstance(group, parent, this);
      group.addObserver(instance);
      if (group instanceof ViewerDependent) {
        viewerDependent.add(instance);
      }
      fill(instance, depth);
      return instance;
    }
    if (node.type().is("X3DShapeNode") && node.type().name().equals("Shape")) {
      ShapeLook look = looks.computeIfAbsent(node, shape -> new ShapeLook(shape, assets, this));
      ShapeInstance instance = new ShapeInstance(node, parent, look);
      look.instances.add(instance);
      return instance;
    }
    if (LightReader.isLight(node)) {
      LightInstance instance = new LightInstance(node, parent);
      node.addObserver(instance);
      return instance;
    }
    Occurrence occurrence = new Occurrence(node, parent);
    occurrences.computeIfAbsent(node, key -> new ArrayList<>(1)).add(occurrence);
    return occurrence;
  }

  /** Nesting beyond which a scene that contains itself is cut off. */
  private static final int MAX_DEPTH = 1000;

  private void fill(GroupInstance group, int depth) {
    if (depth > MAX_DEPTH) {
      return;
    }
    List<Node> nodes = group.node().children();
    List<Instance> children = new ArrayList<>(nodes.size());
    for (Node child : nodes) {
      children.add(build(child, group, depth + 1));
    }
    group.children = children;
  }

  /** Gives a group the instances of its present children. */
  void rebuild(GroupInstance group) {
    group.children.forEach(this::dispose);
    int depth = 0;
    for (GroupInstance above = group.parent(); above != null; above = above.parent()) {
      depth++;
    }
    group.moved(this);
    fill(group, depth);
    group.choose();
    structureChanged = true;
  }

  private void dispose(Instance instance) {
    instance.show(false, this);
    if (instance instanceof GroupInstance group) {
      group.children.forEach(this::dispose);
      group.node().removeObserver(group);
      viewerDependent.remove(group);
    } else if (instance instanceof ShapeInstance shape) {
      shape.look().instances.remove(shape);
      if (shape.look().instances.isEmpty()) {
        shape.look().dispose();
        looks.remove(shape.node());
      }
    } else if (instance instanceof LightInstance light) {
      light.node().removeObserver(light);
    } else {
      occurrences.computeIfPresent(
          instance.node(),
          (node, list) -> {
            list.remove(instance);
            return list.isEmpty() ? null : list;
          });
    }
  }

  private void collect() {
    List<ShapeInstance> all = new ArrayList<>();
    lights.clear();
    collect(root, all);
    for (ShapeInstance shape : all) {
      shape.light(lights.stream().filter(light -> light.reaches(shape)).toList());
    }
    shapes = List.copyOf(all);
    structureVersion++;
    structureChanged = false;
  }

  private void collect(Instance instance, List<ShapeInstance> all) {
    if (instance instanceof GroupInstance group) {
      group.children.forEach(child -> collect(child, all));
    } else if (instance instanceof ShapeInstance shape) {
      all.add(shape);
    } else if (instance instanceof LightInstance light) {
      lights.add(light);
    }
  }
}
