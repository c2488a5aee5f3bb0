package org.selectiverenderer.x3d.write;

import org.jspecify.annotations.Nullable;
import org.selectiverenderer.x3d.field.FieldType;
import org.selectiverenderer.x3d.source.DocumentElement;

/** Determines the types of the attributes of statements. */
final class Statement {
  private Statement() {}

  /** Returns the type of an attribute; null if unknown. */
  static @Nullable FieldType type(DocumentElement element, String attribute, Interfaces known) {
    return switch (element.name() + " " + attribute) {
      case "component level" -> FieldType.SFInt32;
      case "unit conversionFactor" -> FieldType.SFDouble;
      case "ExternProtoDeclare url" -> FieldType.MFString;
      case "field value" -> Interfaces.type(element);
      case "fieldValue value" ->
          element
              .parent()
              .flatMap(instance -> instance.text("name"))
              .map(name -> known.type(name, element.text("name").orElse("")))
              .orElse(null);
      default -> FieldType.SFString;
    };
  }
}
