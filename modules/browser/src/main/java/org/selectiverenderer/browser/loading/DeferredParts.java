package org.selectiverenderer.browser.loading;

import java.util.Collections;
import java.util.IdentityHashMap;
import java.util.List;
import java.util.Set;
import org.jspecify.annotations.Nullable;
import org.selectiverenderer.browser.nodes.NodeFactory;
import org.selectiverenderer.browser.scene.Node;
import org.selectiverenderer.browser.scene.NodeTemplate;
import org.selectiverenderer.x3d.read.ParsedNode;
import org.selectiverenderer.x3d.read.X3dFile;

/**
 * Decides in which Shapes of a file that is inlined again the nodes need not be made before they
 * are asked for: a street of equal houses has a million of them, and each house shares the mesh and
 * material of the first. They are those that nothing else in the file refers to, by a DEF name, a
 * ROUTE or as part of a prototype instance, and to which nothing belongs but their values.
 */
final class DeferredParts {
  private static final int UNKNOWN = 0;
  private static final int NONE = -1;

  private final NodeFactory factory;

  /** Whether the file has prototype instances, whose connections name nodes in their bodies. */
  private final boolean instantiated;

  private final Set<ParsedNode> routed = Collections.newSetFromMap(new IdentityHashMap<>());

  DeferredParts(NodeFactory factory, X3dFile file) {
    this.factory = factory;
    instantiated = !file.instances().all().isEmpty();
    for (X3dFile.ParsedRoute route : file.routes()) {
      routed.add(route.from());
      routed.add(route.to());
    }
  }

  /** Tells what the first copy of a node has shown. */
  interface FirstCopy {
    /** Returns whether more belongs to a node than its values, or true if it was not made. */
    boolean attached(ParsedNode parsed);

    /** Returns the template of a node in a Shape, if it has one. */
    @Nullable NodeTemplate template(ParsedNode parsed);
  }

  /** The nodes in one Shape of the file. */
  final class OfShape implements NodeTemplate.PartMaker {
    private final ParsedNode shape;
    private final @Nullable NodeTemplate geometry;
    private int count;
    private int height;

    OfShape(ParsedNode shape, FirstCopy first) {
      this.shape = shape;
      Object drawn = shape.values()[shape.type().indexOf("geometry")];
      geometry = drawn instanceof ParsedNode parsed ? first.template(parsed) : null;
    }

    /**
     * Returns the number of nodes in the Shape, without itself, if they need not be made with a
     * further copy of it; otherwise 0 or less.
     */
    int count(FirstCopy first) {
      if (count == UNKNOWN) {
        Set<ParsedNode> seen = Collections.newSetFromMap(new IdentityHashMap<>());
        boolean free = !instantiated && isFree(shape, first, seen, 0);
        count = free && seen.size() > 1 ? seen.size() - 1 : NONE;
      }
      return count;
    }

    /** Returns how many nodes lie one in the other. */
    int height() {
      return height;
    }

    private boolean isFree(ParsedNode node, FirstCopy first, Set<ParsedNode> seen, int depth) {
      height = Math.max(height, depth);
      if (!seen.add(node)
          || first.attached(node)
          || (node != shape && (node.name() != null || routed.contains(node)))) {
        return false;
      }
      for (Object value : node.values()) {
        if (value instanceof ParsedNode part) {
          if (!isFree(part, first, seen, depth + 1)) {
            return false;
          }
        } else if (value instanceof List<?> parts) {
          if (node == shape) {
            return false; // Only single nodes are made later.
          }
          for (Object part : parts) {
            if (!isFree((ParsedNode) part, first, seen, depth + 1)) {
              return false;
            }
          }
        }
      }
      return true;
    }

    @Override
    public Node make(ParsedNode part) {
      Node node = factory.make(part.type(), part.name(), part.location());
      @Nullable Object[] shared = part.values();
      @Nullable Object[] values = shared;
      for (int i = 0; i < shared.length; i++) {
        if (shared[i] instanceof ParsedNode inner) {
          values = values == shared ? shared.clone() : values;
          values[i] = make(inner);
        } else if (shared[i] instanceof List<?> inner) {
          values = values == shared ? shared.clone() : values;
          values[i] = inner.stream().map(one -> make((ParsedNode) one)).toList();
        }
      }
      node.init(values);
      if (geometry != null && part == shape.values()[shape.type().indexOf("geometry")]) {
        node.template(geometry);
      }
      return node;
    }
  }
}
