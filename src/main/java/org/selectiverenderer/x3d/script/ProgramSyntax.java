package org.selectiverenderer.x3d.script;

import java.util.ArrayList;
import java.util.LinkedHashSet;
import java.util.List;
import java.util.Set;
import org.jspecify.annotations.Nullable;
import org.mozilla.javascript.CompilerEnvirons;
import org.mozilla.javascript.Context;
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

/**
 * What can be said of a program without running it.
 *
 * @param faults what is no ECMAScript, in order; where there are any, functions are not known
 * @param names what its functions and variables at the top are called
 */
public record ProgramSyntax(List<Fault> faults, Set<String> names) {
  /** Faults listed of one program: the first is what matters. */
  private static final int MOST = 3;

  /**
   * A place that is no ECMAScript.
   *
   * @param line of the program, from 1
   */
  public record Fault(int line, String message) {}

  /** The syntax of a Script's program. */
  public static ProgramSyntax of(ScriptProgram program) {
    Listing faults = new Listing();
    CompilerEnvirons settings = new CompilerEnvirons();
    settings.setLanguageVersion(Context.VERSION_ES6);
    settings.setRecoverFromErrors(false);
    AstRoot root = null;
    try {
      root = new Parser(settings, faults).parse(program.text(), "script", 1);
    } catch (EvaluatorException e) {
      // Rhino ends by this after it has reported the faults.
      if (faults.list.isEmpty()) {
        faults.add(e.lineNumber(), e.details());
      }
    } catch (StackOverflowError e) {
      faults.add(1, "the program is nested too deeply");
    }
    Set<String> names = new LinkedHashSet<>();
    if (root != null) {
      BigIntegers.line(program.text()).ifPresent(line -> faults.add(line, BigIntegers.REFUSED));
      for (Node statement : root) {
        names(statement, names);
      }
    }
    return new ProgramSyntax(List.copyOf(faults.list), names);
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
      // A matter of style.
    }

    @Override
    public void error(
        String message, @Nullable String file, int line, @Nullable String text, int offset) {
      add(line, message);
    }

    @Override
    public EvaluatorException runtimeError(
        String message, @Nullable String file, int line, @Nullable String text, int offset) {
      return new EvaluatorException(message, file, line, text, offset);
    }
  }
}
