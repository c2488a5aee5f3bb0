package org.selectiverenderer.browser.sai;

import java.util.LinkedHashSet;
import java.util.Optional;
import java.util.Set;
import java.util.function.DoubleConsumer;
import org.selectiverenderer.browser.scene.EventCascade;
import org.selectiverenderer.browser.scene.Node;
import org.selectiverenderer.browser.scene.NodeObserver;
import org.selectiverenderer.browser.scene.PrototypeInstance;
import org.selectiverenderer.sai.InlineSceneAccess.Registration;

/**
 * Observes the metadata of a node, without an object for each of its fields. The listener is called
 * like field listeners, after the event cascade.
 */
final class MetadataTreeWatcher implements NodeObserver, Registration {
  private final EventCascade cascade;
  private final NodeProxy owner;
  private final DoubleConsumer listener;

  /** The owner, its metadata node with all below it, then the metadata of that. */
  private final Node[] nodes;

  /** The index of the first node of the metadata of the metadata. */
  private final int inner;

  private boolean closed;

  private MetadataTreeWatcher(
      EventCascade cascade, NodeProxy owner, DoubleConsumer listener, Set<Node> found, int inner) {
    this.cascade = cascade;
    this.owner = owner;
    this.listener = listener;
    this.nodes = found.toArray(Node[]::new);
    this.inner = inner;
    for (Node node : nodes) {
      node.addObserver(this);
    }
  }

  /** Begins to observe; empty if a node is a prototype instance, with fields of other nodes. */
  static Optional<Registration> of(EventCascade cascade, NodeProxy owner, DoubleConsumer listener) {
    Set<Node> found = new LinkedHashSet<>();
    found.add(owner.node());
    int inner = 1;
    Node metadata = owner.node().node("metadata");
    if (metadata != null) {
      collect(metadata, found);
      inner = found.size();
      Node further = metadata.node("metadata");
      if (further != null) {
        collect(further, found);
      }
    }
    if (PrototypeInstance.body(owner.node()) != owner.node()
        || found.stream().skip(1).anyMatch(one -> PrototypeInstance.seen(one, null) != one)) {
      return Optional.empty();
    }
    return Optional.of(new MetadataTreeWatcher(cascade, owner, listener, found, inner));
  }

  private static void collect(Node metadata, Set<Node> found) {
    if (found.add(metadata) && isSet(metadata)) {
      metadata.nodes("value").forEach(child -> collect(child, found));
    }
  }

  private static boolean isSet(Node metadata) {
    return metadata.type().name().equals("MetadataSet");
  }

  @Override
  public void changed(Node node, int field) {
    if (concerns(node, node.type().fields().get(field).name())) {
      cascade.notify((at, index, value, time) -> tell(time), node, field, null);
    }
  }

  private boolean concerns(Node node, String field) {
    int at = 0;
    while (nodes[at] != node) {
      at++;
    }
    return switch (field) {
      case "metadata" -> at <= 1;
      case "value" -> at > 0;
      case "name" -> at > 0 && (at >= inner || !isSet(node));
      default -> false;
    };
  }

  private void tell(double time) {
    if (!closed && !owner.gone()) {
      listener.accept(time);
    }
  }

  @Override
  public void close() {
    if (!closed) {
      closed = true;
      for (Node node : nodes) {
        node.removeObserver(this);
      }
    }
  }
}
