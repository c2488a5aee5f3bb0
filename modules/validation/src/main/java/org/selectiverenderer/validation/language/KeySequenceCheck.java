package org.selectiverenderer.validation.language;

import java.lang.reflect.Array;
import org.jspecify.annotations.Nullable;
import org.selectiverenderer.validation.FileCheck;
import org.selectiverenderer.validation.FileContext;
import org.selectiverenderer.validation.FindingCollector;
import org.selectiverenderer.x3d.catalogue.NodeType;
import org.selectiverenderer.x3d.field.FieldType;
import org.selectiverenderer.x3d.source.DocumentAttribute;
import org.selectiverenderer.x3d.source.DocumentElement;

/** Checks the keys of interpolators and sequencers, and the ranges of LOD nodes. */
final class KeySequenceCheck implements FileCheck {
  @Override
  public void check(FileContext file, FindingCollector findings) {
    for (DocumentElement element : file.document().elements()) {
      NodeType type = file.catalogue().find(element.name()).orElse(null);
      if (type == null || element.attribute("USE").isPresent()) {
        continue;
      }
      if (type.is("X3DInterpolatorNode") || type.is("X3DSequencerNode")) {
        keys(element, type, findings);
      } else if (type.name().equals("LOD")) {
        float[] range = floats(element, "range");
        int at = range == null ? 0 : firstWrong(range, true);
        if (at > 0) {
          DocumentAttribute attribute = element.attribute("range").orElseThrow();
          findings.add(SequenceRules.RANGE_ORDER, attribute, range[at - 1], range[at]);
        }
      }
    }
  }

  private static void keys(DocumentElement element, NodeType type, FindingCollector findings) {
    float[] keys = floats(element, "key");
    if (keys == null) {
      return; // Its keys are set by IS or an event.
    }
    int at = firstWrong(keys, false);
    if (at > 0) {
      DocumentAttribute attribute = element.attribute("key").orElseThrow();
      findings.add(SequenceRules.KEY_ORDER, attribute, keys[at - 1], keys[at]);
    }
    values(element, type, keys.length, findings);
  }

  private static void values(
      DocumentElement element, NodeType type, int keys, FindingCollector findings) {
    DocumentAttribute values = element.attribute("keyValue").orElse(null);
    FieldType valueType = type.field("keyValue").map(field -> field.type()).orElse(null);
    Object list = values == null || valueType == null ? null : values.value(valueType);
    if (values == null || valueType == null || list == null || !values.flaws(valueType).isEmpty()) {
      return;
    }
    int count = Array.getLength(list) / Math.max(1, valueType.components());
    // Coordinate and normal interpolators have several values for each key.
    boolean several =
        type.name().startsWith("CoordinateInterpolator")
            || type.name().equals("NormalInterpolator");
    boolean fits = several ? keys == 0 ? count == 0 : count % keys == 0 : count == keys;
    if (!fits) {
      String needed = several ? "a multiple of " + keys + " is needed" : keys + " are needed";
      findings.add(SequenceRules.KEY_COUNT, values, "keyValue", count, needed, keys);
    }
  }

  /**
   * Returns the index of the first number that is less than the one before it, or, if {@code
   * growing}, not greater; 0 if there is none.
   */
  private static int firstWrong(float[] numbers, boolean growing) {
    for (int i = 1; i < numbers.length; i++) {
      if (growing ? numbers[i] <= numbers[i - 1] : numbers[i] < numbers[i - 1]) {
        return i;
      }
    }
    return 0;
  }

  private static float @Nullable [] floats(DocumentElement element, String field) {
    DocumentAttribute attribute = element.attribute(field).orElse(null);
    return attribute != null
            && attribute.value(FieldType.MFFloat) instanceof float[] numbers
            && attribute.flaws(FieldType.MFFloat).isEmpty()
        ? numbers
        : null;
  }
}
