package org.selectiverenderer.validation.language;

import java.util.List;
import org.selectiverenderer.x3d.source.DocumentElement;

/**
 * The declaration of a prototype.
 *
 * @param element a ProtoDeclare or an ExternProtoDeclare
 */
record PrototypeDeclaration(DocumentElement element) {
  boolean external() {
    return element.name().equals("ExternProtoDeclare");
  }

  String name() {
    return element.text("name").orElse("").strip();
  }

  NodeInterface fields() {
    List<DocumentElement> fields =
        external()
            ? element.children()
            : element.children().stream()
                .filter(child -> child.name().equals("ProtoInterface"))
                .flatMap(child -> child.children().stream())
                .toList();
    return NodeInterface.of(name(), java.util.Optional.empty(), fields);
  }

  /** Returns the elements of the body. */
  List<DocumentElement> body() {
    return element.children().stream()
        .filter(child -> child.name().equals("ProtoBody"))
        .flatMap(child -> child.children().stream())
        .toList();
  }
}
