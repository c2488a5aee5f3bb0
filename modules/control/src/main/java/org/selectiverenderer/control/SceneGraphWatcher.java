package org.selectiverenderer.control;

import java.util.ArrayDeque;
import java.util.ArrayList;
import java.util.Deque;
import java.util.HashMap;
import java.util.HashSet;
import java.util.List;
import java.util.Map;
import java.util.Set;
import java.util.function.Predicate;
import java.util.function.UnaryOperator;
import org.jspecify.annotations.Nullable;
import org.selectiverenderer.sai.InlineSceneAccess;
import org.selectiverenderer.sai.NodeNameAccess;
import org.web3d.x3d.sai.MFNode;
import org.web3d.x3d.sai.SFNode;
import org.web3d.x3d.sai.X3DAppearanceChildNode;
import org.web3d.x3d.sai.X3DAppearanceNode;
import org.web3d.x3d.sai.X3DExecutionContext;
import org.web3d.x3d.sai.X3DField;
import org.web3d.x3d.sai.X3DFieldDefinition;
import org.web3d.x3d.sai.X3DFieldEvent;
import org.web3d.x3d.sai.X3DFieldEventListener;
import org.web3d.x3d.sai.X3DFieldTypes;
import org.web3d.x3d.sai.X3DFontStyleNode;
import org.web3d.x3d.sai.X3DGeometricPropertyNode;
import org.web3d.x3d.sai.X3DGeometryNode;
import org.web3d.x3d.sai.X3DGroupingNode;
import org.web3d.x3d.sai.X3DLightNode;
import org.web3d.x3d.sai.X3DMetadataObject;
import org.web3d.x3d.sai.X3DNode;
import org.web3d.x3d.sai.X3DProtoInstance;
import org.web3d.x3d.sai.X3DShapeNode;
import org.web3d.x3d.sai.networking.Inline;

/**
 * Finds nodes of certain types in a scene graph and reports changes. It traverses every field that
 * holds nodes, whatever its name, except metadata and nodes that cannot contain a Switch or sensor
 * (shapes, appearances, geometry, lights); and the scenes of Inlines, if the browser gives access
 * to them. A node that is used several times is found once and lost when its last use is removed;
 * cycles are allowed.
 *
 * <p>The SAI sends no event when a root node is added to the scene: call {@link #rescan}.
 */
final class SceneGraphWatcher {
  /** Receives the nodes that were found and lost. */
  interface Listener {
    /**
     * The scene changed.
     *
     * @param found wanted nodes that were added, in the order of the scene
     * @param lost wanted nodes that were removed
     * @param time stamp in seconds
     */
    void changed(List<Found> found, List<X3DNode> lost, double time);

    /** Nodes were added, removed or loaded, wanted ones or others. */
    default void nodesChanged() {}
  }

  /**
   * A wanted node.
   *
   * @param scope the scene that contains it
   */
  record Found(X3DNode node, SceneScope scope) {}

  private final SceneScope main;
  private final @Nullable InlineSceneAccess inlined;
  private final Set<String> wanted;
  private final ListenerLock turn;
  private final Listener listener;
  private final Map<X3DNode, Place> places = new HashMap<>();
  private final ChildSource.Listener onChildren = this::replace;
  private List<X3DNode> roots = List.of();

  /** The names of the fields with children, by type of grouping node. */
  private final Map<String, List<String>> childFields = new HashMap<>();

  /**
   * Makes a watcher that traverses the scene with the first {@link #rescan}.
   *
   * @param wanted names of node types
   * @param inlined gives access to the scenes of Inlines; null where the browser does not
   * @param bodies maps prototype instances to the first nodes of their bodies, and other nodes to
   *     themselves
   * @param names tells the names of nodes; null where the browser does not
   */
  SceneGraphWatcher(
      X3DExecutionContext scene,
      @Nullable InlineSceneAccess inlined,
      UnaryOperator<X3DNode> bodies,
      @Nullable NodeNameAccess names,
      Set<String> wanted,
      ListenerLock turn,
      Listener listener) {
    this.main = new SceneScope(scene, bodies, names);
    this.inlined = inlined;
    this.wanted = wanted;
    this.turn = turn;
    this.listener = listener;
  }

  /**
   * Traverses the scene the first time; later looks for changes of its root nodes.
   *
   * @param time the time stamp for the listener
   */
  void rescan(double time) {
    List<X3DNode> before = roots;
    roots = main.opened(main.scene().getRootNodes());
    replace(main, before, roots, time);
  }

  /** Returns the Inlines of the main scene that are not descendants of certain nodes. */
  List<X3DNode> inlinesOutside(Predicate<X3DNode> within) {
    List<X3DNode> outside = new ArrayList<>();
    Set<X3DNode> seen = new HashSet<>();
    Deque<X3DNode> pending = new ArrayDeque<>();
    pushReversed(pending, roots);
    while (!pending.isEmpty()) {
      X3DNode node = pending.pop();
      Place place = places.get(node);
      if (place == null || within.test(node) || !seen.add(node)) {
        continue;
      }
      if (node instanceof Inline) {
        outside.add(node);
      } else {
        pushReversed(pending, place.children());
      }
    }
    return outside;
  }

