package org.selectiverenderer.browser.instance;

import java.util.AbstractList;
import java.util.ArrayList;
import java.util.Collections;
import java.util.IdentityHashMap;
import java.util.List;
import java.util.Map;
import java.util.RandomAccess;
import org.joml.Matrix4dc;
import org.selectiverenderer.browser.nodes.group.ViewerDependentNode;
import org.selectiverenderer.browser.nodes.layout.ViewDependentLayout;
import org.selectiverenderer.browser.scene.Node;

/**
 * Lists of the instances of an {@link InstanceTree} by kind, in document order. They are rebuilt in
 * one pass over the tree when its structure changes.
 */
final class InstanceIndex {
  /**
   * For each node its only instance, or a {@link NodeInstances}: a street of copies has hundreds of
   * thousands of nodes with one instance each.
   */
  private Map<Node, Object> places = new IdentityHashMap<>();

  /** The nodes that are neither group, shape nor light, each once. */
  final List<Node> otherNodes = new ArrayList<>();

  /** The groups that depend on the viewer's position; the first instance of each. */
  final List<GroupInstance> viewerDependent = new ArrayList<>();

  /** The groups whose layout depends on the size of the picture. */
  final List<GroupInstance> seenGroups = new ArrayList<>();

  /** The shapes that are measured in pixels. */
  final List<ShapeInstance> screenShapes = new ArrayList<>();

  final List<LightInstance> lights = new ArrayList<>();

  /** The EnvironmentLights. */
  final List<ScopedEffectInstance> environments = new ArrayList<>();

  /** All shapes; an immutable list, replaced when it is rebuilt. */
  List<ShapeInstance> shapes = List.of();

  /**
   * Rebuilds all lists.
   *
   * @param instances about how many there are
   */
  void collect(GroupInstance root, int instances) {
    places = new IdentityHashMap<>(Math.max(1, instances)); // To grow takes longer than to fill it.
    otherNodes.clear();
    viewerDependent.clear();
    seenGroups.clear();
    screenShapes.clear();
    lights.clear();
    environments.clear();
    List<ShapeInstance> all = new ArrayList<>();
    add(root, all);
    shapes = List.copyOf(all);
  }

  private void add(Instance instance, List<ShapeInstance> all) {
    Object known = places.putIfAbsent(instance.node(), instance);
    boolean first = known == null;
    if (known != null) {
      several(instance.node(), known).append(instance);
    }
    if (instance instanceof GroupInstance group) {
      if (first && group.node() instanceof ViewerDependentNode) {
        viewerDependent.add(group);
      }
      if (group.node() instanceof ViewDependentLayout) {
        seenGroups.add(group);
      }
      List<Instance> children = group.children;
      for (int i = 0; i < children.size(); i++) {
        add(children.get(i), all);
      }
    } else if (instance instanceof ShapeInstance shape) {
      shape.index = all.size();
      all.add(shape);
      if (shape.look().onScreen()) {
        screenShapes.add(shape);
      }
    } else if (instance instanceof LightInstance light) {
      lights.add(light);
    } else if (instance instanceof ScopedEffectInstance effect && effect.environment()) {
      environments.add(effect);
    } else if (first && instance instanceof NonVisualInstance) {
      otherNodes.add(instance.node());
    }
  }

  /** Returns the instances of a node; empty if it is in no part of the scene. */
  List<Instance> instances(Node node) {
    Object known = places.get(node);
    if (known instanceof Instance only) {
      return List.of(only);
    }
    return known == null ? List.of() : ((NodeInstances) known).instances();
  }

  /** Returns a view of the matrices {@link Instance#world()} of a node's instances. */
  List<Matrix4dc> places(Node node) {
    Object known = places.get(node);
    return known == null ? List.of() : several(node, known);
  }

  /** Returns the list of a node's instances, which is made when it is first needed. */
  private NodeInstances several(Node node, Object known) {
    if (known instanceof NodeInstances list) {
      return list;
    }
    NodeInstances made = new NodeInstances();
    made.append((Instance) known);
    places.put(node, made);
    return made;
  }

  /** The instances of a node, which is also a list of their world matrices. */
  private static final class NodeInstances extends AbstractList<Matrix4dc> implements RandomAccess {
    private final List<Instance> instances = new ArrayList<>(1);
    private final List<Instance> view = Collections.unmodifiableList(instances);

    void append(Instance instance) {
      instances.add(instance);
    }

    List<Instance> instances() {
      return view;
    }

    @Override
    public Matrix4dc get(int index) {
      return instances.get(index).world();
    }

    @Override
    public int size() {
      return instances.size();
    }
  }
}
