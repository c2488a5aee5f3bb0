package org.selectiverenderer.control;

import java.util.ArrayDeque;
import java.util.ArrayList;
import java.util.Deque;
import java.util.HashMap;
import java.util.List;
import java.util.Map;
import java.util.function.Predicate;
import org.web3d.x3d.sai.MFNode;
import org.web3d.x3d.sai.SFNode;
import org.web3d.x3d.sai.X3DAppearanceChildNode;
import org.web3d.x3d.sai.X3DAppearanceNode;
import org.web3d.x3d.sai.X3DExecutionContext;
import org.web3d.x3d.sai.X3DField;
import org.web3d.x3d.sai.X3DFieldDefinition;
import org.web3d.x3d.sai.X3DFieldEventListener;
import org.web3d.x3d.sai.X3DFieldTypes;
import org.web3d.x3d.sai.X3DFontStyleNode;
import org.web3d.x3d.sai.X3DGeometricPropertyNode;
import org.web3d.x3d.sai.X3DGeometryNode;
import org.web3d.x3d.sai.X3DLightNode;
import org.web3d.x3d.sai.X3DMetadataObject;
import org.web3d.x3d.sai.X3DNode;
import org.web3d.x3d.sai.X3DShapeNode;

/**
 * Finds nodes in a scene and keeps finding them as the scene changes. It follows every field that
 * holds nodes, whatever its name, except metadata and what no Switch or sensor can stand in
 * (shapes, appearances, geometry, lights). A node that stands in several places is found once and
 * lost when it has left the last one; nodes that hold themselves do not disturb.
 *
 * <p>The SAI sends no event when a node is added at the top of the scene: call {@link #rescan}.
 */
final class SceneWatch {
  /** Hears which nodes have come and gone. */
  interface Listener {
    /**
     * The scene changed.
     *
     * @param found wanted nodes that are there now, in the order of the scene
     * @param lost wanted nodes that are there no more
     * @param time stamp in seconds
     */
    void changed(List<X3DNode> found, List<X3DNode> lost, double time);
  }

  private final X3DExecutionContext scene;
  private final Predicate<X3DNode> wanted;
  private final Listener listener;
  private final Map<X3DNode, Place> places = new HashMap<>();
  private List<X3DNode> roots = List.of();

  /** Walks nothing yet; see {@link #rescan}. */
  SceneWatch(X3DExecutionContext scene, Predicate<X3DNode> wanted, Listener listener) {
    this.scene = scene;
    this.wanted = wanted;
    this.listener = listener;
  }

  /**
   * Walks the scene, or looks whether the nodes at its top are still the same.
   *
   * @param time for the listener
   */
  void rescan(double time) {
    List<X3DNode> before = roots;
    roots = List.of(scene.getRootNodes());
    replace(before, roots, time);
  }

  /** Ends the walk without a word to the listener. */
  void close() {
    places.values().forEach(Place::close);
    places.clear();
    roots = List.of();
  }

  private void replace(List<X3DNode> before, List<X3DNode> after, double time) {
    List<X3DNode> found = new ArrayList<>();
    List<X3DNode> lost = new ArrayList<>();
    retain(after, found);
    release(before, lost);
    if (!found.isEmpty() || !lost.isEmpty()) {
      listener.changed(found, lost, time);
    }
  }

  private void retain(List<X3DNode> nodes, List<X3DNode> found) {
    Deque<X3DNode> pending = new ArrayDeque<>();
    pushReversed(pending, nodes);
    while (!pending.isEmpty()) {
      X3DNode node = pending.pop();
      if (isLeaf(node)) {
        continue;
      }
      Place place = places.get(node);
      if (place == null) {
        place = new Place(node);
        places.put(node, place);
        if (wanted.test(node)) {
          found.add(node);
        }
        place.open();
        pushReversed(pending, place.children());
      }
      place.uses++;
    }
  }

  private void release(List<X3DNode> nodes, List<X3DNode> lost) {
    Deque<X3DNode> pending = new ArrayDeque<>();
    pushReversed(pending, nodes);
    while (!pending.isEmpty()) {
      X3DNode node = pending.pop();
      Place place = places.get(node);
      if (place != null && --place.uses == 0) {
        places.remove(node);
        place.close();
        if (wanted.test(node)) {
          lost.add(node);
        }
        pushReversed(pending, place.children());
      }
    }
  }

  private static void pushReversed(Deque<X3DNode> stack, List<X3DNode> nodes) {
    for (int i = nodes.size() - 1; i >= 0; i--) {
      stack.push(nodes.get(i));
    }
  }

  private static boolean isLeaf(X3DNode node) {
    return node instanceof X3DShapeNode
        || node instanceof X3DAppearanceNode
        || node instanceof X3DAppearanceChildNode
        || node instanceof X3DGeometryNode
        || node instanceof X3DGeometricPropertyNode
        || node instanceof X3DFontStyleNode
        || node instanceof X3DLightNode
        || node instanceof X3DMetadataObject;
  }

  private static List<X3DNode> read(X3DField field) {
    if (field instanceof MFNode nodes) {
      X3DNode[] array = new X3DNode[nodes.getSize()];
      nodes.getValue(array);
      List<X3DNode> found = new ArrayList<>(array.length);
      for (X3DNode node : array) {
        if (node != null) {
          found.add(node);
        }
      }
      return List.copyOf(found);
    }
    X3DNode node = ((SFNode) field).getValue();
    return node == null ? List.of() : List.of(node);
  }

  /** A node of the scene with the fields that hold other nodes. */
  private final class Place {
    final X3DNode node;
    List<Branch> branches = List.of();
    int uses;

    Place(X3DNode node) {
      this.node = node;
    }

    void open() {
      List<Branch> found = new ArrayList<>();
      for (X3DFieldDefinition definition : node.getFieldDefinitions()) {
        int type = definition.getFieldType();
        if ((type == X3DFieldTypes.SFNODE || type == X3DFieldTypes.MFNODE)
            && definition.getAccessType() != X3DFieldTypes.INPUT_ONLY
            && !definition.getName().equals("metadata")) {
          found.add(new Branch(node.getField(definition.getName())));
        }
      }
      branches = List.copyOf(found);
    }

    List<X3DNode> children() {
      if (branches.size() == 1) {
        return branches.get(0).children;
      }
      List<X3DNode> all = new ArrayList<>();
      branches.forEach(branch -> all.addAll(branch.children));
      return all;
    }

    void close() {
      branches.forEach(Branch::close);
    }
  }

  /** A field that holds nodes. */
  private final class Branch {
    final X3DField field;
    final X3DFieldEventListener onChange = event -> changed(event.getTime());
    List<X3DNode> children;

    Branch(X3DField field) {
      this.field = field;
      this.children = read(field);
      if (field.getDefinition().getAccessType() != X3DFieldTypes.INITIALIZE_ONLY) {
        field.addX3DEventListener(onChange);
      }
    }

    void changed(double time) {
      List<X3DNode> before = children;
      children = read(field);
      replace(before, children, time);
    }

    void close() {
      FieldRelease.remove(field, onChange);
    }
  }
}
