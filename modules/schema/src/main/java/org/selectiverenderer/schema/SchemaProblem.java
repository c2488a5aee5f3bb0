package org.selectiverenderer.schema;

/**
 * An error in the schema metadata of a node.
 *
 * @param message one sentence that says what is wrong and what the program does about it
 * @param metadata the metadata node with the error
 */
public record SchemaProblem(Kind kind, String message, MetadataNode metadata) {
  /** The kinds of errors. */
  public enum Kind {
    /** A schema field without a schema, so that the metadata has no effect. */
    NO_SCHEMA,
    /** A consistency type that is not one of the three. */
    UNKNOWN_TYPE,
    /** A degree of consistency that is neither low nor high nor a number from 0 to 1. */
    UNKNOWN_DEGREE,
    /** Several values where one is expected. */
    SEVERAL_VALUES,
    /** A MetadataSet without a corresponding choice of the Switch. */
    MORE_SETS_THAN_CHOICES,
    /** A choice of the Switch without a MetadataSet. */
    FEWER_SETS_THAN_CHOICES,
    /** A schema field on a node that it does not apply to. */
    MISPLACED,
    /** A quality that is none of the known words. */
    UNKNOWN_QUALITY,
    /** Choices of one Switch that name different qualities. */
    SEVERAL_QUALITIES,
    /** A field quality that does not say which field it sets. */
    UNKNOWN_FIELD,
    /** A second field quality of the same field. */
    FIELD_TWICE,
    /** A level without a value, or a field quality without levels. */
    NO_VALUE
  }
}
