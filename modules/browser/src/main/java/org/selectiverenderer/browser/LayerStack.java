package org.selectiverenderer.browser;

import java.util.ArrayList;
import java.util.Collection;
import java.util.Collections;
import java.util.IdentityHashMap;
import java.util.List;
import java.util.Map;
import java.util.Optional;
import java.util.Set;
import java.util.function.Consumer;
import java.util.function.Function;
import java.util.function.Predicate;
import org.jspecify.annotations.Nullable;
import org.selectiverenderer.browser.collision.MeshBvhCache;
import org.selectiverenderer.browser.instance.AssetProvider;
import org.selectiverenderer.browser.instance.GroupInstance;
import org.selectiverenderer.browser.instance.ShapeInstance;
import org.selectiverenderer.browser.nodes.group.GroupingNode;
import org.selectiverenderer.browser.nodes.sensor.FrameDrivenNode;
import org.selectiverenderer.browser.scene.EventCascade;
import org.selectiverenderer.browser.scene.Node;
import org.selectiverenderer.browser.scene.Scene;
import org.selectiverenderer.browser.viewer.Viewer;

/**
 * The layers of a scene (X3D 4.0, 35.2 and 35.4.2). Layer 0 holds the nodes that are in no Layer
 * node; layers 1 and up are those of the LayerSet among the scene's root nodes. The user navigates
 * in the active layer and sees the layers that the field {@code order} lists, the first at the
 * bottom. A scene without a LayerSet consists of layer 0 only and has no extra cost. Belongs to the
 * thread that steps the world.
 */
final class LayerStack {
  /** The objects that all layers share. */
  record Parts(
      AssetProvider assets,
      MeshBvhCache meshes,
      Consumer<GroupInstance> activated,
      EventCascade cascade) {}

  private final Parts parts;
  private final Scene scene;
  private final Viewer user;
  private final SceneLayer base;
  private final Map<Node, SceneLayer> known = new IdentityHashMap<>();
  private List<Node> rootNodes = List.of();
  private @Nullable Node layerSet;

  /**
   * The LayerSet's {@code layers} field as it is: its indices number the layers, including nodes
   * that are no layers known here.
   */
  private List<Node> given = List.of();

  private List<Node> layerNodes = List.of();

  /** Whether layers were added or removed since their nodes were last collected. */
  private boolean relayered;

  private SceneLayer active;
  private PointingDeviceState pointed = PointingDeviceState.AWAY;
  private DisplayMetrics picture;

  /**
   * @param user the viewer that the user moves in the active layer
   * @param picture the size of the picture
   */
  LayerStack(Scene scene, Parts parts, Viewer user, DisplayMetrics picture) {
    this.picture = picture;
    this.scene = scene;
    this.parts = parts;
    this.user = user;
    base = new SceneLayer((GroupingNode) scene.root(), parts, user);
    active = base;
    follow();
  }

  /** Returns the layer in which the user navigates. */
  SceneLayer active() {
    return active;
  }

  private boolean alone() {
    return layerSet == null;
  }

  /** Returns all layers, layer 0 first. */
  Collection<SceneLayer> all() {
    if (alone()) {
      return List.of(base);
    }
    List<SceneLayer> all = new ArrayList<>(List.of(base));
    layerNodes.forEach(node -> all.add(known.get(node)));
    return all;
  }

  /** Brings the layers and the active layer up to date with the LayerSet. */
  void follow() {
    List<Node> roots = base.root.children();
    if (roots != rootNodes) {
      rootNodes = roots;
      layerSet =
          roots.stream()
              .filter(node -> node.type().name().equals("LayerSet"))
              .findFirst()
              .orElse(null);
    }
    if (layerSet == null && layerNodes.isEmpty()) {
      return;
    }
    List<Node> now = layerSet == null ? List.of() : layerSet.nodes("layers");
    if (now != given) {
      given = now;
      relayer(now);
    }
    SceneLayer wanted = wanted();
    if (wanted != active) {
      Viewer own = new Viewer();
      active.seenBy(own);
      wanted.seenBy(user);
      active = wanted;
    }
  }

  private void relayer(List<Node> now) {
    relayered = true;
    layerNodes = now.stream().filter(GroupingNode.class::isInstance).distinct().toList();
    known
        .entrySet()
        .removeIf(
            entry -> {
              boolean gone = !layerNodes.contains(entry.getKey());
              if (gone) {
                entry.getValue().close();
              }
              return gone;
            });
    for (Node node : layerNodes) {
      known.computeIfAbsent(
          node, layer -> new SceneLayer((GroupingNode) layer, parts, new Viewer()));
    }
  }

  /**
   * Returns the layer that {@code activeLayer} names; layer 0 if the number belongs to no layer.
   */
  private SceneLayer wanted() {
    return layerSet == null
        ? base
        : numbered((Integer) layerSet.value(layerSet.type().indexOf("activeLayer"))).orElse(base);
  }

  private Optional<SceneLayer> numbered(int number) {
    if (number == 0) {
      return Optional.of(base);
    }
    return number < 0 || number > given.size()
        ? Optional.empty()
        : Optional.ofNullable(known.get(given.get(number - 1)));
  }

