package org.selectiverenderer.authoring.editing;

import java.util.ArrayList;
import java.util.List;
import java.util.regex.Matcher;
import java.util.regex.Pattern;
import java.util.regex.PatternSyntaxException;
import org.selectiverenderer.authoring.Edit;
import org.selectiverenderer.x3d.source.TextEdit;

/**
 * Finds words or regular expressions in a text, and replaces them. An expression that takes too
 * long is aborted with a message.
 */
public final class TextSearch {
  /** The largest number of hits; further ones are not searched. */
  public static final int MOST = 100_000;

  /**
   * The largest number of characters that an expression may read: about 10 for each character of a
   * scene of 30 MB.
   */
  private static final long EFFORT = 400_000_000L;

  private final Pattern pattern;
  private final boolean expression;

  /**
   * The search criteria.
   *
   * @param words the words, or a regular expression of {@link Pattern}
   * @param expression whether {@code words} is a regular expression
   * @param matchCase whether the search is case-sensitive
   * @param wholeWords whether hits must not be preceded or followed by letters, digits or
   *     underscores
   */
  public record Wanted(String words, boolean expression, boolean matchCase, boolean wholeWords) {}

  /** Thrown when a search is not possible; the message is a sentence for the author. */
  public static final class BadSearch extends Exception {
    private static final long serialVersionUID = 1L;

    BadSearch(String sentence) {
      super(sentence);
    }
  }

  /**
   * A range of the text.
   *
   * @param from offset of its first character
   * @param to offset after its last one
   */
  public record Hit(int from, int to) {}

  private TextSearch(Pattern pattern, boolean expression) {
    this.pattern = pattern;
    this.expression = expression;
  }

  /**
   * Creates a search.
   *
   * @throws BadSearch if the expression is invalid
   */
  public static TextSearch of(Wanted wanted) throws BadSearch {
    int flags = Pattern.MULTILINE;
    if (!wanted.matchCase()) {
      flags |= Pattern.CASE_INSENSITIVE | Pattern.UNICODE_CASE;
    }
    String words = wanted.expression() ? wanted.words() : Pattern.quote(wanted.words());
    String whole =
        wanted.wholeWords() ? "(?<![\\p{L}\\p{N}_])(?:" + words + ")(?![\\p{L}\\p{N}_])" : words;
    try {
      return new TextSearch(Pattern.compile(whole, flags), wanted.expression());
    } catch (PatternSyntaxException e) {
      String why = e.getDescription() == null ? "" : ": " + e.getDescription();
      throw new BadSearch("This is not a valid regular expression" + why);
    }
  }

  /**
   * Returns the hits in a part of a text in order, without overlaps, at most {@link #MOST}. Empty
   * hits, such as a line's end, are left out.
   *
   * @throws BadSearch if the pattern takes too long
   */
  public List<Hit> all(CharSequence text, int from, int to) throws BadSearch {
    List<Hit> hits = new ArrayList<>();
    each(text, from, to, matcher -> hits.add(new Hit(matcher.start(), matcher.end())));
    return hits;
  }

  private interface Found {
    void add(Matcher matcher) throws BadSearch;
  }

  private void each(CharSequence text, int from, int to, Found found) throws BadSearch {
    Matcher matcher = pattern.matcher(new Bounded(text));
    matcher.useTransparentBounds(true);
    matcher.region(from, to);
    int count = 0;
    try {
      while (count < MOST && matcher.find()) {
        if (matcher.end() > matcher.start()) {
          found.add(matcher);
          count++;
        }
      }
    } catch (TooMuch | StackOverflowError e) {
      // Both mean too much backtracking: Java's patterns recurse for some repetitions.
      throw new BadSearch("This expression takes too long on this text; use a simpler one");
    }
  }

  /**
   * Replaces every hit in a part of a text.
   *
   * @param name name of the undo step
   * @param replacement text; of an expression with {@code $1} for its first group, and so on
   * @throws BadSearch if the pattern takes too long, or the replacement names a group that is not
   *     there
   */
  public Edit replaceAll(CharSequence text, int from, int to, String replacement, String name)
      throws BadSearch {
    List<TextEdit> changes = new ArrayList<>();
    each(text, from, to, matcher -> changes.add(change(matcher, replacement)));
    return new Edit(name, changes);
  }

  /**
   * Replaces one hit.
   *
   * @throws BadSearch likewise, or if the hit does not match any more
   */
  public Edit replace(CharSequence text, Hit hit, String replacement, String name)
      throws BadSearch {
    List<TextEdit> changes = new ArrayList<>();
    each(text, hit.from(), hit.to(), matcher -> changes.add(change(matcher, replacement)));
    if (changes.size() != 1) {
      throw new BadSearch("The text found here has changed; search again");
    }
    return new Edit(name, changes);
  }

  private TextEdit change(Matcher matcher, String replacement) throws BadSearch {
    if (!expression) {
      return new TextEdit(matcher.start(), matcher.end(), replacement);
    }
    StringBuilder into = new StringBuilder();
    for (int i = 0; i < replacement.length(); i++) {
      char c = replacement.charAt(i);
      boolean more = i + 1 < replacement.length();
      if (c == '\\' && more) {
        i++;
        into.append(escaped(replacement.charAt(i)));
      } else if (c == '$' && more && Character.digit(replacement.charAt(i + 1), 10) >= 0) {
        i++;
        int group = Character.digit(replacement.charAt(i), 10);
        if (group > matcher.groupCount()) {
          throw new BadSearch(
              "The expression has no group " + group + "; write \\$ for a dollar sign");
        }
        String value = matcher.group(group);
        into.append(value == null ? "" : value);
      } else {
        into.append(c);
      }
    }
    return new TextEdit(matcher.start(), matcher.end(), into.toString());
  }

  private static char escaped(char c) {
    return switch (c) {
      case 'n' -> '\n';
      case 't' -> '\t';
      default -> c;
    };
  }

  private static final class TooMuch extends RuntimeException {
    private static final long serialVersionUID = 1L;

    TooMuch() {
      super("too many characters looked at", null, false, false);
    }
  }

  /** A character sequence that limits the number of characters read by a pattern. */
  private static final class Bounded implements CharSequence {
    private final CharSequence text;
    private long left = EFFORT;

    Bounded(CharSequence text) {
      this.text = text;
    }

    @Override
    public int length() {
      return text.length();
    }

    @Override
    public char charAt(int index) {
      left--;
      if (left < 0) {
        throw new TooMuch();
      }
      return text.charAt(index);
    }

    @Override
    public CharSequence subSequence(int start, int end) {
      return text.subSequence(start, end);
    }

    @Override
    public String toString() {
      return text.toString();
    }
  }
}
