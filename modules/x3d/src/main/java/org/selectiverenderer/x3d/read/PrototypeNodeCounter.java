package org.selectiverenderer.x3d.read;

import java.util.HashMap;
import java.util.IdentityHashMap;
import java.util.Map;
import java.util.Optional;
import org.jspecify.annotations.Nullable;
import org.selectiverenderer.x3d.catalogue.NodeCatalogue;
import org.selectiverenderer.x3d.source.DocumentAttribute;
import org.selectiverenderer.x3d.source.DocumentElement;

/**
 * Counts the nodes of a prototype instance before its expansion: nested prototypes multiply, so
 * that a file of a few lines may ask for billions of nodes. Each body is counted once. The count is
 * a lower bound: instances of prototypes of other files count as one node.
 */
final class PrototypeNodeCounter {
  private final NodeCatalogue catalogue;
  private final ExternProtoResolver externs;
  private final int maxDepth;
  private final Map<DocumentElement, Long> known = new IdentityHashMap<>();

  /**
   * Creates a counter.
   *
   * @param externs resolves the prototypes of other files
   * @param maxDepth the depth of elements beyond which nothing is read
   */
  PrototypeNodeCounter(NodeCatalogue catalogue, ExternProtoResolver externs, int maxDepth) {
    this.catalogue = catalogue;
    this.externs = externs;
    this.maxDepth = maxDepth;
  }

  /** Returns the number of nodes of an instance, including those of instances in its body. */
  long of(ProtoDeclaration declaration) {
    return body(declaration.body(), new Known(declaration.environment(), null), 0);
  }

  /** The visible prototypes: those declared in a body, then those of enclosing scopes. */
  private static final class Known {
    private final NameScope around;
    private final @Nullable Known outer;
    private final Map<String, Optional<DocumentElement>> bodies = new HashMap<>();

    Known(NameScope around, @Nullable Known outer) {
      this.around = around;
      this.outer = outer;
    }
  }

  private long body(DocumentElement body, Known names, int depth) {
    Long before = known.get(body);
    if (before != null || depth > maxDepth) {
      return before == null ? 0 : before;
    }
    known.put(body, 0L); // a prototype that contains itself is left out
    long nodes = children(body, new Known(names.around, names), depth);
    known.put(body, nodes);
    return nodes;
  }

  private long children(DocumentElement element, Known names, int depth) {
    long nodes = 0;
    for (DocumentElement child : element.children()) {
      nodes = sum(nodes, element(child, names, depth + 1));
    }
    return nodes;
  }

  private long element(DocumentElement element, Known names, int depth) {
    if (depth > maxDepth || element.use().isPresent()) {
      return 0;
    }
    return switch (element.name()) {
      case "ProtoDeclare" -> {
        declare(element, names);
        yield 0;
      }
      case "ExternProtoDeclare" -> {
        name(element).ifPresent(name -> names.bodies.put(name, Optional.empty()));
        yield 0;
      }
      case "fieldValue", "field" -> children(element, names, depth);
      case "ProtoInstance" ->
          sum(1, sum(instance(element, names, depth), children(element, names, depth)));
      default ->
          catalogue.find(element.name()).isEmpty() ? 0 : sum(1, children(element, names, depth));
    };
  }

  private static void declare(DocumentElement element, Known names) {
    for (DocumentElement child : element.children()) {
      if (child.name().equals("ProtoBody")) {
        name(element).ifPresent(name -> names.bodies.put(name, Optional.of(child)));
      }
    }
  }

  private static Optional<String> name(DocumentElement element) {
    return element.attribute("name").map(DocumentAttribute::text);
  }

  private long instance(DocumentElement element, Known names, int depth) {
    String name = name(element).orElse("");
    for (Known scope = names; scope != null; scope = scope.outer) {
      Optional<DocumentElement> body = scope.bodies.get(name);
      if (body != null) {
        return body.isEmpty() ? 0 : body(body.get(), scope, depth);
      }
    }
    DeclaredPrototype named = names.around.prototype(name);
    ProtoDeclaration found =
        named instanceof ExternProtoDeclaration extern
            ? externs.find(extern)
            : (ProtoDeclaration) named;
    return found == null ? 0 : body(found.body(), new Known(found.environment(), null), depth);
  }

  /** Adds without overflow. */
  private static long sum(long a, long b) {
    long sum = a + b;
    return sum < 0 ? Long.MAX_VALUE : sum;
  }
}
