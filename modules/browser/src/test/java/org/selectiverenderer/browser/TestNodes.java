package org.selectiverenderer.browser;

import java.util.ArrayList;
import java.util.List;
import java.util.Map;
import org.selectiverenderer.base.problem.ProblemCollector;
import org.selectiverenderer.base.problem.SourceLocation;
import org.selectiverenderer.browser.nodes.NodeFactory;
import org.selectiverenderer.browser.scene.EventCascade;
import org.selectiverenderer.browser.scene.Node;
import org.selectiverenderer.browser.scene.Route;
import org.selectiverenderer.browser.scene.Scene;
import org.selectiverenderer.x3d.catalogue.FieldDefinition;
import org.selectiverenderer.x3d.catalogue.NodeCatalogue;
import org.selectiverenderer.x3d.catalogue.NodeType;

/** Makes running nodes for tests and records the events that they send. */
public final class TestNodes {
  public static final NodeCatalogue CATALOGUE = NodeCatalogue.load();

  public final ProblemCollector problems = new ProblemCollector();
  public final EventCascade cascade = new EventCascade(problems);

  /** What the nodes watched have sent, in order, as {@code name.field=value}. */
  public final List<String> events = new ArrayList<>();

  private final NodeFactory factory = new NodeFactory();
  private final Scene scene = new Scene(node("Group"), "test", "4.0", "Full", Map.of(), 1);

  /** A node; fields alternate names and values. */
  public Node node(String typeName, Object... fields) {
    return named(null, typeName, fields);
  }

  public Node named(String name, String typeName, Object... fields) {
    NodeType type = CATALOGUE.get(typeName);
    Node node = factory.make(type, name, new SourceLocation("test.x3d", 1, 1));
    for (int i = 0; i < fields.length; i += 2) {
      node.init(type.indexOf((String) fields[i]), fields[i + 1]);
    }
    return node;
  }

  public Node group(Node... children) {
    return node("Group", "children", List.of(children));
  }

  public Node transform(float x, float y, float z, Node... children) {
    return node("Transform", "translation", new float[] {x, y, z}, "children", List.of(children));
  }

  /** A shape with a geometry of its own. */
  public Node shape() {
    return node("Shape", "geometry", node("Box"));
  }

  public void route(Node from, String output, Node to, String input) {
    scene.addRoute(
        new Route(
            from,
            from.type().output(output).orElseThrow().index(),
            to,
            to.type().input(input).orElseThrow().index()));
  }

  /** Sends an event to a field and calls the listeners. */
  public void send(Node node, String input, Object value) {
    cascade.send(node, node.type().input(input).orElseThrow().index(), value);
    cascade.run();
  }

  /** Writes down the events of a node's fields; of all that send any if none are named. */
  public <T extends Node> T watch(T node, String... fields) {
    for (FieldDefinition field : node.type().fields()) {
      if (field.access().sendsEvents()
          && (fields.length == 0 || List.of(fields).contains(field.name()))) {
        node.addListener(
            field.index(),
            (from, index, value, time) ->
                events.add(
                    (from.name() == null ? "" : from.name() + ".")
                        + field.name()
                        + "="
                        + text(value)));
      }
    }
    return node;
  }

  /** What was sent since the last call. */
  public List<String> sent() {
    cascade.run();
    List<String> copy = List.copyOf(events);
    events.clear();
    return copy;
  }

  private static String text(Object value) {
    if (value instanceof float[] floats) {
      StringBuilder text = new StringBuilder();
      for (float number : floats) {
        text.append(text.isEmpty() ? "" : " ").append(Math.round(number * 1000) / 1000.0);
      }
      return text.toString();
    }
    return String.valueOf(value);
  }
}
