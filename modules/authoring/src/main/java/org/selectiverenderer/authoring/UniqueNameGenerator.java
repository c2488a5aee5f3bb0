package org.selectiverenderer.authoring;

import java.util.HashSet;
import java.util.Set;
import java.util.function.Predicate;
import java.util.regex.Matcher;
import java.util.regex.Pattern;
import org.selectiverenderer.x3d.source.DocumentElement;
import org.selectiverenderer.x3d.source.ElementScope;
import org.selectiverenderer.x3d.source.ElementTree;

/** Generates DEF names that no other node of a scope has, for one edit. */
public final class UniqueNameGenerator {
  /** A name that ends with a number; longer numbers are no counts. */
  private static final Pattern NUMBERED = Pattern.compile("(.+)_([1-9][0-9]{0,5})");

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

  /**
   * Returns the name itself; if it is taken, its base with the next free number, so that the copy
   * of {@code Chair_2} is {@code Chair_3}.
   */
  public String unused(String wanted) {
    String name = wanted;
    Matcher numbered = NUMBERED.matcher(wanted);
    boolean counted = numbered.matches();
    String base = counted ? numbered.group(1) : wanted;
    int next = counted ? Integer.parseInt(numbered.group(2)) + 1 : 2;
    while (taken.test(name) || given.contains(name)) {
      name = base + "_" + next++;
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
