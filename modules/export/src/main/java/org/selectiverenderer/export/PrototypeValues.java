package org.selectiverenderer.export;

import java.util.ArrayList;
import java.util.HashSet;
import java.util.List;
import java.util.Optional;
import java.util.Set;
import org.selectiverenderer.authoring.EditRejectedException;
import org.selectiverenderer.authoring.SceneDocument;
import org.selectiverenderer.authoring.SourceFormatter;
import org.selectiverenderer.authoring.UniqueNameGenerator;
import org.selectiverenderer.authoring.structure.InlinedContent;
import org.selectiverenderer.x3d.source.DocumentElement;
import org.selectiverenderer.x3d.source.TextEdit;

/**
 * A prototype instance gives values to the fields of the nodes in the prototype's body that are
 * connected by IS (X3D 4.0, 4.4.4.3): its own, or the defaults of the declaration.
 */
final class PrototypeValues {
  private final SceneDocument document;
  private final DocumentElement instance;
  private final DocumentElement declaration;
  private final UniqueNameGenerator names;
  private final Set<String> placed = new HashSet<>();

  /**
   * @param names generates names that are free where the instance is
   */
  PrototypeValues(
      SceneDocument document,
      DocumentElement instance,
      DocumentElement declaration,
      UniqueNameGenerator names) {
    this.document = document;
    this.instance = instance;
    this.declaration = declaration;
    this.names = names;
  }

  /**
   * Returns the changes of the body's text that put the values in the place of IS.
   *
   * @throws EditRejectedException if a value cannot be written out, with the reason
   */
  List<TextEdit> edits() {
    List<TextEdit> edits = new ArrayList<>();
    declaration.visit(
        element -> {
          if (element.name().equals("IS")) {
            connect(element, edits);
          }
        });
    return edits;
  }

  private void connect(DocumentElement is, List<TextEdit> edits) {
    DocumentElement node = is.parent().orElseThrow();
    StringBuilder inside = new StringBuilder();
    for (DocumentElement connect : is.children()) {
      if (!connect.name().equals("connect")) {
        continue;
      }
      String to = connect.text("nodeField").orElse("");
      String from = connect.text("protoField").orElse("");
      Optional<DocumentElement> source = value(from);
      if (source.isEmpty()) {
        continue;
      }
      if (!source.get().children().isEmpty()) {
        inside.append(nodes(node, to, from, source.get()));
      } else if (source.get().text("value").isPresent()) {
        String value = source.get().text("value").get();
        if (node.name().equals("ProtoInstance")) {
          inside
              .append("<fieldValue")
              .append(SourceFormatter.written("name", to, '\''))
              .append(SourceFormatter.written("value", value, '\''))
              .append("/>");
        } else {
          edits.add(document.layout().attribute(field(node, to), attribute(node, to), value));
        }
      }
    }
    edits.add(new TextEdit(is.start(), is.end(), inside.toString()));
  }

  /** Returns the element that tells the value of a field of the prototype. */
  private Optional<DocumentElement> value(String field) {
    return named(instance, "fieldValue", field)
        .or(
            () ->
                declaration.children().stream()
                    .filter(child -> child.name().equals("ProtoInterface"))
                    .flatMap(child -> named(child, "field", field).stream())
                    .findFirst());
  }

  private static Optional<DocumentElement> named(
      DocumentElement parent, String element, String name) {
    return parent.children().stream()
        .filter(child -> child.name().equals(element) && child.text("name").orElse("").equals(name))
        .findFirst();
  }

  /** Returns the element whose attribute holds a field: that of the node, or of its declaration. */
  private static DocumentElement field(DocumentElement node, String name) {
    return named(node, "field", name).orElse(node);
  }

  private static String attribute(DocumentElement node, String name) {
    return named(node, "field", name).isPresent() ? "value" : name;
  }

  /** Returns nodes as the content of a field. */
  private String nodes(DocumentElement node, String to, String from, DocumentElement source) {
    if (!placed.add(from)) {
      throw new EditRejectedException(
          "its field %s gives a node to two others; put the object itself into the scene"
              .formatted(from));
    }
    List<TextEdit> fields = new ArrayList<>();
    for (DocumentElement child : source.children()) {
      boolean contained = child.text("containerField").isPresent();
      if (!to.equals("children") && !contained && !node.name().equals("ProtoInstance")) {
        int at = child.start() + 1 + child.name().length();
        fields.add(
            new TextEdit(at, at, SourceFormatter.written("containerField", to, '\'')));
      }
    }
    String text = text(source, fields);
    if (node.name().equals("ProtoInstance")) {
      String name = SourceFormatter.written("name", to, '\'');
      return "<fieldValue" + name + ">" + text + "</fieldValue>";
    }
    if (named(node, "field", to).isPresent()) {
      throw new EditRejectedException(
          "a Script in it takes nodes from its field %s; put the object itself into the scene"
              .formatted(from));
    }
    return text;
  }

  /**
   * Returns the text of the nodes in a field. Names of the instance's own nodes are names of the
   * scene already; those of the declaration may be taken there.
   */
  private String text(DocumentElement source, List<TextEdit> changes) {
    StringBuilder text = new StringBuilder();
    if (source.name().equals("field")) {
      InlinedContent content = new InlinedContent(document, source.children(), names, changes);
      source.children().forEach(child -> text.append(String.join("\n", content.lines(child))));
    } else {
      int at = source.children().get(0).start();
      int end = source.children().get(source.children().size() - 1).end();
      List<TextEdit> shifted =
          changes.stream()
              .map(each -> new TextEdit(each.from() - at, each.to() - at, each.text()))
              .toList();
      text.append(TextEdit.applied(shifted, document.text().toString().substring(at, end)));
    }
    return text.toString();
  }
}
