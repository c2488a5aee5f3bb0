package org.selectiverenderer.x3d.read;

import org.jspecify.annotations.Nullable;
import org.selectiverenderer.base.problem.Problem;
import org.selectiverenderer.base.problem.ProblemCollector;
import org.selectiverenderer.base.problem.SourceLocation;
import org.selectiverenderer.x3d.field.FieldType;
import org.selectiverenderer.x3d.source.DocumentElement;
import org.selectiverenderer.x3d.source.DocumentError;
import org.selectiverenderer.x3d.source.XmlDocument;

/** Reads the prototype declarations of a file, without the nodes of its scene. */
final class PrototypeLibraryReader {
  private final ReadContext reading;
  private final ProblemCollector problems;
  private final ProtoDeclarationReader declarations;
  private final NameScope scope = new NameScope(null, null);
  private @Nullable String first;

  /**
   * Creates a reader of one file.
   *
   * @param problems the problems to which {@code reading} reports
   */
  PrototypeLibraryReader(ReadContext reading, ProblemCollector problems) {
    this.reading = reading;
    this.problems = problems;
    declarations = new ProtoDeclarationReader(reading);
  }

  PrototypeLibrary read(XmlDocument document) {
    for (DocumentError fault : document.faults()) {
      boolean harmless = fault.kind() == DocumentError.Kind.ENCODING;
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
          root == null ? SourceLocation.of(document.name()) : root.location(),
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
