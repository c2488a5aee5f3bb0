package org.selectiverenderer.x3d.read;

import java.util.ArrayList;
import java.util.Collections;
import java.util.HashMap;
import java.util.IdentityHashMap;
import java.util.LinkedHashSet;
import java.util.List;
import java.util.Map;
import java.util.Set;
import org.selectiverenderer.x3d.catalogue.AccessType;
import org.selectiverenderer.x3d.catalogue.FieldDefinition;
import org.selectiverenderer.x3d.catalogue.NodeType;
import org.selectiverenderer.x3d.field.FieldType;
import org.selectiverenderer.x3d.source.DocumentElement;

/** Records the prototype instances, and which nodes their interface fields are connected to. */
final class ProtoInstanceRecorder {
  private final List<ParsedProtoInstance> all = new ArrayList<>();
  private final Map<ParsedNode, Integer> scripts = new IdentityHashMap<>();
  private final Map<DocumentElement, NodeType> types = new IdentityHashMap<>();
  private int begun;

  /** Returns the number of an instance whose body is about to be read. */
  int begin() {
    return begun++;
  }

  /** Records a Script in the body of an instance. */
  void script(ParsedNode script, ProtoInstance within) {
    scripts.put(script, within.number());
  }

  ParsedProtoInstance.Listing listing() {
    return new ParsedProtoInstance.Listing(List.copyOf(all), Collections.unmodifiableMap(scripts));
  }

  /**
   * Records an instance whose body has been read.
   *
   * @param top the top-level nodes of its body, at least one
   */
  void end(ProtoInstance instance, List<ParsedNode> top) {
    ParsedNode first = top.get(0);
    ProtoDeclaration declaration = instance.declaration();
    NodeType type = types.computeIfAbsent(declaration.body(), body -> type(declaration, first));
    Map<Integer, Object> values = new HashMap<>();
    List<ParsedProtoInstance.Link> links = new ArrayList<>();
    for (ProtoDeclaration.Field field : declaration.fields().values()) {
      int index = type.indexOf(field.name());
      boolean held = links(instance, field, index, links);
      Object value = held ? null : instance.value(field);
      if (value != null) {
        values.put(index, value);
      }
    }
    all.add(
        new ParsedProtoInstance(
            instance.number(),
            instance.within(),
            instance.location(),
            first,
            List.copyOf(top.subList(1, top.size())),
            type,
            values,
            List.copyOf(links)));
  }

  private static NodeType type(ProtoDeclaration declaration, ParsedNode first) {
    List<FieldDefinition> fields = new ArrayList<>();
    for (ProtoDeclaration.Field field : declaration.fields().values()) {
      fields.add(FieldDefinition.own(fields.size(), field.name(), field.type(), field.access()));
    }
    if (!declaration.fields().containsKey("metadata")) { // X3D 4.0, 4.4.4.1: a node has it
      fields.add(
          FieldDefinition.own(
              fields.size(), "metadata", FieldType.SFNode, AccessType.INPUT_OUTPUT));
    }
    return NodeType.ofPrototype(declaration.name(), first.type(), fields);
  }

  /** Adds the links of a field; returns whether a linked node field stores its value. */
  private static boolean links(
      ProtoInstance instance,
      ProtoDeclaration.Field field,
      int index,
      List<ParsedProtoInstance.Link> into) {
    List<X3dFile.End.Own> takes = new ArrayList<>();
    List<X3dFile.End.Own> sends = new ArrayList<>();
    List<X3dFile.End.Own> holds = new ArrayList<>();
    for (ProtoInstance.Connection connection : instance.connections(field.name())) {
      if (field.access().acceptsEvents()) {
        RouteReader.resolve(connection.node(), connection.field(), true, takes);
      }
      if (field.access().sendsEvents()) {
        RouteReader.resolve(connection.node(), connection.field(), false, sends);
      }
      if (field.access() != AccessType.INPUT_ONLY) {
        holding(connection.node(), connection.field(), holds);
      }
    }
    Set<X3dFile.End.Own> ends = new LinkedHashSet<>(takes);
    ends.addAll(sends);
    ends.addAll(holds);
    for (X3dFile.End.Own end : ends) {
      into.add(
          new ParsedProtoInstance.Link(
              index,
              end.node(),
              end.field(),
              takes.contains(end),
              sends.contains(end),
              holds.contains(end)));
    }
    return !holds.isEmpty();
  }

  /** Adds the node fields with values to which a field name resolves. */
  private static void holding(NameScope.Named named, String name, List<X3dFile.End.Own> into) {
    ProtoInstance instance = named.instance();
    if (instance == null) {
      NodeType type = named.node().type();
      type.field(name)
          .or(() -> type.output(name))
          .filter(field -> field.access() != AccessType.INPUT_ONLY)
          .ifPresent(field -> into.add(new X3dFile.End.Own(named.node(), field.index())));
      return;
    }
    ProtoDeclaration.Field declared = instance.declaration().fields().get(name);
    if (declared == null) {
      declared = instance.declaration().event(name, false);
    }
    if (declared != null && declared.access() != AccessType.INPUT_ONLY) {
      for (ProtoInstance.Connection connection : instance.connections(declared.name())) {
        holding(connection.node(), connection.field(), into);
      }
    }
  }
}
