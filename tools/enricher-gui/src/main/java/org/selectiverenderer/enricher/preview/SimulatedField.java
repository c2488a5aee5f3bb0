package org.selectiverenderer.enricher.preview;

import java.util.ArrayList;
import java.util.List;
import java.util.Optional;
import org.jspecify.annotations.Nullable;
import org.selectiverenderer.browser.scene.EventCascade;
import org.selectiverenderer.browser.scene.Node;
import org.selectiverenderer.schema.FieldLevel;
import org.selectiverenderer.schema.FieldQuality;
import org.selectiverenderer.schema.SwitchSchemas;
import org.selectiverenderer.x3d.catalogue.AccessType;
import org.selectiverenderer.x3d.catalogue.FieldDefinition;
import org.selectiverenderer.x3d.field.FieldParser;
import org.selectiverenderer.x3d.field.FieldType;

/** A field that is a quality of an object in the preview, with its values as levels. */
final class SimulatedField {
  /** The level of the value that the scene has. */
  static final int AT_START = -1;

  private final Node node;
  private final int index;
  private final FieldQuality quality;
  private final Object atStart;
  private final List<Object> values;
  private int shown = AT_START;

  private SimulatedField(
      Node node, int index, FieldQuality quality, Object atStart, List<Object> values) {
    this.node = node;
    this.index = index;
    this.quality = quality;
    this.atStart = atStart;
    this.values = values;
  }

  /** Returns the field of a quality; empty if the node has none, or a level is no value of it. */
  static Optional<SimulatedField> of(FieldQuality quality, Node node) {
    Optional<FieldDefinition> field =
        node.type()
            .field(quality.target().field())
            .filter(of -> of.access() == AccessType.INPUT_OUTPUT && !of.type().isNode());
    if (field.isEmpty()) {
      return Optional.empty();
    }
    List<Object> values = new ArrayList<>();
    for (FieldLevel level : quality.levels()) {
      Object value = value(field.get().type(), level.values());
      if (value == null) {
        return Optional.empty(); // The document's findings report it.
      }
      values.add(value);
    }
    int index = field.get().index();
    return Optional.ofNullable(node.value(index))
        .map(now -> new SimulatedField(node, index, quality, now, List.copyOf(values)));
  }

  private static @Nullable Object value(FieldType type, List<String> strings) {
    return type == FieldType.MFString
        ? strings.toArray(String[]::new)
        : new FieldParser().parse(type, String.join(" ", strings)).value();
  }

  SwitchSchemas schemas() {
    return quality.schemas();
  }

  /** Sets the value of a level, or that of the scene. */
  void show(int level, EventCascade cascade) {
    if (level != shown) {
      shown = level;
      cascade.send(node, index, level < 0 ? atStart : values.get(level));
    }
  }
}
