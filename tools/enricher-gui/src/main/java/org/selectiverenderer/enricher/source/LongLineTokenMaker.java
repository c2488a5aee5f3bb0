package org.selectiverenderer.enricher.source;

import javax.swing.text.Segment;
import org.fife.ui.rsyntaxtextarea.Token;
import org.fife.ui.rsyntaxtextarea.TokenTypes;
import org.fife.ui.rsyntaxtextarea.modes.XMLTokenMaker;

/**
 * Splits lines of XML into tokens that are short, because the text area measures a token anew for
 * each of its characters: a click into one of 120,000 took half a minute. A line longer than {@link
 * #COLORED} has only plain tokens, because the pool of tokens grows in quadratic time; lines after
 * it are coloured as usual.
 */
final class LongLineTokenMaker extends XMLTokenMaker {
  /** Most characters of a line that has colours. */
  static final int COLORED = 200_000;

  /** Most characters of a token. */
  static final int PIECE = 256;

  /** Characters of a line that are parsed at once for the state after it. */
  private static final int CHUNK = 16_384;

  private boolean withinLine;

  /** Sets whether the text begins within a line, which then is plain: its state is not known. */
  void beginWithinLine(boolean within) {
    withinLine = within;
  }

  /** Returns the number of characters in lines that have colours. */
  static int colored(String text) {
    int sum = 0;
    for (int from = 0; from < text.length(); ) {
      int end = text.indexOf('\n', from);
      end = end < 0 ? text.length() : end;
      sum += end - from > COLORED ? 0 : end - from + 1;
      from = end + 1;
    }
    return sum;
  }

  @Override
  public void addToken(char[] array, int start, int end, int type, int offset, boolean link) {
    int from = start;
    int at = offset;
    for (; end - from >= PIECE; from += PIECE, at += PIECE) {
      super.addToken(array, from, from + PIECE - 1, type, at, link);
    }
    super.addToken(array, from, end, type, at, link);
  }

  @Override
  public Token getTokenList(Segment text, int initialType, int offset) {
    return plain(text, offset)
        ? plainTokens(text, offset)
        : super.getTokenList(text, initialType, offset);
  }

  private boolean plain(Segment text, int offset) {
    return text.count > COLORED || withinLine && offset == 0;
  }

  private Token plainTokens(Segment text, int offset) {
    resetTokenList();
    if (text.count > 0) {
      addToken(
          text.array,
          text.offset,
          text.offset + text.count - 1,
          TokenTypes.IDENTIFIER,
          offset,
          false);
    }
    addNullToken();
    return firstToken;
  }

  /** Parses a line chunk by chunk, with few tokens at a time. */
  @Override
  public int getLastTokenTypeOnLine(Segment text, int initialType) {
    int type = initialType;
    int end = text.offset + text.count;
    int from = text.offset;
    do {
      int to = end - from > CHUNK ? afterSpace(text.array, from + CHUNK, end) : end;
      Token last = super.getTokenList(new Segment(text.array, from, to - from), type, 0);
      while (last.getNextToken() != null) {
        last = last.getNextToken();
      }
      type = last.getType();
      from = to;
    } while (from < end);
    return type;
  }

  /** Returns the offset after the next white space, where no delimiter of XML is cut. */
  private static int afterSpace(char[] text, int from, int end) {
    int to = from;
    while (to < end && !Character.isWhitespace(text[to - 1])) {
      to++;
    }
    return to;
  }
}
