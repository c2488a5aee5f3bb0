package org.selectiverenderer.x3d.vrml1;

import java.util.ArrayList;
import java.util.LinkedHashMap;
import java.util.List;
import java.util.Map;
import java.util.Optional;
import org.jspecify.annotations.Nullable;

/** A node as it is written, whether or not its type is known. */
final class Vrml1Node {
  /**
   * A child, or a use of a node that stands elsewhere.
   *
   * @param use whether it is written as USE
   * @param at the offset at which it begins
   */
  record Child(Vrml1Node node, boolean use, int at) {}

  /**
   * The value of a field as it is written.
   *
   * @param at the offset of the field's name
   * @param from the offset of the value, after a bracket or parenthesis
   * @param to the offset after the value
   */
  record Field(Form form, int at, int from, int to) {
    /** The syntactic forms of values. */
    enum Form {
      /** Numbers without brackets. */
      NUMBERS,
      /** A string; its quotes are at {@code from} and before {@code to}. */
      STRING,
      /** A list in brackets. */
      LIST,
      /** A word, such as TRUE, or words in parentheses. */
      WORDS
    }
  }

  private final String type;
  private final @Nullable String name;
  private final int start;
  private final int typeAt;
  private final Map<String, Field> fields = new LinkedHashMap<>();
  private final List<Child> children = new ArrayList<>(0);
  private int end;

  /**
   * Creates a node.
   *
   * @param start the offset at which it begins, with DEF
   * @param typeAt the offset of its type
   */
  Vrml1Node(String type, @Nullable String name, int start, int typeAt) {
    this.type = type;
    this.name = name;
    this.start = start;
    this.typeAt = typeAt;
    this.end = start;
  }

  String type() {
    return type;
  }

  Optional<String> name() {
    return Optional.ofNullable(name);
  }

  /** Returns the offset of its type, or of DEF. */
  int start() {
    return start;
  }

  int typeAt() {
    return typeAt;
  }

  /** Returns the offset after its type. */
  int open() {
    return typeAt + type.length();
  }

  /** Returns the offset after it. */
  int end() {
    return end;
  }

  void endAt(int offset) {
    end = offset;
  }

  Map<String, Field> fields() {
    return fields;
  }

  @Nullable Field field(String field) {
    return fields.get(field);
  }

  List<Child> children() {
    return children;
  }
}
