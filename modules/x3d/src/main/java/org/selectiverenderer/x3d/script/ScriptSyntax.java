package org.selectiverenderer.x3d.script;

import java.util.ArrayList;
import java.util.LinkedHashSet;
import java.util.List;
import java.util.Set;
import org.jspecify.annotations.Nullable;
import org.mozilla.javascript.CompilerEnvirons;
import org.mozilla.javascript.Context;
import org.mozilla.javascript.ContextFactory;
import org.mozilla.javascript.ErrorReporter;
import org.mozilla.javascript.EvaluatorException;
import org.mozilla.javascript.Node;
import org.mozilla.javascript.Parser;
import org.mozilla.javascript.ast.Assignment;
import org.mozilla.javascript.ast.AstNode;
import org.mozilla.javascript.ast.AstRoot;
import org.mozilla.javascript.ast.ExpressionStatement;
import org.mozilla.javascript.ast.FunctionNode;
import org.mozilla.javascript.ast.Name;
import org.mozilla.javascript.ast.VariableDeclaration;
import org.mozilla.javascript.ast.VariableInitializer;
import org.selectiverenderer.scriptengine.MeteredContext;

/**
 * The result of parsing a program without running it.
 *
 * @param faults the syntax errors, in order; if there are any, {@code names} is empty
 * @param names the names of its top-level functions and variables
 */
public record ScriptSyntax(List<Fault> faults, Set<String> names) {
  /** The maximum number of errors listed per program. */
  private static final int MOST = 3;

  private static final int MOST_SECONDS = 10;

  /**
   * A syntax error.
   *
   * @param line the line of the program, from 1
   */
  public record Fault(int line, String message) {}

  /** Parses a Script's program. */
  public static ScriptSyntax of(ScriptProgram program) {
    Listing faults = new Listing();
    CompilerEnvirons settings = new CompilerEnvirons();
    settings.setLanguageVersion(Context.VERSION_ES6);
    settings.setRecoverFromErrors(false);
    AstRoot root = null;
    new Reading().enterContext();
    try {
      root = new Parser(settings, faults).parse(program.text(), "script", 1);
    } catch (EvaluatorException e) {
      // Rhino throws this after it has reported the errors
      if (faults.list.isEmpty()) {
        faults.add(e.lineNumber(), e.details());
      }
    } catch (RuntimeException e) {
      // The parser's assertions and its internal exception, which some broken names let through
      if (faults.list.isEmpty()) {
        faults.add(1, "the program cannot be parsed");
      }
    } catch (StackOverflowError e) {
      faults.add(1, "the program is nested too deeply");
    } catch (TooLong e) {
      faults.add(1, "reading the program takes more than %s s".formatted(MOST_SECONDS));
    } finally {
      Context.exit();
    }
    Set<String> names = new LinkedHashSet<>();
    if (root != null) {
      for (Node statement : root) {
        names(statement, names);
      }
    }
    return new ScriptSyntax(List.copyOf(faults.list), names);
  }

  private static void names(Node statement, Set<String> names) {
    if (statement instanceof FunctionNode function) {
      names.add(function.getName());
    } else if (statement instanceof VariableDeclaration declaration) {
      for (VariableInitializer variable : declaration.getVariables()) {
        if (variable.getTarget() instanceof Name name) {
          names.add(name.getIdentifier());
        }
      }
    } else if (statement instanceof ExpressionStatement expression
        && expression.getExpression() instanceof Assignment assignment) {
      AstNode target = assignment.getLeft();
      if (target instanceof Name name) {
        names.add(name.getIdentifier());
      }
    }
  }

  /** Ends the reading of a program that takes too long. */
  @SuppressWarnings("serial") // Never written to files.
  private static final class TooLong extends Error {
    TooLong() {
      super(null, null, false, false);
    }
  }

  /** Limits the time of reading. */
  private static final class Reading extends ContextFactory {
    private final long began = System.nanoTime();

    @Override
    protected Context makeContext() {
      return new MeteredContext(this) {
        @Override
        protected void checkLimits(long bytes) {
          if (System.nanoTime() - began > MOST_SECONDS * 1_000_000_000L) {
            throw new TooLong();
          }
        }
      };
    }
  }

  private static final class Listing implements ErrorReporter {
    private final List<Fault> list = new ArrayList<>();

    void add(int line, String message) {
      if (list.size() < MOST) {
        list.add(new Fault(line, message));
      }
    }

    @Override
    public void warning(
        String message, @Nullable String file, int line, @Nullable String text, int offset) {
      // warnings concern style only
    }

    @Override
    public void error(
        String message, @Nullable String file, int line, @Nullable String text, int offset) {
      add(line, UnsupportedSyntax.explained(message, text == null ? "" : text, offset));
    }

    @Override
    public EvaluatorException runtimeError(
        String message, @Nullable String file, int line, @Nullable String text, int offset) {
      return new EvaluatorException(message, file, line, text, offset);
    }
  }
}
