package org.selectiverenderer.schema;

/**
 * The DEF names of metadata nodes as the thesis gives them (Figs 52, 77, 78), such as {@code
 * schemaBelonginessDefinitionTrashCan_Part1}.
 */
public final class MetadataNames {
  private static final String SWITCH = "Switch_";
  private static final String DEFINITION = "Definition";

  private MetadataNames() {}

  /** The object's own name: {@code Switch_TrashCanDefinition} is about TrashCan. */
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
   * Of the set of all metadata of a node.
   *
   * @param owner an object's name, or a sensor's
   */
  public static String set(String owner) {
    return "MetadataSet_" + owner + DEFINITION;
  }

  /**
   * Of the set about one version of an object.
   *
   * @param index of the version, from 0
   */
  public static String part(String object, int index) {
    return "MetadataSet" + ofPart(object, index) + DEFINITION;
  }

  /** What the strings about one version are named after. */
  public static String ofPart(String object, int index) {
    return object + "_Part" + (index + 1);
  }

  /**
   * Of a string.
   *
   * @param about {@link #ofPart}, or a sensor's name
   */
  public static String string(SchemaField field, String about) {
    return field.spelling() + DEFINITION + about;
  }
}
