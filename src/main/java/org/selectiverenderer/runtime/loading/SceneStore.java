package org.selectiverenderer.runtime.loading;

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

/**
 * What a loader knows of the nodes that it made, as long as they live: assets, the pictures of
 * Backgrounds, and where the urls of nodes lead. Thread-safe.
 */
final class SceneStore {
  private final AssetStore assets;
  private final Predicate<NodeType> actedOn;
  private final Map<Node, UrlBase> origins = new WeakHashMap<>();
  private final Map<Node, Map<Backdrop.Side, Node>> pictures = new WeakHashMap<>();
  private final Set<NodeType> keptOnly = ConcurrentHashMap.newKeySet();

  /**
   * @param actedOn whether anything is done with nodes of a type
   */
  SceneStore(AssetStore assets, Predicate<NodeType> actedOn) {
    this.assets = assets;
    this.actedOn = actedOn;
  }

  AssetStore assets() {
    return assets;
  }

  /** Keeps where a node comes from. */
  void origin(Node node, UrlBase origin) {
    synchronized (origins) {
      origins.put(node, origin);
    }
  }

  /** Where a node comes from; empty for one that an application made. */
  Optional<UrlBase> origin(Node node) {
    synchronized (origins) {
      return Optional.ofNullable(origins.get(node));
    }
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

  /** Whether this is the first node of a type with which nothing is done. */
  boolean firstKept(NodeType type) {
    return !actedOn.test(type) && keptOnly.add(type);
  }
}
