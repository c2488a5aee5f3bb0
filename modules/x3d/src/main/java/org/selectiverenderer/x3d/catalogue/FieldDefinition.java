package org.selectiverenderer.x3d.catalogue;

import java.util.List;
import org.jspecify.annotations.Nullable;
import org.selectiverenderer.x3d.field.FieldType;

/**
 * The definition of a field of a node type.
 *
 * @param index position among the fields of its node type, from 0
 * @param name for example {@code whichChoice}
 * @param defaultText the default as X3D text; empty if the standard gives none
 * @param min lower bound as the catalogue writes it ({@code 0}, {@code >0}); empty if unbounded
 * @param max upper bound, in the same form
 * @param values the values that the standard allows for a string; empty if any is allowed
 * @param nodeTypes names of the node types that an SFNode or MFNode accepts
 * @param defaultValue the default, as {@link FieldType} represents it; null for an SFNode
 */
public record FieldDefinition(
    int index,
    String name,
    FieldType type,
    AccessType access,
    String defaultText,
    String min,
    String max,
    List<String> values,
    List<String> nodeTypes,
    @Nullable Object defaultValue) {

  /**
   * Returns the definition of an author-defined field, without bounds and for nodes of any type.
   *
   * @param index the index among the fields of the node's own type
   */
  public static FieldDefinition own(int index, String name, FieldType type, AccessType access) {
    return new FieldDefinition(
        index, name, type, access, "", "", "", List.of(), List.of(), type.zero());
  }

  @Override
  public String toString() {
    return access.spelling() + " " + type + " " + name;
  }
}
