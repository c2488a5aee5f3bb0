package org.selectiverenderer.x3d.read;

import java.util.List;
import org.jspecify.annotations.Nullable;
import org.selectiverenderer.base.problem.Problem;

/**
 * The prototypes of a file, for other files to use. Several threads may use one.
 *
 * <p>What is wrong with it is told to every file that uses it.
 */
public final class PrototypeLibrary {
  private final String name;
  private final NameScope scope;
  private final @Nullable String first;
  private final List<Problem> problems;

  /**
   * @param scope holds its prototypes, and is changed no more
   * @param first the name of the first prototype in it
   */
  PrototypeLibrary(String name, NameScope scope, @Nullable String first, List<Problem> problems) {
    this.name = name;
    this.scope = scope;
    this.first = first;
    this.problems = problems;
  }

  /** The file, as messages name it. */
  public String name() {
    return name;
  }

  /** The scope that holds its prototypes. */
  NameScope scope() {
    return scope;
  }

  List<Problem> problems() {
    return problems;
  }

  /**
   * The prototype that a url means.
   *
   * @param fragment its name; empty for the first one
   */
  @Nullable DeclaredPrototype prototype(String fragment) {
    String wanted = fragment.isEmpty() ? first : fragment;
    return wanted == null ? null : scope.prototype(wanted);
  }

  /** Whether a prototype of that name is in it, be it of another file. */
  public boolean has(String prototype) {
    return scope.prototype(prototype) != null;
  }

  Iterable<String> names() {
    return scope.prototypeNames();
  }
}
