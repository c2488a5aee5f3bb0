package org.selectiverenderer.x3d.read;

import java.util.ArrayList;
import java.util.HashMap;
import java.util.List;
import java.util.Map;
import java.util.Set;
import org.jspecify.annotations.Nullable;
import org.selectiverenderer.base.problem.SourceLocation;
import org.selectiverenderer.x3d.catalogue.AccessType;
import org.selectiverenderer.x3d.catalogue.FieldDefinition;
import org.selectiverenderer.x3d.field.FieldType;
import org.selectiverenderer.x3d.source.DocumentElement;

/**
 * Reads the {@code field} elements of one Script or shader node, its author-defined fields (X3D
 * 4.0, 29.2.2 and 31.2.2.3). They and their IS connections are added to the node at its end.
 */
final class AuthorDefinedFieldReader {
  /** A repeated declaration of a field, as in ClassicVRML for each further IS of the field. */
  private record Repeated(String name, SourceLocation location) {}

  private final ParsedNode node;
  private final ReadContext reading;
  private final List<FieldDefinition> fields = new ArrayList<>();
  private final List<@Nullable Object> values = new ArrayList<>();
  private final List<DocumentElement> connections = new ArrayList<>();
  private final Map<String, FieldDeclaration> names = new HashMap<>();
  private final List<Repeated> repeated = new ArrayList<>();

  AuthorDefinedFieldReader(ParsedNode node, ReadContext reading) {
    this.node = node;
    this.reading = reading;
  }

  /** Reads the current element, a {@code field}, to its end. */
  void read(ElementCursor in, NameScope scope, NodeReader nodes) {
    SourceLocation location = in.location();
    FieldDeclaration declared = FieldDeclaration.of(in);
    if (declared == null) {
      reading.error(
          location,
          "a field of a "
              + node.type()
              + " needs a name, a type such as SFFloat, and one of the accessTypes "
              + "initializeOnly, inputOnly, outputOnly and inputOutput; this one is left out");
    } else if (declared.equals(names.get(declared.name())) && in.indexOf("value") < 0) {
      repeated.add(new Repeated(declared.name(), location));
      declared = null;
    } else if (ParsedNode.TAKEN_NAMES.contains(declared.name())
        || names.putIfAbsent(declared.name(), declared) != null) {
      there(declared.name(), location);
      declared = null;
    }
    Object value = value(in, declared);
    List<ParsedNode> inner = new ArrayList<>();
    Set<ParsedNode> open = scope.closeAll();
    while (in.next()) {
      if (in.name().equals("IS")) {
        in.skip(); // a field is connected by the IS of its node (ISO/IEC 19776-1, 4.3.11)
      } else {
        NodeReader.Child child = nodes.read(in, scope);
        if (child != null) {
          inner.add(child.node());
        }
      }
    }
    scope.reopen(open);
    if (declared != null && reading.spend(location)) {
      if (declared.type().isNode() && declared.access().initialisable()) {
        value = nodes(declared, inner, location);
      }
      fields.add(
          FieldDefinition.own(
              node.type().fields().size() + fields.size(),
              declared.name(),
              declared.type(),
              declared.access()));
      values.add(value);
    }
  }

  private void there(String name, SourceLocation location) {
    reading.error(
        location,
        "the "
            + node.type()
            + " has a field "
            + name
            + " already; this one is left out; give it another name");
  }

  /** Returns whether IS connects a field with several fields of the prototype. */
  private boolean connectedTwice(String name) {
    return connections.stream()
            .flatMap(is -> is.children().stream())
            .filter(connect -> connect.text("nodeField").filter(name::equals).isPresent())
            .count()
        > 1;
  }

  private @Nullable Object value(ElementCursor in, @Nullable FieldDeclaration declared) {
    int attribute = in.indexOf("value");
    if (declared == null || attribute < 0) {
      return null;
    }
    AccessType access = declared.access();
    if (!access.initialisable()) {
      if (!in.attributeText(attribute).isBlank()) {
        reading.warning(
            reading.at(in.place(), attribute),
            declared.name()
                + " is "
                + access.spelling()
                + " and cannot have a value in a file; it is left out");
      }
      return null;
    }
    if (declared.type().isNode()) {
      if (!in.attributeText(attribute).isBlank() && !in.attributeText(attribute).equals("NULL")) {
        reading.warning(
            reading.at(in.place(), attribute),
            "the value of " + declared.name() + " must be a child element; it is left out");
      }
      return null;
    }
    return in.attributeValue(attribute, declared.type());
  }

  private @Nullable Object nodes(
      FieldDeclaration declared, List<ParsedNode> inner, SourceLocation location) {
    if (declared.type() == FieldType.MFNode) {
      return List.copyOf(inner);
    }
    if (inner.size() > 1) {
      reading.error(
          location,
          declared.name() + " can have only one node; those after the first are left out");
    }
    return inner.isEmpty() ? null : inner.get(0);
  }

  /** Records the current element, an IS, until all fields are known. */
  void connectLater(ElementCursor in) {
    connections.add(in.record());
  }

  /** Returns the recorded IS elements. */
  List<DocumentElement> connections() {
    return connections;
  }

  /** Adds the fields and their values to the node. */
  void declare() {
    for (Repeated one : repeated) {
      if (!connectedTwice(one.name())) {
        there(one.name(), one.location());
      }
    }
    if (fields.isEmpty()) {
      return;
    }
    node.declare(fields);
    for (int i = 0; i < fields.size(); i++) {
      Object value = values.get(i);
      if (value != null) {
        node.put(fields.get(i).index(), value);
      }
    }
  }
}
