package org.selectiverenderer.runtime.scene;

import java.util.ArrayList;
import java.util.Collection;
import java.util.List;
import java.util.Map;
import org.jspecify.annotations.Nullable;
import org.selectiverenderer.x3d.catalogue.NodeType;

/**
 * What an instance of a prototype shows to scripts and applications: the fields of its interface
 * (X3D 4.0, 4.4.4.1). Its body's nodes stand in its place in the scene and know nothing of it. So
 * that it costs nothing while nobody asks, the node that shows the interface is made when somebody
 * does.
 */
public final class InstanceFace {
  /**
   * A field of the interface and one that it stands for.
   *
   * @param field its index in the interface
   * @param takes whether events go from the interface to the node
   * @param sends whether events go from the node to the interface
   * @param holds whether the node's field has the value of the interface's
   */
  public record Link(
      int field, Node node, int nodeField, boolean takes, boolean sends, boolean holds) {}

  private final Node body;
  private final List<Node> others;
  private final NodeType type;
  private final @Nullable InstanceFace within;
  private final Map<Integer, Object> values;
  private final List<Link> links;
  private @Nullable InstanceFace inner;
  private @Nullable FaceNode shown;

  /**
   * Gives a node an interface to hide behind. Of several, when a body begins with an instance
   * itself, the outermost is the first.
   *
   * @param body the first node of the instance's body
   * @param others those behind it that take part in the scene, though they stand in no other
   * @param within the instance in whose body this one stands, if any
   * @param values of fields that no node holds, by their indices
   */
  public InstanceFace(
      Node body,
      List<Node> others,
      NodeType type,
      @Nullable InstanceFace within,
      Map<Integer, Object> values,
      List<Link> links) {
    this.body = body;
    this.others = others;
    this.type = type;
    this.within = within;
    this.values = values;
    this.links = links;
    InstanceFace outer = body.face();
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
   * What stands for a node where somebody looks: the interface of the outermost instance that it is
   * the first node of, of those in which the onlooker does not stand itself; else the node.
   *
   * @param from the innermost instance in whose body the onlooker stands, or null
   */
  public static Node seen(Node node, @Nullable InstanceFace from) {
    for (InstanceFace face = node.face(); face != null; face = face.inner) {
      if (!face.holds(from)) {
        return face.node();
      }
    }
    return node;
  }

  /** The node of the scene behind what {@link #seen} gives: the first of the instance's body. */
  public static Node body(Node seen) {
    return seen instanceof FaceNode node ? node.shown().body : seen;
  }

  /** The value of a field as it is now, of whatever {@link #seen} gives. */
  public static @Nullable Object value(Node seen, int field) {
    return seen instanceof FaceNode node ? node.current(field) : seen.value(field);
  }

  /**
   * Gives a field that takes no events another value, of whatever {@link #seen} gives: the nodes
   * that it stands for look at it again.
   */
  public static void replace(Node seen, int field, @Nullable Object value) {
    if (seen instanceof FaceNode node) {
      node.shown().links.stream()
          .filter(link -> link.field == field && link.holds)
          .forEach(link -> link.node.replace(link.nodeField, value));
    }
    seen.replace(field, value);
  }

  /** The routes between nodes of the scene that a route stands for; itself if it is one. */
  static List<Route> behind(Route route) {
    if (!(route.from() instanceof FaceNode) && !(route.to() instanceof FaceNode)) {
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
    if (!(node instanceof FaceNode face)) {
      return List.of(new Link(field, node, field, true, true, true));
    }
    return face.shown().links.stream()
        .filter(link -> link.field == field && (input ? link.takes : link.sends))
        .toList();
  }

  /**
   * Gathers what stands beside a node in the bodies of instances that it is the first node of: they
   * are in the scene as long as it is (X3D 4.0, 4.4.4.3).
   */
  public static void beside(Node node, Collection<Node> into) {
    for (InstanceFace face = node.face(); face != null; face = face.inner) {
      for (Node other : face.others) {
        into.add(other);
        beside(other, into);
      }
    }
  }

  private boolean holds(@Nullable InstanceFace from) {
    for (InstanceFace around = from; around != null; around = around.within) {
      if (around == this) {
        return true;
      }
    }
    return false;
  }

  private Node node() {
    synchronized (body) { // Applications ask from any thread.
      if (shown == null) {
        shown = new FaceNode(this, type, body);
        values.forEach(shown::init);
      }
      return shown;
    }
  }

  List<Link> links() {
    return links;
  }
}
