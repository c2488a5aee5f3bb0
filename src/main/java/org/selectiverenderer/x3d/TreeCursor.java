package org.selectiverenderer.x3d;

import java.util.List;
import org.jspecify.annotations.Nullable;

/**
 * Walks through the elements of a document. What is wrong with values is not told: who has the
 * document knows it.
 */
final class TreeCursor implements ElementCursor {
  private final SceneDocument document;
  private final java.util.ArrayDeque<Level> path = new java.util.ArrayDeque<>();
  private @Nullable DocumentElement current;

  private static final class Level {
    final List<DocumentElement> children;
    int next;

    Level(List<DocumentElement> children) {
      this.children = children;
    }
  }

  /** Starts before the root element. */
  TreeCursor(SceneDocument document) {
    this.document = document;
    path.push(new Level(document.root().map(List::of).orElse(List.of())));
  }

  @Override
  public boolean next() {
    Level level = path.peek();
    if (level == null) {
      return false;
    }
    if (level.next == level.children.size()) {
      path.pop();
      return false;
    }
    DocumentElement entered = level.children.get(level.next++);
    current = entered;
    path.push(new Level(entered.children()));
    return true;
  }

  @Override
  public boolean broken() {
    return document.broken();
  }

  @Override
  public String name() {
    return element().name();
  }

  @Override
  public Place place() {
    return element().place();
  }

  @Override
  public int attributes() {
    return element().attributes().size();
  }

  @Override
  public String attributeName(int index) {
    return element().attributes().get(index).name();
  }

  @Override
  public String attributeText(int index) {
    return element().attributes().get(index).text();
  }

  @Override
  public @Nullable Object attributeValue(int index, FieldType type) {
    return element().attributes().get(index).value(type);
  }

  @Override
  public void collectText(StringBuilder into) {
    into.append(element().text());
  }

  @Override
  public RecordedElement record() {
    RecordedElement recorded = new RecordedElement(this);
    while (next()) {
      recorded.add(record());
    }
    return recorded;
  }

  private DocumentElement element() {
    if (current == null) {
      throw new IllegalStateException("no element has been entered");
    }
    return current;
  }
}
