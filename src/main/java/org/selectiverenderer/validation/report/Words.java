package org.selectiverenderer.validation.report;

import java.util.Locale;
import org.selectiverenderer.x3d.Problem.Severity;

/** Words that several formats use. */
final class Words {
  private Words() {}

  /** error, warning or info. */
  static String of(Severity severity) {
    return severity.name().toLowerCase(Locale.ROOT);
  }

  /** A number of things. */
  static String count(int number, String what) {
    return number + " " + what + (number == 1 ? "" : "s");
  }
}
