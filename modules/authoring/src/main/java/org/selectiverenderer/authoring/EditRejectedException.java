package org.selectiverenderer.authoring;

/**
 * Thrown when an edit would damage the document, which stays unchanged. The message is for the
 * author.
 */
public final class EditRejectedException extends RuntimeException {
  private static final long serialVersionUID = 1L;

  /**
   * @param sentence the reason, and what to do
   */
  public EditRejectedException(String sentence) {
    super(sentence);
  }
}
