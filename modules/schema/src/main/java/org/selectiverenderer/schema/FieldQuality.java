package org.selectiverenderer.schema;

import java.util.List;

/**
 * A quality of an object that is the value of one field, chosen independently of the version that
 * the object's Switch shows and of its other qualities. So two qualities of two levels each need no
 * four versions.
 *
 * @param quality what the levels differ in
 * @param target the field that is set
 * @param levels the values to choose from; at least one
 */
public record FieldQuality(Quality quality, FieldReference target, List<FieldLevel> levels) {
  /** The name of the MetadataSet with an object's field qualities. */
  public static final String SET = "fieldQualities";

  /** The types of fields whose values metadata can hold, as X3D spells them. */
  public static final List<String> TYPES =
      List.of(
          "SFBool",
          "SFInt32",
          "SFFloat",
          "SFDouble",
          "SFTime",
          "SFString",
          "SFColor",
          "MFString",
          "MFInt32",
          "MFFloat",
          "MFDouble");

  /** Makes a defensive copy of the list. */
  public FieldQuality {
    levels = List.copyOf(levels);
  }

  /** Returns the schemas of the levels, as if each level were a choice of a Switch. */
  public SwitchSchemas schemas() {
    return new SwitchSchemas(levels.stream().map(FieldLevel::metadata).toList(), quality);
  }
}
