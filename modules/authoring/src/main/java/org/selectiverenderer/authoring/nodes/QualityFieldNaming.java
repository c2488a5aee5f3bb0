package org.selectiverenderer.authoring.nodes;

import java.util.List;
import java.util.Optional;
import java.util.function.UnaryOperator;
import org.selectiverenderer.authoring.MFStringParser;
import org.selectiverenderer.authoring.SourceFormatter;
import org.selectiverenderer.schema.FieldQuality;
import org.selectiverenderer.schema.FieldReference;
import org.selectiverenderer.x3d.source.DocumentElement;
import org.selectiverenderer.x3d.source.TextEdit;
import org.selectiverenderer.x3d.write.FieldValueFormatter;

/** Renames nodes where the qualities of objects name a field of them: {@code SofaTexture.url}. */
final class QualityFieldNaming {
  private QualityFieldNaming() {}

  /**
   * Returns the change of a MetadataString that names a field of a renamed node; empty for all
   * other elements.
   *
   * @param renamed returns the new name of a node, or the same
   */
  static Optional<TextEdit> change(
      SourceFormatter layout, DocumentElement element, UnaryOperator<String> renamed) {
    if (!namesField(element) || element.isReference()) {
      return Optional.empty();
    }
    return element
        .text("value")
        .flatMap(value -> MFStringParser.strings(value).stream().findFirst())
        .flatMap(FieldReference::of)
        .filter(target -> !renamed.apply(target.node()).equals(target.node()))
        .map(target -> new FieldReference(renamed.apply(target.node()), target.field()))
        .map(
            target ->
                layout.attribute(
                    element, "value", FieldValueFormatter.strings(List.of(target.toString()))));
  }

  private static boolean namesField(DocumentElement element) {
    return element.name().equals("MetadataString")
        && element.text("name").filter(name -> name.strip().equals("field")).isPresent()
        && element
            .parent()
            .flatMap(DocumentElement::parent)
            .flatMap(set -> set.text("name"))
            .filter(name -> name.strip().equals(FieldQuality.SET))
            .isPresent();
  }
}
