package org.selectiverenderer.x3d.source;

import java.util.HashMap;
import java.util.HashSet;
import java.util.Map;
import java.util.Optional;
import java.util.Set;
import org.jspecify.annotations.Nullable;

/**
 * The general entities that a text's own DOCTYPE declares (XML 1.0, 4.2), for texts that are
 * edited: values with references to them can be read, and what they come from is known. External
 * ones are known by name and never fetched, nor is an external subset. Immutable.
 *
 * <p>What references grow to is bounded: one by {@link #LONGEST}, all of a text by {@link #MOST}.
 */
public final class Entities {
  /** No entities: of texts without such a DOCTYPE, which are nearly all. */
  public static final Entities NONE = new Entities(Map.of(), 0);

  /** Characters that one reference may stand for in an attribute. */
  static final int LONGEST = 1 << 16;

  /** Characters that all references in the attributes of a text may stand for. */
  static final long MOST = 1 << 24;

  private static final int DEPTH = 16;
  private static final int DECLARED = 10_000;

  private final Map<String, Declared> declared;
  private final Map<String, Optional<String>> expanded = new HashMap<>();
  private final int end;

  /**
   * An entity.
   *
   * @param value its replacement text, where it is no external one
   * @param offset where its declaration begins
   */
  public record Declared(String name, Optional<String> value, int offset) {}

  private Entities(Map<String, Declared> declared, int end) {
    this.declared = declared;
    this.end = end;
    declared.keySet().forEach(name -> expand(name, new HashSet<>()));
  }

  /** Reads the DOCTYPE in front of a text's root. */
  public static Entities of(CharSequence text) {
    DoctypeReader reader = new DoctypeReader(text, DECLARED);
    Map<String, Declared> found = reader.read();
    return found.isEmpty() ? NONE : new Entities(found, reader.end());
  }

  /** Whether there are none. */
  public boolean none() {
    return declared.isEmpty();
  }

  /** The offset behind the DOCTYPE. */
  int end() {
    return end;
  }

  /** The entity of that name, if the text declares it. */
  public Optional<Declared> find(String name) {
    return Optional.ofNullable(declared.get(name));
  }

  /**
   * What a reference in an attribute means; empty for entities that are not declared, external,
   * within themselves, or too long.
   */
  public Optional<String> value(String name) {
    return expanded.getOrDefault(name, Optional.empty());
  }

  /** Whether a part of a text refers to one of them. */
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

  /** The name of the reference at an offset; empty where it does not end. */
  static String name(CharSequence text, int ampersand, int to) {
    int at = ampersand + 1;
    while (at < to && text.charAt(at) != ';' && text.charAt(at) > ' ' && text.charAt(at) != '&') {
      at++;
    }
    return at < to && text.charAt(at) == ';' ? text.subSequence(ampersand + 1, at).toString() : "";
  }

  /**
   * Null where it cannot be told. All are expanded at the start and once only: entities of entities
   * that are used a thousand times each cost no more than their text, and any thread may ask later.
   */
  private @Nullable String expand(String name, Set<String> open) {
    Optional<String> known = expanded.get(name);
    if (known != null) {
      return known.orElse(null);
    }
    Declared entity = declared.get(name);
    if (entity == null || open.size() >= DEPTH || !open.add(name)) {
      return null;
    }
    String value = entity.value().map(written -> replaced(written, open)).orElse(null);
    open.remove(name);
    expanded.put(name, Optional.ofNullable(value));
    return value;
  }

  private @Nullable String replaced(String written, Set<String> open) {
    StringBuilder value = new StringBuilder(written.length());
    for (int i = 0; i < written.length(); i++) {
      char c = written.charAt(i);
      String inner = c == '&' ? name(written, i, written.length()) : "";
      if (inner.isEmpty() || !declared.containsKey(inner)) {
        value.append(c);
      } else {
        String within = expand(inner, open);
        if (within == null) {
          return null;
        }
        value.append(within);
        i += inner.length() + 1;
      }
      if (value.length() > LONGEST) {
        return null;
      }
    }
    return value.toString();
  }
}
