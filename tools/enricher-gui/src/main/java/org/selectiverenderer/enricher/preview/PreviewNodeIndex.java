package org.selectiverenderer.enricher.preview;

import java.util.ArrayList;
import java.util.Collections;
import java.util.HashMap;
import java.util.HashSet;
import java.util.LinkedHashMap;
import java.util.LinkedHashSet;
import java.util.List;
import java.util.Map;
import java.util.Optional;
import java.util.Set;
import org.jspecify.annotations.Nullable;
import org.selectiverenderer.base.problem.SourceLocation;
import org.selectiverenderer.browser.World;
import org.selectiverenderer.browser.instance.GroupInstance;
import org.selectiverenderer.browser.instance.Instance;
import org.selectiverenderer.browser.instance.InstanceTree;
import org.selectiverenderer.browser.instance.ShapeInstance;
import org.selectiverenderer.browser.nodes.group.InlineNode;
import org.selectiverenderer.browser.nodes.group.SwitchNode;
import org.selectiverenderer.browser.nodes.sensor.TimeSensorNode;
import org.selectiverenderer.browser.scene.Node;
import org.selectiverenderer.browser.scene.NodeSubgraphCollector;
import org.selectiverenderer.browser.scene.Scene;
import org.selectiverenderer.enricher.preview.ScenePatch.Place;

/**
 * An index of the nodes in a running scene that stand in the document's own text, by their
 * positions in the text; and of all Switches, those of inlined files too.
 */
final class PreviewNodeIndex {
  private final World world;
  private final Map<Place, Node> byPlace = new HashMap<>();

  /** The present start tag positions of nodes that edits have moved since they were loaded. */
  private final Map<Node, Place> moved = new HashMap<>();

  private final Set<Node> all = new LinkedHashSet<>();

  /** All nodes of the scene, those in fields of others too; Inlines have no more of them here. */
  private Set<Node> scene = Set.of();

  private List<TimeSensorNode> timeSensors = List.of();

  /** The ProtoInstance of the document that has made a node. */
  private final Map<Node, ProtoInstanceOrigin> instances = new LinkedHashMap<>();

  /** The file of each Switch. */
  private final Map<SwitchNode, Scene> switches = new LinkedHashMap<>();

  PreviewNodeIndex(World world) {
    this.world = world;
    collect();
  }

  /** Finds the nodes again, after groups have got other children. */
  void collect() {
    scene = new LinkedHashSet<>(NodeSubgraphCollector.of(world.scene().root()));
    moved.keySet().retainAll(scene);
    timeSensors =
        scene.stream()
            .filter(TimeSensorNode.class::isInstance)
            .map(TimeSensorNode.class::cast)
            .toList();
    all.clear();
    instances.clear();
    switches.clear();
    collect(world.instances().root(), null);
    index();
    switches(world.instances().root(), world.scene());
  }

  private void switches(GroupInstance group, Scene file) {
    Scene within =
        group.node() instanceof InlineNode inlined ? inlined.content().orElse(file) : file;
    if (group.node() instanceof SwitchNode versions) {
      switches.putIfAbsent(versions, within);
    }
    for (Instance child : group.children()) {
      if (child instanceof GroupInstance below) {
        switches(below, within);
      }
    }
  }

  /** All Switches, those of inlined files too, in document order. */
  Set<SwitchNode> switches() {
    return Collections.unmodifiableSet(switches.keySet());
  }

  /** Finds a node by its name in the file of a Switch. */
  Optional<Node> named(SwitchNode object, String name) {
    return Optional.ofNullable(switches.get(object)).flatMap(file -> file.find(name));
  }

  /**
   * Collects the nodes below a group.
   *
   * @param within the ProtoInstance whose body the group is in; null in the scene
   */
  private void collect(GroupInstance group, @Nullable ProtoInstanceOrigin within) {
    if (group.node() instanceof InlineNode) {
      return; // Its content is in another file.
    }
    for (Instance child : group.children()) {
      Node node = child.node();
      if (all.add(node)) {
        ProtoInstanceOrigin body =
            within == null || within.given(node.location()) ? ProtoInstanceOrigin.of(node) : within;
        if (body != null) {
          instances.put(node, body);
        }
        if (child instanceof GroupInstance below) {
          collect(below, body);
        }
      }
    }
  }

  /** Assigns the positions of the nodes: those of the scene come before those of bodies. */
  private void index() {
    byPlace.clear();
    all.stream()
        .filter(node -> written(node) == node)
        .forEach(node -> byPlace.putIfAbsent(place(node), node));
    instances.forEach(
        (node, instance) -> {
          if (instance.first() != node && instance.ofItsFile(node.location())) {
            byPlace.putIfAbsent(place(node), node);
          }
        });
  }

  /** Returns the node that stands for one of the document: for one of a body, the instance's. */
  private Node written(Node node) {
    ProtoInstanceOrigin instance = instances.get(node);
    return instance == null ? node : instance.first();
  }

