package org.selectiverenderer.x3d.read;

import java.util.List;
import org.jspecify.annotations.Nullable;
import org.selectiverenderer.base.problem.Problem;

/**
 * The prototypes of a file, for use by other files. Thread-safe.
 *
 * <p>Its problems are reported for every file that uses it.
 */
public final class PrototypeLibrary {
  private final String name;
  private final NameScope scope;
  private final @Nullable String first;
  private final List<Problem> problems;

  /**
   * Creates a library.
   *
   * @param scope the scope with the prototypes, which no longer changes
   * @param first the name of the first prototype
   */
  PrototypeLibrary(String name, NameScope scope, @Nullable String first, List<Problem> problems) {
    this.name = name;
    this.scope = scope;
    this.first = first;
    this.problems = problems;
  }

  /** Returns the name of the file for messages. */
  public String name() {
    return name;
  }

  /** Returns the scope with the prototypes. */
  NameScope scope() {
    return scope;
  }

  List<Problem> problems() {
    return problems;
  }

  /**
   * Returns the prototype of a url.
   *
   * @param fragment the fragment of the url, which is a name; empty for the first prototype
   */
  @Nullable DeclaredPrototype prototype(String fragment) {
    String wanted = fragment.isEmpty() ? first : fragment;
    return wanted == null ? null : scope.prototype(wanted);
  }

  /** Returns whether it declares a prototype of a name, possibly as EXTERNPROTO. */
  public boolean has(String prototype) {
    return scope.prototype(prototype) != null;
  }

  Iterable<String> names() {
    return scope.prototypeNames();
  }
}
