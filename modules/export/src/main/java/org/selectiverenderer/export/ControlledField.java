package org.selectiverenderer.export;

import java.util.HashMap;
import java.util.List;
import java.util.Map;
import java.util.Optional;
import org.selectiverenderer.base.problem.SourceLocation;
import org.selectiverenderer.schema.FieldReference;
import org.selectiverenderer.schema.SwitchSchemas;
import org.selectiverenderer.x3d.field.FieldType;

/**
 * A field whose value is a quality of an object.
 *
 * @param schemas those of its levels
 * @param levels the values of the levels, in the syntax of X3D's XML encoding
 * @param shown the level whose value the file has; -1 for none
 * @param begin the value that the file has, if it is of no level and known
 * @param routed whether others set the field, too: a ROUTE of the scene, or another quality
 * @param location where the quality stands
 */
record ControlledField(
    FieldReference target,
    FieldType type,
    SwitchSchemas schemas,
    List<String> levels,
    int shown,
    Optional<String> begin,
    boolean routed,
    SourceLocation location) {
  ControlledField {
    levels = List.copyOf(levels);
  }

  /** Returns the fields, those that several qualities set as routed. */
  static List<ControlledField> sharing(List<ControlledField> fields) {
    Map<FieldReference, Integer> uses = new HashMap<>();
    fields.forEach(field -> uses.merge(field.target(), 1, Integer::sum));
    return fields.stream()
        .map(field -> uses.getOrDefault(field.target(), 0) > 1 ? field.asRouted() : field)
        .toList();
  }

  private ControlledField asRouted() {
    return new ControlledField(target, type, schemas, levels, shown, begin, true, location);
  }
}
