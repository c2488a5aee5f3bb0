package org.selectiverenderer.scriptengine;

import java.util.List;
import org.jspecify.annotations.Nullable;
import org.mozilla.javascript.Callable;
import org.mozilla.javascript.Constructable;
import org.mozilla.javascript.Context;
import org.mozilla.javascript.EvaluatorException;
import org.mozilla.javascript.LambdaFunction;
import org.mozilla.javascript.NativeArray;
import org.mozilla.javascript.ScriptRuntime;
import org.mozilla.javascript.Scriptable;
import org.mozilla.javascript.ScriptableObject;
import org.mozilla.javascript.Token;
import org.mozilla.javascript.ast.ArrayLiteral;
import org.mozilla.javascript.ast.AstNode;
import org.mozilla.javascript.ast.ElementGet;
import org.mozilla.javascript.ast.FunctionCall;
import org.mozilla.javascript.ast.Name;
import org.mozilla.javascript.ast.NewExpression;
import org.mozilla.javascript.ast.ParenthesizedExpression;
import org.mozilla.javascript.ast.PropertyGet;
import org.mozilla.javascript.ast.Spread;
import org.mozilla.javascript.ast.StringLiteral;

/**
 * Constructs of ECMAScript 2015 that Rhino's parser lacks. The build lets the parser call these
 * methods.
 *
 * <ul>
 *   <li>{@code const} within blocks, functions and heads of loops is read as {@code let}, so that
 *       it has the scope that it should have. An assignment to such a constant is no error.
 *   <li>Spread in calls and after {@code new}: {@code f(...a, b)} becomes the call of a function
 *       with the function, its receiver and {@code [...a, b]}. The receiver is evaluated once.
 * </ul>
 */
public final class LanguageExtensions {
  /** The message about spread where parts of an expression may be left out. */
  static final String NO_OPTIONAL_SPREAD =
      "spread (...) is not supported in a call with ?. or super; test for undefined before the call,"
          + " or use apply";

  /** Names of global functions that no program can write. */
  private static final String CALL = "spread call";

  private static final String CALL_METHOD = "spread method call";
  private static final String CONSTRUCT = "spread new";

  private LanguageExtensions() {}

  /** Defines the functions that calls with spread become. */
  public static void define(ScriptableObject scope) {
    define(
        scope,
        CALL,
        (cx, args) -> call(cx, scope, args[0], "it", ScriptRuntime.getTopCallScope(cx), args[1]));
    define(
        scope,
        CALL_METHOD,
        (cx, args) -> {
          Scriptable receiver = ScriptRuntime.toObjectOrNull(cx, args[0], scope);
          if (receiver == null) {
            throw ScriptRuntime.undefReadError(args[0], args[1]);
          }
          Object method = ScriptRuntime.getObjectElem(receiver, args[1], cx, scope);
          return call(cx, scope, method, args[1], receiver, args[2]);
        });
    define(
        scope,
        CONSTRUCT,
        (cx, args) -> {
          if (args[0] instanceof Constructable constructor) {
            return constructor.construct(cx, scope, cx.getElements((Scriptable) args[1]));
          }
          throw ScriptRuntime.notFunctionError(args[0]);
        });
  }

  @FunctionalInterface
  private interface Body {
    @Nullable Object call(Context context, Object[] args);
  }

  private static void define(ScriptableObject scope, String name, Body body) {
    scope.defineProperty(
        name,
        new LambdaFunction(scope, name, 0, (cx, from, self, args) -> body.call(cx, args)),
        ScriptableObject.DONTENUM | ScriptableObject.READONLY | ScriptableObject.PERMANENT);
  }

  private static @Nullable Object call(
      Context cx,
      Scriptable scope,
      Object function,
      Object name,
      Scriptable self,
      Object arguments) {
    if (function instanceof Callable callable) {
      return callable.call(cx, scope, self, cx.getElements((NativeArray) arguments));
    }
    throw ScriptRuntime.notFunctionError(function, name);
  }

  /**
   * Returns the token that the parser is given for one that was read.
   *
   * @param scope the innermost scope that is being parsed
   * @param program the innermost function or program that is being parsed
   */
  public static int token(int read, Object scope, Object program) {
    boolean outermost =
        scope == program && !(program instanceof org.mozilla.javascript.ast.FunctionNode);
    return read == Token.CONST && !outermost ? Token.LET : read;
  }

  /** Returns an argument of a call as the parser keeps it. */
  public static AstNode argument(boolean spread, AstNode expression) {
    if (!spread) {
      return expression;
    }
    Spread argument = new Spread(expression.getPosition(), expression.getLength());
    argument.setLineColumnNumber(expression.getLineno(), expression.getColumn());
    argument.setExpression(expression);
    return argument;
  }

  /**
   * Returns an expression in which a call with spread has become one without.
   *
   * @throws EvaluatorException for a call that may be left out, such as {@code f?.(...a)}
   */
  public static AstNode withoutSpread(AstNode node) {
    if (!(node instanceof FunctionCall call)
        || call.getArguments().stream().noneMatch(Spread.class::isInstance)) {
      return node;
    }
    AstNode target = call.getTarget();
    while (target instanceof ParenthesizedExpression inner) {
      target = inner.getExpression();
    }
    if (call.isOptionalCall() || isOptional(target)) {
      throw new EvaluatorException(NO_OPTIONAL_SPREAD, "script", call.getLineno());
    }
    ArrayLiteral arguments = placed(new ArrayLiteral(call.getPosition()), call);
    call.getArguments().forEach(arguments::addElement);
    if (call instanceof NewExpression) {
      return call(CONSTRUCT, call, target, arguments);
    }
    if (target instanceof PropertyGet property) {
      StringLiteral name = placed(new StringLiteral(), call);
      name.setValue(property.getProperty().getIdentifier());
      name.setQuoteCharacter('"');
      return call(CALL_METHOD, call, property.getTarget(), name, arguments);
    }
    if (target instanceof ElementGet element) {
      return call(CALL_METHOD, call, element.getTarget(), element.getElement(), arguments);
    }
    return call(CALL, call, target, arguments);
  }

  /** Returns whether a part of a chain may be left out, or is {@code super}. */
  private static boolean isOptional(AstNode target) {
    for (AstNode part = target; ; ) {
      if (part.getType() == Token.QUESTION_DOT || part.getType() == Token.SUPER) {
        return true;
      }
      if (part instanceof PropertyGet property) {
        part = property.getTarget();
      } else if (part instanceof ElementGet element) {
        part = element.getTarget();
      } else if (part instanceof FunctionCall call && !(part instanceof NewExpression)) {
        if (call.isOptionalCall()) {
          return true;
        }
        part = call.getTarget();
      } else {
        return false;
      }
    }
  }

  private static AstNode call(String function, FunctionCall in, AstNode... arguments) {
    FunctionCall call = placed(new FunctionCall(in.getPosition(), in.getLength()), in);
    Name name = placed(new Name(in.getPosition(), function), in);
    call.setTarget(name);
    call.setArguments(List.of(arguments));
    return call;
  }

  private static <T extends AstNode> T placed(T node, AstNode at) {
    node.setLineColumnNumber(at.getLineno(), at.getColumn());
    return node;
  }
}
