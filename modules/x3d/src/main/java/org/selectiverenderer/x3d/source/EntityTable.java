package org.selectiverenderer.x3d.source;

import java.util.HashMap;
import java.util.HashSet;
import java.util.Map;
import java.util.Optional;
import java.util.Set;
import org.jspecify.annotations.Nullable;

/**
 * The general entities declared in the internal subset of a text's DOCTYPE (XML 1.0, 4.2). External
 * entities, an external subset and parameter entities are never fetched. Immutable.
 *
 * <p>Expansion is bounded, against exponential growth ("billion laughs"): one reference by {@link
 * #LONGEST}, all of a text by {@link #MOST}.
 */
public final class EntityTable {
  /** No entities, as in nearly all texts. */
  public static final EntityTable NONE = new EntityTable(Map.of(), 0);

  /** The maximum length of the expansion of one reference. */
  static final int LONGEST = 1 << 16;

  /** The maximum length of the expansions of all references of a text. */
  static final long MOST = 1 << 24;

  private static final int DEPTH = 16;
  private static final int DECLARED = 10_000;

  private final Map<String, Declared> declared;
  private final Map<String, Optional<String>> expanded = new HashMap<>();
  private final Map<String, String> refused = new HashMap<>();
  private final int end;

  /**
   * An entity declaration.
   *
   * @param value the replacement text; empty for an external entity
   * @param offset the offset of the declaration
   */
  public record Declared(String name, Optional<String> value, int offset) {}

  private EntityTable(Map<String, Declared> declared, int end) {
    this.declared = declared;
    this.end = end;
    declared.keySet().forEach(name -> expand(name, new HashSet<>()));
  }

  /** Parses the DOCTYPE before a text's root. */
  public static EntityTable of(CharSequence text) {
    DoctypeParser reader = new DoctypeParser(text, DECLARED);
    Map<String, Declared> found = reader.read();
    return found.isEmpty() ? NONE : new EntityTable(found, reader.end());
  }

  /** Returns whether there are no entities. */
  public boolean none() {
    return declared.isEmpty();
  }

  /** Returns the offset after the DOCTYPE. */
  int end() {
    return end;
  }

  /** Returns the entity with a name, if it is declared. */
  public Optional<Declared> find(String name) {
    return Optional.ofNullable(declared.get(name));
  }

  /**
   * Returns the expansion of a reference in an attribute; empty for entities that are undeclared,
   * external, recursive, or too long.
   */
  public Optional<String> value(String name) {
    return expanded.getOrDefault(name, Optional.empty());
  }

  /** Returns the replacement text of an entity that can be expanded, with its references. */
  Optional<String> written(String name) {
    return value(name).isPresent() ? declared.get(name).value() : Optional.empty();
  }

  /**
   * Returns the reason why a reference is not expanded.
   *
   * @param attribute whether it is in an attribute value
   */
  String problem(String name, boolean attribute) {
    if (!declared.containsKey(name)) {
      return "the entity &" + name + "; is not declared in the DOCTYPE of this file";
    }
    String why = refused.get(name);
    if (why != null) {
      String start = "the entity &" + name + "; ";
      return why.startsWith(start) ? why : start + "cannot be expanded: " + why;
    }
    return attribute
        ? "the entity &" + name + "; has a '<', which the value of an attribute must not have"
        : "the entity &" + name + "; has an element that does not begin and end in it";
  }

  /** Returns whether a part of a text refers to a declared entity. */
  boolean within(CharSequence text, int from, int to) {
    if (none()) {
      return false;
    }
    for (int i = from; i < to; i++) {
      if (text.charAt(i) == '&' && declared.containsKey(name(text, i, to))) {
        return true;
      }
    }
    return false;
  }

  /** Returns the name of the reference at an offset; empty if it is not terminated. */
  static String name(CharSequence text, int ampersand, int to) {
    int at = ampersand + 1;
    while (at < to && text.charAt(at) != ';' && text.charAt(at) > ' ' && text.charAt(at) != '&') {
      at++;
    }
    return at < to && text.charAt(at) == ';' ? text.subSequence(ampersand + 1, at).toString() : "";
  }

  /**
   * Returns the expansion of an entity, or null if it is invalid. Each is expanded once, in the
   * constructor, so that nested entities cost no more than their text and no later synchronization.
   */
  private @Nullable String expand(String name, Set<String> open) {
    Optional<String> known = expanded.get(name);
    if (known != null) {
      return known.orElse(null);
    }
    Declared entity = declared.get(name);
    if (entity == null) {
      return null;
    }
    if (open.contains(name)) {
      return refuse(open, "the entity &" + name + "; refers to itself");
    }
    if (open.size() >= DEPTH) {
      return refuse(open, "entities refer to each other more than " + DEPTH + " deep");
    }
    open.add(name);
    String value =
        entity.value().isPresent()
            ? replaced(name, entity.value().get(), open)
            : refuse(open, "the entity &" + name + "; is external and is never fetched");
    open.remove(name);
    expanded.put(name, Optional.ofNullable(value));
    return value;
  }

  /** Notes why none of the open entities can be expanded, and returns null. */
  private @Nullable String refuse(Set<String> open, String why) {
    open.forEach(name -> refused.putIfAbsent(name, why));
    return null;
  }

  private @Nullable String replaced(String name, String written, Set<String> open) {
    StringBuilder value = new StringBuilder(written.length());
    for (int i = 0; i < written.length(); i++) {
      char c = written.charAt(i);
      String inner = c == '&' ? name(written, i, written.length()) : "";
      if (inner.isEmpty() || !declared.containsKey(inner)) {
        value.append(c);
      } else {
        String within = expand(inner, open);
        if (within == null) {
          return refuse(open, refused.getOrDefault(inner, ""));
        }
        value.append(within);
        i += inner.length() + 1;
      }
      if (value.length() > LONGEST) {
        String why = " stands for more than " + LONGEST + " characters";
        return refuse(open, "the entity &" + name + ";" + why);
      }
    }
    return value.toString();
  }
}