  /** The position of a node's start tag in the present text; for an instance, its own. */
  private Place place(Node node) {
    Place since = moved.get(node);
    if (since != null) {
      return since;
    }
    ProtoInstanceOrigin instance = instances.get(node);
    SourceLocation at =
        instance != null && instance.first() == node ? instance.location() : node.location();
    return new Place(at.line(), at.column());
  }

  /** The anchor of a node in the present text; for a node of a body, that of the instance. */
  SourceAnchor anchor(Node node) {
    Node written = written(node);
    Place at = place(written);
    return new SourceAnchor(name(written), at.line(), at.column());
  }

  /** Returns the name of a node in the scene; the names in a prototype's body are none. */
  private Optional<String> name(Node node) {
    return Optional.ofNullable(node.name())
        .filter(
            name ->
                !instances.containsKey(node)
                    || world.scene().find(name).filter(found -> found == node).isPresent());
  }

  /**
   * Returns the nodes whose start tags are at these positions of the document's text, also nodes in
   * fields of others.
   */
  Map<Place, Node> at(Set<Place> places) {
    Map<Place, Node> found = new HashMap<>();
    for (Node node : scene) {
      if (instances.containsKey(node)) {
        continue; // An instance has other fields than the first node of its body.
      }
      Place at = place(node);
      if (places.contains(at)) {
        found.putIfAbsent(at, node);
      }
    }
    return found;
  }

  /**
   * Returns the node that stands in a group for the element at a position: for an instance of a
   * prototype, the first node of its body.
   */
  Optional<Node> standing(Place place) {
    return Optional.ofNullable(byPlace.get(place));
  }

  /** Updates the positions after an edit that has moved start tags. */
  void move(ScenePatch patch) {
    if (patch.moved().isEmpty() && patch.shift().isEmpty()) {
      return;
    }
    boolean any = false;
    for (Node node : scene) {
      Place before = place(node);
      Place after = patch.after(before);
      if (!after.equals(before)) {
        moved.put(node, after);
        any = true;
      }
    }
    if (any) {
      index();
    }
  }

  /**
   * All nodes of the document with an instance in the scene (groups, shapes, lights, sensors), in
   * document order.
   */
  List<Node> all() {
    return List.copyOf(all);
  }

  /** Returns whether a node is one of {@link #all()}. */
  boolean contains(Node node) {
    return all.contains(node);
  }

  /** Returns the TimeSensors of the scene, which may be in fields of prototypes too. */
  List<TimeSensorNode> timeSensors() {
    return timeSensors;
  }

  /** Returns the node of the first anchor that has an instance in the scene. */
  Optional<Node> find(List<SourceAnchor> anchors) {
    for (SourceAnchor anchor : anchors) {
      Node found =
          anchor
              .def()
              .flatMap(world.scene()::find)
              .orElseGet(() -> byPlace.get(new Place(anchor.line(), anchor.column())));
      if (found != null && !world.instances().instances(found).isEmpty()) {
        return Optional.of(found);
      }
    }
    return Optional.empty();
  }

  /** Returns the node of an anchor itself, if it has an instance in the scene. */
  Optional<Node> findItself(SourceAnchor anchor) {
    return find(List.of(anchor));
  }

  /** Returns the shape instances in a node, shown or not. */
  Set<ShapeInstance> shapes(Node node) {
    Set<ShapeInstance> shapes = new HashSet<>();
    InstanceTree tree = world.instances();
    tree.instances(node).forEach(place -> gather(place, shapes));
    return shapes;
  }

  /** Adds the shapes of an instance, shown or not. */
  static void gather(Instance instance, Set<ShapeInstance> shapes) {
    if (instance instanceof ShapeInstance shape) {
      shapes.add(shape);
    } else if (instance instanceof GroupInstance group) {
      group.children().forEach(child -> gather(child, shapes));
    }
  }

  /**
   * Returns the node that a click on a shape selects: the nearest Switch around it, else the
   * nearest node with a name or instance of a prototype, else the nearest node of the document. An
   * instance is meant as a whole, named or not: what it draws is not written in the scene.
   *
   * @param innermost whether to select the nearest node of the document in any case
   */
  Optional<Node> meant(ShapeInstance shape, boolean innermost) {
    List<Node> own = own(shape);
    if (own.isEmpty()) {
      return Optional.empty();
    }
    if (!innermost) {
      for (Node node : own) {
        if (node instanceof SwitchNode && !instances.containsKey(node)) {
          return Optional.of(node);
        }
      }
      for (Node node : own) {
        if (node.name() != null || instances.containsKey(node)) {
          return Optional.of(node);
        }
      }
    }
    return Optional.of(own.get(0));
  }

  /** Returns the nodes of the document around a shape, the nearest first. */
  private List<Node> own(ShapeInstance shape) {
    List<Node> own = new ArrayList<>();
    for (@Nullable Instance at = shape; at != null; at = at.parent()) {
      if (at.node() instanceof InlineNode) {
        own.clear();
      }
      if (at.parent() != null) { // The root group is no part of the file.
        own.add(at.node());
      }
    }
    own.removeIf(node -> !all.contains(node));
    return own.stream().map(this::written).distinct().toList();
  }
}
