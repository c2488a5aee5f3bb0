package org.selectiverenderer.authoring.editing;

/**
 * A completion proposal.
 *
 * @param word the word that is matched with the typed text
 * @param text the text that replaces the typed word
 * @param caret position of the caret after insertion, counted from the start of the text
 * @param about a short description: a type, a default
 */
public record CompletionProposal(String word, String text, int caret, String about) {
  static CompletionProposal of(String word, String about) {
    return new CompletionProposal(word, word, word.length(), about);
  }

  @Override
  public String toString() {
    return word;
  }
}
