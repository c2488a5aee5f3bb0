package org.selectiverenderer.schema;

/**
 * Something wrong with the metadata of a node.
 *
 * @param message one sentence: what is wrong and what is done about it
 * @param metadata the metadata node that is at fault
 */
public record SchemaProblem(Kind kind, String message, MetadataSource metadata) {
  /** What can be wrong. */
  public enum Kind {
    /** A place for a schema has none, so that the metadata has no effect. */
    NO_SCHEMA,
    /** A consistency type that is not one of the three. */
    UNKNOWN_TYPE,
    /** A degree of consistency that is neither low nor high nor a number from 0 to 1. */
    UNKNOWN_DEGREE,
    /** Several values where one is expected. */
    SEVERAL_VALUES,
    /** A MetadataSet that has no child of the Switch to describe. */
    MORE_SETS_THAN_CHOICES,
    /** A child of the Switch that has no MetadataSet. */
    FEWER_SETS_THAN_CHOICES,
    /** A name of the vocabulary where it means nothing. */
    MISPLACED
  }
}
