package org.selectiverenderer.enricher.form;

/** What an author typed, understood or not. */
sealed interface Input<T> {
  /** It means something. */
  record Valid<T>(T value) implements Input<T> {}

  /**
   * It cannot be written.
   *
   * @param why and what would be right, as a sentence
   */
  record Wrong<T>(String why) implements Input<T> {}
}
