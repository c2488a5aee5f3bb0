package org.selectiverenderer.authoring;

import java.util.HashSet;
import java.util.Set;
import java.util.function.Predicate;
import org.selectiverenderer.x3d.source.DocumentElement;
import org.selectiverenderer.x3d.source.ElementScope;
import org.selectiverenderer.x3d.source.ElementTree;

/** Generates DEF names that no other node of a scope has, for one edit. */
public final class UniqueNameGenerator {
  private final Predicate<String> taken;
  private final Set<String> given = new HashSet<>();

  /** Creates a generator of names that are in none of the document's scopes. */
  public UniqueNameGenerator(ElementTree tree) {
    this.taken = tree::occurs;
  }

  /** Creates a generator of names for the {@link ElementScope} of an element. */
  public UniqueNameGenerator(ElementTree tree, DocumentElement at) {
    this.taken = name -> tree.named(name, at).isPresent() || tree.used(name, at);
  }

  /** Returns the wanted name as a valid identifier, with a number appended if it is taken. */
  public String free(String wanted) {
    return unused(identifier(wanted));
  }

  /** Returns the name itself, with a number appended if it is taken. */
  public String unused(String base) {
    String name = base;
    for (int i = 2; taken.test(name) || given.contains(name); i++) {
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
