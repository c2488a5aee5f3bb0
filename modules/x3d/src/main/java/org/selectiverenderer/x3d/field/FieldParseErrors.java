package org.selectiverenderer.x3d.field;

import java.util.ArrayList;
import java.util.List;
import org.selectiverenderer.base.problem.Problem;

/**
 * Collects the errors in the text of one value, up to a limit, for values of a million bad numbers.
 */
public final class FieldParseErrors {
  /** The maximum number of errors kept per value; the rest are counted. */
  private static final int LIMIT = 10;

  private final List<FieldParser.Flaw> list = new ArrayList<>();
  private int more;

  void error(int offset, String message) {
    add(Problem.Severity.ERROR, offset, message);
  }

  void warning(int offset, String message) {
    add(Problem.Severity.WARNING, offset, message);
  }

  private void add(Problem.Severity severity, int offset, String message) {
    if (list.size() < LIMIT) {
      list.add(new FieldParser.Flaw(offset, severity, message));
    } else {
      more++;
    }
  }

  /** Replaces all errors by one that says that the default is used: the first one, or this. */
  void unusable(String message) {
    FieldParser.Flaw first = list.isEmpty() ? null : list.get(0);
    list.clear();
    more = 0;
    if (first == null) {
      error(0, message);
    } else {
      error(first.offset(), first.message().replaceFirst(";.*", "") + "; the default is used");
    }
  }

  /** Returns whether there are no errors. */
  public boolean isEmpty() {
    return list.isEmpty();
  }

  /** Returns the errors in the order in which they were found. */
  public List<FieldParser.Flaw> list() {
    if (more > 0) {
      FieldParser.Flaw last = list.get(LIMIT - 1);
      list.set(
          LIMIT - 1,
          new FieldParser.Flaw(
              last.offset(),
              last.severity(),
              last.message() + "; the same value has " + more + " more such problems"));
      more = 0;
    }
    return List.copyOf(list);
  }
}
