package org.selectiverenderer.x3d.script;

import java.util.Locale;
import java.util.Optional;
import org.jspecify.annotations.Nullable;
import org.selectiverenderer.base.problem.Problem;
import org.selectiverenderer.base.problem.Problem.Severity;
import org.selectiverenderer.x3d.read.ParsedNode;
import org.selectiverenderer.x3d.url.BaseUrl;
import org.selectiverenderer.x3d.url.UrlContent;
import org.selectiverenderer.x3d.url.UrlResolver;

/**
 * The selected program of a Script: the text between its tags, or else the first of its urls that
 * can be used (X3D 4.0, 29.2.3 and 29.4.1).
 */
public sealed interface ScriptProgramSelection {
  /** The end of the message about other languages. */
  String NOT_OURS = ", which is not run; write it in ECMAScript";

  /** A program in the scene. */
  record Text(ScriptProgram program) implements ScriptProgramSelection {}

  /** A program in a file of its own. */
  record File(UrlContent content) implements ScriptProgramSelection {}

  /**
   * No usable program.
   *
   * @param problem the reason; only an information for a Script without any program
   * @param language the message for a program in another language; null otherwise
   */
  record None(Problem problem, @Nullable String language) implements ScriptProgramSelection {}

  /**
   * Selects the program of a Script.
   *
   * @param base the base of the relative urls of the Script
   */
  static ScriptProgramSelection of(ParsedNode script, UrlResolver root, BaseUrl base) {
    @Nullable String reason = null;
    @Nullable String language = null;
    String text = script.string("sourceCode");
    if (!text.isBlank()) {
      Optional<String> other = ScriptProgram.otherLanguage(text);
      if (other.isEmpty()) {
        return new Text(ScriptProgram.of(text, script.textLocation()));
      }
      reason = "is in " + other.get() + NOT_OURS;
      language = reason;
    }
    String[] urls = script.strings("url");
    for (String url : urls) {
      if (ScriptProgram.isText(url)) {
        return new Text(ScriptProgram.of(url, script.textLocation()));
      }
      Optional<String> other = otherLanguage(url);
      String why;
      if (other.isPresent()) {
        why = other.get();
      } else {
        UrlResolver.Target target = root.resolve(url, base);
        if (target instanceof UrlResolver.Target.Found found) {
          return new File(found.content());
        }
        why = ((UrlResolver.Target.Refused) target).reason();
      }
      if (reason == null) {
        reason = "url '%s' %s".formatted(shown(url), why);
        language = other.isPresent() ? reason : null;
      }
    }
    return new None(
        reason == null
            ? new Problem(
                Severity.INFO, script.location(), "the Script has no program; it does nothing")
            : new Problem(
                Severity.ERROR, script.location(), "Script " + reason + "; it does nothing"),
        language);
  }

  /** Returns the message for a url of a program in another language; else empty. */
  static Optional<String> otherLanguage(String url) {
    return isJava(url)
        ? Optional.of("is a program in Java, which is never run; write it in ECMAScript")
        : ScriptProgram.otherLanguage(url).map(language -> "is in " + language + NOT_OURS);
  }

  private static boolean isJava(String url) {
    String name = url.strip().toLowerCase(Locale.ROOT);
    return name.endsWith(".class") || name.endsWith(".jar") || name.startsWith("java:");
  }

  private static String shown(String url) {
    return url.length() <= 80 ? url : url.substring(0, 80) + "…";
  }
}
