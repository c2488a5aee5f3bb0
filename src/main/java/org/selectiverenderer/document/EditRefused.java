package org.selectiverenderer.document;

/**
 * An edit cannot be made without harm; the document is as it was. The message is for the author.
 */
public final class EditRefused extends RuntimeException {
  private static final long serialVersionUID = 1L;

  /**
   * @param sentence why, and what to do
   */
  public EditRefused(String sentence) {
    super(sentence);
  }
}
