package org.selectiverenderer.browser.loading;

import java.util.Collections;
import java.util.EnumMap;
import java.util.Map;
import java.util.Optional;
import java.util.Set;
import java.util.WeakHashMap;
import java.util.concurrent.ConcurrentHashMap;
import java.util.function.Predicate;
import org.selectiverenderer.browser.instance.Background;
import org.selectiverenderer.browser.scene.Node;
import org.selectiverenderer.x3d.catalogue.NodeType;
import org.selectiverenderer.x3d.read.PrototypeLibrary;

/**
 * The registry of the nodes that a loader has made, as long as they live: their assets, the
 * textures of Backgrounds, and the bases of their urls. Thread-safe.
 */
final class NodeRegistry {
  /** Components without support, reported once and not once for each of their node types. */
  private static final Set<String> NOT_DONE = Set.of("DIS", "RigidBodyPhysics", "VolumeRendering");

  /** The component whose audio graph nodes, new in X3D 4.0, have no behaviour here. */
  private static final String SOUND = "Sound";

  private final AssetStore assets;
  private final Predicate<NodeType> actedOn;
  private final Map<Node, UrlContext> origins = perNode();
  private final Map<Node, UrlContext> makers = perNode();
  private final Map<Node, PrototypeLibrary> prototypes = perNode();
  private final Map<Node, Map<Background.Side, Node>> pictures = new WeakHashMap<>();
  private final Set<String> keptOnly = ConcurrentHashMap.newKeySet();

  /**
   * @param actedOn whether nodes of a type have a behaviour or an effect
   */
  NodeRegistry(AssetStore assets, Predicate<NodeType> actedOn) {
    this.assets = assets;
    this.actedOn = actedOn;
  }

  private static <T> Map<Node, T> perNode() {
    return Collections.synchronizedMap(new WeakHashMap<>());
  }

  AssetStore assets() {
    return assets;
  }

  /** Stores where a node comes from. */
  void origin(Node node, UrlContext origin) {
    origins.put(node, origin);
  }

  /** Returns where a node comes from; empty for one that an application made. */
  Optional<UrlContext> origin(Node node) {
    return Optional.ofNullable(origins.get(node));
  }

  /** Stores the base of the urls of a node that a Script has made, which is that of the Script. */
  void maker(Node made, UrlContext origin) {
    makers.put(made, origin);
  }

  /** Returns the base of the urls of a node that a Script has made. */
  Optional<UrlContext> maker(Node made) {
    return Optional.ofNullable(makers.get(made));
  }

  /**
   * Stores the prototypes of a scene, for Scripts of the scene that make instances.
   *
   * @param root the root of the scene
   */
  void prototypes(Node root, PrototypeLibrary library) {
    prototypes.put(root, library);
  }

  /** Returns the prototypes of a scene, if they have been stored. */
  Optional<PrototypeLibrary> prototypes(Node root) {
    return Optional.ofNullable(prototypes.get(root));
  }

  /** Stores the texture made for a side of a Background. */
  void picture(Node background, Background.Side side, Node texture) {
    synchronized (pictures) {
      pictures
          .computeIfAbsent(background, node -> new EnumMap<>(Background.Side.class))
          .put(side, texture);
    }
  }

  /** Returns the texture made for a side of a Background. */
  Optional<Node> picture(Node background, Background.Side side) {
    synchronized (pictures) {
      Map<Background.Side, Node> known = pictures.get(background);
      return known == null ? Optional.empty() : Optional.ofNullable(known.get(side));
    }
  }

  /**
   * Returns the message for a node without support; empty if its type or its whole component was
   * reported before.
   */
  Optional<String> kept(NodeType type) {
    if (actedOn.test(type)) {
      return Optional.empty();
    }
    if (type.component().equals(SOUND)) {
      return keptOnly.add(SOUND)
          ? Optional.of(
              "%s is kept in the scene, but this program plays only Sound and AudioClip nodes"
                  .formatted(type.name()))
          : Optional.empty();
    }
    if (NOT_DONE.contains(type.component())) {
      return keptOnly.add(type.component())
          ? Optional.of(
              "%s is kept in the scene, but this program does not act on nodes of the %s component"
                  .formatted(type.name(), type.component()))
          : Optional.empty();
    }
    return keptOnly.add(type.name())
        ? Optional.of(
            "%s is kept in the scene, but this program does not act on it".formatted(type.name()))
        : Optional.empty();
  }
}
