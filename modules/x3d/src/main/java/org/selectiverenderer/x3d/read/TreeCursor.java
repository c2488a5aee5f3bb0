package org.selectiverenderer.x3d.read;

import java.util.ArrayDeque;
import java.util.Deque;
import java.util.List;
import org.jspecify.annotations.Nullable;
import org.selectiverenderer.x3d.field.FieldParser;
import org.selectiverenderer.x3d.field.FieldTokenizer;
import org.selectiverenderer.x3d.field.FieldType;
import org.selectiverenderer.x3d.source.DocumentAttribute;
import org.selectiverenderer.x3d.source.DocumentElement;
import org.selectiverenderer.x3d.source.ElementLocation;
import org.selectiverenderer.x3d.source.XmlDocument;

/** A cursor over recorded elements, of a document or of a prototype's body. */
final class TreeCursor implements ElementCursor {
  private final ReadContext reading;
  private final boolean broken;
  private final Deque<Level> path = new ArrayDeque<>();
  private @Nullable DocumentElement current;
  private @Nullable ElementLocation place;

  private static final class Level {
    final List<DocumentElement> children;
    int next;

    Level(List<DocumentElement> children) {
      this.children = children;
    }
  }

  private TreeCursor(ReadContext reading, boolean broken) {
    this.reading = reading;
    this.broken = broken;
  }

  /** Returns a cursor before a document's root element. */
  static TreeCursor of(XmlDocument document, ReadContext reading) {
    TreeCursor cursor = new TreeCursor(reading, document.broken());
    cursor.path.push(new Level(document.root().map(List::of).orElse(List.of())));
    return cursor;
  }

  /** Returns a cursor at an element. */
  static TreeCursor at(DocumentElement element, ReadContext reading) {
    TreeCursor cursor = new TreeCursor(reading, false);
    cursor.enter(element);
    return cursor;
  }

  private void enter(DocumentElement element) {
    current = element;
    place = null;
    path.push(new Level(element.children()));
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
    enter(level.children.get(level.next++));
    return true;
  }

  @Override
  public boolean broken() {
    return broken;
  }

  @Override
  public String name() {
    return element().name();
  }

  @Override
  public ElementLocation place() {
    ElementLocation known = place;
    if (known == null) {
      known = element().place();
      place = known;
    }
    return known;
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

  /** Reports the errors of a value once, however often it is read. */
  @Override
  public @Nullable Object attributeValue(int index, FieldType type) {
    DocumentAttribute attribute = element().attributes().get(index);
    List<FieldParser.Flaw> flaws = attribute.untold(type);
    if (!flaws.isEmpty()) {
      int leading = FieldTokenizer.leading(attribute.text());
      reading.flaws(place(), index, attribute.name(), leading, flaws);
    }
    return attribute.value(type);
  }

  @Override
  public void collectText(ElementTextCollector into) {
    DocumentElement from = element();
    if (!from.text().isBlank()) {
      into.add(from.text(), from.textLocation(), from.textStart());
    }
  }

  @Override
  public DocumentElement record() {
    DocumentElement recorded = element();
    skip();
    return recorded;
  }

  private DocumentElement element() {
    if (current == null) {
      throw new IllegalStateException("no element has been entered");
    }
    return current;
  }
}
