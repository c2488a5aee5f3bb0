package org.selectiverenderer.enricher.form;

/** The result of parsing what an author typed. */
sealed interface ParseResult<T> {
  /** The text is valid. */
  record Valid<T>(T value) implements ParseResult<T> {}

  /**
   * The text is invalid.
   *
   * @param why a sentence that says what is wrong and what would be right
   */
  record Wrong<T>(String why) implements ParseResult<T> {}
}
