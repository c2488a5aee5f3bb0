package org.selectiverenderer.authoring;

import java.util.HashSet;
import java.util.Set;
import org.selectiverenderer.x3d.source.ElementTree;

/** Generates DEF names that no node of the document has, for one edit. */
public final class UniqueNameGenerator {
  private final ElementTree tree;
  private final Set<String> given = new HashSet<>();

  public UniqueNameGenerator(ElementTree tree) {
    this.tree = tree;
  }

  /** Returns the wanted name as a valid identifier, with a number appended if it is taken. */
  public String free(String wanted) {
    return unused(identifier(wanted));
  }

  /** Returns the name itself, with a number appended if it is taken. */
  public String unused(String base) {
    String name = base;
    for (int i = 2; tree.named(name).isPresent() || tree.used(name) || given.contains(name); i++) {
      name = base + "_" + i;
    }
    given.add(name);
    return name;
  }

  /** Returns whether a name is valid for a node. */
  public static boolean allowed(String name) {
    return !name.isEmpty()
        && identifier(name).equals(name)
        && "0123456789-".indexOf(name.charAt(0)) < 0;
  }

  /**
   * Replaces the characters that a name must not contain (X3D 4.0, 4.4.2.2), such as spaces and
   * quotes.
   */
  public static String identifier(String wanted) {
    StringBuilder name = new StringBuilder(wanted.length());
    wanted
        .codePoints()
        .map(c -> c <= ' ' || "\"'#+,.[]\\{}:<>&".indexOf(c) >= 0 ? '_' : c)
        .forEach(name::appendCodePoint);
    return name.toString();
  }
}
