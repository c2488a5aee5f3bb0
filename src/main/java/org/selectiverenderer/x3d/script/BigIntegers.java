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
 * Integers of any length, such as {@code 2n}, which programs may not have: one operation on them
 * can take hours and all memory, and nothing can stop it.
 */
public final class BigIntegers {
  /** What is said of them. */
  public static final String REFUSED = "integers of any length, such as 2n, are not supported";

  /** Programs without anything alike, nearly all, are not parsed for their sake. */
  private static final Pattern ALIKE = Pattern.compile("[0-9a-fA-F]n\\b");

  private BigIntegers() {}

  /**
   * The line of the first one in a program, from 1; empty if there is none. What is no ECMAScript
   * has none.
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
      return Optional.empty(); // Who compiles it says what is wrong.
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
