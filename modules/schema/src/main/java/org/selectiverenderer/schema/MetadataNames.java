package org.selectiverenderer.schema;

/**
 * Builds the DEF names of metadata nodes by the convention of the thesis (Figs 52, 77, 78), such as
 * {@code schemaBelonginessDefinitionTrashCan_Part1}.
 */
public final class MetadataNames {
  private static final String SWITCH = "Switch_";
  private static final String DEFINITION = "Definition";

  private MetadataNames() {}

  /** Returns the object's name in a Switch's DEF: TrashCan in {@code Switch_TrashCanDefinition}. */
  public static String object(String switchDef) {
    String name = switchDef;
    if (name.startsWith(SWITCH) && name.length() > SWITCH.length()) {
      name = name.substring(SWITCH.length());
    }
    return name.endsWith(DEFINITION) && name.length() > DEFINITION.length()
        ? name.substring(0, name.length() - DEFINITION.length())
        : name;
  }

  /**
   * Returns the name of the set of all metadata of a node.
   *
   * @param owner the name of an object or a sensor
   */
  public static String set(String owner) {
    return "MetadataSet_" + owner + DEFINITION;
  }

  /**
   * Returns the name of the set of metadata of one version of an object.
   *
   * @param index the index of the version, from 0
   */
  public static String part(String object, int index) {
    return "MetadataSet" + ofPart(object, index) + DEFINITION;
  }

  /** Returns the name of one version, part of the names of its MetadataStrings. */
  public static String ofPart(String object, int index) {
    return object + "_Part" + (index + 1);
  }

  /**
   * Returns the name of a MetadataString.
   *
   * @param about {@link #ofPart}, or the name of a sensor
   */
  public static String string(SchemaField field, String about) {
    return field.spelling() + DEFINITION + about;
  }
}
