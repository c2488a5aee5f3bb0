package org.selectiverenderer.browser.scene;

import java.util.ArrayList;
import java.util.Collection;
import java.util.List;
import java.util.Map;
import java.util.Optional;
import org.jspecify.annotations.Nullable;
import org.selectiverenderer.base.problem.SourceLocation;
import org.selectiverenderer.x3d.catalogue.NodeType;

/**
 * A prototype instance as scripts and applications see it: with the fields of its interface (X3D
 * 4.0, 4.4.4.1). In the scene the nodes of its body take its place and do not refer to it. The node
 * that represents the interface is made on demand, so that it costs nothing until then.
 */
public final class PrototypeInstance {
  /**
   * An IS connection between a field of the interface and a field of a body node.
   *
   * @param field the index of the interface field
   * @param takes whether events go from the interface to the node
   * @param sends whether events go from the node to the interface
   * @param holds whether the node's field holds the value of the interface field
   */
  public record Link(
      int field, Node node, int nodeField, boolean takes, boolean sends, boolean holds) {}

  private final SourceLocation location;
  private final Node body;
  private final List<Node> others;
  private final NodeType type;
  private final @Nullable PrototypeInstance within;
  private final Map<Integer, Object> values;
  private final List<Link> links;
  private @Nullable PrototypeInstance inner;
  private @Nullable PrototypeInstanceNode shown;

  /**
   * Makes an instance and attaches it to the first node of its body. If the body itself starts with
   * an instance, the outermost is attached and leads to the inner ones.
   *
   * @param location the ProtoInstance in the file
   * @param body the first node of the instance's body
   * @param others the other nodes of the body that take part in the scene by routes only
   * @param within the instance whose body contains this one, if any
   * @param values the values of fields that no body node holds, by their indices
   */
  public PrototypeInstance(
      SourceLocation location,
      Node body,
      List<Node> others,
      NodeType type,
      @Nullable PrototypeInstance within,
      Map<Integer, Object> values,
      List<Link> links) {
    this.location = location;
    this.body = body;
    this.others = others;
    this.type = type;
    this.within = within;
    this.values = values;
    this.links = links;
    PrototypeInstance outer = body.face();
    if (outer == null) {
      body.face(this);
    } else {
      while (outer.inner != null) {
        outer = outer.inner;
      }
      outer.inner = this;
    }
  }

  /**
   * Returns the node that an observer sees for a node of the scene: the outermost prototype
   * instance whose body starts with the node and does not contain the observer; else the node
   * itself.
   *
   * @param from the innermost instance whose body contains the observer, or null
   */
  public static Node seen(Node node, @Nullable PrototypeInstance from) {
    for (PrototypeInstance face = node.face(); face != null; face = face.inner) {
      if (!face.holds(from)) {
        return face.node();
      }
    }
    return node;
  }

  /**
   * Returns the node of the scene for a result of {@link #seen}: the first node of the instance's
   * body.
   */
  public static Node body(Node seen) {
    return seen instanceof PrototypeInstanceNode node ? node.shown().body : seen;
  }

  /**
   * Returns the location of the ProtoInstance whose place in a scene a node takes, as the first
   * node of its body; empty for other nodes, and those of instances in the bodies of others.
   */
  public static Optional<SourceLocation> location(Node node) {
    return Optional.ofNullable(node.face())
        .filter(outermost -> outermost.within == null)
        .map(outermost -> outermost.location);
  }

  /** Returns the present value of a field of a result of {@link #seen}. */
  public static @Nullable Object value(Node seen, int field) {
    return seen instanceof PrototypeInstanceNode node ? node.current(field) : seen.value(field);
  }

  /**
   * Replaces the value of a field that accepts no events, for a result of {@link #seen}, and
   * notifies the connected body nodes.
   */
  public static void replace(Node seen, int field, @Nullable Object value) {
    if (seen instanceof PrototypeInstanceNode node) {
      node.shown().links.stream()
          .filter(link -> link.field == field && link.holds)
          .forEach(link -> link.node.replace(link.nodeField, value));
    }
    seen.replace(field, value);
  }

  /**
   * Returns the routes between nodes of the scene that a route stands for; the route itself if its
   * ends are no prototype instances.
   */
  static List<Route> behind(Route route) {
    if (!(route.from() instanceof PrototypeInstanceNode)
        && !(route.to() instanceof PrototypeInstanceNode)) {
      return List.of(route);
    }
    List<Route> all = new ArrayList<>();
    for (Link from : ends(route.from(), route.fromField(), false)) {
      for (Link to : ends(route.to(), route.toField(), true)) {
        all.add(new Route(from.node, from.nodeField, to.node, to.nodeField));
      }
    }
    return all;
  }

  private static List<Link> ends(Node node, int field, boolean input) {
    if (!(node instanceof PrototypeInstanceNode face)) {
      return List.of(new Link(field, node, field, true, true, true));
    }
    return face.shown().links.stream()
        .filter(link -> link.field == field && (input ? link.takes : link.sends))
        .toList();
  }

  /**
   * Collects the other body nodes of the instances whose body starts with a node; they are in the
   * scene as long as that node is (X3D 4.0, 4.4.4.3).
   */
  public static void beside(Node node, Collection<Node> into) {
    for (PrototypeInstance face = node.face(); face != null; face = face.inner) {
      for (Node other : face.others) {
        into.add(other);
        beside(other, into);
      }
    }
  }

  private boolean holds(@Nullable PrototypeInstance from) {
    for (PrototypeInstance around = from; around != null; around = around.within) {
      if (around == this) {
        return true;
      }
    }
    return false;
  }

  private Node node() {
    synchronized (body) { // Applications call this from any thread.
      if (shown == null) {
        shown = new PrototypeInstanceNode(this, type, body);
        values.forEach(shown::init);
      }
      return shown;
    }
  }

  List<Link> links() {
    return links;
  }
}