  /** Returns the layers in drawing order, the lowest first, each once. */
  private List<SceneLayer> order() {
    if (layerSet == null) {
      return List.of(base);
    }
    List<SceneLayer> order = new ArrayList<>();
    for (int number : layerSet.ints("order")) {
      numbered(number).filter(layer -> !order.contains(layer)).ifPresent(order::add);
    }
    return order;
  }

  /** Returns the visible layers, the lowest first. */
  List<LayerView> views() {
    return order().stream().map(layer -> layer.view(part(layer), layer == active)).toList();
  }

  private static LayerView.Part part(SceneLayer layer) {
    return layer.root.type().field("viewport").isEmpty()
        ? LayerView.Part.WHOLE
        : Optional.ofNullable(layer.root.node("viewport"))
            .filter(node -> node.type().name().equals("Viewport"))
            .map(node -> LayerView.Part.of(node.floats("clipBoundary")))
            .orElse(LayerView.Part.WHOLE);
  }

  private static boolean pickable(SceneLayer layer) {
    return layer.root.type().field("pickable").isEmpty() || layer.root.bool("pickable");
  }

  /**
   * Moves the viewers of the inactive layers to their viewpoints; the world moves the viewer of the
   * active one.
   */
  void lead() {
    if (!alone()) {
      all().stream().filter(layer -> layer != active).forEach(layer -> layer.follower.follow());
    }
  }

  void look(EventCascade cascade) {
    all().forEach(layer -> layer.look(picture, part(layer), cascade));
  }

  /** Brings nodes whose layout depends on the size of the picture up to date. */
  void see(DisplayMetrics now) {
    picture = now;
    all().forEach(layer -> layer.see(now, part(layer)));
  }

  /**
   * Passes the pointing device to the layers from the top down: a layer with a shape under the
   * pointer hides the layers below it.
   *
   * @param since the pointer states since the last frame, oldest first
   */
  void point(List<PointingDeviceState> since, EventCascade cascade) {
    if (alone()) {
      base.pointing.frame(since, user, cascade);
      return;
    }
    List<PointingDeviceState> left = since.isEmpty() ? List.of(pointed) : since;
    pointed = left.get(left.size() - 1);
    List<SceneLayer> order = order();
    for (int i = order.size() - 1; i >= 0; i--) {
      SceneLayer layer = order.get(i);
      left = layer.point(left, part(layer), pickable(layer), user, cascade);
    }
  }

  /**
   * Returns the shape of the active layer under the pointer, unless a layer above covers it or a
   * sensor or Anchor of the scene takes clicks there.
   *
   * @param latest the last pointer state since the last frame, if there was one
   */
  Optional<ShapeInstance> pointedAt(Optional<PointingDeviceState> latest) {
    if (alone()) {
      return base.pointing.idle(latest.orElse(base.pointing.last()), user);
    }
    List<SceneLayer> order = order();
    for (int i = order.size() - 1; i >= 0; i--) {
      SceneLayer layer = order.get(i);
      PointingDeviceState inside =
          LayerPointerMapping.in(part(layer), layer.viewer(), latest.orElse(pointed), user);
      if (pickable(layer) && layer.pointing.meets(inside, layer.viewer())) {
        return layer == active ? layer.pointing.idle(inside, user) : Optional.empty();
      }
    }
    return Optional.empty();
  }

  void sense(double time, EventCascade cascade) {
    all().forEach(layer -> layer.sense(time, cascade));
  }

  void update() {
    all().forEach(layer -> layer.instances.update());
  }

  void bind(EventCascade cascade) {
    all().forEach(layer -> layer.bindables.update(cascade));
  }

  /**
   * Returns the number of polygons shown in all layers, including layers that the field {@code
   * order} does not list.
   */
  long shownPolygons() {
    return alone()
        ? base.instances.shownPolygons()
        : all().stream().mapToLong(layer -> layer.instances.shownPolygons()).sum();
  }

  /**
   * Collects the nodes of one kind from all layers; a node that is USEd in several layers comes
   * once.
   */
  <T> List<T> gathered(Function<SceneLayer, List<T>> kind) {
    return alone()
        ? kind.apply(base)
        : all().stream().flatMap(l -> kind.apply(l).stream()).distinct().toList();
  }

  /** Returns whether a condition holds for the pointing device handler of any layer. */
  boolean anyPointing(Predicate<PointingDeviceHandler> so) {
    return all().stream().anyMatch(layer -> so.test(layer.pointing));
  }

  /**
   * Returns the descriptions of the sensors or Anchor under the pointer, the topmost layer first.
   */
  List<String> descriptions() {
    List<SceneLayer> order = order();
    for (int i = order.size() - 1; i >= 0; i--) {
      List<String> said = order.get(i).pointing.descriptions();
      if (!said.isEmpty()) {
        return said;
      }
    }
    return List.of();
  }

  /** Collects the nodes of all layers whose structure has changed; returns whether any has. */
  boolean frameNodes() {
    boolean changed = relayered;
    relayered = false;
    for (SceneLayer layer : all()) {
      changed |= layer.frameNodes(scene, layer == base);
    }
    if (changed) {
      // A node may be USEd in several layers; it is updated once per frame.
      Set<FrameDrivenNode> taken = Collections.newSetFromMap(new IdentityHashMap<>());
      all().forEach(layer -> layer.choose(taken));
      all().forEach(SceneLayer::engage);
    }
    return changed;
  }

  void close() {
    all().forEach(SceneLayer::close);
  }
}
