package org.selectiverenderer.x3d.read;

import java.util.ArrayList;
import java.util.List;
import org.jspecify.annotations.Nullable;
import org.selectiverenderer.base.problem.SourceLocation;
import org.selectiverenderer.base.problem.SpellingSuggester;
import org.selectiverenderer.x3d.catalogue.ContainerFieldRules;
import org.selectiverenderer.x3d.catalogue.FieldDefinition;

/** Reads IS elements, which connect node fields with fields of the enclosing prototype. */
final class IsStatementReader {
  /**
   * A connection given by a connect element.
   *
   * @param field the field of the prototype's interface
   */
  record Connection(String nodeField, ProtoDeclaration.Field field) {}

  private final ReadContext reading;

  IsStatementReader(ReadContext reading) {
    this.reading = reading;
  }

  /**
   * Reads the IS element of a node in a prototype's body and sets the instance's values in the
   * node.
   */
  void connect(
      ElementCursor in, NameScope scope, NameScope.Named named, ChildNodeAssigner children) {
    ProtoInstance instance = scope.instance();
    ParsedNode node = named.node();
    while (in.next()) {
      Connection connection = outer(in, scope);
      if (connection != null && instance != null) {
        String name = connection.nodeField();
        FieldDefinition field =
            node.type()
                .field(name)
                .or(() -> node.type().input(name))
                .or(() -> node.type().output(name))
                .orElse(null);
        if (field != null && field.type() == connection.field().type()) {
          instance.connect(connection.field().name(), new ProtoInstance.Connection(named, name));
          give(instance, node, field, instance.value(connection.field()), children, in.location());
        } else {
          mismatch(in.location(), node.type().name(), connection);
        }
      }
      in.skip();
    }
  }

  private void give(
      ProtoInstance instance,
      ParsedNode node,
      FieldDefinition field,
      @Nullable Object value,
      ChildNodeAssigner children,
      SourceLocation location) {
    if (value == null || !field.access().initialisable()) {
      return;
    }
    if (!field.type().isNode()) {
      node.put(field.index(), value);
      return;
    }
    List<?> given = value instanceof List<?> list ? list : List.of(value);
    for (Object child : given) {
      ParsedNode childNode = (ParsedNode) child;
      if (instance.isTurningBack(childNode) && !node.type().is("X3DScriptNode")) {
        // a Script may refer to its ancestors, but a part of the scene may not contain itself
        reading.error(
            location,
            "the %s in the field %s would contain the instance itself; it is left out"
                .formatted(childNode.type().name(), field.name()));
      } else if (field.nodeTypes().isEmpty()
          || ContainerFieldRules.accepts(field, childNode.type())) {
        children.connect(field, childNode, location);
      } else {
        reading.error(
            location,
            SpellingSuggester.one(childNode.type().name())
                + " cannot be the "
                + field.name()
                + " of "
                + SpellingSuggester.one(node.type().name())
                + "; it is left out");
      }
    }
  }

  /**
   * Reads the IS element of an instance in another prototype's body. The values are set at once;
   * the connections are returned, to be made when the nodes of the instance exist.
   */
  List<Connection> arguments(ElementCursor in, NameScope scope, ProtoInstance inner) {
    List<Connection> connections = new ArrayList<>();
    ProtoInstance enclosing = scope.instance();
    while (in.next()) {
      Connection connection = outer(in, scope);
      if (connection != null && enclosing != null) {
        ProtoDeclaration.Field field = inner.declaration().fields().get(connection.nodeField());
        if (field == null && inner.declaration().lacking().contains(connection.nodeField())) {
          in.skip();
          continue;
        }
        if (field == null || field.type() != connection.field().type()) {
          mismatch(in.location(), inner.declaration().name(), connection);
        } else {
          connections.add(connection);
          Object value = enclosing.value(connection.field());
          if (value != null) {
            inner.give(field.name(), value);
            inner.turnsBack(enclosing);
          }
        }
      }
      in.skip();
    }
    return connections;
  }

  /** Reads the attributes of a connect element; null, after a message, if it is invalid. */
  private @Nullable Connection outer(ElementCursor in, NameScope scope) {
    ProtoInstance instance = scope.instance();
    String nodeField = in.attribute("nodeField");
    String protoField = in.attribute("protoField");
    if (instance == null) {
      reading.error(in.location(), "IS is allowed only in the body of a prototype; it is left out");
      return null;
    }
    if (!in.name().equals("connect") || nodeField == null || protoField == null) {
      reading.error(
          in.location(),
          "IS may contain only connect elements with nodeField and protoField; this "
              + "one is left out");
      return null;
    }
    ProtoDeclaration.Field field = instance.declaration().fields().get(protoField);
    if (field == null) {
      reading.error(
          in.location(),
          "the prototype "
              + instance.declaration().name()
              + " has no field "
              + protoField
              + reading.question(protoField, instance.declaration().fields().keySet())
              + "; the connection is left out");
      return null;
    }
    return new Connection(nodeField, field);
  }

  private void mismatch(SourceLocation location, String owner, Connection connection) {
    reading.error(
        location,
        owner
            + " has no field "
            + connection.nodeField()
            + " of type "
            + connection.field().type()
            + "; the connection is left out");
  }
}