  /** Stops listening, without calling the listener. */
  void close() {
    places.values().forEach(Place::close);
    places.clear();
    roots = List.of();
  }

  private void replace(SceneScope scope, List<X3DNode> before, List<X3DNode> after, double time) {
    List<Found> found = new ArrayList<>();
    List<X3DNode> lost = new ArrayList<>();
    retain(scope, after, found);
    release(before, lost);
    listener.nodesChanged();
    if (!found.isEmpty() || !lost.isEmpty()) {
      listener.changed(found, lost, time);
    }
  }

  private void retain(SceneScope scope, List<X3DNode> nodes, List<Found> found) {
    Deque<Found> pending = new ArrayDeque<>();
    pushReversed(pending, scope, nodes);
    while (!pending.isEmpty()) {
      Found next = pending.pop();
      X3DNode node = next.node();
      if (isLeaf(node)) {
        continue;
      }
      Place place = places.get(node);
      if (place == null) {
        place = new Place(node, next.scope());
        places.put(node, place);
        if (wanted.contains(node.getNodeName())) {
          found.add(next);
        }
        for (ChildSource branch : place.branches) {
          branch.open();
        }
        for (int i = place.branches.size() - 1; i >= 0; i--) {
          ChildSource branch = place.branches.get(i);
          pushReversed(pending, branch.scope(), branch.children());
        }
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
        if (wanted.contains(node.getNodeName())) {
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

  private static void pushReversed(Deque<Found> stack, SceneScope scope, List<X3DNode> nodes) {
    for (int i = nodes.size() - 1; i >= 0; i--) {
      stack.push(new Found(nodes.get(i), scope));
    }
  }

  /** Returns the names of the fields whose nodes are traversed. */
  private List<String> childFields(X3DNode node) {
    boolean known = node instanceof X3DGroupingNode && !(node instanceof X3DProtoInstance);
    return known // Other nodes, such as Scripts, may have fields of their own.
        ? childFields.computeIfAbsent(node.getNodeName(), type -> readChildFields(node))
        : readChildFields(node);
  }

  private static List<String> readChildFields(X3DNode node) {
    List<String> names = new ArrayList<>();
    for (X3DFieldDefinition definition : node.getFieldDefinitions()) {
      int type = definition.getFieldType();
      if ((type == X3DFieldTypes.SFNODE || type == X3DFieldTypes.MFNODE)
          && definition.getAccessType() != X3DFieldTypes.INPUT_ONLY
          && !definition.getName().equals("metadata")) {
        names.add(definition.getName());
      }
    }
    return List.copyOf(names);
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

  /** A node of the scene with the sources of its children and the number of its uses. */
  private final class Place {
    final List<ChildSource> branches;
    int uses;

    Place(X3DNode node, SceneScope scope) {
      List<ChildSource> found = new ArrayList<>();
      for (String field : childFields(node)) {
        found.add(new FieldChildSource(scope, node.getField(field), turn, onChildren));
      }
      if (inlined != null && node instanceof Inline) {
        found.add(new InlineChildSource(scope, node, inlined, wanted, onChildren));
      }
      branches = List.copyOf(found);
    }

    List<X3DNode> children() {
      if (branches.size() == 1) {
        return branches.get(0).children();
      }
      List<X3DNode> all = new ArrayList<>();
      branches.forEach(branch -> all.addAll(branch.children()));
      return all;
    }

    void close() {
      branches.forEach(ChildSource::close);
    }
  }

  /** The child nodes in an SFNode or MFNode field. */
  private static final class FieldChildSource extends ChildSource implements X3DFieldEventListener {
    private final SceneScope scope;
    private final X3DField field;
    private final ListenerLock turn;

    FieldChildSource(SceneScope scope, X3DField field, ListenerLock turn, Listener listener) {
      super(listener);
      this.scope = scope;
      this.field = field;
      this.turn = turn;
    }

    @Override
    public void readableFieldChanged(X3DFieldEvent event) {
      turn.take(() -> changed(event.getTime()));
    }

    @Override
    SceneScope scope() {
      return scope;
    }

    @Override
    List<X3DNode> look() {
      if (field instanceof MFNode nodes) {
        X3DNode[] array = new X3DNode[nodes.getSize()];
        nodes.getValue(array);
        return scope.opened(array);
      }
      return scope.opened(new X3DNode[] {((SFNode) field).getValue()});
    }

    @Override
    void listen() {
      if (field.getDefinition().getAccessType() != X3DFieldTypes.INITIALIZE_ONLY) {
        field.addX3DEventListener(this);
      }
    }

    @Override
    void close() {
      FieldListeners.remove(field, this);
    }
  }
}
