package org.selectiverenderer.browser.scene;

import java.util.ArrayList;
import java.util.Collections;
import java.util.IdentityHashMap;
import java.util.List;
import java.util.Set;
import org.jspecify.annotations.Nullable;
import org.selectiverenderer.x3d.catalogue.FieldDefinition;

/** Collects a node and all nodes in its fields, recursively, mostly without metadata. */
public final class NodeSubgraphCollector {
  /** Number of nodes up to which a list is searched faster than a hash set is filled. */
  private static final int FEW = 16;

  private final List<Node> found = new ArrayList<>();

  /** The same nodes; null while they are few, as in most shapes. */
  private @Nullable Set<Node> many;

  private final boolean metadata;

  private NodeSubgraphCollector(boolean metadata) {
    this.metadata = metadata;
  }

  /** Returns the nodes except metadata, each once, in document order. */
  public static List<Node> of(Node node) {
    NodeSubgraphCollector collector = new NodeSubgraphCollector(false);
    collector.add(node);
    return collector.found;
  }

  /** Returns the nodes and their metadata, each once. */
  static List<Node> withMetadata(Node node) {
    NodeSubgraphCollector collector = new NodeSubgraphCollector(true);
    collector.add(node);
    return collector.found;
  }

  private void add(Node node) {
    if (!addNew(node)) {
      return;
    }
    // The values of other fields stay as they are: to read a packed array would unpack it.
    List<FieldDefinition> fields = node.type().nodeFields();
    for (int i = 0; i < fields.size(); i++) {
      Object value = node.value(fields.get(i).index());
      if (value instanceof Node child) {
        add(child);
      } else if (value instanceof List<?> children) {
        for (int j = 0; j < children.size(); j++) {
          add((Node) children.get(j));
        }
      }
    }
    if (metadata && node.type().field("metadata").isPresent()) {
      Node described = node.node("metadata");
      if (described != null) {
        add(described);
      }
    }
  }

  private boolean addNew(Node node) {
    if (many == null) {
      for (int i = 0; i < found.size(); i++) {
        if (found.get(i) == node) {
          return false;
        }
      }
      found.add(node);
      if (found.size() > FEW) {
        many = Collections.newSetFromMap(new IdentityHashMap<>());
        many.addAll(found);
      }
      return true;
    }
    return many.add(node) && found.add(node);
  }
}
