package org.selectiverenderer.browser.loading;

import java.util.ArrayList;
import java.util.HashMap;
import java.util.List;
import java.util.Map;
import org.jspecify.annotations.Nullable;
import org.selectiverenderer.browser.nodes.script.ScriptNode;
import org.selectiverenderer.browser.scene.Node;
import org.selectiverenderer.browser.scene.PrototypeInstance;
import org.selectiverenderer.x3d.read.ParsedNode;
import org.selectiverenderer.x3d.read.ParsedProtoInstance;

/** Attaches the interfaces of prototype instances to the nodes made from their bodies. */
final class PrototypeInstanceBuilder {
  private final Map<ParsedNode, Node> made;
  private final PrototypeInstance[] faces;

  /**
   * Attaches the interfaces of all instances.
   *
   * @param made the nodes of the scene that have been made
   */
  static void build(ParsedProtoInstance.Listing instances, Map<ParsedNode, Node> made) {
    if (!instances.all().isEmpty()) {
      new PrototypeInstanceBuilder(instances, made).scripts(instances.scripts());
    }
  }

  private PrototypeInstanceBuilder(
      ParsedProtoInstance.Listing instances, Map<ParsedNode, Node> made) {
    this.made = made;
    int count = instances.all().stream().mapToInt(ParsedProtoInstance::number).max().orElse(-1) + 1;
    ParsedProtoInstance[] ordered = new ParsedProtoInstance[count];
    instances.all().forEach(instance -> ordered[instance.number()] = instance);
    faces = new PrototypeInstance[count];
    for (ParsedProtoInstance instance : ordered) {
      Node body = instance == null ? null : made.get(instance.node());
      if (body != null) {
        faces[instance.number()] = face(instance, body);
      }
    }
  }

  private void scripts(Map<ParsedNode, Integer> scripts) {
    scripts.forEach(
        (script, within) -> {
          if (made.get(script) instanceof ScriptNode node && within < faces.length) {
            node.within(faces[within]);
          }
        });
  }

  private PrototypeInstance face(ParsedProtoInstance instance, Node body) {
    List<PrototypeInstance.Link> links = new ArrayList<>(instance.links().size());
    for (ParsedProtoInstance.Link link : instance.links()) {
      Node node = made.get(link.node());
      if (node != null) {
        links.add(
            new PrototypeInstance.Link(
                link.field(), node, link.nodeField(), link.takes(), link.sends(), link.holds()));
      }
    }
    List<Node> beside = new ArrayList<>(0);
    for (ParsedNode other : instance.others()) {
      Node node = made.get(other);
      if (node != null) {
        beside.add(node);
      }
    }
    Map<Integer, Object> values = new HashMap<>();
    instance
        .values()
        .forEach(
            (field, value) -> {
              Object kept = kept(value);
              if (kept != null) {
                values.put(field, kept);
              }
            });
    return new PrototypeInstance(
        instance.location(),
        body,
        List.copyOf(beside),
        instance.type(),
        instance.within() < 0 ? null : faces[instance.within()],
        Map.copyOf(values),
        List.copyOf(links));
  }

  /**
   * Converts a value of the parsed file to one of the running scene; nodes that were left out are
   * dropped.
   */
  private @Nullable Object kept(Object value) {
    if (value instanceof ParsedNode node) {
      return made.get(node);
    }
    if (value instanceof List<?> nodes) {
      List<Node> found = new ArrayList<>();
      for (Object node : nodes) {
        Node one = made.get((ParsedNode) node);
        if (one != null) {
          found.add(one);
        }
      }
      return List.copyOf(found);
    }
    return value;
  }
}
