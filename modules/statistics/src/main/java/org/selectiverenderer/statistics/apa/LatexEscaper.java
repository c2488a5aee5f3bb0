package org.selectiverenderer.statistics.apa;

import java.util.Map;

/** Escapes text for LaTeX, with commands for letters that not all LaTeX fonts have. */
final class LatexEscaper {
  /** Statistics with several letters, which are written as formulas. */
  private static final Map<String, String> FORMULAS =
      Map.of(
          "ηp²", "$\\eta_p^2$",
          "G²", "$G^2$",
          "BF01", "$BF_{01}$",
          "A_z", "$A_z$",
          "d_a", "$d_a$",
          "d′", "$d'$");

  private static final Map<Integer, String> LETTERS =
      Map.ofEntries(
          Map.entry((int) '\\', "\\textbackslash{}"),
          Map.entry((int) '{', "\\{"),
          Map.entry((int) '}', "\\}"),
          Map.entry((int) '$', "\\$"),
          Map.entry((int) '&', "\\&"),
          Map.entry((int) '#', "\\#"),
          Map.entry((int) '%', "\\%"),
          Map.entry((int) '_', "\\_"),
          Map.entry((int) '^', "\\textasciicircum{}"),
          Map.entry((int) '~', "\\textasciitilde{}"),
          Map.entry((int) '<', "$<$"),
          Map.entry((int) '>', "$>$"),
          Map.entry((int) '−', "$-$"),
          Map.entry((int) '×', "$\\times$"),
          Map.entry((int) '–', "--"),
          Map.entry((int) '²', "$^2$"),
          Map.entry((int) 'η', "$\\eta$"),
          Map.entry((int) 'β', "$\\beta$"),
          Map.entry((int) 'α', "$\\alpha$"),
          Map.entry((int) '′', "$'$"),
          Map.entry((int) '“', "``"),
          Map.entry((int) '”', "''"));

  private LatexEscaper() {}

  static String of(String text) {
    StringBuilder out = new StringBuilder();
    int at = 0;
    while (at < text.length()) {
      int from = at;
      String formula =
          FORMULAS.keySet().stream()
              .filter(known -> text.startsWith(known, from))
              .findFirst()
              .orElse("");
      if (!formula.isEmpty()) {
        out.append(FORMULAS.get(formula));
        at += formula.length();
        continue;
      }
      int letter = text.codePointAt(at);
      String known = LETTERS.get(letter);
      if (known != null) {
        out.append(known);
      } else {
        out.appendCodePoint(letter);
      }
      at += Character.charCount(letter);
    }
    return out.toString();
  }
}
