package org.selectiverenderer.x3d.read;

import org.jspecify.annotations.Nullable;
import org.selectiverenderer.base.problem.Location;
import org.selectiverenderer.base.problem.Problem;
import org.selectiverenderer.base.problem.Problems;
import org.selectiverenderer.x3d.field.FieldType;
import org.selectiverenderer.x3d.source.DocumentElement;
import org.selectiverenderer.x3d.source.DocumentFault;
import org.selectiverenderer.x3d.source.XmlDocument;

/** Reads the prototype declarations of a file, without the nodes of its scene. */
final class LibraryReader {
  private final ReadState reading;
  private final Problems problems;
  private final ProtoDeclarationReader declarations;
  private final NameScope scope = new NameScope(null, null);
  private @Nullable String first;

  /**
   * Creates a reader of one file.
   *
   * @param problems the problems to which {@code reading} reports
   */
  LibraryReader(ReadState reading, Problems problems) {
    this.reading = reading;
    this.problems = problems;
    declarations = new ProtoDeclarationReader(reading);
  }

  PrototypeLibrary read(XmlDocument document) {
    for (DocumentFault fault : document.faults()) {
      boolean harmless = fault.kind() == DocumentFault.Kind.ENCODING;
      problems.add(
          new Problem(
              harmless ? Problem.Severity.WARNING : Problem.Severity.ERROR,
              fault.location(),
              harmless ? fault.message() : fault.message() + "; the part before it is kept"));
    }
    DocumentElement root = document.root().orElse(null);
    if (root != null && root.name().equals("X3D")) {
      for (DocumentElement child : root.children()) {
        if (child.name().equals("head")) {
          child.children().forEach(this::unit);
        } else if (child.name().equals("Scene")) {
          visit(child);
        }
      }
    } else if (!document.broken()) {
      reading.error(
          root == null ? Location.of(document.name()) : root.location(),
          "the file has no X3D element; it holds no prototypes");
    }
    return new PrototypeLibrary(document.name(), scope, first, problems.list());
  }

  private void unit(DocumentElement element) {
    if (element.name().equals("unit") && element.text("category").orElse("").equals("angle")) {
      element
          .attribute("conversionFactor")
          .map(factor -> (Double) factor.value(FieldType.SFDouble))
          .ifPresent(factor -> reading.angles(AngleUnit.of(factor)));
    }
  }

  private void visit(DocumentElement element) {
    for (DocumentElement child : element.children()) {
      switch (child.name()) {
        case "ProtoDeclare" -> {
          declarations.declare(TreeCursor.at(child, reading), scope);
          first = first == null ? child.text("name").orElse(null) : first;
        }
        case "ExternProtoDeclare" ->
            declarations.declareExternal(TreeCursor.at(child, reading), scope);
        default -> visit(child);
      }
    }
  }
}
