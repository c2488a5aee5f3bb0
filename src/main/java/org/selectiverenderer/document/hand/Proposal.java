package org.selectiverenderer.document.hand;

/**
 * Something that may be typed at the caret.
 *
 * @param word that it is found by
 * @param text that comes in the place of the word begun
 * @param caret where one goes on typing, counted from the start of that text
 * @param about a few words about it: a type, a default
 */
public record Proposal(String word, String text, int caret, String about) {
  static Proposal of(String word, String about) {
    return new Proposal(word, word, word.length(), about);
  }

  @Override
  public String toString() {
    return word;
  }
}
