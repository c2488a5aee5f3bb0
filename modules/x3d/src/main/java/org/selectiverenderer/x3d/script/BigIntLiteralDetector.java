package org.selectiverenderer.x3d.script;

import java.util.Optional;
import java.util.regex.Pattern;
import org.jspecify.annotations.Nullable;
import org.mozilla.javascript.CompilerEnvirons;
import org.mozilla.javascript.Context;
import org.mozilla.javascript.EvaluatorException;
import org.mozilla.javascript.Parser;
import org.mozilla.javascript.ast.AstNode;
import org.mozilla.javascript.ast.BigIntLiteral;
import org.mozilla.javascript.ast.NodeVisitor;

/**
 * Detects BigInt literals, such as {@code 2n}, which programs may not use: one operation on them
 * can take hours and all memory, and cannot be interrupted.
 */
public final class BigIntLiteralDetector {
  /** The error message. */
  public static final String REFUSED = "integers of any length, such as 2n, are not supported";

  /** A pre-filter; programs without a match, nearly all, are not parsed. */
  private static final Pattern ALIKE = Pattern.compile("[0-9a-fA-F]n\\b");

  private BigIntLiteralDetector() {}

  /**
   * Returns the line, from 1, of the first BigInt literal in a program; empty if there is none or
   * the program is not ECMAScript.
   */
  public static Optional<Integer> line(String program) {
    if (!ALIKE.matcher(program).find()) {
      return Optional.empty();
    }
    CompilerEnvirons settings = new CompilerEnvirons();
    settings.setLanguageVersion(Context.VERSION_ES6);
    try {
      return line(new Parser(settings).parse(program, "script", 1));
    } catch (EvaluatorException | StackOverflowError e) {
      return Optional.empty(); // the compiler reports the error
    }
  }

  static Optional<Integer> line(AstNode program) {
    Finder finder = new Finder();
    program.visit(finder);
    return Optional.ofNullable(finder.line);
  }

  private static final class Finder implements NodeVisitor {
    private @Nullable Integer line;

    @Override
    public boolean visit(AstNode node) {
      if (line == null && node instanceof BigIntLiteral) {
        line = node.getLineno();
      }
      return line == null;
    }
  }
}
