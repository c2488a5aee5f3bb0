package org.selectiverenderer.runtime.loading;

import java.util.Collections;
import java.util.EnumMap;
import java.util.Map;
import java.util.Optional;
import java.util.Set;
import java.util.WeakHashMap;
import java.util.concurrent.ConcurrentHashMap;
import java.util.function.Predicate;
import org.selectiverenderer.runtime.instance.Backdrop;
import org.selectiverenderer.runtime.scene.Node;
import org.selectiverenderer.x3d.catalogue.NodeType;
import org.selectiverenderer.x3d.read.PrototypeLibrary;

/**
 * What a loader knows of the nodes that it made, as long as they live: assets, the pictures of
 * Backgrounds, and where the urls of nodes lead. Thread-safe.
 */
final class SceneStore {
  /** Components with which nothing is done: told once, not once for each of their node types. */
  private static final Set<String> NOT_DONE = Set.of("DIS", "RigidBodyPhysics", "VolumeRendering");

  /** The component of which the nodes of the audio graph, new in X3D 4.0, are kept only. */
  private static final String SOUND = "Sound";

  private final AssetStore assets;
  private final Predicate<NodeType> actedOn;
  private final Map<Node, UrlBase> origins = perNode();
  private final Map<Node, UrlBase> makers = perNode();
  private final Map<Node, PrototypeLibrary> prototypes = perNode();
  private final Map<Node, Map<Backdrop.Side, Node>> pictures = new WeakHashMap<>();
  private final Set<String> keptOnly = ConcurrentHashMap.newKeySet();

  /**
   * @param actedOn whether anything is done with nodes of a type
   */
  SceneStore(AssetStore assets, Predicate<NodeType> actedOn) {
    this.assets = assets;
    this.actedOn = actedOn;
  }

  private static <T> Map<Node, T> perNode() {
    return Collections.synchronizedMap(new WeakHashMap<>());
  }

  AssetStore assets() {
    return assets;
  }

  /** Keeps where a node comes from. */
  void origin(Node node, UrlBase origin) {
    origins.put(node, origin);
  }

  /** Where a node comes from; empty for one that an application made. */
  Optional<UrlBase> origin(Node node) {
    return Optional.ofNullable(origins.get(node));
  }

  /** Keeps where the urls of a node lead that a Script has made: where those of the Script do. */
  void maker(Node made, UrlBase origin) {
    makers.put(made, origin);
  }

  /** Where the urls of a node lead that a Script has made. */
  Optional<UrlBase> maker(Node made) {
    return Optional.ofNullable(makers.get(made));
  }

  /**
   * Keeps the prototypes of a scene, for a Script of it that makes instances.
   *
   * @param root of the scene
   */
  void prototypes(Node root, PrototypeLibrary library) {
    prototypes.put(root, library);
  }

  /** The prototypes of a scene, where they have been kept. */
  Optional<PrototypeLibrary> prototypes(Node root) {
    return Optional.ofNullable(prototypes.get(root));
  }

  /** Keeps the texture that stands for a picture of a Background. */
  void picture(Node background, Backdrop.Side side, Node texture) {
    synchronized (pictures) {
      pictures
          .computeIfAbsent(background, node -> new EnumMap<>(Backdrop.Side.class))
          .put(side, texture);
    }
  }

  /** The texture that stands for a picture of a Background. */
  Optional<Node> picture(Node background, Backdrop.Side side) {
    synchronized (pictures) {
      Map<Backdrop.Side, Node> known = pictures.get(background);
      return known == null ? Optional.empty() : Optional.ofNullable(known.get(side));
    }
  }

  /**
   * What to say of a node with which nothing is done; nothing when that has been said before, of
   * its type or of the whole component that it belongs to.
   */
  Optional<String> kept(NodeType type) {
    if (actedOn.test(type)) {
      return Optional.empty();
    }
    if (type.component().equals(SOUND)) {
      return keptOnly.add(SOUND)
          ? Optional.of(
              "%s is kept in the scene, but this program hears Sound and AudioClip only"
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
