package org.selectiverenderer.x3d.vrml1;

/**
 * The value of a field as it is written.
 *
 * @param at the offset of the field's name
 * @param from the offset of the value, after a bracket or parenthesis
 * @param to the offset after the value
 */
record Vrml1Field(Form form, int at, int from, int to) {
  /** The syntactic forms of values. */
  enum Form {
    /** Numbers without brackets. */
    NUMBERS,
    /** A string; its quotes are at {@code from} and before {@code to}. */
    STRING,
    /** A list in brackets. */
    LIST,
    /** A word, such as TRUE, or words in parentheses. */
    WORDS
  }
}
